// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/check/written_check.h"

#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <cmath>

#include "core/give_up.h"
#include "io/check/written_materials_check.h"
#include "io/check/written_stl_check.h"
#include "io/check/written_surface_check.h"
#include "io/import.h"
#include "io/number_text.h"
#include "io/readers/ply_header.h"
#include "io/writers/file_positions.h"
#include "io/writers/line_segments.h"

namespace hitscope {
namespace {

/// What a file makes of a coordinate.
double rounded(double coordinate, PlyType type) {
    return isWhole(type)              ? std::round(coordinate)
           : type == PlyType::Float32 ? static_cast<double>(static_cast<float>(coordinate))
                                      : coordinate;
}

/// The type of a PLY file's coordinates (of `name`: "x", or "nx"); floats in all other formats.
PlyType coordinateType(const QString& path, const QString& suffix, const char* name) {
    QFile file(path);
    if (suffix != QStringLiteral("ply") || !file.open(QIODevice::ReadOnly)) {
        return PlyType::Float32;
    }
    const QByteArray start = file.read(kLongestPlyHeader);
    const std::string_view bytes(start.constData(), static_cast<std::size_t>(start.size()));
    const Result<PlyHeader> header = parsePlyHeader(bytes, static_cast<std::uint64_t>(file.size()));
    if (header) {
        for (const PlyElement& element : header.value().elements) {
            for (const PlyProperty& property : element.properties) {
                if (element.name == "vertex" && property.name == name) {
                    return property.type;
                }
            }
        }
    }
    return PlyType::Float32;
}

glm::dvec3 readPosition(const MeshData& mesh, std::size_t v) {
    return mesh.filePositions.empty() ? glm::dvec3(mesh.positions[v]) : mesh.filePositions[v];
}

std::string counts(const char* what, std::size_t is, std::size_t meant) {
    return "it has " + std::to_string(is) + " " + what + " and should have " + std::to_string(meant);
}

Status compareVertices(const MeshData& read, const MeshExport& what, const QString& path, PlyType type) {
    const FilePositions positions(what);
    for (std::size_t v = 0; v < what.positions.size(); ++v) {
        mayGiveUp(v);
        const glm::dvec3 meant = positions.now(v);
        const glm::dvec3 is = readPosition(read, v);
        for (int i = 0; i < 3; ++i) {
            if (rounded(is[i], type) != rounded(meant[i], type)) {
                return notAsMeant(path, elsewhere("vertex " + std::to_string(v + 1), is, meant));
            }
        }
    }
    return Done{};
}

Status compareFaces(const MeshData& read, const MeshData& meant, const QString& path) {
    for (std::size_t f = 0; f < meant.faceCount(); ++f) {
        mayGiveUp(f);
        const std::span<const std::uint32_t> is = read.face(f);
        const std::span<const std::uint32_t> should = meant.face(f);
        if (!std::equal(is.begin(), is.end(), should.begin(), should.end())) {
            return notAsMeant(path, "face " + std::to_string(f + 1) + " has other vertices");
        }
    }
    return Done{};
}

/// OBJ and PLY; PLY has no points.
Status compareLoose(const MeshData& read, const MeshData& meant, bool hasPoints, const QString& path) {
    const std::vector<std::uint32_t> is = lineSegments(read);
    const std::vector<std::uint32_t> should = lineSegments(meant);
    if (is.size() != should.size()) {
        return notAsMeant(path, counts("segments of lines", is.size() / 2, should.size() / 2));
    }
    const auto [at, wanted] = std::mismatch(is.begin(), is.end(), should.begin());
    if (at != is.end()) {
        return notAsMeant(path, "segment " + std::to_string((at - is.begin()) / 2 + 1) +
                                    " of the lines has other vertices");
    }
    return hasPoints && read.points != meant.points ? Status(notAsMeant(path, "it has other points"))
                                                    : Status(Done{});
}

/// The file's own vertices and faces, and what their surface has.
Status compareMesh(const MeshData& read, const MeshExport& what, const WrittenNormals& normals,
                   const QString& path, const ExportGoOn& goOn) {
    constexpr double kSurface = 0.4;  // is begun with so much behind it
    if (read.positions.size() != what.positions.size()) {
        return notAsMeant(path, counts("vertices", read.positions.size(), what.positions.size()));
    }
    if (read.faceCount() != what.mesh->faceCount()) {
        return notAsMeant(path, counts("faces", read.faceCount(), what.mesh->faceCount()));
    }
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (Status same = compareVertices(read, what, path, coordinateType(path, suffix, "x")); !same) {
        return same;
    }
    if (Status same = compareFaces(read, *what.mesh, path); !same) {
        return same;
    }
    if (Status same = compareLoose(read, *what.mesh, suffix == QStringLiteral("obj"), path); !same) {
        return same;
    }
    const bool isObj = suffix == QStringLiteral("obj");
    std::optional<std::string> difference = surfaceDifference(
        read, what, normals, isObj ? SurfaceFormat::Obj : SurfaceFormat::Ply,
        !isWhole(coordinateType(path, suffix, "nx")), [&goOn](ExportStep step, double share) {
            return !goOn || goOn(step, kSurface + (1.0 - kSurface) * share);
        });
    if (!difference) {
        difference = isObj ? materialDifference(read, what, path) : textureDifference(read, what, path);
    }
    return difference ? Status(notAsMeant(path, *difference)) : Status(Done{});
}

void appendVector(std::string& text, const glm::dvec3& vector) {
    for (int i = 0; i < 3; ++i) {
        text += ' ';
        appendNumber(text, vector[i]);
    }
}

}  // namespace

Error notAsMeant(const QString& path, const std::string& difference) {
    return {"The file that was written is not what was meant: " + difference + ".", path.toStdString(),
            "Export again, to another disk if it happens twice."};
}

std::string elsewhere(const std::string& which, const glm::dvec3& is, const glm::dvec3& meant) {
    std::string text = which + " is at";
    appendVector(text, is);
    text += " and should be at";
    appendVector(text, meant);
    return text;
}

Status verifyWritten(const QString& path, const MeshExport& what) {
    return verifyWritten(path, what, {{what.normals, {}}, false});
}

Status verifyWritten(const QString& path, const MeshExport& what, const WrittenNormals& normals,
                     const ExportGoOn& goOn) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == QStringLiteral("glb") || suffix == QStringLiteral("gltf")) {
        return verifyWrittenGltf(path, what, goOn);
    }
    const bool isStl = suffix == QStringLiteral("stl");
    if (!isStl && suffix != QStringLiteral("obj") && suffix != QStringLiteral("ply")) {
        return Done{};
    }
    const Result<ImportedMesh> read = importMesh(path, {}, [&goOn](double share) {
        if (goOn) {
            goOn(ExportStep::Checking, share);  // the scope of this thread ends it
        }
    });
    if (!read) {
        return notAsMeant(path, "it cannot be read (" + read.error().what + ")");
    }
    return isStl ? verifyWrittenStl(read.value().mesh, what, path, goOn)
                 : compareMesh(read.value().mesh, what, normals, path, goOn);
}

}  // namespace hitscope
