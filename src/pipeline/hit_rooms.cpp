// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/hit_rooms.h"

namespace hitscope {

namespace {

int limit(const std::optional<int>& asIf, GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return asIf.value_or(value);
}

}  // namespace

std::vector<HitRoom> roomsToTry(const PipelineOptions& options) {
    const std::size_t uniforms =
        hitsInUniforms(limit(options.vertexUniformComponents, GL_MAX_VERTEX_UNIFORM_COMPONENTS));
    const std::size_t block = hitsInBlock(limit(options.uniformBlockBytes, GL_MAX_UNIFORM_BLOCK_SIZE));
    std::vector<HitRoom> rooms;
    if (uniforms >= kMostArrayHits) {
        rooms.push_back({HitStorage::Floats, uniforms});
    }
    if (block > uniforms) {
        rooms.push_back({HitStorage::UniformBlock, block});
    }
    rooms.push_back({HitStorage::Floats, uniforms});
    rooms.push_back({HitStorage::Vectors, uniforms});
    return rooms;
}

std::vector<HitRoom> formRoomsToTry(const PipelineOptions& options) {
    const int components = limit(options.vertexUniformComponents, GL_MAX_VERTEX_UNIFORM_COMPONENTS);
    const HitRoom floats = formsInUniforms(HitStorage::Floats, components);
    const HitRoom block = formsInBlock(limit(options.uniformBlockBytes, GL_MAX_UNIFORM_BLOCK_SIZE));
    std::vector<HitRoom> rooms;
    if (block.hits + block.curves > floats.hits + floats.curves) {
        rooms.push_back(block);
    }
    rooms.push_back(floats);
    rooms.push_back(formsInUniforms(HitStorage::Vectors, components));
    return rooms;
}

}  // namespace hitscope
