// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractItemModelTester>
#include <QLocale>
#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <vector>

#include "deform/reference.h"
#include "mesh/primitives.h"
#include "models/mesh_health_model.h"
#include "models/mesh_statistics_model.h"
#include "models/statistics_report.h"
#include "support/read_back.h"
#include "support/test_program.h"

namespace hitscope::mesh_statistics_model_test {

namespace {

using Model = MeshStatisticsModel;

QString cell(const Model& model, const char* key, int column) {
    return model.find(key, column).data().toString();
}

double value(const Model& model, const char* key, int column) {
    return model.find(key, column).data(Model::ValueRole).toDouble();
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
    test::readBackOf(session).restart();
    for (const std::unique_ptr<Target>& target : session.targets()) {
        ReferenceDeformation reference(target->deformed.render());
        for (const Hit& hit : session.hits().history().hits()) {
            if (hit.target == target->id) {
                reference.apply({&hit, 1});
            }
        }
        test::readBackOf(session).take(target->id, 0, reference.vertices());
    }
    test::readBackOf(session).finish();
}

}  // namespace

class MeshStatisticsModelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void describesTheOriginal();
    void followsHitsAndUndo();
    void announcesNumbersOfAHitLater();
    void staysConsistentWhileHitsStreamIn();
    void followsTheTargetInFocus();
    void addsUpAllTargets();
    void sharesItsNumbersWithTheCommandLine();
    void saysWhyThereIsNoVolume();
    void measuresOnlyWhileLookedAt();
    void reportsAreWhatIsShown();
    void listsHarmedFacesAndTheirHits();
};

void MeshStatisticsModelTest::describesTheOriginal() {
    Session session;
    loadMesh(session, makeLowPolyCube(2.5f));
    Model model(session);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(cell(model, "vertices", Model::OriginalColumn), QStringLiteral("…"));
    QTRY_COMPARE_WITH_TIMEOUT(cell(model, "vertices", Model::OriginalColumn), QStringLiteral("386"),
                              kPatience);
    QCOMPARE(cell(model, "vertices", Model::PropertyColumn), QStringLiteral("Vertices"));
    QCOMPARE(cell(model, "displacement_rms", Model::PropertyColumn), QStringLiteral("RMS"));
    QCOMPARE(cell(model, "faces", Model::OriginalColumn), QStringLiteral("384"));
    QCOMPARE(cell(model, "quads", Model::DeformedColumn), QStringLiteral("384"));
    QCOMPARE(cell(model, "edges", Model::OriginalColumn), QStringLiteral("768"));
    QCOMPARE(cell(model, "euler_characteristic", Model::OriginalColumn), QStringLiteral("2"));
    QCOMPARE(cell(model, "genus", Model::OriginalColumn), QStringLiteral("0"));
    QCOMPARE(cell(model, "watertight", Model::OriginalColumn), QStringLiteral("yes"));
    QCOMPARE(cell(model, "box_size_x", Model::OriginalColumn), QStringLiteral("5.0000"));
    QCOMPARE(cell(model, "box_min_z", Model::PropertyColumn), QStringLiteral("Min z"));
    QCOMPARE(cell(model, "surface_area", Model::OriginalColumn), QStringLiteral("150.00"));
    QCOMPARE(cell(model, "volume", Model::OriginalColumn), QStringLiteral("125.00"));
    QCOMPARE(cell(model, "volume", Model::DeformedColumn), QStringLiteral("125.00"));
    QCOMPARE(cell(model, "changed_vertices", Model::DeformedColumn), QStringLiteral("0"));
    QCOMPARE(cell(model, "displacement_mean", Model::DeformedColumn), QString());
    QVERIFY(model.find("vertices", 0).data(Model::SharedRole).toBool());
    for (const StatisticsRow& row : statisticsRows()) {
        QVERIFY(!model.find(row.key, 0).data(Qt::ToolTipRole).toString().isEmpty());
    }
}

