// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/frame_costs.h"

#include <algorithm>

#include "session/session.h"

namespace hitscope {

FrameCosts::FrameCosts(const Session& session) : m_session(session) {
    m_clock.start();
    connect(&session, &Session::sceneReplaced, this, &FrameCosts::clear);
    connect(&session.hits(), &SessionHits::rearranged, this, &FrameCosts::followRows);
}

double FrameCosts::now() const {
    return static_cast<double>(m_clock.nsecsElapsed()) * 1.0e-9;
}

std::optional<HitCost> FrameCosts::hitCost(std::size_t index) const {
    if (index >= m_batchOf.size() || m_batchOf[index] == kNoBatch) {
        return std::nullopt;
    }
    const Batch& batch = m_batches[m_batchOf[index]];
    const auto hits = static_cast<double>(batch.hits);
    return HitCost{batch.cpu / hits, batch.gpu ? std::optional(*batch.gpu / hits) : std::nullopt, batch.hits,
                   batch.pipeline};
}

void FrameCosts::addFrame(FrameCost cost) {
    cost.number = m_nextFrame++;
    cost.end = now();
    cost.physics = m_work.physics;
    cost.deformation += m_work.deformation;
    cost.readBack += m_work.readBack;
    cost.hits += m_work.hits;
    cost.cpu = cost.physics + cost.deformation + cost.readBack + cost.drawing;
    cost.total = cost.cpu;
    cost.history = static_cast<std::uint32_t>(m_session.hits().history().size());
    cost.pipeline = m_session.settings().pipeline();
    m_work = {};
    m_frames.push(cost);
}

void FrameCosts::addWork(const FrameCost& cost) {
    ++m_nextFrame;
    m_work.deformation += cost.deformation;
    m_work.readBack += cost.readBack;
    m_work.hits += cost.hits;
}

void FrameCosts::endFrame(double total, bool follows) {
    if (!m_frames.empty()) {
        m_frames.back().end = now();
        m_frames.back().total = total;
        m_frames.back().follows = follows;
        Q_EMIT frameEnded();
    }
}

void FrameCosts::addApplied(std::uint64_t frame, std::size_t first, std::size_t count, double cpu) {
    if (count == 0) {
        return;
    }
    if (count == m_session.hits().history().size()) {
        m_batches.clear();  // all hits are in the new one
    }
    m_batchOf.resize(std::max(m_batchOf.size(), first + count), kNoBatch);
    std::fill_n(m_batchOf.begin() + static_cast<std::ptrdiff_t>(first), count,
                static_cast<std::uint32_t>(m_batches.size()));
    m_batches.push_back({frame, count, cpu, {}, m_session.settings().pipeline()});
    Q_EMIT hitCostsChanged(static_cast<int>(first), static_cast<int>(first + count) - 1);
}

void FrameCosts::addGpuTimes(std::uint64_t frame, double all, double deformation) {
    FrameCost* belongs = nullptr;
    for (std::size_t i = m_frames.size(); i-- > 0 && m_frames[i].number >= frame;) {
        belongs = &m_frames[i];
    }
    if (belongs != nullptr) {
        belongs->gpu = belongs->gpu.value_or(0.0) + all;
        belongs->gpuDeformation = belongs->gpuDeformation.value_or(0.0) + deformation;
    }
    const auto batch =
        std::lower_bound(m_batches.begin(), m_batches.end(), frame,
                         [](const Batch& one, std::uint64_t value) { return one.frame < value; });
    if (batch == m_batches.end() || batch->frame != frame) {
        return;
    }
    batch->gpu = deformation;
    const auto number = static_cast<std::uint32_t>(batch - m_batches.begin());
    const auto isOfBatch = [number](std::uint32_t other) { return other == number; };
    // Its hits are most likely among the last.
    const auto last = std::find_if(m_batchOf.rbegin(), m_batchOf.rend(), isOfBatch);
    if (last != m_batchOf.rend()) {
        const auto end = static_cast<int>(m_batchOf.rend() - last);
        Q_EMIT hitCostsChanged(std::max(0, end - static_cast<int>(batch->hits)), end - 1);
    }
}

void FrameCosts::clear() {
    m_batches.clear();
    m_batchOf.clear();
}

void FrameCosts::followRows(const HitRows& rows) {
    std::vector<std::uint32_t> now(rows.size(), kNoBatch);
    for (std::size_t before = 0; before < m_batchOf.size(); ++before) {
        if (const std::optional<std::size_t> row = rows.now(before)) {
            now[*row] = m_batchOf[before];
        }
    }
    m_batchOf = std::move(now);
}

}  // namespace hitscope
