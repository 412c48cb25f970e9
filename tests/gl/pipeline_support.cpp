// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/pipeline_support.h"

#include <algorithm>
#include <cstring>
#include <glm/geometric.hpp>
#include <random>

#include "deform/reference.h"
#include "gl/pipeline_rows.h"
#include "mesh/primitives.h"

namespace hitscope::test {
namespace {

glm::vec3 randomDirection(std::mt19937& random) {
    std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f);
    for (;;) {
        const glm::vec3 v(coordinate(random), coordinate(random), coordinate(random));
        const float length = glm::length(v);
        if (length > 0.1f && length <= 1.0f) {
            return v / length;
        }
    }
}

MeshData meshNamed(const QString& name) {
    if (name == QStringLiteral("High-poly sphere")) {
        return makeHighPolySphere();
    }
    if (name == QStringLiteral("High-poly cube")) {
        return makeHighPolyCube();
    }
    if (name == QStringLiteral("Low-poly sphere")) {
        return makeLowPolySphere();
    }
    return makeLowPolyCube();
}

Bounds enclosing(std::span<const DynamicVertex> vertices) {
    Bounds bounds;
    for (const DynamicVertex& vertex : vertices) {
        bounds.add(vertex.position);
    }
    return bounds;
}

bool sameBits(const DynamicVertex& a, const DynamicVertex& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

TestScene makeScene(const QStringList& meshes) {
    TestScene scene;
    for (const QString& name : meshes) {
        scene.emplace_back(static_cast<std::uint32_t>(scene.size() + 1), buildRenderMesh(meshNamed(name)));
    }
    return scene;
}

RenderMesh pointCloud(std::uint32_t seed, std::uint32_t count, float extent) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> coordinate(-extent, extent);
    RenderMesh mesh;
    mesh.vertices.resize(count);
    for (DynamicVertex& vertex : mesh.vertices) {
        vertex.position = {coordinate(random), coordinate(random), coordinate(random)};
        vertex.normal = randomDirection(random);
    }
    for (std::uint32_t first = 0; first < count; first += kClusterVertices) {
        const std::uint32_t size = std::min(kClusterVertices, count - first);
        mesh.clusters.push_back({first, size, enclosing(std::span(mesh.vertices).subspan(first, size))});
    }
    return mesh;
}

DeformationConstants testConstants(std::size_t index) {
    const auto step = static_cast<float>(index);
    const float share = step / (step + 20.0f);
    return {0.5f + 0.6f * share, 0.05f - 0.04f * share, 0.3f - 0.25f * share};
}

std::vector<Hit> randomHits(const TestScene& scene, std::uint32_t seed, std::size_t count,
                            std::size_t constants) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> jitter(0.0f, 0.3f);
    std::vector<Hit> hits(count);
    for (Hit& hit : hits) {
        const TestTarget& target = scene[random() % scene.size()];
        const DynamicVertex& vertex = target.mesh.vertices[random() % target.mesh.vertices.size()];
        hit.target = target.id;
        // Some hits are exactly on a vertex (r = 0) and some exactly head-on.
        hit.point = vertex.position;
        if (random() % 8 != 0) {
            hit.point += randomDirection(random) * jitter(random);
        }
        hit.direction = random() % 8 == 0 ? -vertex.normal
                                          : glm::normalize(randomDirection(random) - 0.8f * vertex.normal);
        // As many as hits: each has its own.
        hit.constants = testConstants(constants == count ? static_cast<std::size_t>(&hit - hits.data())
                                                         : random() % constants);
    }
    return hits;
}

Mirror::Mirror(const TestScene& scene) {
    for (const TestTarget& target : scene) {
        m_vertices[target.id].assign(target.mesh.vertices.begin(), target.mesh.vertices.end());
    }
}

void Mirror::take(TargetId target, std::uint32_t first, std::span<const DynamicVertex> vertices) {
    std::copy(vertices.begin(), vertices.end(),
              m_vertices.at(target).begin() + static_cast<std::ptrdiff_t>(first));
}

std::size_t Mirror::readBack(DeformationPipeline& pipeline) {
    std::size_t delivered = 0;
    pipeline.readBack([&](TargetId target, std::uint32_t first, std::span<const DynamicVertex> vertices) {
        take(target, first, vertices);
        delivered += vertices.size();
    });
    return delivered;
}

void Mirror::poll(DeformationPipeline& pipeline) {
    pipeline.pollReadBack([this](TargetId target, std::uint32_t first,
                                 std::span<const DynamicVertex> vertices) { take(target, first, vertices); });
}

std::unique_ptr<DeformationPipeline> pipelineOn(PipelineKind kind, TestScene& scene) {
    Result<std::unique_ptr<DeformationPipeline>> made = makePipeline(kind, pipelineOptions());
    if (!made) {
        qWarning("%s", made.error().message().c_str());
        return nullptr;
    }
    for (TestTarget& target : scene) {
        made.value()->addTarget(target.id, *target.buffers);
    }
    return std::move(made).value();
}

QString difference(std::span<const DynamicVertex> actual, std::span<const DynamicVertex> expected) {
    if (actual.size() != expected.size()) {
        return QStringLiteral("%1 vertices instead of %2").arg(actual.size()).arg(expected.size());
    }
    std::size_t count = 0;
    std::size_t first = actual.size();
    for (std::size_t i = actual.size(); i-- > 0;) {
        if (!sameBits(actual[i], expected[i])) {
            ++count;
            first = i;
        }
    }
    if (count == 0) {
        return {};
    }
    const glm::vec3 a = actual[first].position;
    const glm::vec3 e = expected[first].position;
    return QStringLiteral("%1 of %2 vertices differ, first %3: at (%4 %5 %6) instead of (%7 %8 %9)")
        .arg(count)
        .arg(actual.size())
        .arg(first)
        .arg(a.x, 0, 'g', 9)
        .arg(a.y, 0, 'g', 9)
        .arg(a.z, 0, 'g', 9)
        .arg(e.x, 0, 'g', 9)
        .arg(e.y, 0, 'g', 9)
        .arg(e.z, 0, 'g', 9);
}

QString differenceFromReference(const Mirror& mirror, const TestScene& scene, std::span<const Hit> hits) {
    for (const TestTarget& target : scene) {
        ReferenceDeformation reference(target.mesh);
        for (const Hit& hit : hits) {
            if (hit.target == target.id) {
                reference.apply(std::span(&hit, 1));
            }
        }
        const QString found = difference(mirror.vertices(target.id), reference.vertices());
        if (!found.isEmpty()) {
            return QStringLiteral("target %1: %2").arg(target.id.value).arg(found);
        }
    }
    return {};
}

}  // namespace hitscope::test
