// SPDX-License-Identifier: GPL-3.0-or-later
// What of hits, constants and the cutting plane a step is said to have changed.
#include "session/undo_part.h"

#include <QTest>

#include "session/session_undo.h"
#include "support/test_program.h"

namespace hitscope::undo_part_test {

class UndoPartTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void ofAHit_data() {
        QTest::addColumn<Hit>("after");
        QTest::addColumn<int>("part");
        const auto row = [](const char* name, UndoPart part, const std::function<void(Hit&)>& edit) {
            Hit hit;
            edit(hit);
            QTest::newRow(name) << hit << static_cast<int>(part);
        };
        row("distance", UndoPart::MaxDistance, [](Hit& hit) { hit.constants.maxDistance = 0.7f; });
        row("power", UndoPart::Power, [](Hit& hit) { hit.constants.power = 0.7f; });
        row("magnitude", UndoPart::MaxMagnitude, [](Hit& hit) { hit.constants.maxMagnitude = 0.7f; });
        row("two of them", UndoPart::None, [](Hit& hit) {
            hit.constants.power = 0.7f;
            hit.constants.maxMagnitude = 0.7f;
        });
        row("three of them", UndoPart::None, [](Hit& hit) { hit.constants = {0.7f, 0.7f, 0.7f}; });
        row("profile", UndoPart::Falloff, [](Hit& hit) { hit.form.profile = DentProfile::Linear; });
        row("curve", UndoPart::Falloff, [](Hit& hit) { hit.form.curve[2] = 0.7f; });
        row("direction", UndoPart::Direction, [](Hit& hit) { hit.direction = {1.0f, 0.0f, 0.0f}; });
        row("press", UndoPart::Direction, [](Hit& hit) {
            hit.form.direction = DentDirection::Press;
            hit.form.radius = 0.7f;
        });
        row("radius", UndoPart::PressRadius, [](Hit& hit) { hit.form.radius = 0.7f; });
        row("point", UndoPart::Point, [](Hit& hit) { hit.point.y = 0.7f; });
    }
    void ofAHit() {
        QFETCH(Hit, after);
        QFETCH(int, part);
        const HistoryEdit edit{3, {Hit()}, {after}};
        QCOMPARE(static_cast<int>(changedPart({&edit, 1})), part);
    }

    void ofSeveralHits() {
        Hit wider;
        wider.constants.maxDistance = 0.7f;
        Hit stronger;
        stronger.constants.power = 0.7f;
        const std::vector<HistoryEdit> same{{0, {Hit(), Hit(), Hit()}, {wider, Hit(), wider}},
                                            {5, {Hit()}, {wider}}};
        QCOMPARE(changedPart(same), UndoPart::MaxDistance);
        const std::vector<HistoryEdit> others{{0, {Hit()}, {wider}}, {5, {Hit()}, {stronger}}};
        QCOMPARE(changedPart(others), UndoPart::None);
    }

    void ofTheNextHit() {
        ConstantsSetting before;
        ConstantsSetting after = before;
        after.constants.power = 0.7f;
        QCOMPARE(changedPart(before, after), UndoPart::Power);
        after.relative = !before.relative;
        QCOMPARE(changedPart(before, after), UndoPart::None);
    }

    void ofTheCuttingPlane() {
        const CuttingPlane before;
        CuttingPlane after;
        after.offset = 2.0f;
        QCOMPARE(changedPart(before, after), UndoPart::CutOffset);
        after.fill = true;
        QCOMPARE(changedPart(before, after), UndoPart::None);
        after.normal = {0.0f, 1.0f, 0.0f};
        QCOMPARE(changedPart(before, after), UndoPart::CutAxis);
        after.on = true;
        QCOMPARE(changedPart(before, after), UndoPart::CutOn);
        QCOMPARE(changedPart(after, before), UndoPart::CutOff);
        after = before;
        after.fill = true;
        QCOMPARE(changedPart(before, after), UndoPart::CutFill);
        after = before;
        after.flipped = true;
        QCOMPARE(changedPart(before, after), UndoPart::CutFlip);
        after = before;
        after.deformedLine = false;
        QCOMPARE(changedPart(before, after), UndoPart::CutLines);
    }

    /// A gesture that goes on to something else is about neither alone.
    void ofStepsThatMerge() {
        SessionUndo undo;
        CuttingPlane cut;
        const auto change = [&](const std::function<void(CuttingPlane&)>& edit) {
            SettingsState before;
            before.cut = cut;
            edit(cut);
            SettingsState after;
            after.cut = cut;
            undo.record({.name = {SessionUndo::Kind::CuttingPlane, 1},
                         .merge = SessionUndo::Merge::WithSameKind,
                         .settings = std::make_shared<const ValueEdit<SettingsState>>(
                             ValueEdit<SettingsState>{before, after})});
        };
        change([](CuttingPlane& plane) { plane.offset = 1.0f; });
        change([](CuttingPlane& plane) { plane.offset = 2.0f; });
        QCOMPARE(undo.size(), std::size_t{1});
        QCOMPARE(undo.toUndo()->part, UndoPart::CutOffset);
        change([](CuttingPlane& plane) { plane.fill = true; });
        QCOMPARE(undo.size(), std::size_t{1});
        QCOMPARE(undo.toUndo()->part, UndoPart::None);
    }
};

HITSCOPE_TEST(UndoPartTest, QCoreApplication)

}  // namespace hitscope::undo_part_test

#include "undo_part_test.moc"
