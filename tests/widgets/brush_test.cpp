// SPDX-License-Identifier: GPL-3.0-or-later
// Hits painted, scattered and mirrored in the window, by real mouse and keys.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSpinBox>
#include <QWheelEvent>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/dialogs/brush_dialog.h"
#include "app/dialogs/mirror_dialog.h"
#include "app/dialogs/scatter_dialog.h"
#include "session/primitive_target.h"
#include "session/usual_dent.h"
#include "support/test_program.h"
#include "viewport/brush_tool.h"
#include "viewport/inspect_tool.h"
#include "widgets/window_support.h"

namespace hitscope::brush_test {

class BrushTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        makeWindow();
        QTest::keyClick(&viewport(), Qt::Key_R);
        QVERIFY(viewport().inspectTool().tool() == Tool::Brush);
    }
    void cleanup() { dropWindow(); }

    void aDragIsAGroupAndOneStep() {
        drag(centre() - QPoint(90, 0), centre() + QPoint(90, 0));
        const std::size_t made = hits().size();
        QVERIFY2(made > 3, qPrintable(QString::number(made)));
        const HitGroup group = hits().front().group;
        QCOMPARE(group.kind, HitGroupKind::Stroke);
        for (std::size_t i = 0; i < made; ++i) {
            QVERIFY(hits()[i].group == group);
            QVERIFY(glm::dot(hits()[i].direction, -glm::normalize(hits()[i].point)) > 0.95f);
            if (i > 0) {
                // The spacing is half the reach, along a surface that sinks under the brush by up to 0.3 m a
                // hit; a step looks at the surface every two pixels.
                const float apart = glm::distance(hits()[i].point, hits()[i - 1].point);
                QVERIFY2(apart > 0.05f && apart < 1.0f, qPrintable(QString::number(apart)));
            }
        }
        QCOMPARE(m_session->steps().size(), std::size_t{1});
        drag(centre() - QPoint(0, 90), centre() + QPoint(0, 90));
        QVERIFY(hits().back().group != group);
        QCOMPARE(m_session->steps().size(), std::size_t{2});
        m_session->undo();
        QCOMPARE(hits().size(), made);
        m_session->undo();
        QCOMPARE(hits().size(), std::size_t{0});
        m_session->redo();
        QCOMPARE(hits().size(), made);
    }

    void aClickIsOneHitAndStandingStillNoMore() {
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, centre());
        for (int i = 0; i < 20; ++i) {
            QTest::mouseMove(&viewport(), centre());
        }
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, centre());
        QTRY_VERIFY_WITH_TIMEOUT(!viewport().brushTool().isPainting(), kPatience);
        QCOMPARE(hits().size(), std::size_t{1});
    }

    void escapeTakesTheStrokeBack() {
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, centre());
        QTest::mouseMove(&viewport(), centre() + QPoint(60, 0));
        QTRY_VERIFY_WITH_TIMEOUT(hits().size() > 1, kPatience);
        QTest::keyClick(&viewport(), Qt::Key_Escape);
        QVERIFY(!viewport().brushTool().isPainting());
        QCOMPARE(hits().size(), std::size_t{0});
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, centre());
    }

    /// The stroke, not the hits that it has so far.
    void undoTakesTheStrokeBack() {
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, centre());
        QTest::mouseMove(&viewport(), centre() + QPoint(60, 0));
        QTRY_VERIFY_WITH_TIMEOUT(hits().size() > 1, kPatience);
        QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!viewport().brushTool().isPainting());
        QTest::mouseMove(&viewport(), centre() + QPoint(90, 0));
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, centre() + QPoint(90, 0));
        QTest::qWait(100);
        QCOMPARE(hits().size(), std::size_t{0});
    }

    void theInspectKeyLeadsToInspectAndBack() {
        QCOMPARE(viewport().inspectTool().tool(), Tool::Brush);
        QTest::keyClick(m_window.get(), Qt::Key_I);
        QCOMPARE(viewport().inspectTool().tool(), Tool::Inspect);
        QTest::keyClick(m_window.get(), Qt::Key_I);
        QCOMPARE(viewport().inspectTool().tool(), Tool::Shoot);
    }

    void theDialogShowsWhatIsInForce() {
        QTest::keyClick(&viewport(), Qt::Key_BracketLeft);
        const BrushSettings before = viewport().brushTool().settings();
        const BrushDialog dialog(viewport().brushTool(), m_window.get());
        const BrushSettings after = viewport().brushTool().settings();
        QVERIFY(after.size == before.size && after.strength == before.strength &&
                after.spacing == before.spacing && after.spacingMetres == before.spacingMetres &&
                after.isInward == before.isInward);
        QCOMPARE(dialog.findChild<QDoubleSpinBox*>(QStringLiteral("size"))->value(),
                 std::round(before.size * 100.0));
    }

    /// Along a surface that hardly sinks, as far apart as the dialog says, whatever the brush's size.
    void hitsAreAsFarApartAsTheDialogSays() {
        BrushDialog dialog(viewport().brushTool(), m_window.get());
        auto* unit = dialog.findChild<QComboBox*>(QStringLiteral("unit"));
        auto* millimetres = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("millimetres"));
        QVERIFY(unit != nullptr && millimetres != nullptr && millimetres->isHidden());
        unit->setCurrentIndex(1);
        QVERIFY(!millimetres->isHidden());
        BrushSettings settings = viewport().brushTool().settings();
        settings.strength = BrushSettings::kLeast;
        for (const auto& [apart, size] : {std::pair(0.3, 1.0), {0.3, 2.0}, {0.6, 1.0}}) {
            settings.size = size;
            settings.spacingMetres = viewport().brushTool().settings().spacingMetres;
            viewport().brushTool().setSettings(settings);
            millimetres->setValue(1000.0 * apart);
            const std::size_t before = hits().size();
            drag(centre() - QPoint(90, 0), centre() + QPoint(90, 0));
            QVERIFY2(hits().size() > before + 2, qPrintable(QString::number(hits().size() - before)));
            for (std::size_t i = before + 1; i < hits().size(); ++i) {
                const double between =
                    static_cast<double>(glm::distance(hits()[i].point, hits()[i - 1].point));
                QVERIFY2(between > 0.9 * apart && between < 1.1 * apart + 0.05,
                         qPrintable(QStringLiteral("%1 of %2").arg(between).arg(apart)));
            }
        }
    }

    void keysAndWheelChangeSizeAndStrength() {
        const BrushSettings before = viewport().brushTool().settings();
        QTest::keyClick(&viewport(), Qt::Key_BracketRight);
        const BrushSettings larger = viewport().brushTool().settings();
        QVERIFY(larger.size > before.size && larger.strength == before.strength);
        QTest::keyClick(&viewport(), Qt::Key_BraceLeft, Qt::ShiftModifier);
        const BrushSettings weaker = viewport().brushTool().settings();
        QVERIFY(weaker.size == larger.size && weaker.strength < before.strength);
        drag(centre(), centre());
        QCOMPARE(hits().size(), std::size_t{1});
        const DeformationConstants made = hits()[0].constants;
        QVERIFY(std::abs(made.maxDistance / 0.5f - static_cast<float>(weaker.size)) < 1e-3f);
        QVERIFY(std::abs(made.maxMagnitude / 0.3f - static_cast<float>(weaker.size * weaker.strength)) <
                1e-3f);
        const Camera camera = viewport().camera();
        QWheelEvent wheel(QPointF(centre()), viewport().mapToGlobal(QPointF(centre())), {}, {0, 120},
                          Qt::NoButton, Qt::ControlModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&viewport(), &wheel);
        QVERIFY(viewport().brushTool().settings().size > weaker.size);
        QVERIFY(glm::distance(viewport().camera().eye(), camera.eye()) == 0.0f);
    }

    /// What presses is as large as what a click sends, times the brush's size.
    void pressIsAsLargeAsTheBrush() {
        DentForm press;
        press.direction = DentDirection::Press;
        QVERIFY(m_session->settings().setForm(press).ok());
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, centre());
        QTRY_COMPARE_WITH_TIMEOUT(hits().size(), std::size_t{1}, kPatience);
        Hit shot;
        shot.target = hits()[0].target;
        const float usual = usualForm(*m_session, shot).radius;
        QVERIFY(usual > 0.0f);
        QCOMPARE(hits()[0].form.radius, usual);
        BrushSettings settings = viewport().brushTool().settings();
        settings.size = 2.0;
        viewport().brushTool().setSettings(settings);
        drag(centre(), centre());
        QCOMPARE(hits().size(), std::size_t{2});
        QCOMPARE(hits()[1].form.direction, DentDirection::Press);
        QCOMPARE(hits()[1].form.radius, 2.0f * usual);
    }

    void besideTargetsADragMovesTheCamera() {
        const glm::vec3 eye = viewport().camera().eye();
        drag(QPoint(8, 8), QPoint(80, 30));
        QCOMPARE(hits().size(), std::size_t{0});
        QVERIFY(glm::distance(viewport().camera().eye(), eye) > 0.0f);
    }

    void scatterShowsGhostsAndMakesAGroup() {
        DentForm crater;
        crater.profile = DentProfile::Crater;
        QVERIFY(m_session->settings().setForm(crater).ok());
        trigger(QStringLiteral("Scatter Hits"));
        auto* dialog = m_window->findChild<ScatterDialog*>();
        QVERIFY(dialog != nullptr && dialog->isVisible());
        dialog->findChild<QSpinBox*>(QStringLiteral("count"))->setValue(40);
        QTRY_VERIFY_WITH_TIMEOUT(
            dialog->planner().current() != nullptr && dialog->planner().current()->hits.size() == 40,
            kPatience);
        const auto plan = dialog->planner().current();
        QVERIFY(plan != nullptr && !plan->ghosts->empty());
        const std::vector<Hit> planned(plan->hits.begin(), plan->hits.end());
        QCOMPARE(hits().size(), std::size_t{0});
        QCOMPARE(planned.front().form.profile, DentProfile::Crater);
        dialog->findChild<QPushButton*>(QStringLiteral("apply"))->click();
        QCOMPARE(hits().size(), std::size_t{40});
        QVERIFY(!dialog->isVisible());
        for (std::size_t i = 0; i < planned.size(); ++i) {
            QCOMPARE(hits()[i].point, planned[i].point);
            QCOMPARE(hits()[i].group.kind, HitGroupKind::Scatter);
        }
        m_session->undo();
        QCOMPARE(hits().size(), std::size_t{0});
    }

    /// In a field Return takes the number, and then what is planned.
    void returnScatters() {
        trigger(QStringLiteral("Scatter Hits"));
        auto* dialog = m_window->findChild<ScatterDialog*>();
        QVERIFY(dialog != nullptr);
        makeActive(*dialog);
        auto* count = dialog->findChild<QSpinBox*>(QStringLiteral("count"));
        count->setFocus();
        count->selectAll();
        QTest::keyClicks(count, QStringLiteral("7"));
        QTest::keyClick(count, Qt::Key_Return);
        QVERIFY(dialog->isVisible() || hits().size() == 7);
        QTRY_VERIFY_WITH_TIMEOUT(
            dialog->planner().current() != nullptr && dialog->planner().current()->hits.size() == 7,
            kPatience);
        QTest::keyClick(count, Qt::Key_Return);
        QCOMPARE(hits().size(), std::size_t{7});
        QVERIFY(!dialog->isVisible());
    }

    void mirrorRepeatsHitsOnTheOtherSide() {
        addHit();
        trigger(QStringLiteral("Mirror Hits"));
        auto* dialog = m_window->findChild<MirrorDialog*>();
        QVERIFY(dialog != nullptr && dialog->isVisible());
        QCOMPARE(dialog->findChild<QComboBox*>(QStringLiteral("hits"))->currentIndex(),
                 1);  // none is selected
        dialog->findChild<QComboBox*>(QStringLiteral("through"))->setCurrentIndex(1);
        QTRY_VERIFY_WITH_TIMEOUT(dialog->planner().current() != nullptr, kPatience);
        dialog->apply();
        QCOMPARE(hits().size(), std::size_t{2});
        QCOMPARE(hits()[1].point, glm::vec3(-2.0f, 1.5f, 0.0f));
        QCOMPARE(hits()[1].group.kind, HitGroupKind::Mirror);
    }

    /// A target that goes, or gets another mesh and with it another id, leaves the dialogs something to do.
    void dialogsPlanAgainWhenTargetsGo() {
        m_session->targets().add({planBuiltIn(BuiltInMesh::Teapot)});
        const TargetId teapot = m_session->targets().back()->id;
        addHit();
        trigger(QStringLiteral("Mirror Hits"));
        auto* mirror = m_window->findChild<MirrorDialog*>();
        trigger(QStringLiteral("Scatter Hits"));
        auto* scatter = m_window->findChild<ScatterDialog*>();
        QVERIFY(mirror != nullptr && scatter != nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(isReady(*mirror) && isReady(*scatter), kPatience);
        const TargetId sphere = m_session->targets().front()->id;
        m_session->targets().select(sphere);
        m_session->targets().remove({&teapot, 1});
        QTRY_VERIFY_WITH_TIMEOUT(isReady(*mirror) && isReady(*scatter), kPatience);
        const std::vector<TargetState> same = {*m_session->targets().front()};
        const auto ids = m_session->targets().replaceMeshes(same, [](const Hit& hit) { return hit; });
        m_session->targets().select(ids.at(sphere));
        QTRY_VERIFY_WITH_TIMEOUT(isReady(*mirror) && isReady(*scatter), kPatience);
        QCOMPARE(planned(*mirror).target, ids.at(sphere));
        QCOMPARE(planned(*scatter).target, ids.at(sphere));
    }

    /// The plane and the direction are the world's.
    void dialogsPlanAgainWhenTargetsTurn() {
        addHit();
        CuttingPlane cut;
        cut.on = true;
        cut.normal = {1.0f, 0.0f, 0.0f};
        cut.offset = 0.0f;
        m_session->settings().setCut(cut);
        trigger(QStringLiteral("Mirror Hits"));
        auto* mirror = m_window->findChild<MirrorDialog*>();
        trigger(QStringLiteral("Scatter Hits"));
        auto* scatter = m_window->findChild<ScatterDialog*>();
        QVERIFY(mirror != nullptr && scatter != nullptr);
        mirror->findChild<QComboBox*>(QStringLiteral("plane"))->setCurrentIndex(3);
        scatter->findChild<QComboBox*>(QStringLiteral("direction"))->setCurrentIndex(2);
        QTRY_VERIFY_WITH_TIMEOUT(isReady(*mirror) && isReady(*scatter), kPatience);
        const Target& target = *m_session->targets().front();
        RigidTransform turned = target.transform;
        turned.rotation = glm::angleAxis(1.5707964f, glm::vec3(0.0f, 0.0f, 1.0f));
        turned.position.x += 0.5f;
        QVERIFY(m_session->targets().setTransform(target.id, turned).ok());
        QVERIFY(!isReady(*mirror) && !isReady(*scatter));
        QTRY_VERIFY_WITH_TIMEOUT(isReady(*mirror) && isReady(*scatter), kPatience);
        const glm::vec3 hit = turned.toWorld(hits().front().point);
        const glm::vec3 image = turned.toWorld(planned(*mirror).point);
        QVERIFY(glm::distance(image, glm::vec3(-hit.x, hit.y, hit.z)) < 1e-4f);
        const glm::vec3 down = turned.rotation * planned(*scatter).direction;
        QVERIFY(glm::distance(down, glm::vec3(0.0f, -1.0f, 0.0f)) < 1e-4f);
    }

private:
    static bool isReady(PlanDialog& dialog) {
        return dialog.findChild<QPushButton*>(QStringLiteral("apply"))->isEnabled() &&
               dialog.planner().current() != nullptr && !dialog.planner().current()->hits.empty();
    }
    static Hit planned(PlanDialog& dialog) {
        const HitPlanner::Plan* plan = dialog.planner().current();
        return plan != nullptr && !plan->hits.empty() ? plan->hits.front() : Hit{};
    }
    void addHit() {
        Hit hit;
        hit.target = m_session->targets().front()->id;
        hit.point = {2.0f, 1.5f, 0.0f};
        hit.direction = glm::normalize(glm::vec3(-2.0f, -1.5f, 0.0f));
        QVERIFY(m_session->hits().add(hit).ok());
    }
    [[nodiscard]] Viewport& viewport() const { return m_window->viewport(); }
    [[nodiscard]] QPoint centre() const { return viewport().rect().center(); }
    [[nodiscard]] std::span<const Hit> hits() const { return m_session->hits().history().hits(); }

    void drag(const QPoint& from, const QPoint& to) {
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, from);
        for (int step = 1; step <= 6; ++step) {
            QTest::mouseMove(&viewport(), from + (to - from) * step / 6);
            QTest::qWait(5);
        }
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, to);
        QTRY_VERIFY_WITH_TIMEOUT(!viewport().brushTool().isPainting(), kPatience);
    }
    void trigger(const QString& begin) {
        for (QAction* action : m_window->findChildren<QAction*>()) {
            if (action->text().remove(u'&').startsWith(begin)) {
                action->trigger();
                return;
            }
        }
        QFAIL("no such action");
    }
};

HITSCOPE_TEST(BrushTest, QApplication)

}  // namespace hitscope::brush_test

#include "brush_test.moc"
