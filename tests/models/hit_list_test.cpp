// SPDX-License-Identifier: GPL-3.0-or-later
// The hit history filtered and sorted, under the model tester while hits stream in.
#include "models/hit_list.h"

#include <QAbstractItemModelTester>
#include <QItemSelectionModel>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <array>
#include <random>

#include "analysis/hit_effects.h"
#include "support/test_program.h"

namespace hitscope::hit_list_test {

class HitListTest : public QObject {
    Q_OBJECT
private:
    void add(std::size_t target, float x, bool enabled = true) const {
        Hit hit;
        hit.target = m_session->targets()[target]->id;
        hit.point = {x, 0.0f, 2.5f};
        hit.speed = x;
        hit.time = static_cast<double>(m_session->hits().history().size());
        hit.enabled = enabled;
        hit.pipeline =
            static_cast<std::uint8_t>(target % 2 == 0 ? PipelineKind::Compute : PipelineKind::Reference);
        QVERIFY(m_session->hits().add(hit).ok());
    }
    /// The numbers of the hits as they are listed.
    [[nodiscard]] std::vector<int> listed() const {
        std::vector<int> numbers;
        for (int row = 0; row < m_list->rowCount(); ++row) {
            numbers.push_back(m_list->index(row, HitHistoryModel::NumberColumn)
                                  .data(HitHistoryModel::RawValueRole)
                                  .toInt());
        }
        return numbers;
    }