void MeshStatisticsModelTest::followsHitsAndUndo() {
    Session session;
    loadMesh(session, makeHighPolyCube(2.5f));
    Model model(session);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QTRY_COMPARE_WITH_TIMEOUT(cell(model, "vertices", Model::OriginalColumn), QStringLiteral("6,146"),
                              kPatience);

    QVERIFY(session.hits().add(hitOn(*session.targets().front())).ok());
    applyOnCpu(session);
    std::size_t within = 0;
    for (const glm::vec3& position : session.targets().front()->deformed.original().positions) {
        const glm::vec3 way = position - glm::vec3(0.0f, 2.5f, 0.0f);
        within += way.x * way.x + way.y * way.y + way.z * way.z <= 0.25f ? 1 : 0;
    }
    QVERIFY(within > 20);
    QTRY_COMPARE_WITH_TIMEOUT(cell(model, "changed_vertices", Model::DeformedColumn), QString::number(within),
                              kPatience);
    QCOMPARE(cell(model, "displacement_max", Model::DeformedColumn), QStringLiteral("0.30000"));
    QVERIFY(value(model, "volume", Model::ChangeColumn) < 0.0);
    QVERIFY(cell(model, "surface_area", Model::ChangeColumn).startsWith(u'+'));

    session.undo();
    applyOnCpu(session);
    QTRY_COMPARE_WITH_TIMEOUT(cell(model, "changed_vertices", Model::DeformedColumn), QStringLiteral("0"),
                              kPatience);
    QCOMPARE(value(model, "volume", Model::ChangeColumn), 0.0);
}

/// Nothing is painted while a hit's picture is drawn; what another target's numbers are is seen at once.
void MeshStatisticsModelTest::announcesNumbersOfAHitLater() {
    Session session;
    loadMesh(session, makeHighPolyCube(2.5f));
    Model model(session);
    QTRY_VERIFY_WITH_TIMEOUT(model.measuring().measurement() && model.measuring().isUpToDate(), kPatience);
    QTest::qWait(2 * Model::kSoon);  // what is to be announced of the beginning is

    QSignalSpy announced(&model, &QAbstractItemModel::dataChanged);
    QSignalSpy header(&model, &QAbstractItemModel::headerDataChanged);
    QVERIFY(session.hits().add(hitOn(*session.targets().front())).ok());
    applyOnCpu(session);
    QCOMPARE(announced.count(), 0);
    QVERIFY(header.count() > 0);
    QVERIFY(model.find("volume", Model::DeformedColumn).data(Model::OutOfDateRole).toBool());
    // The last that views are told is what there is.
    QString told;
    connect(&model, &QAbstractItemModel::dataChanged, this,
            [&] { told = cell(model, "displacement_max", Model::DeformedColumn); });
    QTRY_COMPARE_WITH_TIMEOUT(told, QStringLiteral("0.30000"), kPatience);

    announced.clear();
    loadMesh(session, makeHighPolyCube(1.5f));
    QVERIFY(announced.count() > 0);
}

