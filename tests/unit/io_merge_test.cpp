// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "deform/reference.h"
#include "io/check/written_check.h"
#include "io/export_obj.h"
#include "io/writers/merge_targets.h"
#include "io/writers/morph_steps.h"
#include "mesh/primitives.h"
#include "support/test_program.h"
#include "write_support.h"

namespace hitscope::io_merge_test {

using namespace test;

namespace {

const char* const kPlate =
    "mtllib p.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 5 5\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\ng "
    "front\nusemtl wood\nf "
    "1/1/1 2/2/1 3/3/1\ng back\nf 1//1 3//1 4//1\n";

PlacedTarget placedTarget(const DentedFile& mesh, const char* name) {
    PlacedTarget target;
    target.mesh = &mesh.original.mesh;
    target.positions = mesh.positions;
    target.normals = mesh.normals;
    target.hits = mesh.hits;
    target.name = name;
    target.sourcePath = mesh.sourcePath;
    return target;
}

QString writePlate(const QString& folder) {
    QDir(folder).mkpath(QStringLiteral("."));
    writeFile(folder, QStringLiteral("p.mtl"), "newmtl wood\nKd 0.5 0.5 0.5\nmap_Kd wood.png\n");
    writeFile(folder, QStringLiteral("wood.png"), smallPng().toStdString());
    return writeFile(folder, QStringLiteral("p.obj"), kPlate);
}

Hit hitAt(TargetId target, const glm::vec3& point) {
    Hit hit;
    hit.target = target;
    hit.point = point;
    hit.direction = glm::vec3(0.0f, 0.0f, -1.0f);
    return checkedHit(hit).value();
}

class TestIoMerge : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void targetsInOneFile_data() {
        QTest::addColumn<QString>("suffix");
        for (const char* const suffix : {"obj", "ply", "stl", "glb"}) {
            QTest::newRow(suffix) << QString::fromLatin1(suffix);
        }
    }
    void targetsInOneFile() {
        QFETCH(QString, suffix);
        QTemporaryDir folder;
        DentedFile plate(writePlate(folder.path()));
        plate.normals.assign(6, {0.0f, 0.0f, 1.0f});
        DentedFile bare(
            writeFile(folder.path(), QStringLiteral("bare.obj"), "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\n"));
        plate.move(2, {0.0f, 0.0f, 0.5f});
        PlacedTarget first = placedTarget(plate, "thing");
        first.transform = glm::translate(glm::dmat4(1.0), glm::dvec3(10.0, 0.0, 0.0)) *
                          glm::rotate(glm::dmat4(1.0), glm::radians(90.0), glm::dvec3(0.0, 0.0, 1.0));
        const std::vector<PlacedTarget> targets{first, placedTarget(bare, "thing"), placedTarget(plate, "")};
        Result<MergedTargets> result = mergeTargets(targets);
        QVERIFY2(result, qPrintable(messageOf(result)));
        const MergedTargets& merged = result.value();
        const Status valid = validate(merged.mesh);
        QVERIFY2(valid, qPrintable(messageOf(valid)));
        QCOMPARE(merged.mesh.positions.size(), std::size_t{13});
        QVERIFY(glm::distance(merged.mesh.positions[1], glm::vec3(10, 1, 0)) < 1e-6f);
        QVERIFY(glm::distance(merged.positions[2], glm::vec3(9, 1, 0.5)) < 1e-6f);
        QCOMPARE(merged.hits[2], 1u);
        QCOMPARE(merged.normals.size(), merged.mesh.cornerVertices.size());
        std::vector<std::string> names;
        for (const FaceGroup& group : merged.mesh.groups) {
            names.push_back((group.kind == FaceGroup::Kind::Object ? "o " : "g ") + group.name);
        }
        QCOMPARE(names, (std::vector<std::string>{"o thing", "g front", "g back", "o thing_2", "g thing_2",
                                                  "o p", "g front", "g back"}));
        QCOMPARE(merged.mesh.faceMaterials, (std::vector<std::uint32_t>{0, 0, kNoIndex, 1, 1}));
        const QString path = folder.filePath(QStringLiteral("all.") + suffix);
        const MeshExport what = merged.what();
        if (suffix == QStringLiteral("obj")) {
            ObjExport file;
            file.mesh = what.mesh;
            file.positions = what.positions;
            file.normals = {what.normals, {}};
            file.sourceFolder = what.sourceFolder;
            QVERIFY(exportObj(file, path));
            const MeshData back = readBack(path);
            QCOMPARE(back.materials.size(), std::size_t{2});
            QVERIFY(back.materials[1].diffuseImage >= 0);
        } else {
            QVERIFY(suffix == QStringLiteral("ply")   ? exportPly(what, path, {}).ok()
                    : suffix == QStringLiteral("stl") ? exportStl(what, path, {}).ok()
                                                      : exportGltf(what, path, {}).ok());
        }
        const Status same = verifyWritten(path, what);
        QVERIFY2(same, qPrintable(messageOf(same)));
    }

