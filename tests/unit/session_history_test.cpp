// SPDX-License-Identifier: GPL-3.0-or-later
// Changing the session's history, and who is told what of it.
#include <QSignalSpy>
#include <QTest>
#include <array>
#include <numeric>

#include "session/session.h"
#include "support/read_back.h"
#include "support/test_program.h"

namespace hitscope::session_history_test {

namespace {

using Rows = std::vector<std::size_t>;

void addHits(Session& session, int count) {
    for (int i = 0; i < count; ++i) {
        Hit hit;
        hit.target = session.targets()[static_cast<std::size_t>(i) % session.targets().size()]->id;
        hit.point.x = static_cast<float>(session.hits().history().size());
        QVERIFY(session.hits().add(hit).ok());
    }
}

/// The hits by the number they were made with; disabled ones negative, less one.
std::vector<int> state(const Session& session) {
    std::vector<int> numbers;
    for (const Hit& hit : session.hits().history().hits()) {
        const int number = static_cast<int>(hit.point.x);
        numbers.push_back(hit.enabled ? number : -number - 1);
    }
    return numbers;
}

std::vector<int> upTo(int count) {
    std::vector<int> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

}  // namespace

class SessionHistoryTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        m_session = std::make_unique<Session>();
        loadPaperRow(*m_session, kDefaultPaperRow);
        addHits(*m_session, 6);
    }

