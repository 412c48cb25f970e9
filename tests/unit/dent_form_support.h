// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <random>

#include "deform/hit.h"
#include "deform_support.h"

namespace hitscope::test {

inline DentForm formOf(DentProfile profile) {
    DentForm form;
    form.profile = profile;
    return form;
}

inline DentForm pressOf(float radius) {
    DentForm form;
    form.direction = DentDirection::Press;
    form.radius = radius;
    return form;
}

/// Of any form, on and about a sphere of 1 m.
inline Hit anyHit(std::mt19937& random, std::size_t index) {
    std::uniform_real_distribution<float> share(0.0f, 1.0f);
    Hit hit = randomHit(random, 1.0f);
    hit.point = glm::normalize(hit.point) * (0.9f + 0.2f * share(random));
    hit.constants = {0.05f + 0.4f * share(random), 0.05f * share(random), 0.3f * share(random)};
    hit.normal = index % 3 == 0 ? glm::vec3(0.0f) : glm::normalize(hit.point);
    if (index % 7 == 6) {
        hit.form = pressOf(0.05f + 0.3f * share(random));
    } else {
        hit.form = formOf(static_cast<DentProfile>(index % 7));
        hit.form.direction = index % 2 == 0 ? DentDirection::Projectile : DentDirection::IntoSurface;
        std::generate(hit.form.curve.begin(), hit.form.curve.end(),
                      [&] { return 2.0f * share(random) - 1.0f; });
    }
    return checkedHit(hit).value();
}

}  // namespace hitscope::test