    void normalsTurnWithTheTarget() {
        QTemporaryDir folder;
        DentedFile plate(writePlate(folder.path()));
        plate.normals.assign(6, {0.0f, 0.0f, 1.0f});
        PlacedTarget target = placedTarget(plate, "a");
        target.transform = glm::rotate(glm::dmat4(1.0), glm::radians(90.0), glm::dvec3(1.0, 0.0, 0.0));
        const Result<MergedTargets> merged = mergeTargets({&target, 1});
        QVERIFY(merged);
        QVERIFY(glm::distance(merged.value().normals[0], glm::vec3(0, -1, 0)) < 1e-6f);
        QVERIFY(glm::distance(merged.value().mesh.normals[0], glm::vec3(0, -1, 0)) < 1e-6f);
    }

    void picturesOfSeveralFoldersComeAlong() {
        QTemporaryDir folder;
        const DentedFile one(writePlate(folder.filePath(QStringLiteral("one"))));
        const DentedFile two(writePlate(folder.filePath(QStringLiteral("two"))));
        const std::vector<PlacedTarget> targets{placedTarget(one, "one"), placedTarget(two, "two")};
        const Result<MergedTargets> merged = mergeTargets(targets);
        QVERIFY(merged);
        QCOMPARE(merged.value().sourceFolder, QString());
        const QString path = folder.filePath(QStringLiteral("all.glb"));
        const Result<QStringList> written = exportGltf(merged.value().what(), path, {});
        QVERIFY2(written, qPrintable(messageOf(written)));
        QVERIFY(!written.value().join(u' ').contains(QStringLiteral("left out.")) ||
                !written.value().join(u' ').contains(QStringLiteral("picture")));
        QCOMPARE(readBack(path).images.size(), std::size_t{2});
        QCOMPARE(readBack(path).images[1].width, 2);
    }

    void spansOfOtherLengthsAreRefused() {
        QTemporaryDir folder;
        const DentedFile one(writePlate(folder.path()));
        PlacedTarget target = placedTarget(one, "one");
        target.positions = target.positions.first(2);
        QVERIFY(!mergeTargets({&target, 1}));
    }

    void stepsFollowTheHits() {
        const MeshData mesh = makeLowPolySphere();
        const auto render = std::make_shared<const RenderMesh>(buildRenderMesh(mesh));
        const TargetId a{1};
        const TargetId b{2};
        const TargetId other{3};
        std::vector<Hit> hits;
        for (int i = 0; i < 5; ++i) {
            const float angle = 1.2f * static_cast<float>(i);
            hits.push_back(hitAt(i == 2 ? b : a, glm::vec3(std::cos(angle), std::sin(angle), 0.1f) *
                                                     glm::length(mesh.positions[0])));
        }
        hits.insert(hits.begin() + 1, hitAt(other, {0, 0, 1}));
        hits.push_back(hits[0]);
        hits.back().enabled = false;
        const std::vector<MorphedTarget> targets{{a, render}, {b, render}};
        const auto steps = morphSteps(hits, targets, {MorphUnit::Hit, 3});
        QVERIFY(steps);
        QCOMPARE(steps->size(), std::size_t{2});
        const std::vector<MorphStep>& own = steps->front();
        QCOMPARE(own.size(), std::size_t{3});
        QCOMPARE(own[0].name, std::string("Hit 1"));
        QCOMPARE(own[1].name, std::string("Hits 3-4"));
        QCOMPARE(own[2].name, std::string("Hits 5-6"));
        QVERIFY((*steps)[1][0].moved.empty() && !(*steps)[1][1].moved.empty());
        ReferenceDeformation reference(*render);
        std::vector<Hit> onA;
        std::copy_if(hits.begin(), hits.end(), std::back_inserter(onA),
                     [a](const Hit& hit) { return hit.target == a && hit.enabled; });
        static_cast<void>(reference.apply(onA));
        PageVector<glm::vec3> positions = mesh.positions;
        for (const MorphStep& step : own) {
            std::set<std::uint32_t> once;
            for (const MovedVertex& moved : step.moved) {
                positions[moved.vertex] = moved.position;
                QVERIFY(once.insert(moved.vertex).second);
            }
        }
        std::size_t moved = 0;
        for (std::size_t r = 0; r < render->vertices.size(); ++r) {
            QCOMPARE(positions[render->fileVertices[r]], reference.vertices()[r].position);
            moved += positions[render->fileVertices[r]] != mesh.positions[render->fileVertices[r]] ? 1 : 0;
        }
        QVERIFY(moved > 4);
        QTemporaryDir folder;
        MeshExport what;
        what.mesh = &mesh;
        what.positions = positions;
        what.steps = own;
        const QString path = folder.filePath(QStringLiteral("a.glb"));
        QVERIFY(exportGltf(what, path, {.steps = true}));
        const Status same = verifyWritten(path, what);
        QVERIFY2(same, qPrintable(messageOf(same)));
    }