    void disablingManyIsOneStep() {
        Session& session = *m_session;
        const QSignalSpy changed(&session.hits(), &SessionHits::changed);
        const QSignalSpy rearranged(&session.hits(), &SessionHits::rearranged);
        session.hits().setEnabled(Rows{4, 1, 2, 99, 1}, false);
        QCOMPARE(state(session), (std::vector<int>{0, -2, -3, 3, -5, 5}));
        QCOMPARE(session.hits().disabled(), std::size_t{3});
        QCOMPARE(changed.size(), 1);
        QCOMPARE(changed[0][0].toInt(), 1);
        QCOMPARE(changed[0][1].toInt(), 4);
        QCOMPARE(session.steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::Disable, 3}));
        session.hits().enableAll();
        QCOMPARE(session.hits().disabled(), std::size_t{0});
        QCOMPARE(session.steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::Enable, 3}));
        session.undo();
        QCOMPARE(session.hits().disabled(), std::size_t{3});
        session.undo();
        QCOMPARE(state(session), upTo(6));
        QCOMPARE(session.hits().disabled(), std::size_t{0});
        QCOMPARE(session.steps().toRedo(), (SessionUndo::Name{SessionUndo::Kind::Disable, 3}));
        session.redo();
        QCOMPARE(session.hits().disabled(), std::size_t{3});
        QCOMPARE(changed.size(), 5);
        QCOMPARE(rearranged.size(), 0);
    }

    void disablingTheDisabledIsNoStep() {
        m_session->hits().setEnabled(Rows{3}, false);
        const QSignalSpy changed(&m_session->hits(), &SessionHits::changed);
        const QSignalSpy reset(&m_session->hits(), &SessionHits::reset);
        m_session->hits().setEnabled(Rows{3}, false);
        QCOMPARE(changed.size() + reset.size(), 0);
        m_session->undo();
        QCOMPARE(m_session->hits().disabled(), std::size_t{0});
    }

    void movesTogether_data() {
        QTest::addColumn<Rows>("rows");
        QTest::addColumn<std::size_t>("to");
        QTest::addColumn<std::vector<int>>("after");
        const auto row = [](const char* name, Rows rows, std::size_t to, std::vector<int> after) {
            QTest::newRow(name) << rows << to << after;
        };
        row("up", {3}, 1, {0, 3, 1, 2, 4, 5});
        row("down", {1}, 4, {0, 2, 3, 1, 4, 5});
        row("to the end", {0}, 6, {1, 2, 3, 4, 5, 0});
        row("several from both sides", {5, 0, 2}, 4, {1, 3, 0, 2, 5, 4});
        row("before one of them", {1, 3}, 3, {0, 2, 1, 3, 4, 5});
        row("where they stand", {2, 3}, 3, {0, 1, 2, 3, 4, 5});
        row("after where they stand", {2, 3}, 4, {0, 1, 2, 3, 4, 5});
        row("out of range", {2}, 7, {0, 1, 2, 3, 4, 5});
    }
    void movesTogether() {
        QFETCH(Rows, rows);
        QFETCH(std::size_t, to);
        QFETCH(std::vector<int>, after);
        Session& session = *m_session;
        session.hits().move(rows, to);
        QCOMPARE(state(session), after);
        if (after != upTo(6)) {
            QCOMPARE(session.steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::Move, rows.size(),
                                                                  rows.size() == 1 ? rows[0] + 1 : 0}));
            session.undo();
            QCOMPARE(state(session), upTo(6));
            session.redo();
            QCOMPARE(state(session), after);
        } else {
            QCOMPARE(session.steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::Hit, 1, 6}));
        }
    }

    void movesByOne_data() {
        QTest::addColumn<Rows>("rows");
        QTest::addColumn<std::vector<int>>("up");
        QTest::addColumn<std::vector<int>>("down");
        const auto row = [](const char* name, Rows rows, std::vector<int> up, std::vector<int> down) {
            QTest::newRow(name) << rows << up << down;
        };
        row("one", {3}, {0, 1, 3, 2, 4, 5}, {0, 1, 2, 4, 3, 5});
        row("a block", {2, 3}, {0, 2, 3, 1, 4, 5}, {0, 1, 4, 2, 3, 5});
        row("apart", {3, 1}, {1, 0, 3, 2, 4, 5}, {0, 2, 1, 4, 3, 5});
        row("one at the top", {0, 2}, {0, 2, 1, 3, 4, 5}, {1, 0, 3, 2, 4, 5});
        row("one at the end", {3, 5}, {0, 1, 3, 2, 5, 4}, {0, 1, 2, 4, 3, 5});
        row("blocks at both ends", {0, 1, 4, 5}, {0, 1, 2, 4, 5, 3}, {2, 0, 1, 3, 4, 5});
        row("all", {0, 1, 2, 3, 4, 5}, upTo(6), upTo(6));
        row("none", {}, upTo(6), upTo(6));
    }
    void movesByOne() {
        QFETCH(Rows, rows);
        QFETCH(std::vector<int>, up);
        QFETCH(std::vector<int>, down);
        Session& session = *m_session;
        const std::size_t steps = session.steps().size();
        const auto check = [&](const std::vector<int>& after) {
            QCOMPARE(state(session), after);
            QCOMPARE(session.steps().size(), steps + (after == upTo(6) ? 0 : 1));
            if (after != upTo(6)) {
                session.undo();
                QCOMPARE(state(session), upTo(6));
                session.redo();
                QCOMPARE(state(session), after);
                session.undo();
            }
        };
        session.hits().select(3);
        session.hits().moveUp(rows);
        QCOMPARE(session.hits().selected(),
                 std::optional(static_cast<std::size_t>(std::ranges::find(up, 3) - up.begin())));
        check(up);
        session.hits().moveDown(rows);
        check(down);
    }

    void removesManyAtOnce() {
        Session& session = *m_session;
        session.hits().remove(Rows{0, 5, 2, 3});
        QCOMPARE(state(session), (std::vector<int>{1, 4}));
        QCOMPARE(session.steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::Remove, 4}));
        session.undo();
        QCOMPARE(state(session), upTo(6));
    }

    /// So many apart that they are one edit over all between.
    void scatteredRowsToo() {
        Session& session = *m_session;
        addHits(session, 494);
        Rows even;
        std::vector<int> odd;
        std::vector<int> moved;
        for (int i = 0; i < 500; i += 2) {
            even.push_back(static_cast<std::size_t>(i));
            odd.push_back(i + 1);
            moved.push_back(i);
        }
        moved.insert(moved.begin(), odd.begin(), odd.begin() + 100);
        moved.insert(moved.end(), odd.begin() + 100, odd.end());
        session.hits().move(even, 200);
        QCOMPARE(state(session), moved);
        session.undo();
        QCOMPARE(state(session), upTo(500));
        session.hits().remove(even);
        QCOMPARE(state(session), odd);
        session.undo();
        QCOMPARE(state(session), upTo(500));
        std::vector<int> swapped = upTo(500);
        for (std::size_t i = 0; i < 500; i += 2) {
            std::swap(swapped[i], swapped[i + 1]);
        }
        session.hits().moveDown(even);
        QCOMPARE(state(session), swapped);
        session.undo();
        Rows uneven;
        for (const std::size_t row : even) {
            uneven.push_back(row + 1);
        }
        session.hits().moveUp(uneven);
        QCOMPARE(state(session), swapped);
        session.undo();
        QCOMPARE(state(session), upTo(500));
    }

    void selectedHitGoesWhereItsHitGoes() {
        Session& session = *m_session;
        const QSignalSpy selected(&session.hits(), &SessionHits::selectedChanged);
        session.hits().select(4);
        session.hits().move(Rows{4}, 1);
        QCOMPARE(session.hits().selected(), std::optional<std::size_t>(1));
        session.hits().remove(0);
        QCOMPARE(session.hits().selected(), std::optional<std::size_t>(0));
        session.undo();
        QCOMPARE(session.hits().selected(), std::optional<std::size_t>(1));
        session.undo();
        QCOMPARE(session.hits().selected(), std::optional<std::size_t>(4));
        session.hits().setEnabled(Rows{4}, false);
        QCOMPARE(session.hits().selected(), std::optional<std::size_t>(4));
        QCOMPARE(selected.size(), 5);
        session.hits().remove(4);
        QVERIFY(!session.hits().selected());
        QCOMPARE(selected.size(), 6);
    }

    void rowsSayWhereEachHitWent() {
        Session& session = *m_session;
        std::optional<HitRows> rows;
        const auto connection = connect(&session.hits(), &SessionHits::rearranged, this,
                                        [&rows](const HitRows& now) { rows = now; });
        session.hits().move(Rows{0, 1}, 4);
        const std::array<std::size_t, 6> after{2, 3, 0, 1, 4, 5};
        for (std::size_t i = 0; i < after.size(); ++i) {
            QCOMPARE(rows->now(i), std::optional(after[i]));
        }
        session.hits().remove(Rows{1, 4});
        QCOMPARE(rows->size(), std::size_t{4});
        QVERIFY(!rows->now(1) && !rows->now(4));
        QCOMPARE(rows->now(5), std::optional<std::size_t>(3));
        session.undo();
        QCOMPARE(rows->now(3), std::optional<std::size_t>(5));
        session.hits().clear();
        QVERIFY(!rows->now(0));
        disconnect(connection);
    }

    void equalHitsKeepTheirOrder() {
        HitHistory history;
        const std::vector<Hit> same(4);
        history.append(same);
        const std::vector<HistoryEdit> edits{history.splice(1, 2, {}),
                                             history.splice(2, 0, {same.data(), 2})};
        const HitRows rows(4, edits);
        QCOMPARE(rows.now(1), std::optional<std::size_t>(2));
        QCOMPARE(rows.now(2), std::optional<std::size_t>(3));
    }

    /// Also where one edit does it, over all hits between.
    void hitsThatChangePlacesAreNotEdited() {
        HitHistory history;
        std::vector<Hit> hits(3);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            hits[i].point.x = static_cast<float>(i);
        }
        history.append(hits);
        const HistoryEdit moved = history.splice(0, 3, std::array{hits[2], hits[0], hits[1]});
        QVERIFY(!keepsPlaces(moved));
        const HitRows rows(3, {&moved, 1});
        QCOMPARE(rows.now(0), std::optional<std::size_t>(1));
        QCOMPARE(rows.now(2), std::optional<std::size_t>(0));
        for (Hit& hit : hits) {
            hit.direction = {1.0f, 0.0f, 0.0f};
        }
        QVERIFY(keepsPlaces(history.splice(0, 3, std::array{hits[2], hits[0], hits[1]})));
        hits[0].time = 1.0;
        hits[1].time = 2.0;
        QVERIFY(!keepsPlaces(history.splice(0, 2, std::array{hits[0], hits[1]})));  // others
    }

    void everyChangeHasItsName() {
        Session& session = *m_session;
        DeformationConstants constants;
        constants.power = 0.2f;
        QVERIFY(session.settings().setConstants(constants));
        session.hits().giveConstantsToAll();
        QCOMPARE(session.steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::HitConstants, 6}));
        session.hits().clear();
        QCOMPARE(session.steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::Clear, 6}));
        QVERIFY(!session.steps().toRedo());
    }

    void capacityIsPassedOn() {
        const QSignalSpy changed(&m_session->readBack(), &ReadBack::capacityChanged);
        test::readBackOf(*m_session).setCapacity({4, false, 4, {0, 3}});
        QCOMPARE(m_session->readBack().droppedHits(), std::size_t{2});
        QVERIFY(m_session->readBack().isDropped(0) && !m_session->readBack().isDropped(1) &&
                m_session->readBack().isDropped(3));
        test::readBackOf(*m_session).setCapacity({4, false, 4, {0, 3}});
        QCOMPARE(changed.size(), 1);
        loadTeapot(*m_session);
        QCOMPARE(m_session->readBack().droppedHits(), std::size_t{0});
        QCOMPARE(changed.size(), 2);
    }

    void unavailablePipelinesHaveAReason() {
        const QSignalSpy changed(&m_session->readBack(), &ReadBack::unavailablePipelinesChanged);
        QVERIFY(m_session->readBack().whyUnavailable(PipelineKind::UniformArray).isEmpty());
        test::readBackOf(*m_session)
            .setUnavailablePipelines({{PipelineKind::UniformArray, QStringLiteral("Too old.")}});
        QCOMPARE(m_session->readBack().whyUnavailable(PipelineKind::UniformArray),
                 QStringLiteral("Too old."));
        QVERIFY(m_session->readBack().whyUnavailable(PipelineKind::TransformFeedback).isEmpty());
        QCOMPARE(changed.size(), 1);
    }

private:
    std::unique_ptr<Session> m_session;
};

HITSCOPE_TEST(SessionHistoryTest, QCoreApplication)

}  // namespace hitscope::session_history_test

#include "session_history_test.moc"
