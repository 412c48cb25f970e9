// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>
#include <glm/mat4x4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "deform/hit.h"
#include "deform/reference.h"
#include "gl/context.h"
#include "gl/render_target.h"
#include "mesh/mesh_data.h"
#include "mesh/render_mesh.h"
#include "pipeline/deformation_pipeline.h"
#include "render/renderer.h"

namespace hitscope::test {

/// Targets with their buffers and materials, as a session has them on the GPU. A context is current.
class TestScene {
public:
    TargetId add(Renderer& renderer, const MeshData& mesh, const glm::vec3& position);
    /// Registers the targets and applies the hits.
    std::unique_ptr<DeformationPipeline> pipeline(PipelineKind kind, std::span<const Hit> hits);

    /// Gives the targets the shading normals that go with these hits.
    void showTrueNormals(std::span<const Hit> hits);

    [[nodiscard]] std::span<const DrawItem> items() const { return m_items; }
    void select(std::size_t item, bool selected) { m_items[item].selected = selected; }
    [[nodiscard]] const Bounds& bounds() const { return m_bounds; }  ///< world

private:
    struct Entry {
        MeshData original;
        RenderMesh mesh;
        std::unique_ptr<TargetBuffers> buffers;
        std::shared_ptr<const MaterialSet> materials;
    };
    std::vector<std::unique_ptr<Entry>> m_entries;
    std::vector<DrawItem> m_items;
    Bounds m_bounds;
};

/// One sphere of radius 2.5 m on the floor, seen from the front, lights as by default.
void addSphere(TestScene& scene, Renderer& renderer);
/// The paper's scene: 16 targets on a 4x4 grid, 15 m apart.
void addPaperScene(TestScene& scene, Renderer& renderer);
/// A frame that has the whole scene in it.
[[nodiscard]] Frame frameOf(const TestScene& scene, int width, int height);
/// Each vertex has a colour by its direction from the middle.
[[nodiscard]] MeshData withColours(MeshData mesh);
/// Dents of the first target, which is a sphere of radius 2.5 m about its origin.
[[nodiscard]] std::vector<Hit> dents(TargetId target, std::size_t count);

/// Six of dents(), as deep as a metre, the first one four times: they push vertices far from where their
/// clusters were, and turn some of the surface inside out.
[[nodiscard]] std::vector<Hit> deepDents();

/// Draws with 4 samples and reads the picture; a null image and a message on failure.
[[nodiscard]] QImage picture(Renderer& renderer, const Frame& frame, DeformationPipeline& pipeline,
                             int samples = 4);

}  // namespace hitscope::test
