// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/read_back.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <system_error>
#include <thread>
#include <utility>

namespace hitscope {

namespace {

Target* findTarget(std::span<const std::unique_ptr<Target>> targets, TargetId id) {
    const auto found = std::find_if(targets.begin(), targets.end(),
                                    [id](const std::unique_ptr<Target>& target) { return target->id == id; });
    return found == targets.end() ? nullptr : found->get();
}

/// Sorts different numbers. Many that lie close together, as vertices around dents do, are marked and
/// gathered, which takes a fraction of comparing them.
void sort(std::vector<std::uint32_t>& numbers) {
    constexpr std::size_t kFew = 64;
    constexpr std::size_t kSparse = 32;
    if (numbers.empty()) {
        return;
    }
    const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
    const std::uint32_t first = *least;
    const std::size_t span = *most - first + std::size_t{1};
    if (numbers.size() <= kFew || span / numbers.size() >= kSparse) {
        std::sort(numbers.begin(), numbers.end());
        return;
    }
    std::vector<std::uint8_t> marks(span, 0);
    for (const std::uint32_t number : numbers) {
        marks[number - first] = 1;
    }
    auto next = numbers.begin();
    for (std::size_t i = 0; i < span; ++i) {
        if (marks[i] != 0) {
            *next++ = first + static_cast<std::uint32_t>(i);
        }
    }
}

/// Fewer are done sooner than a thread is started.
constexpr std::size_t kManyVertices = 4096;

/// Calls work(i) for i in [0, count), on all processors if that is worth it.
template <class Work>
void forEach(std::size_t count, bool isWorthThreads, const Work& work) {
    std::atomic<std::size_t> next{0};
    const auto run = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            work(i);
        }
    };
    const std::size_t processors = std::clamp(std::thread::hardware_concurrency(), 1u, 8u);
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; isWorthThreads && i < std::min(processors, count); ++i) {
        try {
            helpers.emplace_back(run);
        } catch (const std::system_error&) {
            break;  // no more threads to be had
        }
    }
    run();
}

}  // namespace

ReadBack::ReadBack(const std::vector<std::unique_ptr<Target>>& targets) : m_targets(targets) {}

void ReadBack::setUnavailablePipelines(std::map<PipelineKind, QString> reasons) {
    if (reasons != m_unavailablePipelines) {
        m_unavailablePipelines = std::move(reasons);
        Q_EMIT unavailablePipelinesChanged();
    }
}

QString ReadBack::whyUnavailable(PipelineKind kind) const {
    const auto reason = m_unavailablePipelines.find(kind);
    return reason == m_unavailablePipelines.end() ? QString() : reason->second;
}

void ReadBack::setCapacity(CapacityReport report) {
    if (report != m_capacity) {
        m_capacity = std::move(report);
        Q_EMIT capacityChanged();
    }
}

bool ReadBack::isDropped(std::size_t index) const {
    return std::binary_search(m_capacity.dropped.begin(), m_capacity.dropped.end(), index);
}

void ReadBack::restart() {
    for (const std::unique_ptr<Target>& target : m_targets) {
        DeformedMesh& mesh = target->deformed;
        std::vector<std::uint32_t>& moved = m_moved[target->id];
        for (const std::uint32_t vertex : mesh.onceChanged()) {
            if (mesh.isChanged(vertex)) {
                moved.push_back(vertex);
            }
        }
        mesh.reset();
    }
}

void ReadBack::take(TargetId id, std::uint32_t first, std::span<const DynamicVertex> vertices) {
    Target* target = findTarget(m_targets, id);
    if (target == nullptr) {
        return;
    }
    target->deformed.write(first, vertices, m_moved[id]);
}

void ReadBack::setVerdict(RendererVerdict verdict) {
    if (verdict != m_verdict) {
        m_verdict = std::move(verdict);
        Q_EMIT verdictChanged();
    }
}

void ReadBack::setExactness(const Exactness& exactness) {
    if (exactness != m_exactness) {
        m_exactness = exactness;
        Q_EMIT exactnessChanged();
    }
}

std::vector<ReadBack::ChangedNormals> ReadBack::finish() {
    std::vector<ChangedNormals> changes;
    std::vector<std::pair<Target*, const std::vector<std::uint32_t>*>> work;
    std::size_t vertices = 0;
    for (const auto& [id, moved] : m_moved) {
        Target* target = findTarget(m_targets, id);
        if (target != nullptr && !moved.empty()) {
            changes.push_back({id, {}});
            work.emplace_back(target, &moved);
            vertices += moved.size();
        }
    }
    // The largest first, so that all processors are done at about the same time.
    std::vector<std::size_t> order(work.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&work](std::size_t a, std::size_t b) {
        return work[a].second->size() > work[b].second->size();
    });
    forEach(work.size(), vertices > kManyVertices, [&work, &changes, &order](std::size_t i) {
        const auto& [target, moved] = work[order[i]];
        std::vector<std::uint32_t>& updated = changes[order[i]].renderVertices;
        target->trueNormals.update(target->deformed.positions(), *moved, updated);
        sort(updated);
    });
    const auto announced = std::exchange(m_moved, {});
    for (const ChangedNormals& change : changes) {
        Q_EMIT shadingChanged(change.target, change.renderVertices);
        Q_EMIT verticesMoved(change.target, announced.at(change.target));
        Q_EMIT meshChanged(change.target);
    }
    return changes;
}

}  // namespace hitscope