/// Live numbers end where a measurement from scratch does.
void MeshStatisticsModelTest::staysConsistentWhileHitsStreamIn() {
    Session session;
    loadMesh(session, makeHighPolySphere(2.5f));
    Model model(session);
    MeshHealthModel health(session, model.measuring());
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    const QAbstractItemModelTester other(&health, QAbstractItemModelTester::FailureReportingMode::QtTest);
    const Target& target = *session.targets().front();
    ReferenceDeformation reference(target.deformed.render());
    for (int i = 0; i < 60; ++i) {
        Hit hit;
        hit.target = target.id;
        const float angle = 0.3f * static_cast<float>(i);
        hit.point = 2.5f * glm::vec3(std::cos(angle), 0.1f, std::sin(angle));
        hit.direction = -glm::normalize(hit.point);
        QVERIFY(session.hits().add(hit));
        for (const VertexRange& range : reference.apply({&hit, 1})) {
            test::readBackOf(session).take(target.id, range.first,
                                           reference.vertices().subspan(range.first, range.count));
        }
        test::readBackOf(session).finish();
        QTest::qWait(5);
    }
    Model fresh(session);
    QTRY_VERIFY_WITH_TIMEOUT(fresh.measuring().measurement(), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(model.measuring().measurement() && model.measuring().measurement()->deformed ==
                                                                    fresh.measuring().measurement()->deformed,
                             kPatience);
    QVERIFY(model.measuring().measurement()->displacement == fresh.measuring().measurement()->displacement);
    QTRY_COMPARE_WITH_TIMEOUT(health.found(), fresh.measuring().measurement()->harmsFound, kPatience);
    QVERIFY(health.rowCount() > 0);
}

void MeshStatisticsModelTest::followsTheTargetInFocus() {
    Session session;
    Model model(session);
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(cell(model, "vertices", Model::OriginalColumn), QString());
    loadPaperRow(session, kDefaultPaperRow);
    QCOMPARE(model.shownTarget(), session.targets().front()->id);

    const QSignalSpy changed(&model, &Model::shownTargetChanged);
    const Target& other = *session.targets()[9];
    session.targets().select(other.id);
    QCOMPARE(model.shownTarget(), other.id);
    QCOMPARE(changed.size(), 1);
    const QString vertices =
        QLocale(QLocale::English).toString(qulonglong(other.deformed.original().vertexCount()));
    QTRY_COMPARE_WITH_TIMEOUT(cell(model, "vertices", Model::OriginalColumn), vertices, kPatience);

    QVERIFY(session.hits().add(hitOn(*session.targets()[4])).ok());
    session.targets().select({});
    QCOMPARE(model.shownTarget(), session.targets()[4]->id);
    loadPaperRow(session, 3);
    QCOMPARE(model.shownTarget(), session.targets().front()->id);
}

void MeshStatisticsModelTest::addsUpAllTargets() {
    Session session;
    loadMesh(session, makeLowPolyCube(1.0f));
    std::vector<TargetPlan> more;
    more.push_back(planMesh(makeLowPolyCube(2.0f)));
    session.targets().add(std::move(more));
    RigidTransform turned;
    turned.position = {10.0f, 0.0f, 0.0f};
    turned.rotation = glm::angleAxis(0.78539816f, glm::vec3(0.0f, 1.0f, 0.0f));
    QVERIFY(session.targets().setTransform(session.targets()[1]->id, turned));
    QVERIFY(session.targets().setTransform(session.targets()[0]->id, RigidTransform{}));
    Model model(session);
    model.setShowsAll(true);
    QCOMPARE(model.shownTarget(), TargetId{});
    QTRY_COMPARE_WITH_TIMEOUT(cell(model, "vertices", Model::OriginalColumn), QStringLiteral("772"),
                              kPatience);
    QCOMPARE(cell(model, "components", Model::OriginalColumn), QStringLiteral("2"));
    QVERIFY(std::abs(value(model, "volume", Model::OriginalColumn) - (8.0 + 64.0)) < 1e-6);
    QVERIFY(std::abs(value(model, "surface_area", Model::DeformedColumn) - (24.0 + 96.0)) < 1e-6);
    QVERIFY(std::abs(value(model, "centre_of_mass_x", Model::OriginalColumn) - 640.0 / 72.0) < 1e-5);
    QVERIFY(std::abs(value(model, "box_max_x", Model::OriginalColumn) - (10.0 + std::sqrt(8.0))) < 1e-5);
    QVERIFY(std::abs(value(model, "box_min_x", Model::OriginalColumn) + 1.0) < 1e-6);
    // A target that is moved takes the box along.
    turned.position.x = 20.0f;
    QVERIFY(session.targets().setTransform(session.targets()[1]->id, turned));
    QTRY_VERIFY_WITH_TIMEOUT(
        std::abs(value(model, "box_max_x", Model::DeformedColumn) - (20.0 + std::sqrt(8.0))) < 1e-5,
        kPatience);
    session.targets().remove(std::vector<TargetId>{session.targets()[1]->id});
    QTRY_COMPARE_WITH_TIMEOUT(cell(model, "vertices", Model::OriginalColumn), QStringLiteral("386"),
                              kPatience);
}

/// Of a cube whose vertices are split along every edge, as files with seams have it.
void MeshStatisticsModelTest::sharesItsNumbersWithTheCommandLine() {
    const MeshData cube = makeLowPolyCube(2.5f);
    MeshData split;
    split.faceStarts = cube.faceStarts;
    for (const std::uint32_t vertex : cube.cornerVertices) {
        split.cornerVertices.push_back(static_cast<std::uint32_t>(split.positions.size()));
        split.positions.push_back(cube.positions[vertex]);
    }
    Session session;
    loadMesh(session, split);
    Model model(session);
    QTRY_COMPARE_WITH_TIMEOUT(cell(model, "vertices", Model::OriginalColumn), QStringLiteral("1,536"),
                              kPatience);
    QCOMPARE(cell(model, "components", Model::OriginalColumn), QStringLiteral("1"));
    QCOMPARE(cell(model, "watertight", Model::OriginalColumn), QStringLiteral("yes"));
    const MeshMeasurement measurement = measure(std::make_shared<const MeshData>(split));
    for (const StatisticsRow& row : statisticsRows()) {
        const std::optional<double> measured = statisticsValue(row, measurement, StatisticsSide::Original);
        const QVariant shown = model.find(row.key, Model::OriginalColumn).data(Model::ValueRole);
        QCOMPARE(shown.isValid(), measured.has_value());
        QCOMPARE(shown.toDouble(), measured.value_or(0.0));
    }
}

void MeshStatisticsModelTest::saysWhyThereIsNoVolume() {
    MeshData mesh;
    mesh.name = "triangle";
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
    mesh.faceStarts = {0, 3};
    mesh.cornerVertices = {0, 1, 2};
    Session session;
    loadMesh(session, mesh);
    const Model model(session);
    QTRY_COMPARE_WITH_TIMEOUT(cell(model, "volume", Model::OriginalColumn), QStringLiteral("open"),
                              kPatience);
    QVERIFY(model.find("volume", Model::OriginalColumn)
                .data(Qt::ToolTipRole)
                .toString()
                .contains(QStringLiteral("Not watertight: 3 boundary edges.")));
    QVERIFY(!model.find("volume", Model::OriginalColumn).data(Model::ValueRole).isValid());
    QCOMPARE(cell(model, "boundary_edges", Model::OriginalColumn), QStringLiteral("3"));
    QCOMPARE(cell(model, "holes", Model::OriginalColumn), QStringLiteral("1"));
    QCOMPARE(cell(model, "surface_area", Model::OriginalColumn), QStringLiteral("2.0000"));

    MeshData fan = mesh;
    fan.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
    fan.faceStarts = {0, 3, 6, 9};
    fan.cornerVertices = {0, 1, 2, 0, 1, 3, 0, 1, 4};
    loadMesh(session, fan);
    QTRY_COMPARE_WITH_TIMEOUT(cell(model, "genus", Model::OriginalColumn), QStringLiteral("n/a"), kPatience);
    QVERIFY(model.find("genus", 0).data(Qt::ToolTipRole).toString().contains(QStringLiteral("Not defined")));
    QCOMPARE(cell(model, "non_manifold_edges", Model::OriginalColumn), QStringLiteral("1"));
    QCOMPARE(cell(model, "volume", Model::OriginalColumn), QStringLiteral("open"));  // the same word
}

void MeshStatisticsModelTest::measuresOnlyWhileLookedAt() {
    Session session;
    loadMesh(session, makeHighPolyCube(2.5f));
    Model model(session);
    QTRY_VERIFY_WITH_TIMEOUT(model.measuring().measurement(), kPatience);
    model.measuring().setActive(false);
    const QSignalSpy measured(&model.measuring(), &MeshMeasuring::measured);
    QVERIFY(session.hits().add(hitOn(*session.targets().front())).ok());
    applyOnCpu(session);
    QTest::qWait(400);
    QCOMPARE(measured.size(), 0);
    model.measuring().setActive(true);
    QTRY_VERIFY_WITH_TIMEOUT(value(model, "volume", Model::ChangeColumn) < 0.0, kPatience);
    // A scene that goes while it is measured takes nothing with it.
    loadMesh(session, makeHighPolyCube(3.0f));
    QTest::qWait(1);
    loadMesh(session, makeLowPolyCube(1.0f));
    QTRY_COMPARE_WITH_TIMEOUT(cell(model, "vertices", Model::OriginalColumn), QStringLiteral("386"),
                              kPatience);
}

void MeshStatisticsModelTest::reportsAreWhatIsShown() {
    Session session;
    loadMesh(session, makeLowPolyCube(2.5f));
    Model model(session);
    QTRY_VERIFY_WITH_TIMEOUT(model.measuring().measurement(), kPatience);
    const MeshMeasurement& measurement = *model.measuring().measurement();
    const QString csv = statisticsAsCsv(measurement);
    QCOMPARE(csv.count(QStringLiteral("\r\n")), static_cast<qsizetype>(statisticsRows().size()) + 1);
    for (const QString& line : csv.split(QStringLiteral("\r\n"))) {
        const QStringList cells = line.split(u',');
        if (cells.value(1) == QStringLiteral("volume")) {
            QCOMPARE(cells.value(3), QStringLiteral("m³"));
            QCOMPARE(cells.value(4).toDouble(), measurement.original.volume());
            QVERIFY(std::abs(cells.value(5).toDouble() - 125.0) < 1e-9);
        }
    }
    QVERIFY(csv.contains(QStringLiteral("Surface and volume,volume,Volume,")));
    const QString text = statisticsAsText(QStringLiteral("cube"), measurement);
    QVERIFY(text.startsWith(QStringLiteral("cube\n")));
    QVERIFY(text.contains(QStringLiteral("Volume (m³)")));
    const QString markdown = statisticsAsMarkdown(QStringLiteral("cube"), measurement);
    QVERIFY(markdown.contains(QStringLiteral("| Volume (m³) | 125.00 | 125.00 | 0 |")));
    QCOMPARE(markdown.count(QStringLiteral("### ")), qsizetype{6});
    QLocale::setDefault(QLocale(QLocale::German));
    const QString german = statisticsAsMarkdown(QStringLiteral("cube"), measurement);
    const QString shown = statisticsText(statisticsRow("volume"), measurement, StatisticsSide::Original);
    QLocale::setDefault(QLocale::c());
    QCOMPARE(german, markdown);
    QCOMPARE(shown, QStringLiteral("125,00"));
}

void MeshStatisticsModelTest::listsHarmedFacesAndTheirHits() {
    Session session;
    loadMesh(session, makeHighPolyCube(2.5f));
    const Target& target = *session.targets().front();
    Hit harmless = hitOn(target);
    harmless.constants.power = 0.0001f;
    harmless.constants.maxMagnitude = 0.0001f;
    QVERIFY(session.hits().add(std::vector<Hit>{harmless, hitOn(target), harmless}));
    applyOnCpu(session);
    Model model(session);
    model.measuring().setStretchLimit(1.15f);
    MeshHealthModel health(session, model.measuring());
    const QAbstractItemModelTester tester(&health, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QTRY_VERIFY_WITH_TIMEOUT(health.rowCount() > 0, kPatience);
    for (int row = 0; row < health.rowCount(); ++row) {
        QCOMPARE(health.harmAt(row).hit, std::optional<std::size_t>(1));
        QCOMPARE(health.index(row, MeshHealthModel::HitColumn).data().toString(), QStringLiteral("2"));
        QVERIFY(health.harmAt(row).harm.kind != FaceHarm::Kind::Stretched ||
                health.harmAt(row).harm.stretch > 1.15f);
    }
    // Edits that move nothing, or have not yet: the numbers follow.
    session.hits().remove(0);
    QTRY_COMPARE_WITH_TIMEOUT(health.harmAt(0).hit, std::optional<std::size_t>(0), kPatience);
    session.undo();
    QTRY_COMPARE_WITH_TIMEOUT(health.harmAt(0).hit, std::optional<std::size_t>(1), kPatience);
    const int before = health.rowCount();
    model.measuring().setStretchLimit(1.01f);
    QTRY_VERIFY_WITH_TIMEOUT(health.rowCount() > before, kPatience);
    // Nothing is known yet of others, and these faces are not theirs.
    model.measuring().setTargets({}, true);
    QCOMPARE(health.rowCount(), 0);
    model.measuring().setTargets({target.id}, true);
    QTRY_VERIFY_WITH_TIMEOUT(health.rowCount() > before, kPatience);
    session.undo();
    applyOnCpu(session);
    QTRY_COMPARE_WITH_TIMEOUT(health.rowCount(), 0, kPatience);
}

HITSCOPE_TEST(MeshStatisticsModelTest, QCoreApplication)

}  // namespace hitscope::mesh_statistics_model_test

#include "mesh_statistics_model_test.moc"
