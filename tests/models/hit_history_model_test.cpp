// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractItemModelTester>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <array>
#include <memory>

#include "models/hit_history_model.h"
#include "models/quantity_text.h"
#include "support/read_back.h"
#include "support/test_program.h"

namespace hitscope::hit_history_model_test {

namespace {

Hit hitOn(const Session& session, std::size_t target, float x) {
    Hit hit;
    hit.target = session.targets()[target]->id;
    hit.point = {x, 0.5f, -1.25f};
    hit.direction = {0.0f, 0.0f, -1.0f};
    hit.time = 1.5;
    hit.speed = 29.5f;
    hit.impulse = 30.25f;
    return hit;
}

}  // namespace

class HitHistoryModelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void followsEveryChange();
    void appendsAreRowInsertions();
    void cellsSayWhatTheHitIs();
    void csvIsExactAndQuoted();
    void manyHits();
    void checkBoxEnables();
    void statesAreTold();
    void persistentIndexesStayWithTheirHits();
    void dragsRows();
    void survivesAnythingWhileHitsStreamIn();
};

void HitHistoryModelTest::followsEveryChange() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    HitHistoryModel model(session);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(model.rowCount(), 0);

    for (int i = 0; i < 20; ++i) {
        QVERIFY(session.hits()
                    .add(hitOn(session, static_cast<std::size_t>(i % 16), 0.1f * static_cast<float>(i)))
                    .ok());
    }
    QCOMPARE(model.rowCount(), 20);
    session.undo();
    session.undo();
    QCOMPARE(model.rowCount(), 18);
    session.redo();
    QCOMPARE(model.rowCount(), 19);
    session.hits().remove(0);
    QCOMPARE(model.rowCount(), 18);
    QCOMPARE(model.index(0, HitHistoryModel::NumberColumn).data().toString(), QStringLiteral("1"));
    QCOMPARE(model.index(0, HitHistoryModel::TargetColumn).data().toString(), session.targets()[1]->name);
    session.hits().clear();
    QCOMPARE(model.rowCount(), 0);

    QVERIFY(session.hits().add(hitOn(session, 0, 0.0f)).ok());
    loadPaperRow(session, 0);
    QCOMPARE(model.rowCount(), 0);
    QVERIFY(session.hits().add(hitOn(session, 0, 0.0f)).ok());
    QCOMPARE(model.rowCount(), 1);
}

void HitHistoryModelTest::appendsAreRowInsertions() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    HitHistoryModel model(session);
    const QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
    const QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    QVERIFY(session.hits().add(hitOn(session, 0, 0.0f)).ok());
    QVERIFY(session.hits().add(hitOn(session, 1, 0.0f)).ok());
    QCOMPARE(inserted.size(), 2);
    QCOMPARE(inserted.at(1).at(1).toInt(), 1);
    QCOMPARE(inserted.at(1).at(2).toInt(), 1);
    QCOMPARE(reset.size(), 0);
}

void HitHistoryModelTest::cellsSayWhatTheHitIs() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    const HitHistoryModel model(session);
    QVERIFY(session.hits().add(hitOn(session, 2, 0.25f)).ok());
    const auto cell = [&model](int column) { return model.index(0, column).data().toString(); };
    const auto raw = [&model](int column) {
        return model.index(0, column).data(HitHistoryModel::RawValueRole);
    };
    QCOMPARE(cell(HitHistoryModel::NumberColumn), QStringLiteral("1"));
    QCOMPARE(cell(HitHistoryModel::TimeColumn), QStringLiteral("1.50"));
    QCOMPARE(cell(HitHistoryModel::TargetColumn), session.targets()[2]->name);
    QCOMPARE(cell(HitHistoryModel::PointColumn), QStringLiteral("0.250, 0.500, -1.250"));
    QCOMPARE(cell(HitHistoryModel::DirectionColumn), QStringLiteral("0.000, 0.000, -1.000"));
    QCOMPARE(cell(HitHistoryModel::SpeedColumn), QStringLiteral("29.50"));
    QCOMPARE(cell(HitHistoryModel::ImpulseColumn), QStringLiteral("30.25"));
    Hit slow = hitOn(session, 2, 0.25f);
    slow.speed = 0.001f;
    slow.impulse = 0.0f;
    QVERIFY(session.hits().add(slow).ok());
    QCOMPARE(model.index(1, HitHistoryModel::SpeedColumn).data().toString(), quantityText(0.001));
    QCOMPARE(model.index(1, HitHistoryModel::ImpulseColumn).data().toString(), QStringLiteral("0.00"));
    QCOMPARE(raw(HitHistoryModel::SpeedColumn).toDouble(), 29.5);
    QCOMPARE(raw(HitHistoryModel::TargetColumn).toUInt(), session.targets()[2]->id.value);
    QCOMPARE(raw(HitHistoryModel::PointColumn).toList(), (QVariantList{0.25, 0.5, -1.25}));
    QCOMPARE(model.headerData(HitHistoryModel::PointColumn, Qt::Horizontal).toString(),
             QStringLiteral("Point (m)"));
}

