// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/assimp_reader.h"

#include <assimp/scene.h>

#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>

#include <QFileInfo>
#include <algorithm>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <new>
#include <sstream>

#include "core/finite.h"
#include "io/readers/assimp_check.h"
#include "io/readers/assimp_files.h"
#include "io/readers/assimp_materials.h"
#include "io/readers/assimp_morphs.h"
#include "io/readers/dae_check.h"
#include "io/readers/fbx_check.h"
#include "io/readers/gltf_numbers.h"
#include "io/readers/gltf_prepare.h"
#include "io/readers/tidy.h"
#include "io/welder.h"

namespace hitscope {
namespace {

class Progress : public Assimp::ProgressHandler {
public:
    explicit Progress(const ProgressSink& sink) : m_sink(sink) {}
    bool Update(float fraction) override {
        if (m_sink) {
            m_sink(fraction >= 0.0f && fraction <= 1.0f ? static_cast<double>(fraction) : 0.0, "Reading");
        }
        return true;
    }

private:
    const ProgressSink& m_sink;
};

glm::dmat4 toGlm(const aiMatrix4x4& m) {
    return glm::dmat4(m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4,
                      m.c4, m.d4);
}

/// Moves, turns, scales and shears; a matrix whose last row is not 0 0 0 1 would divide, at worst by zero.
bool isPlacement(const glm::dmat4& m) {
    constexpr double kNear = 1e-3;
    const auto isNear = [](double value, double wanted) { return std::abs(value - wanted) <= kNear; };
    for (int column = 0; column < 4; ++column) {
        if (!isFinite(m[column]) || !isNear(m[column].w, column == 3 ? 1.0 : 0.0)) {
            return false;
        }
    }
    return true;
}

/// How a format's meshes are taken over.
struct Merging {
    bool weld = false;   ///< vertices at the same place are one
    bool morph = false;  ///< by the weights of the file
};

/// Adds instances of Assimp's meshes to one MeshData.
class SceneMerger {
public:
    SceneMerger(const aiScene& scene, ImportedMesh& imported, Merging how)
        : m_scene(scene), m_imported(imported), m_how(how), m_welder(imported.mesh.positions) {}

    Status merge();
    [[nodiscard]] bool hasMorphed() const { return m_hasMorphed; }

private:
    Status addInstance(const aiMesh& mesh, const std::string& name, const glm::dmat4& transform);
    void addVertices(const aiMesh& mesh, const glm::dmat4& transform);
    Status addFaces(const aiMesh& mesh, bool mirrored);
    void addColours(const aiMesh& mesh);
    [[nodiscard]] std::uint32_t attributeIndex(bool has, std::size_t base, unsigned index) const {
        return has ? static_cast<std::uint32_t>(base + index) : kNoIndex;
    }

    const aiScene& m_scene;
    ImportedMesh& m_imported;
    MeshData& m_mesh = m_imported.mesh;
    Merging m_how;
    bool m_hasMorphed = false;
    Welder<> m_welder;
    std::vector<std::uint32_t> m_vertexOf;  ///< of the mesh being added: its vertex -> ours
    std::size_t m_texcoordBase = 0;
    std::size_t m_normalBase = 0;
    std::vector<glm::vec3> m_colours;
    bool m_anyColour = false;
};

void SceneMerger::addVertices(const aiMesh& mesh, const glm::dmat4& transform) {
    const glm::dmat3 forNormals = glm::transpose(glm::inverse(glm::dmat3(transform)));
    const bool moved = transform != glm::dmat4(1.0);
    m_welder.startAnew();
    m_vertexOf.clear();
    m_texcoordBase = m_mesh.texcoords.size();
    m_normalBase = m_mesh.normals.size();
    const MorphedMesh shape(mesh, m_how.morph);
    m_hasMorphed = m_hasMorphed || shape.isMorphed();
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        const glm::vec3 p = shape.position(v);
        const glm::vec3 position = moved ? glm::vec3(transform * glm::dvec4(p, 1.0)) : p;
        if (m_how.weld) {
            m_vertexOf.push_back(m_welder.index(position));
        } else {
            m_vertexOf.push_back(static_cast<std::uint32_t>(m_mesh.positions.size()));
            m_mesh.positions.push_back(position);
        }
        if (mesh.HasNormals()) {
            const glm::vec3 n = shape.normal(v);
            const glm::dvec3 turned = forNormals * glm::dvec3(n);
            m_mesh.normals.push_back(moved ? glm::vec3(glm::normalize(turned)) : n);
        }
        if (mesh.HasTextureCoords(0)) {
            m_mesh.texcoords.emplace_back(mesh.mTextureCoords[0][v].x, mesh.mTextureCoords[0][v].y);
        }
    }
    addColours(mesh);
}

void SceneMerger::addColours(const aiMesh& mesh) {
    m_colours.resize(m_mesh.positions.size(), glm::vec3(1.0f));
    for (unsigned v = 0; mesh.HasVertexColors(0) && v < mesh.mNumVertices; ++v) {
        const aiColor4D& colour = mesh.mColors[0][v];
        m_colours[m_vertexOf[v]] = {colour.r, colour.g, colour.b};
        m_anyColour = true;
    }
}

Status SceneMerger::addFaces(const aiMesh& mesh, bool mirrored) {
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        for (unsigned i = 0; i < face.mNumIndices; ++i) {
            if (face.mIndices[i] >= mesh.mNumVertices) {
                return Error{"It refers to vertex " + std::to_string(face.mIndices[i]) +
                                 " (counted from 0), but there are only " +
                                 std::to_string(mesh.mNumVertices) + ".",
                             "face " + std::to_string(f + 1) + " of \"" + mesh.mName.C_Str() + "\"",
                             "Write the file again with the program it came from."};
            }
        }
        if (face.mNumIndices == 1) {
            m_mesh.points.push_back(m_vertexOf[face.mIndices[0]]);
        } else if (face.mNumIndices == 2) {
            m_mesh.lines.push_back({m_vertexOf[face.mIndices[0]], m_vertexOf[face.mIndices[1]]});
        }
        if (face.mNumIndices < 3) {
            continue;
        }
        for (unsigned i = 0; i < face.mNumIndices; ++i) {
            const unsigned corner = face.mIndices[mirrored ? face.mNumIndices - 1 - i : i];
            m_mesh.cornerVertices.push_back(m_vertexOf[corner]);
            m_mesh.cornerTexcoords.push_back(
                attributeIndex(mesh.HasTextureCoords(0), m_texcoordBase, corner));
            m_mesh.cornerNormals.push_back(attributeIndex(mesh.HasNormals(), m_normalBase, corner));
        }
        if (m_mesh.cornerVertices.size() >= kNoIndex) {
            return Error{"The mesh has more face corners than Hitscope can count (4,294,967,294).",
                         {},
                         "Split the mesh into smaller files."};
        }
        m_mesh.faceStarts.push_back(static_cast<std::uint32_t>(m_mesh.cornerVertices.size()));
        m_mesh.faceMaterials.push_back(mesh.mMaterialIndex < m_scene.mNumMaterials ? mesh.mMaterialIndex
                                                                                   : kNoIndex);
    }
    return Done{};
}

