// SPDX-License-Identifier: GPL-3.0-or-later
// What the export dialog says a file will take, beside files that are written.
#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include "mesh/primitives.h"
#include "session/export/export_target.h"
#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::export_estimate_test {

namespace {

enum class Loose : std::uint8_t { None, Lines, Points };

/// A cube whose vertices lie on lines of three, or are points, too.
MeshData meshWith(Loose loose) {
    MeshData mesh = makeHighPolyCube(2.5f);
    for (std::uint32_t at = 0; at + 2 < mesh.positions.size(); at += 3) {
        if (loose == Loose::Lines) {
            mesh.lines.push_back({at, at + 1, at + 2});
        } else if (loose == Loose::Points) {
            mesh.points.insert(mesh.points.end(), {at, at + 1, at + 2});
        }
    }
    return mesh;
}

struct Sizes {
    double estimated = 0.0;
    double written = 0.0;
};

class ExportEstimateTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// What lines and points add to the estimate is what they add to the file, or somewhat more: no hit moved
    /// them here, which would add to a glTF file.
    void linesAndPointsAreCounted_data() {
        QTest::addColumn<int>("format");
        QTest::addColumn<bool>("points");
        QTest::addColumn<double>("most");  // of the estimate, in what is written
        const auto row = [](const char* name, ExportFormat format, bool points, double most) {
            QTest::newRow(name) << static_cast<int>(format) << points << most;
        };
        row("ply, lines", ExportFormat::Ply, false, 1.01);
        row("ply as text, lines", ExportFormat::PlyAscii, false, 1.1);
        row("glb, lines", ExportFormat::Glb, false, 3.0);
        row("gltf, lines", ExportFormat::Gltf, false, 3.0);
        row("glb, points", ExportFormat::Glb, true, 3.0);
    }
    void linesAndPointsAreCounted() {
        QFETCH(const int, format);
        QFETCH(const bool, points);
        QFETCH(const double, most);
        const Sizes without = sizesOf(Loose::None, static_cast<ExportFormat>(format));
        const Sizes with = sizesOf(points ? Loose::Points : Loose::Lines, static_cast<ExportFormat>(format));
        QVERIFY(without.written > 0.0 && with.written > without.written);
        const double share = (with.estimated - without.estimated) / (with.written - without.written);
        QVERIFY2(share > 0.99 && share < most, qPrintable(QString::number(share)));
    }

    void textsAreAboutAsLong_data() {
        QTest::addColumn<int>("format");
        QTest::addColumn<bool>("isSphere");
        QTest::addColumn<bool>("hasNormals");
        for (const bool isSphere : {true, false}) {
            for (const bool hasNormals : {true, false}) {
                const char* const shape = isSphere ? "sphere" : "cube";
                const char* const which = hasNormals ? "with" : "without";
                QTest::addRow("OBJ, %s %s normals", shape, which)
                    << static_cast<int>(ExportFormat::Obj) << isSphere << hasNormals;
                QTest::addRow("PLY, %s %s normals", shape, which)
                    << static_cast<int>(ExportFormat::PlyAscii) << isSphere << hasNormals;
            }
        }
    }
    void textsAreAboutAsLong() {
        QFETCH(const int, format);
        QFETCH(const bool, isSphere);
        QFETCH(const bool, hasNormals);
        TargetPlan plan = planMesh(isSphere ? makeHighPolySphere() : makeHighPolyCube(2.5f));
        // As read from a file without normals, which is not there any more.
        plan.sourcePath = hasNormals ? QString() : QStringLiteral("/nowhere/mesh.stl");
        const Sizes sizes = sizesOf(std::move(plan), static_cast<ExportFormat>(format));
        const double share = sizes.estimated / sizes.written;
        QVERIFY2(share > 0.85 && share < 1.15, qPrintable(QString::number(share)));
    }

private:
    static Sizes sizesOf(Loose loose, ExportFormat format) {
        return sizesOf(planMesh(meshWith(loose)), format);
    }
    /// All that an export writes, its buffer beside it too.
    static Sizes sizesOf(TargetPlan plan, ExportFormat format) {
        Session session;
        std::vector<TargetPlan> plans;
        plans.push_back(std::move(plan));
        session.loadScene({QStringLiteral("one"), std::move(plans)});
        const Target* const target = session.targets()[0].get();
        ExportOptions options;
        options.format = format;
        QTemporaryDir folder;
        const QString path =
            folder.filePath(QStringLiteral("mesh.") + QLatin1String(traitsOf(format).suffix));
        Sizes sizes;
        sizes.estimated =
            static_cast<double>(estimateExport({&target, 1}, options, session.hits().shown()).bytes);
        if (writeExport(copyForExport(session, {&target, 1}, options), path)) {
            for (const QFileInfo& file : QDir(folder.path()).entryInfoList(QDir::Files)) {
                sizes.written += static_cast<double>(file.size());
            }
        }
        return sizes;
    }
};

}  // namespace

HITSCOPE_TEST(ExportEstimateTest, QCoreApplication)

}  // namespace hitscope::export_estimate_test

#include "export_estimate_test.moc"
