// SPDX-License-Identifier: GPL-3.0-or-later
#include "io_support.h"

#include <QDir>
#include <QFile>
#include <cstring>

#include "io/save_image.h"

namespace hitscope::test {
namespace {

template <class Values>
bool same(const Values& a, const Values& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), std::span(a).size_bytes()) == 0);
}

bool sameGroups(const MeshData& a, const MeshData& b) {
    return std::equal(a.groups.begin(), a.groups.end(), b.groups.begin(), b.groups.end(),
                      [](const FaceGroup& x, const FaceGroup& y) {
                          return x.kind == y.kind && x.name == y.name && x.firstFace == y.firstFace;
                      });
}

bool sameMaterials(const MeshData& a, const MeshData& b) {
    return std::equal(a.materials.begin(), a.materials.end(), b.materials.begin(), b.materials.end(),
                      [](const Material& x, const Material& y) {
                          return x.name == y.name && x.ambient == y.ambient && x.diffuse == y.diffuse &&
                                 x.specular == y.specular && x.shininess == y.shininess &&
                                 x.opacity == y.opacity && x.diffuseTexture == y.diffuseTexture &&
                                 x.diffuseImage == y.diffuseImage && x.normalMap.kind == y.normalMap.kind &&
                                 x.normalMap.texture == y.normalMap.texture &&
                                 x.normalMap.strength == y.normalMap.strength &&
                                 x.normalMap.image == y.normalMap.image &&
                                 x.metalRoughness.metalness == y.metalRoughness.metalness &&
                                 x.metalRoughness.roughness == y.metalRoughness.roughness &&
                                 x.metalRoughness.texture == y.metalRoughness.texture &&
                                 x.metalRoughness.image == y.metalRoughness.image;
                      });
}

bool sameImages(const MeshData& a, const MeshData& b) {
    return std::equal(a.images.begin(), a.images.end(), b.images.begin(), b.images.end(),
                      [](const Image& x, const Image& y) {
                          return x.width == y.width && x.height == y.height && x.pixels == y.pixels;
                      });
}

}  // namespace

QString writeFile(const QString& folder, const QString& name, std::string_view content) {
    const QString path = QDir(folder).filePath(name);
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content.data(), static_cast<qint64>(content.size())) !=
                                                static_cast<qint64>(content.size())) {
        qFatal("cannot write %s", qPrintable(path));
    }
    return path;
}

std::string readFile(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

QStringList differences(const MeshData& a, const MeshData& b) {
    const std::pair<const char*, bool> parts[] = {
        {"positions", same(a.positions, b.positions)},
        {"filePositions", same(a.filePositions, b.filePositions)},
        {"placement", a.placement.centre == b.placement.centre && a.placement.scale == b.placement.scale},
        {"colours", same(a.colours, b.colours)},
        {"normals", same(a.normals, b.normals)},
        {"texcoords", same(a.texcoords, b.texcoords)},
        {"faceStarts", same(a.faceStarts, b.faceStarts)},
        {"cornerVertices", same(a.cornerVertices, b.cornerVertices)},
        {"cornerTexcoords", same(a.cornerTexcoords, b.cornerTexcoords)},
        {"cornerNormals", same(a.cornerNormals, b.cornerNormals)},
        {"faceMaterials", same(a.faceMaterials, b.faceMaterials)},
        {"faceSmoothing", same(a.faceSmoothing, b.faceSmoothing)},
        {"groups", sameGroups(a, b)},
        {"materials", sameMaterials(a, b)},
        {"images", sameImages(a, b)},
        {"lines", a.lines == b.lines},
        {"points", same(a.points, b.points)},
    };
    QStringList different;
    for (const auto& [name, equal] : parts) {
        if (!equal) {
            different += QString::fromLatin1(name);
        }
    }
    return different;
}

QByteArray smallPng() {
    return encodePng(Image{2, 1, {255, 0, 0, 255, 0, 255, 0, 128}});
}

}  // namespace hitscope::test
