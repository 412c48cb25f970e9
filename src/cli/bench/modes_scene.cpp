// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/modes_scene.h"

#include <cmath>
#include <numeric>

#include "cli/bench/random_hits.h"
#include "deform/dent_preview.h"
#include "gl/context.h"

namespace hitscope::bench {

namespace {

constexpr std::size_t kHits = 600;         // as many as the paper's arrays hold
constexpr std::uint32_t kSeed = 1;         // of the checks
constexpr float kEdge = 0.1f;              // metres, of the high-poly meshes, about
constexpr float kCloseEdgePixels = 16.0f;  // of an edge, seen from close by

std::shared_ptr<const std::vector<glm::vec3>> dentOf(const Session& session, const Hit& hit) {
    const Target& target = *session.targets().find(hit.target);
    const RenderMesh& mesh = target.deformed.render();
    std::vector<std::uint32_t> triangles(mesh.triangles.size() / 3);
    std::iota(triangles.begin(), triangles.end(), 0U);
    const VertexRange all{0, static_cast<std::uint32_t>(mesh.vertices.size())};
    const DentPreview preview =
        previewDent(mesh, target.deformed.vertices(), std::span(&all, 1), triangles, hit);
    auto corners = std::make_shared<std::vector<glm::vec3>>();
    for (const glm::vec3& corner : preview.dent) {
        corners->push_back(target.transform.toWorld(corner));
    }
    return corners;
}

}  // namespace

ModesScene::ModesScene(const gl::RenderTarget& picture)
    : m_picture(picture), m_values(m_session), m_comparison(m_session) {}

ModesScene::~ModesScene() = default;

Status ModesScene::open(int row, PipelineKind pipeline, std::uint32_t seed) {
    m_session.loadScene(planPaintedRow(row));
    m_session.settings().setPipeline(pipeline);
    Result<std::unique_ptr<SceneGpu>> gpu = SceneGpu::create(m_session);
    if (!gpu) {
        return gpu.error();
    }
    m_gpu = std::move(gpu).value();
    m_picker = std::make_unique<ScenePicker>(m_session, *m_gpu);
    std::vector<HitTarget> targets;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        targets.push_back({target->id, &target->deformed.render()});
    }
    m_hits = RandomHits(targets, DeformationConstants(), seed).next(kHits);
    static_cast<void>(m_session.hits().add(m_hits));  // made on the session's own targets
    m_session.targets().select({});                   // a selected target is drawn with an outline
    m_view.width = m_picture.width();
    m_view.height = m_picture.height();
    m_view.changeValues = &m_values;
    return m_gpu->sync();
}

void ModesScene::look(ViewMode::Place place) {
    m_view.camera = Camera();
    m_view.camera.setSceneRadius(m_session.targets().bounds().diagonal());
    if (place == ViewMode::Place::Overview) {
        m_view.camera.frame(m_session.targets().bounds(),
                            static_cast<float>(m_view.width) / static_cast<float>(m_view.height));
        return;
    }
    const Hit& hit = m_hits.back();
    const float pixels = static_cast<float>(m_view.height) / m_view.camera.heightAt(1.0f);
    m_view.camera.setPivot(m_session.targets().find(hit.target)->transform.toWorld(hit.point),
                           std::atan2(-hit.direction.x, -hit.direction.z), 0.0f,
                           pixels * kEdge / kCloseEdgePixels);
}

void ModesScene::select(bool on) {
    VertexSelection& selection = m_session.selection();
    if (!on || selection.count() > 0) {
        if (!on) {
            selection.clear();
        }
        return;
    }
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        const std::span<const std::uint32_t> changed = target->deformed.onceChanged();
        selection.select(target->id, {changed.begin(), changed.end()}, VertexSelection::Combine::Add);
    }
    selection.setPicked(VertexRef{m_hits.front().target, 0});
    selection.setHovered(VertexRef{m_hits.front().target, 1});
}

void ModesScene::preview(bool on) {
    if (on != (m_view.ghost != nullptr)) {
        m_view.ghost = on ? dentOf(m_session, m_hits.front()) : nullptr;
    }
}

Status ModesScene::prepare(const ViewMode& mode) {
    m_mode = &mode;
    m_view.options = {};
    m_view.options.vertexColours = false;  // else every mode would be drawn with them
    mode.set(m_view.options);
    look(mode.place);
    const bool compares = mode.extra == ViewMode::Extra::Comparison;
    m_comparison.setOther(compares ? std::optional(PipelineKind::TransformFeedback) : std::nullopt);
    m_view.comparison = compares ? &m_comparison : nullptr;
    const ChangeMapOptions& change = m_view.options.change;
    m_values.setQuantity(change.on ? std::optional(change.quantity) : std::nullopt);
    m_values.setOtherVertices([this](TargetId target) { return m_comparison.vertices(target); });
    m_values.finish();
    m_metal.put(m_session, mode.extra == ViewMode::Extra::Metal);
    select(mode.extra == ViewMode::Extra::Selection);
    preview(mode.extra == ViewMode::Extra::Preview);
    Status status = draw();
    while (status && m_gpu->isReadBackPending()) {
        status = draw();
    }
    m_values.finish();
    return status;
}

Status ModesScene::draw() {
    Status status = m_gpu->draw(m_view, m_picture.framebuffer());
    if (status && m_mode->extra == ViewMode::Extra::Picking) {
        status = m_picker->request(
            m_view, {0.5f * static_cast<float>(m_view.width), 0.5f * static_cast<float>(m_view.height)});
        gl::finish();
        static_cast<void>(m_picker->arrived());
    }
    gl::finish();
    return status;
}

qulonglong ModesScene::vertices() const {
    qulonglong count = 0;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        count += target->deformed.original().vertexCount();
    }
    return count;
}

Variant ModesScene::variant(const ViewMode& mode) {
    return {mode.name, 1.0, [this, &mode] { return prepare(mode); }, [this] { return draw(); }};
}

Result<TimeRatio> modeCost(const BenchRoom& room, const Plan& plan, const ViewMode& mode) {
    ModesScene scene(room.picture());
    if (Status status = scene.open(kFullestRow, PipelineKind::TransformFeedback, kSeed); !status) {
        return status.error();
    }
    Result<std::vector<Samples>> samples =
        room.measure(QLatin1String(mode.name), {scene.variant(plainModeOf(mode)), scene.variant(mode)}, plan);
    if (!samples) {
        return samples.error();
    }
    return timeRatioWithRounds(samples.value()[1], samples.value()[0]);
}

}  // namespace hitscope::bench