void HitHistoryModelTest::csvIsExactAndQuoted() {
    Session session;
    MeshData mesh;
    mesh.name = "a, \"quoted\" mesh";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faceStarts = {0, 3};
    mesh.cornerVertices = {0, 1, 2};
    loadMesh(session, mesh);
    const HitHistoryModel model(session);
    QVERIFY(session.hits().add(hitOn(session, 0, 0.1f)).ok());
    QVERIFY(session.hits().add(hitOn(session, 0, 2.0f)).ok());
    const QString all = model.csv();
    QCOMPARE(all.count(u'\n'), 3);
    const QStringList columns = all.section(u'\n', 0, 0).split(u',');
    const auto fromTheEnd = (columns.size() - columns.indexOf(QStringLiteral("enabled")));
    const auto isEnabled = [fromTheEnd](const QString& row) {
        return row.section(u',', -fromTheEnd, -fromTheEnd);
    };
    const QString first = all.section(u'\n', 1, 1);
    QCOMPARE(isEnabled(first), QStringLiteral("1"));
    session.hits().setEnabled(std::array<std::size_t, 1>{0}, false);
    QCOMPARE(isEnabled(model.csv().section(u'\n', 1, 1)), QStringLiteral("0"));
    QVERIFY2(first.startsWith(QStringLiteral("1,1.5,\"a, \"\"quoted\"\" mesh\",0.1,0.5,-1.25,")),
             qPrintable(first));
    const std::array<std::size_t, 2> rows{1, 99};
    const QString some = model.csv(rows);
    QCOMPARE(some.count(u'\n'), 2);
    QVERIFY(some.section(u'\n', 1, 1).startsWith(QStringLiteral("2,")));
}

void HitHistoryModelTest::manyHits() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    const HitHistoryModel model(session);
    const QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
    constexpr int kMany = 100'000;
    const auto placeOf = [](int i) { return static_cast<float>(i) / 1024.0f; };
    for (int i = 0; i < kMany; ++i) {
        QVERIFY(session.hits().add(hitOn(session, static_cast<std::size_t>(i % 16), placeOf(i))).ok());
    }
    QCOMPARE(model.rowCount(), kMany);
    QCOMPARE(inserted.size(), kMany);
    QCOMPARE(inserted.last()[1].toInt(), kMany - 1);
    QCOMPARE(model.index(kMany - 1, HitHistoryModel::NumberColumn).data().toString(),
             QStringLiteral("100,000"));
    // Each row is its own hit, and stays it when another goes.
    const auto isHit = [&](int row, int hit) {
        return model.index(row, HitHistoryModel::TargetColumn).data().toString() ==
                   session.targets()[static_cast<std::size_t>(hit % 16)]->name &&
               session.hits().history().hits()[static_cast<std::size_t>(row)].point.x == placeOf(hit) &&
               model.index(row, HitHistoryModel::NumberColumn).data().toString() ==
                   QLocale().toString(row + 1);
    };
    for (int row = 0; row < kMany; row += 997) {
        QVERIFY2(isHit(row, row), qPrintable(QString::number(row)));
    }
    session.hits().remove(50'000);
    QCOMPARE(model.rowCount(), kMany - 1);
    QVERIFY(isHit(49'999, 49'999));
    QVERIFY(isHit(50'000, 50'001));
    QVERIFY(isHit(kMany - 2, kMany - 1));
    session.undo();
    QCOMPARE(model.rowCount(), kMany);
    QVERIFY(isHit(50'000, 50'000));
    QVERIFY(isHit(kMany - 1, kMany - 1));
}

