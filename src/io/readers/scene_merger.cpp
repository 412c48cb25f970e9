// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/scene_merger.h"

#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "core/finite.h"
#include "io/readers/assimp_morphs.h"
#include "io/readers/tidy.h"

namespace hitscope {
namespace {

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

bool hasFaces(const aiMesh& mesh) {
    return mesh.HasPositions() && std::any_of(mesh.mFaces, mesh.mFaces + mesh.mNumFaces,
                                              [](const aiFace& face) { return face.mNumIndices > 2; });
}

bool usesAll(const aiMesh& mesh) {
    std::vector<bool> isUsed(mesh.mNumVertices, false);
    unsigned used = 0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        for (unsigned i = 0; i < mesh.mFaces[f].mNumIndices; ++i) {
            const unsigned vertex = mesh.mFaces[f].mIndices[i];
            if (vertex < mesh.mNumVertices && !isUsed[vertex]) {
                isUsed[vertex] = true;
                ++used;
            }
        }
    }
    return used == mesh.mNumVertices;
}

bool areAlike(const aiVector3D* a, const aiVector3D* b, unsigned count) {
    return (a == nullptr) == (b == nullptr) &&
           (a == nullptr || std::memcmp(a, b, count * sizeof(aiVector3D)) == 0);
}

/// Materials of one mesh that has all vertices in one list: Assimp gives each material a copy of it. Two
/// shells at the same place use all of theirs.
bool shareVertices(const aiMesh& a, const aiMesh& b) {
    const unsigned count = a.mNumVertices;
    return count == b.mNumVertices && a.mNumAnimMeshes == 0 && b.mNumAnimMeshes == 0 &&
           areAlike(a.mVertices, b.mVertices, count) && areAlike(a.mNormals, b.mNormals, count) &&
           areAlike(a.mTextureCoords[0], b.mTextureCoords[0], count) && (!usesAll(a) || !usesAll(b));
}

}  // namespace

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

void SceneMerger::beginGroup(const std::string& name) {
    m_mesh.groups.push_back(
        {FaceGroup::Kind::Object, name, static_cast<std::uint32_t>(m_mesh.faceStarts.size() - 1)});
}

Status SceneMerger::addInstance(const aiMesh& mesh, const glm::dmat4& transform) {
    if (!mesh.HasPositions()) {
        return Done{};
    }
    if (m_before == nullptr || !shareVertices(*m_before, mesh)) {
        addVertices(mesh, transform);
    } else {
        addColours(mesh);
    }
    m_before = &mesh;
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
        m_before = nullptr;
        std::optional<std::string> group;  // which its meshes of several materials share
        for (unsigned i = 0; i < visit.node->mNumMeshes; ++i) {
            const unsigned index = visit.node->mMeshes[i];
            if (index >= m_scene.mNumMeshes) {
                continue;
            }
            const aiMesh& mesh = *m_scene.mMeshes[index];
            const std::string name =
                visit.node->mName.length > 0 ? visit.node->mName.C_Str() : mesh.mName.C_Str();
            if (hasFaces(mesh) && group != name) {
                group = name;
                beginGroup(name);
            }
            if (Status added = addInstance(mesh, transform); !added) {
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

}  // namespace hitscope