Status SceneMerger::addInstance(const aiMesh& mesh, const std::string& name, const glm::dmat4& transform) {
    if (!mesh.HasPositions()) {
        return Done{};
    }
    m_mesh.groups.push_back(
        {FaceGroup::Kind::Object, name, static_cast<std::uint32_t>(m_mesh.faceStarts.size() - 1)});
    addVertices(mesh, transform);
    const bool mirrored = glm::determinant(glm::dmat3(transform)) < 0.0;
    return addFaces(mesh, mirrored);
}

/// Nodes are walked with a stack of our own: a file can nest them deeper than a thread's stack.
Status SceneMerger::merge() {
    struct Visit {
        const aiNode* node;
        glm::dmat4 parent;
    };
    m_mesh.faceStarts.push_back(0);
    std::vector<Visit> open{{m_scene.mRootNode, glm::dmat4(1.0)}};
    while (!open.empty()) {
        const Visit visit = open.back();
        open.pop_back();
        const glm::dmat4 transform = visit.parent * toGlm(visit.node->mTransformation);
        if (!isPlacement(transform)) {
            return Error{
                "Its matrix does not place anything: its last row is not 0 0 0 1, or not of numbers.",
                "node \"" + std::string(visit.node->mName.C_Str()) + "\"",
                "Write the file again with the program it came from."};
        }
        for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) {
            const unsigned index = visit.node->mMeshes[i];
            if (index >= m_scene.mNumMeshes) {
                continue;
            }
            const aiMesh& mesh = *m_scene.mMeshes[index];
            const aiString& name = visit.node->mName.length > 0 ? visit.node->mName : mesh.mName;
            if (Status added = addInstance(mesh, name.C_Str(), transform); !added) {
                return added;
            }
        }
        for (unsigned i = visit.node->mNumChildren; i > 0; --i) {
            open.push_back({visit.node->mChildren[i - 1], transform});
        }
    }
    if (m_mesh.faceStarts.size() == 1) {
        m_mesh.faceStarts.clear();
    }
    if (m_anyColour) {
        setColours(m_mesh, std::move(m_colours));
    }
    return Done{};
}

void noteWhatIsLeftOut(const aiScene& scene, bool hasMorphed, ImportedMesh& imported) {
    bool hasBones = false;
    bool hasMorphs = false;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        hasBones = hasBones || scene.mMeshes[m]->HasBones();
        hasMorphs = hasMorphs || scene.mMeshes[m]->mNumAnimMeshes > 0;
    }
    if (hasMorphed) {
        imported.notes += QStringLiteral("Morph targets were applied with the weights that the file gives.");
    }
    if (hasBones || scene.HasAnimations() || (hasMorphs && !hasMorphed)) {
        imported.notes += hasMorphed ? QStringLiteral("Animations and bones were left out.")
                                     : QStringLiteral("Animations, bones and morph targets were left out.");
    }
}

