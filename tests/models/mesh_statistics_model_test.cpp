// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractItemModelTester>
#include <QLocale>
#include <QSignalSpy>
#include <QTest>
#include <vector>

#include "deform/reference.h"
#include "mesh/primitives.h"
#include "models/mesh_statistics_model.h"

using namespace hitscope;

namespace {

using Model = MeshStatisticsModel;

QString cell(const Model& model, int row, int column) {
    return model.index(row, column).data().toString();
}

Hit hitOn(const Target& target) {
    Hit hit;
    hit.target = target.id;
    hit.point = {0.0f, 2.5f, 0.0f};
    hit.direction = {0.0f, -1.0f, 0.0f};
    return hit;
}

/// What the GPU's side does after a hit, in C++: deform, read back.
void applyOnCpu(Session& session) {
    session.restartReadBack();
    for (const std::unique_ptr<Target>& target : session.targets()) {
        ReferenceDeformation reference(target->deformed.render());
        for (const Hit& hit : session.history().hits()) {
            if (hit.target == target->id) {
                reference.apply({&hit, 1});
            }
        }
        session.takeReadBack(target->id, 0, reference.vertices());
    }
    session.finishReadBack();
}

}  // namespace

class MeshStatisticsModelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void describesTheOriginal();
    void followsHitsAndUndo();
    void followsTheTargetInFocus();
    void saysWhyThereIsNoVolume();
    void largeMeshesAreMeasuredElsewhere();
};

void MeshStatisticsModelTest::describesTheOriginal() {
    Session session;
    session.loadMesh(makeLowPolyCube(2.5f));
    Model model(session);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QTRY_COMPARE(cell(model, Model::VerticesRow, Model::OriginalColumn), QStringLiteral("386"));
    QCOMPARE(cell(model, Model::VerticesRow, Model::PropertyColumn), QStringLiteral("Vertices"));
    QCOMPARE(cell(model, Model::RmsDisplacementRow, Model::PropertyColumn), QStringLiteral("RMS (m)"));
    QCOMPARE(cell(model, Model::FacesRow, Model::OriginalColumn), QStringLiteral("384"));
    QCOMPARE(cell(model, Model::QuadsRow, Model::OriginalColumn), QStringLiteral("384"));
    QCOMPARE(cell(model, Model::EdgesRow, Model::OriginalColumn), QStringLiteral("768"));
    QCOMPARE(cell(model, Model::EulerRow, Model::OriginalColumn), QStringLiteral("2"));
    QCOMPARE(cell(model, Model::WatertightRow, Model::OriginalColumn), QStringLiteral("yes"));
    QCOMPARE(cell(model, Model::SizeXRow, Model::OriginalColumn), QStringLiteral("5.0000"));
    QCOMPARE(cell(model, Model::SizeZRow, Model::PropertyColumn), QStringLiteral("Bounding box z (m)"));
    QCOMPARE(cell(model, Model::SurfaceAreaRow, Model::OriginalColumn), QStringLiteral("150.00"));
    QCOMPARE(cell(model, Model::VolumeRow, Model::OriginalColumn), QStringLiteral("125.00"));
    QCOMPARE(cell(model, Model::VolumeRow, Model::DeformedColumn), QStringLiteral("125.00"));
    QCOMPARE(cell(model, Model::ChangedVerticesRow, Model::DeformedColumn), QStringLiteral("0 (0.0 %)"));
    QVERIFY(model.index(Model::VerticesRow, 0).data(Model::SharedRole).toBool());
    QVERIFY(model.index(Model::ShapeHeading, 0).data(Model::HeadingRole).toBool());
}

