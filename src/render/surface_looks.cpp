// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surface_looks.h"

namespace hitscope::render {
namespace {

Material makeClay() {
    Material clay;
    clay.diffuse = glm::vec3(0.62f, 0.38f, 0.27f);
    clay.specular = glm::vec3(0.05f);
    clay.shininess = 8.0f;
    return clay;
}

Material makeMetal() {
    Material metal;
    metal.diffuse = glm::vec3(0.74f, 0.75f, 0.77f);
    metal.metalRoughness.metalness = 1.0f;
    metal.metalRoughness.roughness = 0.34f;
    return metal;
}

}  // namespace

const MaterialSet* materialOfLook(SurfaceLook look) {
    static const MaterialSet clay(makeClay());
    static const MaterialSet metal(makeMetal());
    switch (look) {
        case SurfaceLook::File:
            return nullptr;
        case SurfaceLook::Matcap:  // its colour comes from the normal alone
        case SurfaceLook::Clay:
            return &clay;
        case SurfaceLook::Metal:
            return &metal;
    }
    return nullptr;
}

}  // namespace hitscope::render