/// Assimp tries all its readers, of some fifty formats, on a file that the one for its suffix does not want.
void keepReadersOf(const std::string& suffix, Assimp::Importer& importer) {
    for (std::size_t i = importer.GetImporterCount(); i > 0; --i) {
        std::istringstream suffixes(importer.GetImporterInfo(i - 1)->mFileExtensions);
        bool reads = false;
        for (std::string each; suffixes >> each;) {
            reads = reads || each == suffix;
        }
        if (!reads) {
            Assimp::BaseImporter* const reader = importer.GetImporter(i - 1);
            importer.UnregisterLoader(reader);
            delete reader;
        }
    }
}

/// `why`: with a full stop or without; `advice`: empty if there is none better than the usual.
Error unreadable(const std::string& suffix, std::string why, const std::string& where,
                 const std::string& advice = {}) {
    while (why.ends_with('.')) {
        why.pop_back();
    }
    return {
        "It cannot be read as " + QString::fromStdString(suffix).toUpper().toStdString() + ": " + why + ".",
        where,
        advice.empty()
            ? "It may be damaged, or its suffix be wrong. Try opening and saving it with another program."
            : advice};
}

bool isGltf(const std::string& suffix) {
    return suffix == "gltf" || suffix == "glb";
}

/// Of a glTF file also what is to be read instead of it, and how many triangles it promises: Assimp leaves
/// out, and says nothing, those whose corners there are not.
Result<PreparedGltf> prepare(const std::string& suffix, std::string_view content, const QString& folder) {
    if (isGltf(suffix)) {
        Result<PreparedGltf> prepared = prepareGltf(content, folder);
        const Error bad = prepared ? Error{} : prepared.error();
        return prepared ? std::move(prepared) : unreadable(suffix, bad.what, bad.where, bad.advice);
    }
    if (suffix == "dae" || suffix == "fbx") {
        const Status checked = suffix == "dae" ? checkDae(content) : checkFbx(content);
        if (!checked) {
            return unreadable(suffix, checked.error().what, checked.error().where);
        }
    }
    return PreparedGltf{};
}

Status checkAfter(const aiScene& scene, std::uint64_t promised) {
    if (Status checked = checkScene(scene); !checked) {
        return checked;
    }
    std::uint64_t triangles = 0;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[m];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            triangles += mesh.mFaces[f].mNumIndices == 3 ? 1 : 0;
        }
    }
    if (triangles < promised) {
        return Error{std::to_string(promised - triangles) + " of its " + std::to_string(promised) +
                         " triangles refer to vertices that it does not have.",
                     {},
                     "Write the file again with the program it came from."};
    }
    return Done{};
}

}  // namespace

Result<ImportedMesh> readWithAssimp(const QString& path, std::string_view content,
                                    const ProgressSink& progress) {
    const QFileInfo info(path);
    const std::string suffix = info.suffix().toLower().toStdString();
    constexpr std::string_view kBinaryOfVersion1("glTF\1", 5);
    if (isGltf(suffix) && content.starts_with(kBinaryOfVersion1)) {  // Assimp takes its lengths for others
        return Error{"It is binary glTF 1.0, which cannot be read.",
                     {},
                     "Save it as glTF 2.0 with the program it came from."};
    }
    Result<PreparedGltf> prepared = prepare(suffix, content, info.absolutePath());
    if (!prepared) {
        return prepared.error();
    }
    const PreparedGltf& gltf = prepared.value();
    Assimp::Importer importer;
    keepReadersOf(suffix, importer);
    importer.SetIOHandler(  // which the importer deletes
        makeFolderFiles(info.absoluteFilePath(), {.namesAreUris = isGltf(suffix),
                                                  .document = gltf.document,
                                                  .otherName = kDecodedGltfBuffer,
                                                  .other = gltf.numbers})
            .release());
    importer.SetProgressHandler(new Progress(progress));
    const aiScene* const scene = importer.ReadFile(info.absoluteFilePath().toUtf8().constData(), 0);
    if (!scene || !scene->mRootNode) {
        const std::string why = importer.GetErrorString();
        if (why.find("bad_alloc") != std::string::npos) {
            throw std::bad_alloc();
        }
        return unreadable(suffix, why, {});
    }
    if (const Status checked = checkAfter(*scene, gltf.triangles); !checked) {
        return checked.error();
    }
    ImportedMesh imported;
    SceneMerger merger(
        *scene, imported,
        {.weld = suffix == "fbx" || suffix == "3ds" || suffix == "dae", .morph = isGltf(suffix)});
    if (const Status merged = merger.merge(); !merged) {
        return merged.error();
    }
    if (isGltf(suffix)) {
        turnColoursToSrgb(imported.mesh);
    }
    convertMaterials(*scene, imported);
    if (isGltf(suffix)) {
        nameTexturesOfUris(info.absolutePath(), imported.mesh);
    }
    imported.notes += gltf.notes;
    noteWhatIsLeftOut(*scene, merger.hasMorphed(), imported);
    tidy(imported);
    return imported;
}

}  // namespace hitscope
