// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/target.h"

#include <algorithm>
#include <utility>

namespace hitscope {

Target::Target(TargetState state)
    : TargetState(std::move(state)), deformed(shape.mesh, shape.render), trueNormals(*shape.trueNormals) {
    const glm::vec3 size = deformed.render().bounds.size();
    m_extent = std::max({size.x, size.y, size.z});
}

Bounds Target::worldBounds() const {
    return hitscope::worldBounds(deformed.render(), transform);
}

}  // namespace hitscope