void HitHistoryModelTest::checkBoxEnables() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    HitHistoryModel model(session);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    for (int i = 0; i < 3; ++i) {
        QVERIFY(session.hits().add(hitOn(session, 0, 0.1f * static_cast<float>(i))).ok());
    }
    const QModelIndex number = model.index(1, HitHistoryModel::NumberColumn);
    const QModelIndex time = model.index(1, HitHistoryModel::TimeColumn);
    QVERIFY(number.flags().testFlag(Qt::ItemIsUserCheckable));
    QVERIFY(!time.flags().testFlag(Qt::ItemIsUserCheckable));
    QVERIFY(!time.data(Qt::CheckStateRole).isValid());
    QCOMPARE(number.data(Qt::CheckStateRole).toInt(), static_cast<int>(Qt::Checked));
    const QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    const QSignalSpy layout(&model, &QAbstractItemModel::layoutChanged);
    QVERIFY(model.setData(number, Qt::Unchecked, Qt::CheckStateRole));
    QVERIFY(!session.hits().history().hits()[1].enabled);
    QCOMPARE(number.data(Qt::CheckStateRole).toInt(), static_cast<int>(Qt::Unchecked));
    QCOMPARE(changed.size(), 1);
    QCOMPARE(changed[0][0].toModelIndex().row(), 1);
    QCOMPARE(changed[0][1].toModelIndex().row(), 1);
    QCOMPARE(layout.size(), 0);
    QVERIFY(!model.setData(time, Qt::Checked, Qt::CheckStateRole));
    QVERIFY(!model.setData(number, 7));
    session.undo();
    QCOMPARE(number.data(Qt::CheckStateRole).toInt(), static_cast<int>(Qt::Checked));
}

void HitHistoryModelTest::statesAreTold() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    session.settings().setPipeline(PipelineKind::UniformArray);
    HitHistoryModel model(session);
    for (int i = 0; i < 4; ++i) {
        QVERIFY(session.hits().add(hitOn(session, 0, 0.1f * static_cast<float>(i))).ok());
    }
    const auto state = [&model](int row) {
        return model.index(row, 0).data(HitHistoryModel::HitStateRole).toInt();
    };
    const auto tip = [&model](int row) { return model.index(row, 0).data(Qt::ToolTipRole).toString(); };
    const QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    session.hits().setEnabled(std::array<std::size_t, 1>{2}, false);
    test::readBackOf(session).setCapacity({2, false, 2, {0}});
    QCOMPARE(changed.size(), 2);
    QCOMPARE(state(0), static_cast<int>(HitHistoryModel::Dropped));
    QCOMPARE(state(1), static_cast<int>(HitHistoryModel::Applied));
    QCOMPARE(state(2), static_cast<int>(HitHistoryModel::Disabled));
    QVERIFY2(tip(0).startsWith(QStringLiteral(
                 "Dropped: the pipeline “Uniform array” keeps the last 2 hits of the scene.\n")),
             qPrintable(tip(0)));
    QVERIFY(tip(1).startsWith(QStringLiteral("Max distance")));
    QVERIFY(tip(2).startsWith(QStringLiteral("Disabled")));
    test::readBackOf(session).setCapacity({2, true, 2, {0}});
    QVERIFY(tip(0).contains(QStringLiteral("on each target")));
}

void HitHistoryModelTest::persistentIndexesStayWithTheirHits() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    HitHistoryModel model(session);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    std::vector<QPersistentModelIndex> kept;
    for (int i = 0; i < 8; ++i) {
        QVERIFY(session.hits().add(hitOn(session, 0, static_cast<float>(i))).ok());
    }
    for (int i = 0; i < 8; ++i) {
        kept.emplace_back(model.index(i, HitHistoryModel::PointColumn));
    }
    const auto staysRight = [&](std::size_t i) {
        return !kept[i].isValid() || kept[i].data().toString().startsWith(QStringLiteral("%1.000").arg(i));
    };
    const auto allRight = [&] {
        for (std::size_t i = 0; i < kept.size(); ++i) {
            if (!staysRight(i)) {
                return false;
            }
        }
        return true;
    };
    session.hits().move(std::array<std::size_t, 2>{1, 6}, 4);
    QVERIFY(allRight());
    QCOMPARE(kept[6].row(), 4);
    session.hits().remove(std::array<std::size_t, 2>{0, 3});
    QVERIFY(allRight());
    QVERIFY(!kept[0].isValid());
    QCOMPARE(kept[7].row(), 5);
    session.undo();
    session.undo();
    QVERIFY(allRight());
    QCOMPARE(kept[7].row(), 7);
}

