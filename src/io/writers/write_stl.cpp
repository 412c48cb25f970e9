// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "io/export_names.h"
#include "io/number_text.h"
#include "io/writers/coordinate_check.h"
#include "io/writers/file_positions.h"
#include "io/writers/piece_writer.h"
#include "io/writers/stl_facet.h"
#include "mesh/triangulate.h"

namespace hitscope {
namespace {

void putBinary(PieceWriter& out, const StlFacet& facet) {
    out.plain(stlNormal(facet));
    out.plain(facet);
    out.plain(std::uint16_t{0});
}

void putVector(std::string& text, const char* word, const glm::vec3& vector) {
    text += word;
    for (int i = 0; i < 3; ++i) {
        text += ' ';
        appendTwiceRoundedFloat(text, vector[i]);
    }
    text += '\n';
}

void putAscii(PieceWriter& out, const StlFacet& facet) {
    std::string& text = out.text();
    putVector(text, "facet normal", stlNormal(facet));
    text += "outer loop\n";
    for (const glm::vec3& corner : facet) {
        putVector(text, "vertex", corner);
    }
    text += "endloop\nendfacet\n";
}

void putFacets(const MeshExport& what, PieceWriter& out, bool isAscii) {
    const MeshData& mesh = *what.mesh;
    const FilePositions positions(what);
    Triangulator triangulator;
    std::vector<std::uint32_t> corners;
    for (std::size_t f = 0; f < mesh.faceCount() && out.goesOn(f, mesh.faceCount()); ++f) {
        corners.clear();
        triangulator.triangulate(mesh.positions, mesh.face(f), corners);
        for (std::size_t t = 0; t + 3 <= corners.size(); t += 3) {
            StlFacet facet;
            for (std::size_t i = 0; i < 3; ++i) {
                facet[i] = glm::vec3(positions.now(mesh.face(f)[corners[t + i]]));
            }
            isAscii ? putAscii(out, facet) : putBinary(out, facet);
        }
    }
}

QStringList notesOf(const MeshExport& what) {
    const MeshData& mesh = *what.mesh;
    QStringList notes;
    QStringList lost;
    const auto add = [&lost](bool has, const char* name) {
        if (has) {
            lost += QString::fromLatin1(name);
        }
    };
    add(mesh.cornerVertices.size() != 3 * mesh.faceCount(), "polygons");
    add(!mesh.texcoords.empty(), "texture coordinates");
    add(!mesh.materials.empty(), "materials");
    add(!mesh.colours.empty(), "vertex colours");
    add(!mesh.groups.empty(), "groups");
    add(!mesh.lines.empty() || !mesh.points.empty(), "lines and points");
    add(std::ranges::find(mesh.sourceVertices, kNoIndex) != mesh.sourceVertices.end(),
        "which vertices are new");
    if (!lost.isEmpty()) {
        notes += QStringLiteral("STL has triangles only; left out: %1.").arg(lost.join(QStringLiteral(", ")));
    }
    if (!FilePositions(what).fitFloats()) {
        notes += QStringLiteral("STL has floats only; the coordinates are rounded.");
    }
    return notes;
}

}  // namespace

Result<QStringList> exportStl(const MeshExport& what, const QString& path, const StlOptions& options) {
    if (const Status fits = checkLengths(what); !fits) {
        return fits.error();
    }
    if (const Status fits = checkCoordinates(*what.mesh, what.positions, path); !fits) {
        return fits.error();
    }
    const MeshData& mesh = *what.mesh;
    const auto make = [&](PieceWriter& out) {
        std::string name = nameOnLine(mesh.name);
        if (options.isAscii) {
            out.put("solid " + name + '\n');
            putFacets(what, out, true);
            out.put("endsolid " + name + '\n');
            return;
        }
        std::string header = "Written by Hitscope " HITSCOPE_VERSION;
        header.resize(80, '\0');
        out.put(header);
        out.plain(static_cast<std::uint32_t>(mesh.cornerVertices.size() - 2 * mesh.faceCount()));
        putFacets(what, out, false);
    };
    if (const Status written = writeInPieces(what, path, make); !written) {
        return written.error();
    }
    return notesOf(what);
}

}  // namespace hitscope
