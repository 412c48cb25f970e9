// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <span>

#include "io/export_obj.h"
#include "io/readers/read_mesh.h"
#include "io_support.h"

namespace hitscope::test {

/// Everything an OBJ can hold: polygons, corners with and without coordinates, things no face uses.
inline const char* const kRich =
    "mtllib rich.mtl\n"
    "v 0.1 0.2 0.3\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 7 7 7\nv 123456.789012345 1e-7 -0\nv 2 2 2\n"
    "vt 0 0\nvt 0.1 0.2\nvt 9 9\nvt 1 1\nvn 0 0 2\nvn 0 1 0\nvn 0.6 0.8 0\n"
    "o body\ng left\nusemtl wood\ns 1\nf 1/1/1 2/2/1 3/4/1 4/2/1\nf 1//1 2//1 3//2\n"
    "g right\nusemtl tin\ns off\nf 1/1 2/2 3/4 4/1 6/2\nf 6 1 2\nusemtl wood\ng none\no last\n"
    "f 3/1/1 2 1/1\nl 1 2 7\np 5\np 6\ng trailing\n";
inline const char* const kRichMtl =
    "newmtl wood\nKa 0.1 0.2 0.3\nKd 0.4 0.5 0.6\nKs 0.7 0.8 0.9\nNs 12.5\nd 0.75\nmap_Kd maps/wood.png\n"
    "newmtl tin\nKd 1 0 0\nnewmtl unused\nKd 0 1 0\nmap_Kd lost.png\n";

inline ImportedMesh read(const QString& path) {
    const Result<ImportedMesh> result = readMesh(path, {});
    if (!result) {
        qWarning("%s", result.error().message().c_str());
        return {};
    }
    return result.value();
}

inline ObjExport exportOf(const MeshData& mesh, std::span<const glm::vec3> positions) {
    ObjExport what;
    what.mesh = &mesh;
    what.positions = positions;
    return what;
}

/// rich.obj with its library and texture; `folder` has a folder "maps".
inline QString writeRich(const QString& folder) {
    writeFile(folder, QStringLiteral("rich.mtl"), kRichMtl);
    writeFile(folder, QStringLiteral("maps/wood.png"), smallPng().toStdString());
    return writeFile(folder, QStringLiteral("rich.obj"), kRich);
}

}  // namespace hitscope::test
