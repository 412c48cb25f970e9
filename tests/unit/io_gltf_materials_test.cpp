// SPDX-License-Identifier: GPL-3.0-or-later
// Faces of a glTF file that have no material have none, whatever is added on the way.
#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "io/import.h"
#include "io_support.h"
#include "mesh/primitives.h"
#include "session/export/export_target.h"
#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::io_gltf_materials_test {

using namespace test;

class IoGltfMaterialsTest : public QObject {
    Q_OBJECT
private:
    QTemporaryDir m_folder;

    /// A mesh as glTF, with its JSON as `change` leaves it, read again.
    template <class Change>
    [[nodiscard]] MeshData read(const MeshData& mesh, const Change& change) {
        const QString path = m_folder.filePath(QStringLiteral("mesh.gltf"));
        Session session;
        loadMesh(session, mesh);
        ExportOptions options;
        options.format = ExportFormat::Gltf;
        const Result<ExportReport> written = exportTarget(session, *session.targets().front(), path, options);
        if (!written) {
            qFatal("%s", written.error().message().c_str());
        }
        QJsonObject root = QJsonDocument::fromJson(QByteArray::fromStdString(readFile(path))).object();
        change(root);
        writeFile(m_folder.path(), QStringLiteral("mesh.gltf"), QJsonDocument(root).toJson().toStdString());
        Result<ImportedMesh> imported = importMesh(path);
        if (!imported) {
            qFatal("%s", imported.error().message().c_str());
        }
        return std::move(imported.value().mesh);
    }
    static MeshData twoPainted() {
        MeshData mesh = makeCube(2, 1.0f);
        mesh.materials.resize(1);
        mesh.materials[0].diffuse = {0.9f, 0.1f, 0.2f};
        mesh.faceMaterials.assign(mesh.faceCount(), kNoIndex);
        mesh.faceMaterials.front() = 0;
        return mesh;
    }

private Q_SLOTS:
    void noneStaysNone() {
        const MeshData made = read(makeCube(2, 1.0f), [](QJsonObject& root) {
            QCOMPARE(root[QStringLiteral("materials")].toArray().size(), 1);  // for other programs
        });
        QVERIFY(made.materials.empty() && made.faceMaterials.empty());
    }

    void noneOfAnotherProgramIsNone() {
        const MeshData made = read(makeCube(2, 1.0f), [](QJsonObject& root) {
            root.remove(QStringLiteral("materials"));
            QJsonArray meshes = root[QStringLiteral("meshes")].toArray();
            QJsonObject mesh = meshes[0].toObject();
            QJsonArray primitives = mesh[QStringLiteral("primitives")].toArray();
            QJsonObject primitive = primitives[0].toObject();
            primitive.remove(QStringLiteral("material"));
            primitives[0] = primitive;
            mesh[QStringLiteral("primitives")] = primitives;
            meshes[0] = mesh;
            root[QStringLiteral("meshes")] = meshes;
        });
        QVERIFY(made.materials.empty() && made.faceMaterials.empty());
    }

    void facesWithOneKeepIt() {
        const MeshData made = read(twoPainted(), [](QJsonObject&) {});
        QCOMPARE(made.materials.size(), std::size_t{1});
        QVERIFY(std::abs(made.materials[0].diffuse.x - 0.9f) < 1.0e-6f);
        QCOMPARE(std::count(made.faceMaterials.begin(), made.faceMaterials.end(), 0u), 2);  // triangles
        QCOMPARE(std::count(made.faceMaterials.begin(), made.faceMaterials.end(), kNoIndex),
                 static_cast<std::ptrdiff_t>(made.faceCount()) - 2);
    }

    /// A white one that somebody made.
    void whiteIsNotNone() {
        const MeshData made = read(makeCube(2, 1.0f), [](QJsonObject& root) {
            const QJsonObject surface{{QStringLiteral("roughnessFactor"), 0.4},
                                      {QStringLiteral("metallicFactor"), 0.0}};
            root[QStringLiteral("materials")] =
                QJsonArray{QJsonObject{{QStringLiteral("pbrMetallicRoughness"), surface}}};
        });
        QCOMPARE(made.materials.size(), std::size_t{1});
        QCOMPARE(made.materials[0].diffuse, glm::vec3(1.0f));
        QCOMPARE(made.materials[0].metalRoughness.roughness, 0.4f);
        QCOMPARE(made.faceMaterials.size(), made.faceCount());
    }
};

HITSCOPE_TEST(IoGltfMaterialsTest, QCoreApplication)

}  // namespace hitscope::io_gltf_materials_test

#include "io_gltf_materials_test.moc"
