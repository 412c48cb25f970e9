// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parallel.h"
#include "session/export/export_target.h"
#include "session/session.h"

namespace hitscope {

namespace {

constexpr std::size_t kLeastPart = std::size_t{1} << 16;  // vertices, of what threads share

/// The paper's, one a render vertex.
std::shared_ptr<const std::vector<glm::vec3>> normalsOf(std::span<const DynamicVertex> vertices) {
    auto normals = std::make_shared<std::vector<glm::vec3>>(vertices.size());
    inParts(vertices.size(), kLeastPart, [&](std::size_t first, std::size_t end) {
        for (std::size_t v = first; v < end; ++v) {
            (*normals)[v] = vertices[v].normal;
        }
    });
    return normals;
}

/// All of them, or those that hits changed, whichever is less.
void copyPositions(const DeformedMesh& mesh, TargetExport& copy) {
    const std::span<const std::uint32_t> changed = mesh.onceChanged();
    const std::span<const glm::vec3> positions = mesh.positions();
    if (changed.size() > positions.size() / 2) {
        copy.positions.assign(positions.begin(), positions.end());
        return;
    }
    copy.changed.assign(changed.begin(), changed.end());
    copy.changedPositions.reserve(changed.size());
    for (const std::uint32_t vertex : changed) {
        copy.changedPositions.push_back(positions[vertex]);
    }
}

}  // namespace

void TargetExport::complete() {
    if (positions.empty()) {
        positions.assign(original->positions.begin(), original->positions.end());
        for (std::size_t i = 0; i < changed.size(); ++i) {
            positions[changed[i]] = changedPositions[i];
        }
    }
    if (!normals) {
        normals = turned ? std::make_shared<const std::vector<glm::vec3>>(turned->all())
                         : normalsOf(render->vertices);
    }
}

SceneExport copyForExport(const Session& session, std::span<const Target* const> targets,
                          const ExportOptions& options) {
    SceneExport copy;
    copy.options = options;
    for (const Target* target : targets) {
        const DeformedMesh& mesh = target->deformed;
        TargetExport& one = copy.targets.emplace_back();
        one.id = target->id;
        one.name = target->name.toStdString();
        one.original = mesh.sharedOriginal();
        one.render = mesh.sharedRender();
        one.transform = target->transform;
        one.sourcePath = target->sourcePath;
        copyPositions(mesh, one);
        if (options.normals == NormalMode::Paper) {
            one.normals = normalsOf(mesh.vertices());
        } else if (!target->trueNormals.areOriginal()) {
            one.turned = target->trueNormals.normals();
        }
    }
    const AppliedHits applied = session.hits().applied();
    for (const Hit& hit : session.hits().history().hits()) {
        copy.hits.push_back(hit);
        copy.hits.back().enabled = hit.enabled && applied.contains(copy.hits.size() - 1);
    }
    return copy;
}

}  // namespace hitscope
