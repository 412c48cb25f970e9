// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/assimp_morphs.h"

#include <assimp/mesh.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace hitscope {

namespace {

glm::dvec3 toGlm(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

}  // namespace

MorphedMesh::MorphedMesh(const aiMesh& mesh, bool applies) : m_mesh(mesh) {
    for (unsigned t = 0; applies && t < mesh.mNumAnimMeshes; ++t) {
        const aiAnimMesh& target = *mesh.mAnimMeshes[t];
        if (std::isfinite(target.mWeight) && target.mWeight != 0.0f) {
            m_targets.push_back(&target);
        }
    }
}

/// Assimp has added each target to the base already. With one of weight 1 the sum is that, to the last bit.
glm::vec3 MorphedMesh::position(unsigned vertex) const {
    const glm::dvec3 base = toGlm(m_mesh.mVertices[vertex]);
    glm::dvec3 sum = base;
    for (const aiAnimMesh* const target : m_targets) {
        if (target->HasPositions()) {
            sum += double{target->mWeight} * (toGlm(target->mVertices[vertex]) - base);
        }
    }
    return glm::vec3(sum);
}

glm::vec3 MorphedMesh::normal(unsigned vertex) const {
    const glm::dvec3 base = toGlm(m_mesh.mNormals[vertex]);
    glm::dvec3 sum = base;
    for (const aiAnimMesh* const target : m_targets) {
        if (target->HasNormals()) {
            sum += double{target->mWeight} * (toGlm(target->mNormals[vertex]) - base);
        }
    }
    const double length = glm::length(sum);
    return glm::vec3(isMorphed() && length > 0.0 ? sum / length : base);
}

}  // namespace hitscope
