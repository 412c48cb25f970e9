// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/assimp_check.h"

#include <assimp/scene.h>
#include <malloc.h>

#include <cstddef>
#include <string>
#include <vector>

namespace hitscope {
namespace {

/// Of an array that new[] made: whether `count` entries were allocated, as the allocator knows.
template <class T>
bool holds(const T* array, std::size_t count) {
    return count == 0 || (array && ::malloc_usable_size(const_cast<T*>(array)) / sizeof(T) >= count);
}

/// Faces have destructors, so the compiler keeps their number before them.
bool holdsFaces(const aiFace* faces, std::size_t count) {
    if (count == 0 || !faces) {
        return count == 0;
    }
    auto* const start = reinterpret_cast<std::size_t*>(const_cast<aiFace*>(faces)) - 1;
    const std::size_t bytes = ::malloc_usable_size(start);
    return bytes > sizeof *start && (bytes - sizeof *start) / sizeof(aiFace) >= count;
}

bool meshHolds(const aiMesh& mesh) {
    const std::size_t vertices = mesh.mNumVertices;
    if ((mesh.mVertices && !holds(mesh.mVertices, vertices)) ||
        (mesh.mNormals && !holds(mesh.mNormals, vertices)) ||
        (mesh.mTextureCoords[0] && !holds(mesh.mTextureCoords[0], vertices)) ||
        (mesh.mColors[0] && !holds(mesh.mColors[0], vertices)) || !holdsFaces(mesh.mFaces, mesh.mNumFaces)) {
        return false;
    }
    for (unsigned t = 0; t < mesh.mNumAnimMeshes; ++t) {
        const aiAnimMesh& target = *mesh.mAnimMeshes[t];
        if ((target.mVertices && !holds(target.mVertices, vertices)) ||
            (target.mNormals && !holds(target.mNormals, vertices))) {
            return false;
        }
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        if (!holds(mesh.mFaces[f].mIndices, mesh.mFaces[f].mNumIndices)) {
            return false;
        }
    }
    return true;
}

bool textureHolds(const aiTexture& texture) {
    const std::size_t bytes = texture.mHeight == 0
                                  ? texture.mWidth
                                  : std::size_t{texture.mWidth} * texture.mHeight * sizeof(aiTexel);
    return !texture.pcData || holds(reinterpret_cast<const std::byte*>(texture.pcData), bytes);
}

Error shorter(const char* what, const aiString& name) {
    return {std::string("The ") + what + " has fewer numbers than it says.",
            "\"" + std::string(name.C_Str()) + "\"", "Write the file again with the program it came from."};
}

}  // namespace

Status checkScene(const aiScene& scene) {
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        if (!meshHolds(*scene.mMeshes[m])) {
            return shorter("mesh", scene.mMeshes[m]->mName);
        }
    }
    for (unsigned t = 0; t < scene.mNumTextures; ++t) {
        if (!textureHolds(*scene.mTextures[t])) {
            return shorter("picture", scene.mTextures[t]->mFilename);
        }
    }
    std::vector<const aiNode*> open{scene.mRootNode};
    while (!open.empty()) {
        const aiNode& node = *open.back();
        open.pop_back();
        if (!holds(node.mMeshes, node.mNumMeshes) || !holds(node.mChildren, node.mNumChildren)) {
            return shorter("node", node.mName);
        }
        open.insert(open.end(), node.mChildren, node.mChildren + node.mNumChildren);
    }
    return Done{};
}

}  // namespace hitscope