void HitHistoryModelTest::dragsRows() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    HitHistoryModel model(session);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    for (int i = 0; i < 5; ++i) {
        QVERIFY(session.hits().add(hitOn(session, 0, static_cast<float>(i))).ok());
    }
    const auto xs = [&session] {
        std::vector<float> points;
        for (const Hit& hit : session.hits().history().hits()) {
            points.push_back(hit.point.x);
        }
        return points;
    };
    QVERIFY(model.index(0, 3).flags().testFlag(Qt::ItemIsDragEnabled));
    QVERIFY(!model.index(0, 3).flags().testFlag(Qt::ItemIsDropEnabled));
    QVERIFY(model.flags({}).testFlag(Qt::ItemIsDropEnabled));
    const std::unique_ptr<QMimeData> data(
        model.mimeData({model.index(1, 0), model.index(1, 1), model.index(3, 0), model.index(3, 1)}));
    QVERIFY(!model.dropMimeData(data.get(), Qt::CopyAction, 0, 0, {}));
    QVERIFY(model.dropMimeData(data.get(), Qt::MoveAction, 0, 0, {}));
    QCOMPARE(xs(), (std::vector<float>{1, 3, 0, 2, 4}));
    QVERIFY(!model.removeRows(1, 1));  // what the view asks for after a move
    QCOMPARE(model.rowCount(), 5);
    const std::unique_ptr<QMimeData> first(model.mimeData({model.index(0, 0)}));
    QVERIFY(model.dropMimeData(first.get(), Qt::MoveAction, -1, -1, {}));
    QCOMPARE(xs(), (std::vector<float>{3, 0, 2, 4, 1}));
    const QMimeData other;
    QVERIFY(!model.dropMimeData(&other, Qt::MoveAction, 0, 0, {}));
    session.undo();
    session.undo();
    QCOMPARE(xs(), (std::vector<float>{0, 1, 2, 3, 4}));
}

void HitHistoryModelTest::survivesAnythingWhileHitsStreamIn() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    HitHistoryModel model(session);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    std::uint32_t seed = 1;
    const auto random = [&seed](std::size_t below) {
        seed = seed * 1664525u + 1013904223u;
        return static_cast<std::size_t>(seed >> 8) % below;
    };
    for (int i = 0; i < 400; ++i) {
        QVERIFY(session.hits().add(hitOn(session, random(16), static_cast<float>(i))).ok());
        const std::size_t hits = session.hits().history().size();
        const std::array<std::size_t, 3> some{random(hits), random(hits), random(hits)};
        switch (random(7)) {
            case 0:
                session.hits().setEnabled(some, random(2) == 0);
                break;
            case 1:
                session.hits().move(some, random(hits + 1));
                break;
            case 2:
                session.hits().remove(some[0]);
                break;
            case 3:
                session.undo();
                session.undo();
                break;
            case 4:
                session.redo();
                break;
            case 5:
                test::readBackOf(session).setCapacity({hits / 2, false, hits / 2, {some[0]}});
                break;
            default:
                break;
        }
        QCOMPARE(static_cast<std::size_t>(model.rowCount()), session.hits().history().size());
        const std::span<const Hit> now = session.hits().history().hits();
        QCOMPARE(session.hits().disabled(),
                 static_cast<std::size_t>(
                     std::count_if(now.begin(), now.end(), [](const Hit& hit) { return !hit.enabled; })));
    }
}

HITSCOPE_TEST(HitHistoryModelTest, QCoreApplication)

}  // namespace hitscope::hit_history_model_test

#include "hit_history_model_test.moc"
