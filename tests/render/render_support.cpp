// SPDX-License-Identifier: GPL-3.0-or-later
#include "render_support.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <iterator>

#include "mesh/primitives.h"
#include "mesh/true_normals.h"

namespace hitscope::test {

TargetId TestScene::add(Renderer& renderer, const MeshData& mesh, const glm::vec3& position) {
    auto entry = std::make_unique<Entry>();
    entry->original = mesh;
    entry->mesh = buildRenderMesh(mesh);
    entry->buffers = std::make_unique<TargetBuffers>(entry->mesh, mesh.colours);
    entry->materials = renderer.makeMaterials(mesh);
    const TargetId id{static_cast<std::uint32_t>(m_entries.size() + 1)};
    m_items.push_back(
        {id, entry->buffers.get(), entry->materials.get(), glm::translate(glm::mat4(1.0f), position), false});
    m_bounds.add(entry->mesh.bounds.min + position);
    m_bounds.add(entry->mesh.bounds.max + position);
    m_entries.push_back(std::move(entry));
    return id;
}

std::unique_ptr<DeformationPipeline> TestScene::pipeline(PipelineKind kind, std::span<const Hit> hits) {
    auto made = makePipeline(kind);
    if (!made) {
        qCritical("%s", made.error().message().c_str());
        return nullptr;
    }
    auto pipeline = std::move(made).value();
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        m_entries[i]->buffers->restoreOriginal();
        pipeline->addTarget(m_items[i].target, *m_entries[i]->buffers);
    }
    pipeline->append(hits);
    return pipeline;
}

void TestScene::showTrueNormals(std::span<const Hit> hits) {
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        Entry& entry = *m_entries[i];
        ReferenceDeformation reference(entry.mesh);
        std::vector<Hit> own;
        std::copy_if(hits.begin(), hits.end(), std::back_inserter(own),
                     [&](const Hit& hit) { return hit.target == m_items[i].target; });
        (void)reference.apply(own);
        PageVector<glm::vec3> positions = entry.original.positions;
        std::vector<std::uint32_t> moved;
        for (std::size_t v = 0; v < entry.mesh.vertices.size(); ++v) {
            const std::uint32_t fileVertex = entry.mesh.fileVertices[v];
            positions[fileVertex] = reference.vertices()[v].position;
            moved.push_back(fileVertex);
        }
        TrueNormals normals(entry.original, entry.mesh);
        std::vector<std::uint32_t> updated;
        normals.update(positions, moved, updated);
        entry.buffers->writeShadingNormals(0, normals.normals().all());
    }
}

void addSphere(TestScene& scene, Renderer& renderer) {
    scene.add(renderer, makeHighPolySphere(), glm::vec3(0.0f, 2.5f, 0.0f));
}

void addPaperScene(TestScene& scene, Renderer& renderer) {
    const MeshData meshes[] = {makeHighPolySphere(), makeHighPolyCube(), makeLowPolySphere(),
                               makeLowPolyCube()};
    for (int i = 0; i < 16; ++i) {
        const int row = i / 4;
        const glm::vec3 position(15.0f * (static_cast<float>(i % 4) - 1.5f), 2.5f,
                                 15.0f * (static_cast<float>(row) - 1.5f));
        scene.add(renderer, meshes[(i + row) % 4], position);
    }
}

Frame frameOf(const TestScene& scene, int width, int height) {
    Frame frame;
    frame.width = width;
    frame.height = height;
    const glm::vec3 size = scene.bounds().size();
    frame.lights = defaultLights({scene.bounds().centre(), std::max({size.x, size.y, size.z})});
    frame.camera.setSceneRadius(scene.bounds().diagonal());
    frame.camera.frame(scene.bounds(), static_cast<float>(width) / static_cast<float>(height));
    frame.floorHeight = scene.bounds().min.y;
    frame.targets = scene.items();
    return frame;
}

MeshData withColours(MeshData mesh) {
    for (const glm::vec3& position : mesh.positions) {
        mesh.colours.push_back(0.5f + 0.5f * glm::normalize(position));
    }
    return mesh;
}

std::vector<Hit> dents(TargetId target, std::size_t count) {
    std::vector<Hit> hits;
    for (std::size_t i = 0; i < count; ++i) {
        // Spread over the side that the camera sees, by the golden angle.
        const float t = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
        const float phi = 2.3999632f * static_cast<float>(i);
        const float tilt = 1.1f * std::sqrt(t);
        glm::vec3 n(std::sin(tilt) * std::cos(phi), std::sin(tilt) * std::sin(phi), std::cos(tilt));
        n = glm::mat3(glm::rotate(glm::mat4(1.0f), 0.6f, glm::vec3(0, 1, 0))) * n;
        Hit hit;
        hit.target = target;
        hit.point = 2.5f * n;
        hit.direction = glm::normalize(glm::vec3(0.2f, -0.1f, 0.0f) - n);
        hits.push_back(hit);
    }
    return hits;
}

std::vector<Hit> deepDents() {
    std::vector<Hit> hits = dents({1}, 6);
    for (Hit& hit : hits) {
        hit.constants.maxDistance = 1.0f;
        hit.constants.maxMagnitude = 1.0f;
        hit.constants.power = 0.4f;
    }
    hits.insert(hits.end(), 3, hits.front());
    return hits;
}

QImage picture(Renderer& renderer, const Frame& frame, DeformationPipeline& pipeline, int samples) {
    const gl::RenderTarget target(frame.width, frame.height, samples);
    if (!target.isComplete()) {
        QTest::qFail(
            qPrintable(QStringLiteral("no framebuffer of %1 x %2").arg(frame.width).arg(frame.height)),
            __FILE__, __LINE__);
        return {};
    }
    if (const Status status = renderer.draw(frame, pipeline, target.framebuffer()); !status) {
        QTest::qFail(status.error().message().c_str(), __FILE__, __LINE__);
        return {};
    }
    const Image image = target.read();
    return QImage(image.pixels.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
}

}  // namespace hitscope::test