    std::unique_ptr<Session> m_session;
    std::unique_ptr<HitEffects> m_effects;
    std::unique_ptr<HitHistoryModel> m_model;
    std::unique_ptr<HitList> m_list;
    std::unique_ptr<QAbstractItemModelTester> m_tester;

private Q_SLOTS:
    void init() {
        cleanup();
        m_session = std::make_unique<Session>();
        loadPaperRow(*m_session, kDefaultPaperRow);
        m_effects = std::make_unique<HitEffects>(*m_session);
        m_model = std::make_unique<HitHistoryModel>(*m_session, m_effects.get());
        m_list = std::make_unique<HitList>(*m_session, *m_model);
        m_tester = std::make_unique<QAbstractItemModelTester>(
            m_list.get(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    }
    void cleanup() {
        m_tester.reset();
        m_list.reset();
        m_model.reset();
        m_effects.reset();
        m_session.reset();
    }

    void listsAllAtFirst() {
        add(0, 1.0f);
        add(1, 2.0f);
        QCOMPARE(listed(), (std::vector<int>{1, 2}));
        QVERIFY(m_list->isInOrder());
        QCOMPARE(m_list->headerData(HitHistoryModel::PointColumn, Qt::Horizontal).toString(),
                 QStringLiteral("Point (m)"));
    }

    /// A selection that is told of no hint keeps an index a cell, and takes seconds over some hundred rows.
    void aLongSelectionIsKeptByRows() {
        for (int i = 0; i < 60; ++i) {
            add(static_cast<std::size_t>(i % 3), static_cast<float>(i));
        }
        QItemSelectionModel selection(m_list.get());
        selection.select({m_list->index(5, 0), m_list->index(49, HitHistoryModel::ColumnCount - 1)},
                         QItemSelectionModel::Select);
        std::vector<QAbstractItemModel::LayoutChangeHint> hints;
        for (QAbstractItemModel* model : {static_cast<QAbstractItemModel*>(m_list.get()),
                                          static_cast<QAbstractItemModel*>(m_model.get())}) {
            const auto take = [&hints](const QList<QPersistentModelIndex>&,
                                       QAbstractItemModel::LayoutChangeHint hint) { hints.push_back(hint); };
            connect(model, &QAbstractItemModel::layoutAboutToBeChanged, m_list.get(), take);
            connect(model, &QAbstractItemModel::layoutChanged, m_list.get(), take);
        }
        const auto selected = [&selection] {
            std::vector<int> rows;
            for (const QModelIndex& index : selection.selectedRows()) {
                rows.push_back(index.row());
            }
            std::sort(rows.begin(), rows.end());
            return rows;
        };
        m_session->hits().remove(2);
        QCOMPARE(selected().size(), std::size_t{45});
        QCOMPARE(selected().front(), 4);
        m_session->hits().remove(10);
        QCOMPARE(selected().size(), std::size_t{44});
        m_session->undo();
        QCOMPARE(selected().size(), std::size_t{44});
        m_list->sort(HitHistoryModel::NumberColumn, Qt::DescendingOrder);
        QCOMPARE(selected().size(), std::size_t{44});
        QVERIFY(hints.size() >= 14);
        QVERIFY(std::all_of(hints.begin(), hints.end(),
                            [](auto hint) { return hint == QAbstractItemModel::VerticalSortHint; }));
    }

    void filtersByNumbersAsTheyAreShown() {
        std::vector<Hit> hits(1005);
        for (Hit& hit : hits) {
            hit.target = m_session->targets()[0]->id;
        }
        QVERIFY(m_session->hits().add(hits).ok());
        const QString shown = m_list->index(1003, HitHistoryModel::NumberColumn).data().toString();
        QCOMPARE(shown, QStringLiteral("1,004"));
        m_list->setFilter({shown, {}, false});
        QCOMPARE(listed(), (std::vector<int>{1004}));
        m_list->setFilter({QStringLiteral("1004"), {}, false});
        QCOMPARE(listed(), (std::vector<int>{1004}));
        m_list->setFilter({QStringLiteral(","), {}, false});
        QCOMPARE(listed(), std::vector<int>());
    }

    void aMovedTargetFiltersNothingAnew() {
        add(0, 1.0f);
        add(1, 2.0f);
        m_list->setFilter({QStringLiteral("cube 2"), {}, false});
        const TargetId moved = m_session->targets()[0]->id;
        QVERIFY(m_session->targets().rename(moved, QStringLiteral("cube 22")).ok());
        QVERIFY(!m_list->isSettled());
        QTRY_COMPARE_WITH_TIMEOUT(listed(), (std::vector<int>{1, 2}), kPatience);
        RigidTransform there = m_session->targets()[0]->transform;
        there.position.y += 1.0f;
        const QString before = m_list->index(0, HitHistoryModel::WorldPointColumn).data().toString();
        QVERIFY(m_session->targets().setTransform(moved, there).ok());
        QVERIFY(m_list->isSettled());
        QVERIFY(m_list->index(0, HitHistoryModel::WorldPointColumn).data().toString() != before);
    }

    void filters() {
        for (int i = 0; i < 12; ++i) {
            add(static_cast<std::size_t>(i % 3), static_cast<float>(i), i != 4);
        }
        m_list->setFilter({{}, m_session->targets()[1]->id, false});
        QCOMPARE(listed(), (std::vector<int>{2, 5, 8, 11}));
        m_list->setFilter({{}, m_session->targets()[1]->id, true});
        QCOMPARE(listed(), (std::vector<int>{2, 8, 11}));
        m_list->setFilter({QStringLiteral("1"), {}, true});
        QVERIFY(listed().size() >= 4);  // in a number, or in a target's name
        m_list->setFilter({QStringLiteral("REFER"), {}, false});
        QCOMPARE(listed(), (std::vector<int>{2, 5, 8, 11}));
        m_list->setFilter({m_session->targets()[2]->name, m_session->targets()[1]->id, false});
        QVERIFY(listed().empty());
        m_list->setFilter({{}, m_session->targets()[0]->id, false});
        const QSignalSpy inserted(m_list.get(), &QAbstractItemModel::rowsInserted);
        add(0, 20.0f);
        add(1, 21.0f);
        QCOMPARE(listed(), (std::vector<int>{1, 4, 7, 10, 13}));
        QCOMPARE(inserted.size(), 1);
        m_session->hits().setEnabled(std::array<std::size_t, 1>{3}, false);
        m_list->setFilter({{}, m_session->targets()[0]->id, true});
        QCOMPARE(listed(), (std::vector<int>{1, 7, 10, 13}));
        m_session->hits().setEnabled(std::array<std::size_t, 1>{6}, false);
        QTRY_COMPARE_WITH_TIMEOUT(listed(), (std::vector<int>{1, 10, 13}), kPatience);
        m_list->setFilter({});
        QCOMPARE(m_list->rowCount(), 14);
    }

    void sorts() {
        for (const float x : {3.0f, 1.0f, 2.0f, 1.0f}) {
            add(0, x);
        }
        m_list->sort(HitHistoryModel::SpeedColumn, Qt::AscendingOrder);
        QCOMPARE(listed(), (std::vector<int>{2, 4, 3, 1}));
        QVERIFY(!m_list->isInOrder());
        QVERIFY(!m_list->index(0, 0).flags().testFlag(Qt::ItemIsDragEnabled));
        m_list->sort(HitHistoryModel::SpeedColumn, Qt::DescendingOrder);
        QCOMPARE(listed(), (std::vector<int>{1, 3, 2, 4}));
        add(0, 2.5f);
        QTRY_COMPARE_WITH_TIMEOUT(listed(), (std::vector<int>{1, 5, 3, 2, 4}), kPatience);
        m_list->sort(HitHistoryModel::NumberColumn, Qt::DescendingOrder);
        QCOMPARE(listed(), (std::vector<int>{5, 4, 3, 2, 1}));
        m_list->sort(-1, Qt::AscendingOrder);
        QCOMPARE(listed(), (std::vector<int>{1, 2, 3, 4, 5}));
        QVERIFY(m_list->index(0, 0).flags().testFlag(Qt::ItemIsDragEnabled));
        m_list->sort(HitHistoryModel::AffectedColumn, Qt::DescendingOrder);
        m_effects->finish();
        QTRY_VERIFY_WITH_TIMEOUT(m_list->isSettled(), kPatience);
        std::uint32_t last = 0xffffffffu;
        for (const int number : listed()) {
            const std::uint32_t affected = m_effects->effect(static_cast<std::size_t>(number) - 1)->affected;
            QVERIFY(affected <= last);
            last = affected;
        }
    }

    void manyAreSortedBesides() {
        std::vector<Hit> hits(20'000);
        std::mt19937 random(4);
        for (Hit& hit : hits) {
            hit.target = m_session->targets()[random() % 16]->id;
            hit.point.x = 50.0f;
            hit.speed = static_cast<float>(random() % 1000);
        }
        QVERIFY(m_session->hits().add(hits).ok());
        m_list->sort(HitHistoryModel::SpeedColumn, Qt::AscendingOrder);
        QVERIFY(!m_list->isSettled());
        QTRY_VERIFY_WITH_TIMEOUT(m_list->isSettled(), kPatience);
        float last = -1.0f;
        for (const int number : listed()) {
            const float speed =
                m_session->hits().history().hits()[static_cast<std::size_t>(number) - 1].speed;
            QVERIFY(speed >= last);
            last = speed;
        }
        QCOMPARE(m_list->rowCount(), 20'000);
        // Of a sorting that is under way when the rows change nothing comes.
        m_list->sort(HitHistoryModel::SpeedColumn, Qt::DescendingOrder);
        m_session->hits().clear();
        QTRY_VERIFY_WITH_TIMEOUT(m_list->isSettled(), kPatience);
        QTest::qWait(50);
        QCOMPARE(m_list->rowCount(), 0);
    }

    /// The list is the history's until the first sorting is done, which goes without the newcomer.
    void hitsThatComeDuringSortingAreListed() {
        std::vector<Hit> hits(20'000);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            hits[i].target = m_session->targets()[0]->id;
            hits[i].point.x = 50.0f;
            hits[i].speed = static_cast<float>((i * 7919) % 1000);
        }
        QVERIFY(m_session->hits().add(hits).ok());
        m_effects->finish();
        m_list->sort(HitHistoryModel::SpeedColumn, Qt::AscendingOrder);
        QVERIFY(!m_list->isSettled());
        add(0, 5000.0f);
        QTRY_VERIFY_WITH_TIMEOUT(m_list->isSettled(), kPatience);
        QCOMPARE(m_list->rowCount(), 20'001);
        QCOMPARE(listed().back(), 20'001);
    }

    void dropsAmongTheListed() {
        for (int i = 0; i < 6; ++i) {
            add(static_cast<std::size_t>(i % 2), static_cast<float>(i));
        }
        m_list->setFilter({{}, m_session->targets()[0]->id, false});  // 1, 3, 5
        const std::unique_ptr<QMimeData> first(m_list->mimeData({m_list->index(0, 0)}));
        QVERIFY(m_list->dropMimeData(first.get(), Qt::MoveAction, 2, 0, {}));
        const auto xs = [this] {
            std::vector<int> found;
            for (const Hit& hit : m_session->hits().history().hits()) {
                found.push_back(static_cast<int>(hit.point.x));
            }
            return found;
        };
        QCOMPARE(xs(), (std::vector<int>{1, 2, 3, 0, 4, 5}));
        const std::unique_ptr<QMimeData> again(m_list->mimeData({m_list->index(0, 0)}));
        QVERIFY(m_list->dropMimeData(again.get(), Qt::MoveAction, -1, -1, {}));
        QCOMPARE(xs(), (std::vector<int>{1, 3, 0, 4, 2, 5}));
        m_list->sort(HitHistoryModel::SpeedColumn, Qt::AscendingOrder);
        QVERIFY(!m_list->dropMimeData(again.get(), Qt::MoveAction, 0, 0, {}));
    }

    void persistentIndexesStayWithTheirHits() {
        for (int i = 0; i < 8; ++i) {
            add(static_cast<std::size_t>(i % 2), static_cast<float>(10 - i));
        }
        const QPersistentModelIndex third(m_list->index(2, HitHistoryModel::SpeedColumn));
        const QPersistentModelIndex fourth(m_list->index(3, HitHistoryModel::SpeedColumn));
        m_list->sort(HitHistoryModel::SpeedColumn, Qt::AscendingOrder);
        QCOMPARE(third.data().toString(), QStringLiteral("8.00"));
        QCOMPARE(third.row(), 5);
        m_list->setFilter({{}, m_session->targets()[0]->id, false});
        QCOMPARE(third.data().toString(), QStringLiteral("8.00"));
        QVERIFY(!fourth.isValid());
        m_session->hits().remove(0);
        QCOMPARE(third.data().toString(), QStringLiteral("8.00"));
        m_list->setFilter({});
        QCOMPARE(third.data().toString(), QStringLiteral("8.00"));
        m_session->hits().remove(1);
        QVERIFY(!third.isValid());
    }

    void survivesAnythingWhileHitsStreamIn() {
        std::mt19937 random(1);
        for (int step = 0; step < 600; ++step) {
            add(random() % 4, static_cast<float>(random() % 50));
            const std::size_t hits = m_session->hits().history().size();
            const std::array<std::size_t, 3> some{random() % hits, random() % hits, random() % hits};
            switch (random() % 12) {
                case 0:
                    m_session->hits().setEnabled(some, random() % 2 == 0);
                    break;
                case 1:
                    m_session->hits().move(some, random() % (hits + 1));
                    break;
                case 2:
                    m_session->hits().remove(some);
                    break;
                case 3:
                    m_session->undo();
                    break;
                case 4:
                    m_list->setFilter(
                        {random() % 2 == 0 ? QStringLiteral("1") : QString(),
                         random() % 2 == 0 ? m_session->targets()[random() % 4]->id : TargetId{},
                         random() % 2 == 0});
                    break;
                case 5:
                    m_list->setFilter({});
                    break;
                case 6:
                    m_list->sort(static_cast<int>(random() % HitHistoryModel::ColumnCount),
                                 random() % 2 == 0 ? Qt::AscendingOrder : Qt::DescendingOrder);
                    break;
                case 7:
                    m_list->sort(-1, Qt::AscendingOrder);
                    break;
                case 8: {
                    Hit hit = m_session->hits().history().hits()[some[0]];
                    hit.point.y += 1.0f;
                    hit.constants.power = 0.02f;
                    QVERIFY(m_session->hits().replace(some[0], hit).ok());
                    break;
                }
                case 9:
                    m_session->hits().show(some[1]);
                    break;
                default:
                    QCoreApplication::processEvents();
                    break;
            }
        }
        QTRY_VERIFY_WITH_TIMEOUT(m_list->isSettled(), kPatience);
        m_list->setFilter({});
        QTRY_COMPARE_WITH_TIMEOUT(static_cast<std::size_t>(m_list->rowCount()),
                                  m_session->hits().history().size(), kPatience);
    }
};

HITSCOPE_TEST(HitListTest, QCoreApplication)

}  // namespace hitscope::hit_list_test

#include "hit_list_test.moc"
