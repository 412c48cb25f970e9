// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/other_readers.h"

#include <assimp/scene.h>
#include <fcntl.h>
#include <tiny_obj_loader.h>
#include <unistd.h>

#include <QFile>
#include <assimp/Importer.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace hitscope::bench {

namespace {

Error notRead(const QString& path, const char* by) {
    return {std::string("The file cannot be read by ") + by + ".", path.toStdString(), ""};
}

}  // namespace

Status readWithTinyObjLoader(const QString& path) {
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning;
    std::string error;
    const bool read = tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error,
                                       QFile::encodeName(path).constData());
    return read && !attributes.vertices.empty() ? Status(Done{}) : notRead(path, "tinyobjloader");
}

Status readWithAssimp(const QString& path) {
    Assimp::Importer importer;
    const aiScene* const scene = importer.ReadFile(QFile::encodeName(path).constData(), 0);
    return scene != nullptr && scene->HasMeshes() ? Status(Done{}) : notRead(path, "Assimp");
}

Status copyAndSync(const QString& from, const QString& to) {
    std::error_code wrong;
    std::filesystem::copy_file(from.toStdString(), to.toStdString(),
                               std::filesystem::copy_options::overwrite_existing, wrong);
    const int file = wrong ? -1 : ::open(QFile::encodeName(to).constData(), O_RDONLY | O_CLOEXEC);
    const bool synced = file >= 0 && ::fsync(file) == 0;
    if (file >= 0) {
        ::close(file);
    }
    return synced ? Status(Done{})
                  : Error{"The file cannot be copied.", to.toStdString(),
                          "Make room there, or set TMPDIR to another folder."};
}

}  // namespace hitscope::bench
