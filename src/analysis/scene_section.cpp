// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene_section.h"

#include <glm/geometric.hpp>
#include <iterator>

#include "session/target.h"

namespace hitscope {

namespace {

Plane toLocal(const Plane& world, const RigidTransform& transform) {
    return {transform.directionToLocal(world.normal),
            world.offset - glm::dot(world.normal, transform.position)};
}

std::vector<SectionCurve> cutWorld(const MeshSections& mesh, const Plane& world,
                                   const RigidTransform& transform) {
    std::vector<SectionCurve> curves = mesh.cut(toLocal(world, transform));
    for (SectionCurve& curve : curves) {
        for (glm::vec3& point : curve.points) {
            point = transform.toWorld(point);
        }
    }
    return curves;
}

void append(std::vector<SectionCurve>& all, const std::vector<SectionCurve>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

void SectionedTarget::follow(std::span<const MovedVertex> moved) {
    if (!m_before) {
        m_before = std::make_unique<MeshSections>(*m_mesh);
        m_after = std::make_unique<MeshSections>(*m_before);
    }
    m_after->move(moved);
    m_factor = moved.empty() ? m_factor : 0.0f;
}

TargetSection SectionedTarget::cut(const Plane& world, const RigidTransform& transform) const {
    TargetSection section;
    section.original = cutWorld(*m_before, world, transform);
    section.deformed = cutWorld(*m_after, world, transform);
    section.depths = sectionDepths(section.original, section.deformed);
    return section;
}

void SectionedTarget::exaggerate(float factor) {
    if (m_factor == factor) {
        return;
    }
    m_factor = factor;
    std::vector<glm::vec3> places(m_before->positions().begin(), m_before->positions().end());
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] += factor * (m_after->positions()[i] - places[i]);
    }
    if (!m_drawn) {
        m_drawn = std::make_unique<MeshSections>(*m_before);
    }
    m_drawn->setPositions(places);
}

void SectionedTarget::addLines(SectionLines& lines, const TargetSection& section, const Plane& world,
                               const RigidTransform& transform, float exaggeration) {
    append(lines.original, section.original);
    if (exaggeration == 1.0f) {
        m_drawn.reset();
        m_factor = 0.0f;
        append(lines.deformed, section.deformed);
    } else {
        exaggerate(exaggeration);
        append(lines.deformed, cutWorld(*m_drawn, world, transform));
    }
}

std::shared_ptr<const SectionLines> sectionLines(const Session& session, const CuttingPlane& cut,
                                                 float exaggeration) {
    if (!cut.on) {
        return nullptr;
    }
    auto lines = std::make_shared<SectionLines>();
    for (const std::unique_ptr<Target>& target : session.targets()) {
        if (!target->visible) {
            continue;
        }
        std::vector<MovedVertex> moved;
        for (const std::uint32_t vertex : target->deformed.onceChanged()) {
            moved.push_back({vertex, target->deformed.positions()[vertex]});
        }
        SectionedTarget sectioned(target->deformed.sharedRender());
        sectioned.follow(moved);
        const TargetSection section = sectioned.cut(cut.plane(), target->transform);
        sectioned.addLines(*lines, section, cut.plane(), target->transform, exaggeration);
    }
    return lines;
}

}  // namespace hitscope
