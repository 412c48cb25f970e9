// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/vertex_changes_model.h"

#include <QAbstractItemModelTester>
#include <QPersistentModelIndex>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <set>

#include "deform/deform.h"
#include "models/read_back_support.h"
#include "session/primitive_target.h"
#include "session/vertex_selection.h"
#include "support/test_program.h"

namespace hitscope::vertex_changes_model_test {

using namespace test;
using Column = VertexChangesModel::Column;

class VertexChangesModelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_tester.reset();
        m_model.reset();
        m_effects.reset();
        m_session = std::make_unique<Session>();
        loadPaperRow(*m_session, kDefaultPaperRow);
        m_session->targets().select(m_session->targets()[10]->id);
        m_effects = std::make_unique<HitEffects>(*m_session);
        m_model = std::make_unique<VertexChangesModel>(*m_session, *m_effects);
        m_tester = std::make_unique<QAbstractItemModelTester>(
            m_model.get(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    }
    void cleanup() { m_tester.reset(); }

    void showsWhatIsChanged() {
        QCOMPARE(m_model->rowCount(), 0);
        hit(30, 1);
        QVERIFY(follows());
        QVERIFY(m_model->rowCount() > 100);
        const int row = m_model->rowCount() / 2;
        const std::uint32_t vertex = m_model->vertexAt(row);
        const VertexFacts facts = vertexFacts(target().deformed, vertex);
        QVERIFY(facts.length > 0.0);
        QCOMPARE(raw(row, Column::NumberColumn).toULongLong(), qulonglong{vertex} + 1);
        QCOMPARE(raw(row, Column::LengthColumn).toDouble(), facts.length);
        QCOMPARE(raw(row, Column::TurnedColumn).toDouble(), facts.turned);
        QCOMPARE(raw(row, Column::CurrentColumn).toList().at(1).toDouble(),
                 static_cast<double>(facts.current.y));
        m_effects->finish();
        QCOMPARE(raw(row, Column::HitsColumn).toULongLong(), hitsThatMoved(vertex));
        QVERIFY(hitsThatMoved(vertex) > 0);
    }

    void followsHitsThatStreamIn() {
        m_model->sort(Column::LengthColumn, Qt::DescendingOrder);
        for (unsigned round = 0; round < 25; ++round) {
            hit(4, 100 + round);
            QTest::qWait(static_cast<int>(round % 4) * 20);
        }
        QVERIFY(follows());
        QVERIFY(isSorted());
        for (int i = 0; i < 6; ++i) {
            m_session->undo();
            readBack(*m_session);
            QTest::qWait(i * 15);
        }
        QVERIFY(follows());
        m_session->hits().clear();
        readBack(*m_session);
        QVERIFY(follows());
        QCOMPARE(m_model->rowCount(), 0);
        m_session->undo();
        readBack(*m_session);
        QVERIFY(follows());
        QVERIFY(isSorted());
        QVERIFY(m_model->rowCount() > 100);
    }

    void sortsByEveryColumn_data() {
        QTest::addColumn<int>("column");
        QTest::addColumn<bool>("descending");
        for (int column = 0; column < VertexChangesModel::ColumnCount; ++column) {
            QTest::addRow("%d up", column) << column << false;
            QTest::addRow("%d down", column) << column << true;
        }
    }
    void sortsByEveryColumn() {
        QFETCH(int, column);
        QFETCH(bool, descending);
        hit(40, 3);
        m_effects->finish();
        QVERIFY(follows());
        m_model->sort(column, descending ? Qt::DescendingOrder : Qt::AscendingOrder);
        QVERIFY(follows());
        const auto key = [&](int row) -> std::vector<double> {
            const QVariant value = raw(row, column);
            std::vector<double> numbers;
            if (value.typeId() == QMetaType::QVariantList) {
                for (const QVariant& part : value.toList()) {
                    numbers.push_back(part.toDouble());
                }
            } else {
                numbers.push_back(static_cast<double>(value.toFloat()));
            }
            return numbers;
        };
        for (int row = 1; row < m_model->rowCount(); ++row) {
            QVERIFY(descending ? key(row - 1) >= key(row) : key(row - 1) <= key(row));
        }
    }

    void filters() {
        hit(40, 5);
        QVERIFY(follows());
        const int all = m_model->rowCount();
        m_model->setLeastDisplacement(0.15);
        QVERIFY(follows());
        QVERIFY(m_model->rowCount() > 0 && m_model->rowCount() < all);
        for (int row = 0; row < m_model->rowCount(); ++row) {
            QVERIFY(raw(row, Column::LengthColumn).toDouble() >= 0.1499999);
        }
        m_model->setLeastDisplacement(0.0);
        m_model->setFilter(VertexChangesModel::Filter::Selected);
        QVERIFY(follows());
        QCOMPARE(m_model->rowCount(), 0);
        std::vector<std::uint32_t> everyThird(target().deformed.positions().size() / 3);
        std::iota(everyThird.begin(), everyThird.end(), 0u);
        std::for_each(everyThird.begin(), everyThird.end(), [](std::uint32_t& vertex) { vertex *= 3; });
        m_session->selection().select(target().id, everyThird, VertexSelection::Combine::Replace);
        QVERIFY(follows());
        QVERIFY(m_model->rowCount() > 0 && m_model->rowCount() < all / 2);
        for (int row = 0; row < m_model->rowCount(); ++row) {
            QCOMPARE(m_model->vertexAt(row) % 3, 0u);
            QVERIFY(m_model->index(row, 0).data(VertexChangesModel::SelectedRole).toBool());
        }
        m_session->selection().clear();
        QVERIFY(follows());
        QCOMPARE(m_model->rowCount(), 0);
        m_model->setFilter(VertexChangesModel::Filter::AllChanged);
        QVERIFY(follows());
        QCOMPARE(m_model->rowCount(), all);
    }

    void showsWhatOneHitMoved() {
        hit(40, 6);
        m_model->setFilter(VertexChangesModel::Filter::MovedBySelectedHit);
        QVERIFY(follows());
        QCOMPARE(m_model->rowCount(), 0);
        m_session->hits().select(7);
        m_effects->finish();
        // By the reference: run up to the hit, then see whom it moves.
        ReferenceDeformation before(target().deformed.render());
        before.apply(m_session->hits().history().hits().first(7));
        std::set<std::uint32_t> moved;
        for (std::size_t v = 0; v < before.vertices().size(); ++v) {
            DynamicVertex vertex = before.vertices()[v];
            if (deform(vertex.position, vertex.normal, m_session->hits().history().hits()[7])) {
                moved.insert(target().deformed.render().fileVertices[v]);
            }
        }
        QVERIFY(!moved.empty());
        QTRY_COMPARE_WITH_TIMEOUT(m_model->rowCount(), static_cast<int>(moved.size()), kPatience);
        for (int row = 0; row < m_model->rowCount(); ++row) {
            QVERIFY(moved.contains(m_model->vertexAt(row)));
        }
        m_session->hits().select(std::nullopt);
        QVERIFY(follows());
        QCOMPARE(m_model->rowCount(), 0);
    }

    void keepsPlacesWhileRowsMove() {
        m_model->sort(Column::LengthColumn, Qt::DescendingOrder);
        hit(20, 7);
        QVERIFY(follows());
        const QPersistentModelIndex kept(m_model->index(m_model->rowCount() / 2, Column::LengthColumn));
        const std::uint32_t vertex = m_model->vertexAt(kept.row());
        hit(60, 8);
        QVERIFY(follows());
        QVERIFY(kept.isValid());
        QCOMPARE(m_model->vertexAt(kept.row()), vertex);
        QCOMPARE(m_model->rowOf(vertex), kept.row());
        QCOMPARE(m_model->rowOf(0xffffffu), -1);
    }

    void followsTheTargetInFocus() {
        hit(20, 9);
        QVERIFY(follows());
        QVERIFY(m_model->rowCount() > 0);
        const TargetId first = target().id;
        m_session->targets().select(m_session->targets()[11]->id);
        QVERIFY(follows());
        QCOMPARE(m_model->rowCount(), 0);
        m_session->targets().select(first);
        QVERIFY(follows());
        QVERIFY(m_model->rowCount() > 0);
        m_session->targets().remove(std::array{first});
        QVERIFY(follows());
        QVERIFY(m_model->target()->id != first);
        loadPaperRow(*m_session, 0);
        QVERIFY(follows());
        QCOMPARE(m_model->rowCount(), 0);
        m_session->loadScene({});
        QCOMPARE(m_model->target(), nullptr);
        QCOMPARE(m_model->rowCount(), 0);
    }

    void writesCsv() {
        hit(20, 10);
        m_model->sort(Column::NumberColumn, Qt::AscendingOrder);
        m_effects->finish();
        QVERIFY(follows());
        std::vector<std::uint32_t> all;
        for (int row = 0; row < m_model->rowCount(); ++row) {
            all.push_back(m_model->vertexAt(row));
        }
        const QByteArray text = csv(m_model->table(all));
        const QList<QByteArray> lines = text.trimmed().split('\n');
        QCOMPARE(lines.size(), m_model->rowCount() + 1);
        const QList<QByteArray> titles = lines.front().split(',');
        const QList<QByteArray> numbers = lines.at(5).split(',');
        QCOMPARE(numbers.size(), titles.size());
        const std::uint32_t vertex = m_model->vertexAt(4);
        QCOMPARE(numbers.at(0).toULongLong(), qulonglong{vertex} + 1);
        QCOMPARE(numbers.at(5).toFloat(), target().deformed.positions()[vertex].y);
        QCOMPARE(numbers.at(7).toFloat(), target().deformed.displacement(vertex).x);
        QCOMPARE(numbers.at(12).toULongLong(), hitsThatMoved(vertex));

        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("changes.csv"));
        QSignalSpy saved(m_model.get(), &VertexChangesModel::saved);
        m_model->saveCsv(path);
        QVERIFY(saved.wait());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), text);
        m_model->saveCsv(folder.filePath(QStringLiteral("no/such/folder.csv")));
        QVERIFY(saved.wait());
        QVERIFY(saved.last().at(1).value<std::optional<Error>>().has_value());
    }

    void aMillionRows() {
        m_tester.reset();  // it goes through all of them again and again
        ScenePlan plan;
        plan.targets.push_back(planPrimitive({PrimitiveKind::Sheet, 1000, 10.0f}));
        m_session->loadScene(std::move(plan));
        const Target& sheet = *m_session->targets().front();
        QVERIFY(sheet.deformed.positions().size() > 1'000'000);
        Hit everywhere;
        everywhere.target = sheet.id;
        everywhere.point = sheet.deformed.positions()[501'000];
        everywhere.constants.maxDistance = 10.0f;
        QVERIFY(m_session->hits().add(everywhere).ok());
        readBack(*m_session);
        m_model->sort(Column::LengthColumn, Qt::DescendingOrder);
        QVERIFY(follows(60'000));
        QVERIFY(m_model->rowCount() > 1'000'000);
        QVERIFY(isInOrderThroughout());
        const std::vector<std::uint32_t> before = topRows(1000);
        everywhere.constants.maxDistance = 0.2f;
        everywhere.point = sheet.deformed.positions()[801'200];
        QVERIFY(m_session->hits().add(everywhere).ok());
        readBack(*m_session);
        QVERIFY(follows(60'000));
        // The second hit moved some to the top, and every row says what its vertex is now.
        QVERIFY(topRows(1000) != before);
        QVERIFY(isInOrderThroughout());
        QVERIFY(m_model->rowCount() > 1'000'000);
    }

private:
    [[nodiscard]] const Target& target() const { return *m_model->target(); }
    [[nodiscard]] QVariant raw(int row, int column) const {
        return m_model->index(row, column).data(VertexChangesModel::RawValueRole);
    }
    void hit(std::size_t count, unsigned seed) {
        QVERIFY(m_session->hits().add(randomHits(target(), count, seed)).ok());
        readBack(*m_session);
    }
    [[nodiscard]] qulonglong hitsThatMoved(std::uint32_t vertex) const {
        DynamicVertex moved =
            target().deformed.render().vertices[target().deformed.render().renderVerticesOf(vertex)[0]];
        qulonglong count = 0;
        for (const Hit& hit : m_session->hits().history().hits()) {
            count += hit.target == target().id && deform(moved.position, moved.normal, hit) ? 1 : 0;
        }
        return count;
    }
    /// Whether the rows come to be the changed vertices (of a filtered model: some of them).
    [[nodiscard]] bool follows(int patience = 10'000) {
        if (!QTest::qWaitFor([this] { return m_model->isUpToDate(); }, patience)) {
            return false;
        }
        std::set<std::uint32_t> shown;
        for (int row = 0; row < m_model->rowCount(); ++row) {
            if (!target().deformed.isChanged(m_model->vertexAt(row)) ||
                !shown.insert(m_model->vertexAt(row)).second) {
                return false;
            }
        }
        return m_model->filter() != VertexChangesModel::Filter::AllChanged ||
               m_model->leastDisplacement() > 0.0 ||
               shown.size() == target().deformed.statistics().changedVertices;
    }
    /// Whether the lengths of all rows go down, and those of some are what their vertices are moved by.
    [[nodiscard]] bool isInOrderThroughout() const {
        float last = std::numeric_limits<float>::infinity();
        for (int row = 0; row < m_model->rowCount(); ++row) {
            const float length = glm::length(target().deformed.displacement(m_model->vertexAt(row)));
            // Roots of nearly equal squares may round either way.
            if (length > last * (1.0f + 1e-6f) ||
                (row % 4999 == 0 &&
                 std::abs(raw(row, Column::LengthColumn).toFloat() - length) > 1e-6f * length)) {
                return false;
            }
            last = length;
        }
        return true;
    }
    [[nodiscard]] std::vector<std::uint32_t> topRows(int count) const {
        std::vector<std::uint32_t> vertices;
        for (int row = 0; row < count; ++row) {
            vertices.push_back(m_model->vertexAt(row));
        }
        return vertices;
    }
    [[nodiscard]] bool isSorted() const {
        for (int row = 1; row < m_model->rowCount(); ++row) {
            if (raw(row - 1, Column::LengthColumn).toFloat() < raw(row, Column::LengthColumn).toFloat()) {
                return false;
            }
        }
        return true;
    }

    std::unique_ptr<Session> m_session;
    std::unique_ptr<HitEffects> m_effects;
    std::unique_ptr<VertexChangesModel> m_model;
    std::unique_ptr<QAbstractItemModelTester> m_tester;
};

HITSCOPE_TEST(VertexChangesModelTest, QCoreApplication)

}  // namespace hitscope::vertex_changes_model_test

#include "vertex_changes_model_test.moc"
