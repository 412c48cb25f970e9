// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/texture.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace hitscope::bench {

namespace {

constexpr int kCourses = 8;  // even, so that the bricks' shift by half closes at the edge
constexpr int kBricks = 4;

/// Noise in [0, 255] that belongs to the pixel.
std::uint32_t noise(std::uint32_t x, std::uint32_t y) {
    std::uint32_t h = x * 0x9e3779b1u ^ y * 0x85ebca77u;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    return (h ^ (h >> 12)) >> 24;
}

struct Colour {
    int red, green, blue;
};
constexpr Colour kBrick{150, 82, 60};
constexpr Colour kMortar{165, 160, 150};

bool isMortar(int x, int y, int size) {
    const int course = y * kCourses / size;
    const int shifted = (x + (course % 2) * size / (2 * kBricks)) % size;
    const int alongBrick = shifted * kBricks % size;
    const int upCourse = y * kCourses % size;
    return alongBrick < size / 20 || upCourse < size / 10;
}

Material texturedMaterial() {
    Material material;
    material.name = "bricks";
    material.diffuse = glm::vec3(1.0f);
    material.diffuseTexture = "bricks";
    material.diffuseImage = 0;
    return material;
}

}  // namespace

Image makeTexture(int size) {
    Image image;
    image.width = size;
    image.height = size;
    image.pixels.reserve(std::size_t{4} * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const Colour base = isMortar(x, y, size) ? kMortar : kBrick;
            const int rough =
                static_cast<int>(noise(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))) / 4 -
                32;
            for (const int channel : {base.red, base.green, base.blue}) {
                image.pixels.push_back(static_cast<std::uint8_t>(std::clamp(channel + rough, 0, 255)));
            }
            image.pixels.push_back(255);
        }
    }
    return image;
}

void useTexture(MeshData& mesh) {
    mesh.materials = {texturedMaterial()};
    mesh.materials.front().diffuseImage = -1;
    mesh.faceMaterials.assign(mesh.faceCount(), 0);
}

MeshData textureCarrier(Image image) {
    MeshData mesh;
    mesh.materials = {texturedMaterial()};
    mesh.images.push_back(std::move(image));
    return mesh;
}

}  // namespace hitscope::bench
