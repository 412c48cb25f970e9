// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>
#include <array>

#include "models/hit_history_model.h"

using namespace hitscope;

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
};

void HitHistoryModelTest::followsEveryChange() {
    Session session;
    session.loadPaperRow(kDefaultPaperRow);
    HitHistoryModel model(session);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(model.rowCount(), 0);

    for (int i = 0; i < 20; ++i) {
        QVERIFY(session.addHit(hitOn(session, static_cast<std::size_t>(i % 16), 0.1f * static_cast<float>(i)))
                    .ok());
    }
    QCOMPARE(model.rowCount(), 20);
    session.undoHit();
    session.undoHit();
    QCOMPARE(model.rowCount(), 18);
    session.redoHit();
    QCOMPARE(model.rowCount(), 19);
    session.removeHit(0);
    QCOMPARE(model.rowCount(), 18);
    QCOMPARE(model.index(0, HitHistoryModel::NumberColumn).data().toString(), QStringLiteral("1"));
    QCOMPARE(model.index(0, HitHistoryModel::TargetColumn).data().toString(), session.targets()[1]->name);
    session.clearHits();
    QCOMPARE(model.rowCount(), 0);

    QVERIFY(session.addHit(hitOn(session, 0, 0.0f)).ok());
    session.loadPaperRow(0);
    QCOMPARE(model.rowCount(), 0);
    QVERIFY(session.addHit(hitOn(session, 0, 0.0f)).ok());
    QCOMPARE(model.rowCount(), 1);
}

void HitHistoryModelTest::appendsAreRowInsertions() {
    Session session;
    session.loadPaperRow(kDefaultPaperRow);
    HitHistoryModel model(session);
    const QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
    const QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    QVERIFY(session.addHit(hitOn(session, 0, 0.0f)).ok());
    QVERIFY(session.addHit(hitOn(session, 1, 0.0f)).ok());
    QCOMPARE(inserted.size(), 2);
    QCOMPARE(inserted.at(1).at(1).toInt(), 1);
    QCOMPARE(inserted.at(1).at(2).toInt(), 1);
    QCOMPARE(reset.size(), 0);
}

void HitHistoryModelTest::cellsSayWhatTheHitIs() {
    Session session;
    session.loadPaperRow(kDefaultPaperRow);
    const HitHistoryModel model(session);
    QVERIFY(session.addHit(hitOn(session, 2, 0.25f)).ok());
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
    session.loadMesh(mesh);
    const HitHistoryModel model(session);
    QVERIFY(session.addHit(hitOn(session, 0, 0.1f)).ok());
    QVERIFY(session.addHit(hitOn(session, 0, 2.0f)).ok());
    const QString all = model.csv();
    QCOMPARE(all.count(u'\n'), 3);
    const QString first = all.section(u'\n', 1, 1);
    QVERIFY2(first.startsWith(QStringLiteral("1,1.5,\"a, \"\"quoted\"\" mesh\",0.100000001,0.5,-1.25,")),
             qPrintable(first));
    const std::array<int, 2> rows{1, 99};
    const QString some = model.csv(rows);
    QCOMPARE(some.count(u'\n'), 2);
    QVERIFY(some.section(u'\n', 1, 1).startsWith(QStringLiteral("2,")));
}

void HitHistoryModelTest::manyHits() {
    Session session;
    session.loadPaperRow(kDefaultPaperRow);
    const HitHistoryModel model(session);
    constexpr int kMany = 100'000;
    for (int i = 0; i < kMany; ++i) {
        QVERIFY(session.addHit(hitOn(session, static_cast<std::size_t>(i % 16), 0.0f)).ok());
    }
    QCOMPARE(model.rowCount(), kMany);
    QCOMPARE(model.index(kMany - 1, HitHistoryModel::NumberColumn).data().toString(),
             QStringLiteral("100,000"));
}

QTEST_GUILESS_MAIN(HitHistoryModelTest)
#include "hit_history_model_test.moc"
