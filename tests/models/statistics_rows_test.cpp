// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of the mesh statistics says the number that its key names, and no other.
#include <QTest>
#include <map>
#include <string>

#include "models/statistics_rows.h"
#include "support/test_program.h"

namespace hitscope::statistics_rows_test {

namespace {

Spread spread(double least, double greatest, double sum, std::size_t count) {
    Spread made;
    made.least = least;
    made.greatest = greatest;
    made.sum = sum;
    made.count = count;
    return made;
}

/// No two numbers of it are the same.
SurfaceMeasures measures(double from) {
    SurfaceMeasures made;
    made.box.min = {from + 1.0, from + 2.0, from + 3.0};
    made.box.max = {from + 11.0, from + 22.0, from + 33.0};
    made.edgeLength = spread(from + 41.0, from + 42.0, from + 43.0, 2);
    made.faceArea = spread(from + 44.0, from + 45.0, from + 46.0, 2);
    made.aspect = spread(from + 47.0, from + 48.0, from + 49.0, 2);
    made.degenerateFaces = static_cast<std::size_t>(from) + 50;
    made.flippedFaces = static_cast<std::size_t>(from) + 51;
    made.signedVolume = -(from + 60.0);
    made.volumeMoment = made.signedVolume * glm::dvec3(from + 61.0, from + 62.0, from + 63.0);
    return made;
}

MeshMeasurement measurement() {
    MeshMeasurement made;
    made.original = measures(1000.0);
    made.deformed = measures(3000.0);
    made.displacement = {spread(5001.0, 5002.0, 5003.0 * 100.0, 100), 5004.0, 5005.0, 5006.0};
    made.refusedFaces = 7001;
    SurfaceStatistics& topology = made.topology;
    topology.vertices = 400;
    topology.unreferencedVertices = 7002;
    topology.places = 7003;
    topology.edges = 7004;
    topology.faces = 7005;
    topology.triangles = 7006;
    topology.quads = 7007;
    topology.largerPolygons = 7008;
    topology.collapsedFaces = 7009;
    topology.boundaryEdges = 7010;
    topology.holes = 7011;
    topology.components = 7012;
    topology.nonManifoldEdges = 7013;
    topology.nonManifoldVertices = 7014;
    topology.opposedEdges = 0;
    topology.eulerCharacteristic = -7015;
    topology.genus = 7016;
    topology.watertight = true;
    return made;
}

/// Of the original; the deformed has 2,000 more of each.
const std::map<std::string, double> kOfBoth{
    {"box_size_x", 10.0},         {"box_size_y", 20.0},
    {"box_size_z", 30.0},         {"box_diagonal", 37.416573867739416},
    {"box_min_x", 1001.0},        {"box_min_y", 1002.0},
    {"box_min_z", 1003.0},        {"box_max_x", 1011.0},
    {"box_max_y", 1022.0},        {"box_max_z", 1033.0},
    {"surface_area", 1046.0},     {"volume", 1060.0},
    {"centre_of_mass_x", 1061.0}, {"centre_of_mass_y", 1062.0},
    {"centre_of_mass_z", 1063.0}, {"edge_length_total", 1043.0},
    {"edge_length_mean", 521.5},  {"edge_length_min", 1041.0},
    {"edge_length_max", 1042.0},  {"face_area_min", 1044.0},
    {"face_area_max", 1045.0},    {"aspect_min", 1047.0},
    {"aspect_max", 1048.0},       {"degenerate_faces", 1050.0},
    {"flipped_faces", 1051.0},
};
const std::map<std::string, double> kOfTheDeformed{
    {"changed_vertices", 100.0},   {"changed_share", 25.0},
    {"displacement_min", 5001.0},  {"displacement_max", 5002.0},
    {"displacement_mean", 5003.0}, {"displacement_median", 5004.0},
    {"displacement_rms", 5005.0},  {"displacement_deviation", 5006.0},
};
const std::map<std::string, double> kTheSame{
    {"vertices", 400.0},
    {"unreferenced_vertices", 7002.0},
    {"places", 7003.0},
    {"edges", 7004.0},
    {"faces", 7005.0},
    {"triangles", 7006.0},
    {"quads", 7007.0},
    {"larger_polygons", 7008.0},
    {"collapsed_faces", 7009.0},
    {"boundary_edges", 7010.0},
    {"holes", 7011.0},
    {"components", 7012.0},
    {"non_manifold_edges", 7013.0},
    {"non_manifold_vertices", 7014.0},
    {"opposed_edges", 0.0},
    {"refused_faces", 7001.0},
    {"euler_characteristic", -7015.0},
    {"genus", 7016.0},
    {"watertight", 1.0},
};

/// What does not grow with the place: sizes.
double apart(const std::string& key) {
    if (key.starts_with("box_size") || key == "box_diagonal") {
        return 0.0;
    }
    return key == "edge_length_mean" ? 1000.0 : 2000.0;
}

}  // namespace

class StatisticsRowsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void saysWhatItsKeyNames_data() {
        QTest::addColumn<QByteArray>("key");
        for (const StatisticsRow& row : statisticsRows()) {
            QTest::newRow(row.key) << QByteArray(row.key);
        }
    }

    void saysWhatItsKeyNames() {
        QFETCH(const QByteArray, key);
        const StatisticsRow& row = statisticsRow(key.constData());
        const MeshMeasurement all = measurement();
        const auto of = [&](StatisticsSide side) { return statisticsValue(row, all, side); };
        const std::string name = key.toStdString();
        if (kOfBoth.contains(name)) {
            QCOMPARE(of(StatisticsSide::Original), std::optional(kOfBoth.at(name)));
            QCOMPARE(of(StatisticsSide::Deformed), std::optional(kOfBoth.at(name) + apart(name)));
            QCOMPARE(of(StatisticsSide::Change), std::optional(apart(name)));
        } else if (kOfTheDeformed.contains(name)) {
            QVERIFY(!of(StatisticsSide::Original));
            QCOMPARE(of(StatisticsSide::Deformed), std::optional(kOfTheDeformed.at(name)));
            QVERIFY(!of(StatisticsSide::Change));
        } else {
            QVERIFY2(kTheSame.contains(name), "a row that nobody holds against anything");
            QCOMPARE(of(StatisticsSide::Original), std::optional(kTheSame.at(name)));
            QCOMPARE(of(StatisticsSide::Deformed), std::optional(kTheSame.at(name)));
            QVERIFY(!of(StatisticsSide::Change));
        }
    }

    void everyKeyHasARow() {
        QCOMPARE(statisticsRows().size(), kOfBoth.size() + kOfTheDeformed.size() + kTheSame.size());
    }

    void nothingHasNoLeast() {
        MeshMeasurement nothing;
        nothing.topology.opposedEdges = 5;
        QCOMPARE(statisticsValue(statisticsRow("opposed_edges"), nothing, StatisticsSide::Original),
                 std::optional(5.0));
        for (const char* key : {"displacement_min", "displacement_mean", "edge_length_min", "aspect_max",
                                "box_min_x", "box_max_z", "volume", "genus"}) {
            QVERIFY2(!statisticsValue(statisticsRow(key), nothing, StatisticsSide::Deformed), key);
        }
    }
};

HITSCOPE_TEST(StatisticsRowsTest, QCoreApplication)

}  // namespace hitscope::statistics_rows_test

#include "statistics_rows_test.moc"
