// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/shot_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <glm/geometric.hpp>

#include "deform/dent_shape.h"
#include "models/quantity_text.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

struct ShotText {
    Q_DECLARE_TR_FUNCTIONS(hitscope::ShotText)
};

QString oneShot(const ShotCount& count, const Session& session) {
    if (count.hits > 0) {
        const Target* target = session.targets().find(count.lastHit);
        return target != nullptr ? ShotText::tr("The shot hit %1.").arg(target->name)
                                 : ShotText::tr("The shot hit.");
    }
    if (count.landed > 0) {
        return ShotText::tr("The shot struck the floor.");
    }
    return count.isOver() ? ShotText::tr("The shot went past everything.")
                          : ShotText::tr("The shot is on its way.");
}

QString wholeSeries(const ShotCount& count) {
    QString text = ShotText::tr("%1, %2").arg(ShotText::tr("%Ln {shot|shots}", nullptr, trCount(count.shots)),
                                              ShotText::tr("%Ln {hit|hits}", nullptr, trCount(count.hits)));
    if (count.landed > 0) {
        text += ShotText::tr(", %1 on the floor").arg(countText(count.landed));
    }
    if (count.past > 0) {
        text += ShotText::tr(", %1 past everything").arg(countText(count.past));
    }
    return text;
}

bool hasVertexWithin(const HitReach& reach, const DeformedMesh& mesh) {
    const std::span<const glm::vec3> positions = mesh.positions();
    return std::any_of(positions.begin(), positions.end(), [&reach](const glm::vec3& position) {
        return glm::distance(glm::dvec3(position), glm::dvec3(reach.centre)) <=
               static_cast<double>(reach.radius);
    });
}

QString whyIdle(const Hit& hit, const Target& target) {
    if (!(hit.constants.maxMagnitude > 0.0f)) {
        return ShotText::tr("max magnitude is 0.");
    }
    if (hit.form.usesPower() && !(hit.constants.power > 0.0f)) {
        return ShotText::tr("power is 0.");
    }
    return hasVertexWithin(reachOf(hit), target.deformed)
               ? ShotText::tr("the hit is too weak for those that are near.")
               : ShotText::tr("none is near enough. Ctrl+R refines the mesh there.");
}

}  // namespace

QString idleHitText(const Hit& hit, const Target& target) {
    return ShotText::tr("The shot hit %1, and moved no vertex: %2").arg(target.name, whyIdle(hit, target));
}

QString shotText(const ShotCount& count, const Session& session) {
    if (count.shots == 1) {
        return oneShot(count, session);
    }
    if (count.isOver() && count.shots > 0) {
        return wholeSeries(count);
    }
    return count.fired == 0 && count.shots > 0
               ? ShotText::tr("%Ln {shot is|shots are} on {its|their} way.", nullptr, trCount(count.shots))
               : QString();
}

}  // namespace hitscope
