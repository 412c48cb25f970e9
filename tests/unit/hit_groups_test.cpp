// SPDX-License-Identifier: GPL-3.0-or-later
// Hits that were made together.
#include <QTest>
#include <array>
#include <numeric>

#include "analysis/hit_files.h"
#include "deform/fingerprint.h"
#include "mesh/primitives.h"
#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::hit_groups_test {

namespace {

std::vector<Hit> someHits(const Session& session, std::size_t count) {
    std::vector<Hit> hits(count);
    for (std::size_t i = 0; i < count; ++i) {
        hits[i].target = session.targets().front()->id;
        hits[i].point = {0.1f * static_cast<float>(i), 0.0f, 0.0f};
    }
    return hits;
}

}  // namespace

class HitGroupsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_session = std::make_unique<Session>();
        loadMesh(*m_session, makeCube(4, 5.0f));
    }

    void textsAreRead() {
        QCOMPARE(groupText({3, HitGroupKind::Scatter}), std::string("scatter 3"));
        QVERIFY(groupText({}).empty());
        for (std::size_t kind = 1; kind < kHitGroupWords.size(); ++kind) {
            const HitGroup group{4000000000u, static_cast<HitGroupKind>(kind)};
            QVERIFY(groupOf(groupText(group)) == group);
        }
        for (const char* wrong : {"", "scatter", "scatter 0", "scatter -1", "scatter 1 ", "scatter 1x", " 3",
                                  "none 3", "Scatter 3", "scatter 99999999999"}) {
            QVERIFY2(!groupOf(wrong), wrong);
        }
    }

    void aGroupIsOneStepAndCountsForNoFingerprint() {
        QVERIFY(hits().add(someHits(*m_session, 2)).ok());
        const Result<HitGroup> group = hits().addGroup(HitGroupKind::Scatter, someHits(*m_session, 5));
        QVERIFY(group.ok());
        QCOMPARE(hits().of(group.value()), (std::vector<std::size_t>{2, 3, 4, 5, 6}));
        QVERIFY(m_session->steps().toUndo() == (SessionUndo::Name{SessionUndo::Kind::Scatter, 5}));
        const TargetId target = m_session->targets().front()->id;
        const std::uint64_t print = hitsFingerprint(history(), {&target, 1});
        const std::array<std::size_t, 7> all{0, 1, 2, 3, 4, 5, 6};
        hits().ungroup(all);
        QCOMPARE(hitsFingerprint(history(), {&target, 1}), print);
        QVERIFY(hits().of(group.value()).empty());
        m_session->undo();
        QCOMPARE(hits().of(group.value()).size(), std::size_t{5});
        m_session->undo();
        QCOMPARE(history().size(), std::size_t{2});
        m_session->redo();
        QCOMPARE(hits().of(group.value()).size(), std::size_t{5});
    }

    void groupingChangesNothingThatIsDrawn() {
        QVERIFY(hits().add(someHits(*m_session, 3)).ok());
        HitsByTarget byTarget;
        byTarget.reset(history());
        const std::uint64_t revision = hits().history().revision();
        const std::array<std::size_t, 2> two{0, 2};
        hits().group(two);
        QCOMPARE(hits().of(history()[0].group), (std::vector<std::size_t>{0, 2}));
        const auto edits = hits().history().editsSince(revision);
        QVERIFY(edits && !edits->empty());
        for (const HistoryEdit& edit : *edits) {
            QVERIFY(byTarget.apply(edit).empty());
        }
    }

    void aStrokeIsOneStepHoweverManyHitsItHas() {
        const HitGroup first = hits().newGroup(HitGroupKind::Stroke);
        for (const Hit& hit : someHits(*m_session, 4)) {
            QVERIFY(hits().extendStroke(first, hit).ok());
        }
        m_session->finishUndoStep();
        const HitGroup second = hits().newGroup(HitGroupKind::Stroke);
        QVERIFY(second.number > first.number);
        for (const Hit& hit : someHits(*m_session, 3)) {
            QVERIFY(hits().extendStroke(second, hit).ok());
        }
        QCOMPARE(m_session->steps().size(), std::size_t{2});
        QVERIFY(m_session->steps().toUndo() == (SessionUndo::Name{SessionUndo::Kind::Stroke, 3}));
        m_session->undo();
        QCOMPARE(history().size(), std::size_t{4});
        m_session->undo();
        QCOMPARE(history().size(), std::size_t{0});
        m_session->redo();
        m_session->redo();
        QCOMPARE(history().size(), std::size_t{7});
        QCOMPARE(hits().of(first).size(), std::size_t{4});
        QCOMPARE(hits().of(second).size(), std::size_t{3});
    }

    void aStrokeThatIsInterruptedIsUndoneInOrder() {
        const HitGroup stroke = hits().newGroup(HitGroupKind::Stroke);
        const std::vector<Hit> some = someHits(*m_session, 3);
        QVERIFY(hits().extendStroke(stroke, some[0]).ok());
        QVERIFY(hits().add(some[1]).ok());  // a projectile that was on its way
        QVERIFY(hits().extendStroke(stroke, some[2]).ok());
        QCOMPARE(m_session->steps().size(), std::size_t{3});
        m_session->undo();
        QCOMPARE(history().size(), std::size_t{2});
        m_session->undo();
        m_session->undo();
        QCOMPARE(history().size(), std::size_t{0});
    }

    void eachKindIsCountedOnItsOwn() {
        const auto add = [this](HitGroupKind kind) {
            const Result<HitGroup> group = hits().addGroup(kind, someHits(*m_session, 2));
            return group ? groupText(group.value()) : group.error().what;
        };
        QCOMPARE(add(HitGroupKind::Scatter), std::string("scatter 1"));
        QCOMPARE(add(HitGroupKind::Mirror), std::string("mirror 1"));
        QCOMPARE(add(HitGroupKind::Scatter), std::string("scatter 2"));
        m_session->undo();
        QCOMPARE(add(HitGroupKind::Scatter), std::string("scatter 2"));
        const std::array<std::size_t, 2> two{0, 2};
        hits().group(two);
        QCOMPARE(groupText(history()[0].group), std::string("group 1"));
        // As after the session was saved and opened: by the hits alone.
        const std::vector<Hit> kept(history().begin(), history().end());
        hits().clear();
        QVERIFY(hits().add(kept).ok());
        QCOMPARE(add(HitGroupKind::Mirror), std::string("mirror 2"));
        QCOMPARE(add(HitGroupKind::Stroke), std::string("stroke 1"));
    }

    void importedGroupsOfSeveralKindsStayApart() {
        for (const HitGroupKind kind : {HitGroupKind::Scatter, HitGroupKind::Mirror, HitGroupKind::Scatter}) {
            QVERIFY(hits().addGroup(kind, someHits(*m_session, 1)).ok());
        }
        QVERIFY(appendRecords(*m_session, recordsOf(*m_session, nullptr)).ok());
        QStringList groups;
        for (const Hit& hit : history().subspan(3)) {
            groups << QString::fromStdString(groupText(hit.group));
        }
        QCOMPARE(groups, (QStringList{"scatter 3", "mirror 2", "scatter 4"}));
    }

    void tablesKeepGroupsAndImportedOnesAreNew() {
        QVERIFY(hits().addGroup(HitGroupKind::Mirror, someHits(*m_session, 2)).ok());
        QVERIFY(hits().add(someHits(*m_session, 1)).ok());
        const HitRecords table = recordsOf(*m_session, nullptr);
        for (const std::string& text : {toCsv(table), toJson(table)}) {
            const Result<HitRecords> read = readHitRecords(text, pipelineKeys());
            QVERIFY2(read.ok(), read.ok() ? "" : read.error().message().c_str());
            QVERIFY(read.value().hits[1].group == (HitGroup{1, HitGroupKind::Mirror}));
            QVERIFY(!read.value().hits[2].group);
            const std::size_t before = history().size();
            QVERIFY(appendRecords(*m_session, read.value()).ok());
            const HitGroup now = history()[before].group;
            QVERIFY(now.kind == HitGroupKind::Mirror && now.number > 1);
            QCOMPARE(hits().of(now).size(), std::size_t{2});
        }
        QVERIFY(!readHitRecords("target,point_x_m,point_y_m,point_z_m,direction_x,direction_y,direction_z,"
                                "group\na,0,0,0,0,0,1,heap 3\n",
                                pipelineKeys())
                     .ok());
    }

private:
    [[nodiscard]] SessionHits& hits() const { return m_session->hits(); }
    [[nodiscard]] std::span<const Hit> history() const { return m_session->hits().history().hits(); }
    std::unique_ptr<Session> m_session;
};

HITSCOPE_TEST(HitGroupsTest, QCoreApplication)

}  // namespace hitscope::hit_groups_test

#include "hit_groups_test.moc"
