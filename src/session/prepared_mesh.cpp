// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/prepared_mesh.h"

#include <utility>

namespace hitscope {

PreparedMesh prepareMesh(MeshData mesh) {
    PreparedMesh prepared;
    prepared.mesh = std::make_shared<const MeshData>(std::move(mesh));
    prepared.render = std::make_shared<const RenderMesh>(buildRenderMesh(*prepared.mesh));
    prepared.trueNormals = std::make_shared<const TrueNormals>(*prepared.mesh, *prepared.render);
    return prepared;
}

}  // namespace hitscope
