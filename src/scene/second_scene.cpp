// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/second_scene.h"

#include <utility>

#include "scene/shading_normals.h"

namespace hitscope {

void SecondScene::release() {
    m_pipeline.reset();
    m_targets.clear();
    m_changeUpload.forget();
    m_comparison = nullptr;
    m_tried.reset();
}

/// Whether the pipeline starts over.
bool SecondScene::followPipeline(Comparison& comparison, const gl::Defines& deformDefines) {
    if (m_comparison == &comparison && m_tried == comparison.other()) {
        return false;
    }
    release();
    m_comparison = &comparison;
    m_tried = comparison.other();
    Result<std::unique_ptr<DeformationPipeline>> made = makePipeline(
        *m_tried, {.vertexUniformComponents = {}, .deformDefines = deformDefines, .uniformBlockBytes = {}});
    if (!made) {
        comparison.setFailure(QString::fromStdString(made.error().message()));
        return false;
    }
    m_pipeline = std::move(made).value();
    comparison.restart();
    return true;
}

void SecondScene::followTargets() {
    for (auto it = m_targets.begin(); it != m_targets.end();) {
        if (m_session.targets().find(it->first) == nullptr) {
            m_pipeline->removeTarget(it->first);
            it = m_targets.erase(it);
        } else {
            ++it;
        }
    }
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        std::unique_ptr<GpuTarget>& made = m_targets[target->id];
        if (!made) {
            made = std::make_unique<GpuTarget>(*target);
            m_changeUpload.forget(target->id);
            m_pipeline->addTarget(target->id, made->buffers);
        }
    }
}

void SecondScene::readBack(Comparison& comparison, Delivery delivery) {
    const auto take = [&comparison](TargetId target, std::uint32_t first,
                                    std::span<const DynamicVertex> vertices) {
        comparison.take(target, first, vertices);
    };
    if (delivery == Delivery::All) {
        m_pipeline->readBack(take);
    } else {
        m_pipeline->pollReadBack(take);
    }
    for (const ReadBack::ChangedNormals& change : comparison.finishReadBack()) {
        GpuTarget& gpu = *m_targets.at(change.target);
        gpu.changed.note(change.renderVertices);
        writeShadingNormals(gpu.buffers, change.renderVertices, comparison.normals(change.target));
    }
}

void SecondScene::follow(Comparison* comparison, const gl::Defines& deformDefines, Delivery delivery) {
    if (comparison == nullptr || !comparison->other()) {
        release();
        return;
    }
    const bool startOver = followPipeline(*comparison, deformDefines);
    if (!m_pipeline) {
        return;
    }
    followTargets();
    const HitHistory& history = m_session.hits().history();
    const std::span<const Hit> shown = m_session.hits().shown();
    if (startOver || m_revision != history.revision() || m_applied.size() != shown.size()) {
        const auto edits = startOver ? std::nullopt : history.editsSince(m_revision);
        if (edits) {
            for (const HistoryEdit& edit : m_applied.follow(*edits, history.hits(), shown.size())) {
                m_pipeline->edit(edit);
            }
        } else {
            m_pipeline->reset(shown);
            m_applied.reset(shown.size());
            delivery = Delivery::All;
        }
        m_revision = history.revision();
    }
    readBack(*comparison, delivery);
}

std::vector<DrawItem> SecondScene::itemsFor(std::span<const DrawItem> items) const {
    std::vector<DrawItem> own(items.begin(), items.end());
    for (DrawItem& item : own) {
        const GpuTarget& gpu = *m_targets.at(item.target);
        item.buffers = &gpu.buffers;
        item.changedParts = &gpu.changed;
    }
    return own;
}

void SecondScene::uploadChange(const ChangeValues* values, std::span<const DrawItem> items) {
    m_changeUpload.follow(values);
    for (const DrawItem& item : items) {
        m_changeUpload.upload(item.target, m_targets.at(item.target)->buffers);
    }
}

}  // namespace hitscope