void MeshStatisticsModelTest::followsHitsAndUndo() {
    Session session;
    session.loadMesh(makeHighPolyCube(2.5f));
    Model model(session);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QTRY_COMPARE(cell(model, Model::VerticesRow, Model::OriginalColumn), QStringLiteral("6,146"));

    QVERIFY(session.addHit(hitOn(*session.targets().front())).ok());
    applyOnCpu(session);
    std::size_t within = 0;
    for (const glm::vec3& position : session.targets().front()->deformed.original().positions) {
        const glm::vec3 way = position - glm::vec3(0.0f, 2.5f, 0.0f);
        within += way.x * way.x + way.y * way.y + way.z * way.z <= 0.25f ? 1 : 0;
    }
    QVERIFY(within > 20);
    QTRY_VERIFY(cell(model, Model::ChangedVerticesRow, Model::DeformedColumn)
                    .startsWith(QString::number(within) + u' '));
    QCOMPARE(cell(model, Model::LargestDisplacementRow, Model::DeformedColumn), QStringLiteral("0.30000"));
    QVERIFY(cell(model, Model::VolumeRow, Model::DeformedColumn) !=
            cell(model, Model::VolumeRow, Model::OriginalColumn));

    session.undo();
    applyOnCpu(session);
    QTRY_COMPARE(cell(model, Model::ChangedVerticesRow, Model::DeformedColumn), QStringLiteral("0 (0.0 %)"));
    QCOMPARE(cell(model, Model::VolumeRow, Model::DeformedColumn),
             cell(model, Model::VolumeRow, Model::OriginalColumn));
}

void MeshStatisticsModelTest::followsTheTargetInFocus() {
    Session session;
    Model model(session);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(model.rowCount(), 0);
    session.loadPaperRow(kDefaultPaperRow);
    QCOMPARE(model.shownTarget(), session.targets().front()->id);

    const QSignalSpy changed(&model, &Model::shownTargetChanged);
    const Target& other = *session.targets()[9];
    session.selectTarget(other.id);
    QCOMPARE(model.shownTarget(), other.id);
    QCOMPARE(changed.size(), 1);
    const QString vertices =
        QLocale(QLocale::English).toString(qulonglong(other.deformed.original().vertexCount()));
    QTRY_COMPARE(cell(model, Model::VerticesRow, Model::OriginalColumn), vertices);

    QVERIFY(session.addHit(hitOn(*session.targets()[4])).ok());
    session.selectTarget({});
    QCOMPARE(model.shownTarget(), session.targets()[4]->id);
    session.loadPaperRow(3);
    QCOMPARE(model.shownTarget(), session.targets().front()->id);
}

void MeshStatisticsModelTest::saysWhyThereIsNoVolume() {
    MeshData mesh;
    mesh.name = "triangle";
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
    mesh.faceStarts = {0, 3};
    mesh.cornerVertices = {0, 1, 2};
    Session session;
    session.loadMesh(mesh);
    const Model model(session);
    QTRY_COMPARE(cell(model, Model::VolumeRow, Model::OriginalColumn), QStringLiteral("not watertight"));
    QCOMPARE(cell(model, Model::BoundaryEdgesRow, Model::OriginalColumn), QStringLiteral("3"));
    QCOMPARE(cell(model, Model::SurfaceAreaRow, Model::OriginalColumn), QStringLiteral("2.0000"));
}

void MeshStatisticsModelTest::largeMeshesAreMeasuredElsewhere() {
    Session session;
    session.loadMesh(makeHighPolyCube(2.5f));
    constexpr std::size_t kEveryMeshIsLarge = 1;
    Model model(session, kEveryMeshIsLarge);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(cell(model, Model::VerticesRow, Model::OriginalColumn), QStringLiteral("…"));
    QTRY_COMPARE(cell(model, Model::VerticesRow, Model::OriginalColumn), QStringLiteral("6,146"));
    QVERIFY(session.addHit(hitOn(*session.targets().front())).ok());
    applyOnCpu(session);
    QTRY_VERIFY(cell(model, Model::VolumeRow, Model::DeformedColumn) !=
                cell(model, Model::VolumeRow, Model::OriginalColumn));
    // A scene that goes while it is measured takes nothing with it.
    session.loadMesh(makeLowPolyCube(1.0f));
    QTRY_COMPARE(cell(model, Model::VerticesRow, Model::OriginalColumn), QStringLiteral("386"));
}

QTEST_GUILESS_MAIN(MeshStatisticsModelTest)
#include "mesh_statistics_model_test.moc"
