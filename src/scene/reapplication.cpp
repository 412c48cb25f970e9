// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/reapplication.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <algorithm>
#include <optional>
#include <utility>

#include "session/session.h"

namespace hitscope {

namespace {

constexpr qint64 kFrameShare = 4;         // milliseconds of a frame
constexpr std::size_t kAtOnce = 64;       // hits between two looks at the clock
constexpr std::size_t kMostAFrame = 512;  // the GPU may be behind, which the clock does not tell

}  // namespace

bool Reapplication::isWorthSlicing(PipelineKind kind, std::size_t hits) {
    return hits > kWorthSlicing && pipelineTraits(kind).keepsAll;
}

Reapplication::Reapplication(Session& session, std::unique_ptr<DeformationPipeline> made,
                             std::function<void()> cancel, const QString& cancelHelp)
    : m_session(session),
      m_pipeline(std::move(made)),
      m_revision(session.hits().history().revision()),
      m_progress(session.tasks(),
                 QCoreApplication::translate("hitscope::Reapplication", "Applying all hits again"),
                 std::move(cancel), cancelHelp) {
    for (const std::unique_ptr<Target>& target : session.targets()) {
        auto buffers =
            std::make_unique<TargetBuffers>(target->deformed.render(), target->deformed.original().colours);
        m_pipeline->addTarget(target->id, *buffers);
        m_buffers.emplace(target->id, std::move(buffers));
    }
}

bool Reapplication::isOfTheseTargets() const {
    return m_session.targets().size() == m_buffers.size() &&
           std::all_of(
               m_session.targets().begin(), m_session.targets().end(),
               [this](const std::unique_ptr<Target>& target) { return m_buffers.contains(target->id); });
}

/// What changes among the hits that are still to come needs no attention; among the others, it begins anew.
void Reapplication::followEdits() {
    const HitHistory& history = m_session.hits().history();
    if (m_revision == history.revision() && m_applied <= m_session.hits().shown().size()) {
        return;
    }
    const std::optional<std::vector<HistoryEdit>> edits = history.editsSince(m_revision);
    m_revision = history.revision();
    const bool isBehind = edits && m_applied <= m_session.hits().shown().size() &&
                          std::all_of(edits->begin(), edits->end(),
                                      [this](const HistoryEdit& edit) { return edit.first >= m_applied; });
    if (!isBehind) {
        m_pipeline->reset({});
        m_applied = 0;
    }
}

void Reapplication::applySome(std::size_t most) {
    const std::span<const Hit> hits = m_session.hits().shown();
    const std::size_t count = std::min(most, hits.size() - m_applied);
    m_pipeline->append(hits.subspan(m_applied, count));
    m_applied += count;
    // On the way the pipeline learns where the vertices are, and so which of them a hit can reach.
    m_pipeline->pollReadBack(
        [this](TargetId target, std::uint32_t first, std::span<const DynamicVertex> vertices) {
            Arrived& arrived = m_arrived[target];
            if (arrived.vertices.empty()) {
                const auto& all = m_session.targets().find(target)->deformed.render().vertices;
                arrived.vertices.assign(all.begin(), all.end());
            }
            std::copy(vertices.begin(), vertices.end(), arrived.vertices.begin() + first);
            const VertexRange range{first, static_cast<std::uint32_t>(vertices.size())};
            arrived.ranges.add({&range, 1});
        });
}

void Reapplication::deliver(const ReadBackSink& sink) {
    for (auto& [target, arrived] : m_arrived) {
        for (const VertexRange& range : arrived.ranges.take()) {
            sink(target, range.first, std::span(arrived.vertices).subspan(range.first, range.count));
        }
    }
}

bool Reapplication::advance() {
    followEdits();
    const std::size_t all = m_session.hits().shown().size();
    QElapsedTimer clock;
    clock.start();
    const std::size_t before = m_applied;
    while (m_applied < all && m_applied - before < kMostAFrame && clock.elapsed() < kFrameShare) {
        applySome(kAtOnce);
    }
    m_progress.report(all == 0 ? 1.0 : static_cast<double>(m_applied) / static_cast<double>(all));
    return m_applied == all;
}

void Reapplication::finish() {
    followEdits();
    while (m_applied < m_session.hits().shown().size()) {
        applySome(kMostAFrame);
    }
}

}  // namespace hitscope