    void stepsFollowGroups() {
        const MeshData mesh = makeLowPolySphere();
        const auto render = std::make_shared<const RenderMesh>(buildRenderMesh(mesh));
        const HitGroup scatter{2, HitGroupKind::Scatter};
        const HitGroup stroke{3, HitGroupKind::Stroke};
        std::vector<Hit> hits;
        for (const HitGroup group :
             {HitGroup{}, HitGroup{}, scatter, scatter, scatter, stroke, stroke, scatter}) {
            hits.push_back(hitAt(TargetId{1}, mesh.positions[hits.size()]));
            hits.back().group = group;
        }
        hits.insert(hits.begin() + 3,
                    hitAt(TargetId{2}, {0, 0, 1}));  // of another target: it divides nothing
        const std::vector<MorphedTarget> targets{{TargetId{1}, render}};
        const auto names = [&](const MorphGrouping& grouping) {
            std::vector<std::string> result;
            const auto steps = morphSteps(hits, targets, grouping);
            for (const MorphStep& step : steps->front()) {
                result.push_back(step.name);
            }
            return result;
        };
        using Names = std::vector<std::string>;
        QCOMPARE(names({MorphUnit::Group, 20}), (Names{"Hit 1", "Hit 2", "Hits 3-6 (scatter 2)",
                                                       "Hits 7-8 (stroke 3)", "Hit 9 (scatter 2)"}));
        QCOMPARE(names({MorphUnit::Group, 2}), (Names{"Hits 1-2", "Hits 3-9"}));
        QCOMPARE(names({MorphUnit::Hit, 20}).size(), std::size_t{8});
        const std::vector<std::size_t> rows{0, 1, 2, 4, 5, 6, 7, 8};
        QCOMPARE(morphUnitCount(hits, rows, MorphUnit::Group), std::size_t{5});
        QCOMPARE(morphUnitCount(hits, rows, MorphUnit::Hit), std::size_t{8});
    }

    void stepsCanBeGivenUp() {
        const MeshData mesh = makeLowPolySphere();
        const auto render = std::make_shared<const RenderMesh>(buildRenderMesh(mesh));
        const std::vector<Hit> hits{hitAt(TargetId{1}, mesh.positions[0]),
                                    hitAt(TargetId{1}, mesh.positions[1])};
        const std::vector<MorphedTarget> targets{{TargetId{1}, render}};
        QVERIFY(
            !morphSteps(hits, targets, {MorphUnit::Hit, 2}, [](double fraction) { return fraction < 0.5; }));
        QVERIFY(morphSteps(hits, targets, {MorphUnit::Hit, 2}, [](double) { return true; }));
        QCOMPARE(morphSteps({}, targets, {MorphUnit::Hit, 2})->front().size(), std::size_t{0});
    }
};

}  // namespace

HITSCOPE_TEST(TestIoMerge, QCoreApplication)

}  // namespace hitscope::io_merge_test

#include "io_merge_test.moc"
