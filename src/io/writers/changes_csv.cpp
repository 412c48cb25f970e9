// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/changes_csv.h"

#include "io/writers/coordinate_check.h"
#include "io/writers/file_positions.h"
#include "io/writers/piece_writer.h"

namespace hitscope {

void ChangesCsv::header() {
    for (const char* const name :
         {"vertex", "original_x", "original_y", "original_z", "current_x", "current_y", "current_z",
          "displacement_x", "displacement_y", "displacement_z", "displacement"}) {
        m_csv.text(name);
    }
    if (m_columns.turned) {
        m_csv.text("normal_turned_degrees");
    }
    if (m_columns.hits) {
        m_csv.text("hits");
    }
    if (m_columns.isNew) {
        m_csv.text("new");
    }
    m_csv.endRow();
}

namespace {

/// Floats where the file's coordinates are floats: fewer digits say the same.
template <class Vector>
void putChanges(const MeshExport& what, bool allVertices, PieceWriter& out) {
    const FilePositions positions(what);
    CsvWriter csv;
    ChangesCsv rows(csv, {.turned = false, .hits = !what.hits.empty(), .isNew = !what.mesh->isAsRead()});
    rows.header();
    for (std::size_t v = 0; v < what.positions.size() && out.goesOn(v, what.positions.size()); ++v) {
        if (!allVertices && !positions.isMoved(v)) {
            continue;
        }
        const glm::dvec3 displacement = positions.displacement(v);
        rows.row<Vector>(static_cast<std::uint32_t>(v), Vector(positions.original(v)),
                         Vector(positions.now(v)), Vector(displacement), glm::length(displacement), 0.0f,
                         what.hits.empty() ? 0 : what.hits[v], what.mesh->isNew(v));
        out.put(csv.take());
    }
    out.put(csv.take());
}

}  // namespace

Result<QStringList> exportChangesCsv(const MeshExport& what, const QString& path,
                                     const ChangesCsvOptions& options) {
    if (const Status fits = checkLengths(what); !fits) {
        return fits.error();
    }
    if (const Status fits = checkDisplacements(what, path); !fits) {
        return fits.error();
    }
    const bool areFloats = FilePositions(what).fitFloatsMoved();
    const Status written = writeInPieces(what, path, [&](PieceWriter& out) {
        areFloats ? putChanges<glm::vec3>(what, options.allVertices, out)
                  : putChanges<glm::dvec3>(what, options.allVertices, out);
    });
    return written ? Result<QStringList>(QStringList()) : Result<QStringList>(written.error());
}

}  // namespace hitscope
