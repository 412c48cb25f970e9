// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/change_values.h"
#include "analysis/beside.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "core/zero_array.h"

namespace hitscope {

namespace {

constexpr qint64 kSlice = 2'000'000;            // nanoseconds of work between two events
constexpr std::size_t kLookAtClock = 16;        // clusters
constexpr int kHistogramPause = 80;             // milliseconds between two histograms while values change
constexpr std::size_t kLargeMesh = 50'000;      // vertices whose neighbours take more than a slice to find
constexpr std::size_t kManyVertices = 100'000;  // of which to mark each would take more than a slice

std::size_t clusterOf(std::uint32_t renderVertex) {
    return renderVertex / kClusterVertices;
}

/// Of some vertices' values, the one of largest magnitude.
template <class ValueOf>
auto largestOf(std::span<const std::uint32_t> vertices, const ValueOf& valueOf) {
    auto largest = valueOf(vertices.front());
    for (const std::uint32_t vertex : vertices.subspan(1)) {
        const auto value = valueOf(vertex);
        largest = std::abs(value) > std::abs(largest) ? value : largest;
    }
    return largest;
}

}  // namespace

struct ChangeValues::TargetValues {
    explicit TargetValues(const Target& of)
        : target(&of),
          tree(of.deformed.render().clusters.size()),
          values(of.deformed.render().vertices.size()),
          marked(of.deformed.render().clusters.size(), 0) {}

    const Target* target;
    SummaryTree tree;
    ZeroArray<float> values;
    std::vector<std::uint8_t> marked;  ///< the cluster waits
    std::vector<std::uint32_t> waiting;
    std::vector<VertexRange> measured;  ///< since valuesChanged()
    EdgeNeighbours neighbours;          ///< for edge stretch, when they have been found
    bool neighboursWanted = false;
};

ChangeValues::ChangeValues(Session& session, QObject* parent)
    : ChangeValues(
          session,
          [](const Target& target) {
              return Shape{&target.deformed, &target.trueNormals};
          },
          parent) {
    connect(&session.readBack(), &ReadBack::shadingChanged, this, &ChangeValues::touch);
}

ChangeValues::ChangeValues(Session& session, Shapes shapes, QObject* parent)
    : QObject(parent), m_session(session), m_shapes(std::move(shapes)) {
    m_timer.setSingleShot(true);
    m_timer.setInterval(0);
    m_histogramTimer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &ChangeValues::work);
    connect(&m_histogramTimer, &QTimer::timeout, this, &ChangeValues::workOnHistogram);
    connect(&session.targets(), &SessionTargets::removed, this, [this](TargetId id) {
        const auto known = m_targets.find(id);
        if (known != m_targets.end()) {
            m_waiting -= known->second->waiting.size();
            m_targets.erase(known);
            announce();
        }
    });
    connect(&session, &Session::sceneReplaced, this, &ChangeValues::restart);
    connect(&session.targets(), &SessionTargets::changed, this, &ChangeValues::announce);  // it may be hidden
}

ChangeValues::~ChangeValues() = default;

void ChangeValues::setQuantity(std::optional<ChangeQuantity> quantity) {
    if (quantity != m_quantity) {
        m_quantity = quantity;
        restart();
    }
}

void ChangeValues::setHitCounts(HitCounts counts) {
    m_hitCounts = std::move(counts);
    restart();
}

void ChangeValues::setOtherVertices(OtherVertices vertices) {
    m_otherVertices = std::move(vertices);
    restart();
}

void ChangeValues::restart() {
    m_targets.clear();
    m_waiting = 0;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        if (const auto shape = m_shapes(*target);
            m_quantity && shape && !shape->deformed->onceChanged().empty()) {
            start(*target);
        }
    }
    announce();
    if (m_waiting > 0) {
        m_timer.start();
    }
}

/// Everything on the target that may count.
void ChangeValues::start(const Target& target) {
    auto& values = m_targets[target.id];
    if (!values) {
        values = std::make_unique<TargetValues>(target);
    }
    const std::optional<Shape> shape = m_shapes(target);
    const std::span<const std::uint32_t> changed =
        shape ? shape->deformed->onceChanged() : std::span<const std::uint32_t>();
    if (!changeTraits(*m_quantity).isAlone || changed.size() > kManyVertices) {
        for (std::size_t cluster = 0; cluster < values->marked.size(); ++cluster) {
            mark(*values, cluster);
        }
        return;
    }
    for (const std::uint32_t fileVertex : changed) {
        for (const std::uint32_t vertex : target.deformed.render().renderVerticesOf(fileVertex)) {
            mark(*values, clusterOf(vertex));
        }
    }
}

void ChangeValues::touch(TargetId id, std::span<const std::uint32_t> renderVertices) {
    const Target* target = m_session.targets().find(id);
    if (!m_quantity || target == nullptr || renderVertices.empty()) {
        return;
    }
    auto& values = m_targets[id];
    if (!values) {
        values = std::make_unique<TargetValues>(*target);
    }
    const RenderMesh& render = target->deformed.render();
    for (const std::uint32_t vertex : renderVertices) {
        mark(*values, clusterOf(vertex));
        if (changeTraits(*m_quantity).usesNormal) {  // it is counted with the first of its file vertex
            mark(*values, clusterOf(render.renderVerticesOf(render.fileVertices[vertex]).front()));
        }
    }
    work();
}

void ChangeValues::touchAll(TargetId id) {
    const Target* target = m_session.targets().find(id);
    if (m_quantity && target != nullptr) {
        start(*target);
        work();
    }
}

void ChangeValues::mark(TargetValues& values, std::size_t cluster) {
    if (values.marked[cluster] == 0) {
        values.marked[cluster] = 1;
        values.waiting.push_back(static_cast<std::uint32_t>(cluster));
        ++m_waiting;
    }
}

double ChangeValues::valueOf(const TargetValues& values, const Shape& shape,
                             std::uint32_t renderVertex) const {
    const DeformedMesh& mesh = *shape.deformed;
    const std::uint32_t fileVertex = mesh.render().fileVertices[renderVertex];
    switch (*m_quantity) {
        case ChangeQuantity::HitCount: {
            const auto counts =
                m_hitCounts ? m_hitCounts(values.target->id) : std::span<const std::uint32_t>();
            return fileVertex < counts.size() ? counts[fileVertex] : 0.0;
        }
        case ChangeQuantity::EdgeStretch:
            return values.neighbours.empty() ? 0.0
                                             : edgeStretch(values.neighbours, fileVertex,
                                                           mesh.original().positions, mesh.positions());
        case ChangeQuantity::Difference: {
            const auto others =
                m_otherVertices ? m_otherVertices(values.target->id) : std::span<const DynamicVertex>();
            return renderVertex < others.size()
                       ? glm::distance(glm::dvec3(others[renderVertex].position),
                                       glm::dvec3(mesh.vertices()[renderVertex].position))
                       : 0.0;
        }
        default:
            return changeOf(*m_quantity, mesh.render().vertices[renderVertex], mesh.vertices()[renderVertex],
                            shape.normals->normals()[renderVertex]);
    }
}

void ChangeValues::measure(TargetValues& values, std::size_t cluster) {
    const RenderMesh& render = values.target->deformed.render();
    const Cluster& run = render.clusters[cluster];
    const std::optional<Shape> shape = m_shapes(*values.target);
    Summary summary;
    for (std::uint32_t vertex = run.first; vertex < run.first + run.count; ++vertex) {
        const double value = shape ? valueOf(values, *shape, vertex) : 0.0;
        values.values[vertex] = static_cast<float>(value);
        const std::uint32_t fileVertex = render.fileVertices[vertex];
        // One that is not drawn has no colour, but may differ.
        const std::span<const std::uint32_t> all = render.renderVerticesOf(fileVertex);
        if ((vertex >= render.drawnVertices && *m_quantity != ChangeQuantity::Difference) ||
            all.front() != vertex) {
            continue;
        }
        const double largest = !shape || !changeTraits(*m_quantity).usesNormal
                                   ? value
                                   : largestOf(all, [&](auto v) { return valueOf(values, *shape, v); });
        if (largest != 0.0 || (shape && shape->deformed->isChanged(fileVertex))) {
            summary.add(largest);
        }
    }
    values.tree.set(cluster, summary);
    values.measured.push_back({run.first, run.count});
}

void ChangeValues::takeNeighbours(TargetId id, const std::shared_ptr<const RenderMesh>& of,
                                  EdgeNeighbours neighbours) {
    const auto known = m_targets.find(id);
    if (known != m_targets.end() && known->second->target->deformed.sharedRender() == of) {
        known->second->neighbours = std::move(neighbours);
        work();
    }
}

/// Whether the target is done.
bool ChangeValues::workOn(TargetValues& values, const QElapsedTimer& clock, bool toTheEnd) {
    if (*m_quantity == ChangeQuantity::EdgeStretch && values.neighbours.empty() && !values.waiting.empty()) {
        const DeformedMesh& mesh = values.target->deformed;
        if (mesh.positions().size() <= kLargeMesh || toTheEnd) {
            values.neighbours = EdgeNeighbours(mesh.render());
        } else if (!std::exchange(values.neighboursWanted, true)) {
            auto found = std::make_shared<EdgeNeighbours>();
            workBeside(
                this, [render = mesh.sharedRender(), found] { *found = EdgeNeighbours(*render); },
                [id = values.target->id, render = mesh.sharedRender(), found](ChangeValues& self, bool) {
                    self.takeNeighbours(id, render, std::move(*found));
                });
        }
        if (values.neighbours.empty()) {
            return true;  // goes on when they have been found
        }
    }
    std::size_t done = 0;
    while (!values.waiting.empty()) {
        const std::uint32_t cluster = values.waiting.back();
        values.waiting.pop_back();
        values.marked[cluster] = 0;
        --m_waiting;
        measure(values, cluster);
        if (++done % kLookAtClock == 0 && !toTheEnd && clock.nsecsElapsed() > kSlice) {
            return false;
        }
    }
    return true;
}

void ChangeValues::work() {
    QElapsedTimer clock;
    clock.start();
    bool done = true;
    for (auto& [id, values] : m_targets) {
        done = workOn(*values, clock, false);
        if (!done) {
            break;
        }
    }
    if (!done) {
        m_timer.start();
    }
    announce();
}

void ChangeValues::finish() {
    const QElapsedTimer unused;
    for (auto& [id, values] : m_targets) {
        workOn(*values, unused, true);
    }
    m_timer.stop();
    announce();
    m_histogramTimer.stop();
    while (m_histogramWanted && (m_isGrowing || m_histogramStale)) {
        workOnHistogram();
    }
}

void ChangeValues::announce() {
    for (auto& [id, values] : m_targets) {
        if (!values->measured.empty()) {
            const std::vector<VertexRange> ranges = merged(std::exchange(values->measured, {}));
            m_histogramStale = true;
            Q_EMIT valuesChanged(id, ranges);
        }
    }
    const Summary now = summary();
    if (now != m_announced && m_waiting == 0) {
        m_announced = now;
        m_histogramStale = true;
        Q_EMIT summaryChanged();
    }
    if (m_histogramWanted && m_histogramStale && !m_isGrowing && !m_histogramTimer.isActive()) {
        m_histogramTimer.start(kHistogramPause);
    }
}

Summary ChangeValues::summary() const {
    Summary all;
    for (const auto& [id, values] : m_targets) {
        if (values->target->visible) {
            all.add(values->tree.all());
        }
    }
    return all;
}

std::span<const float> ChangeValues::values(TargetId target) const {
    const auto known = m_targets.find(target);
    return known == m_targets.end() ? std::span<const float>() : known->second->values.all();
}

void ChangeValues::setHistogramWanted(bool wanted) {
    m_histogramWanted = wanted;
    announce();
}

void ChangeValues::startHistogram() {
    m_histogramStale = false;
    m_isGrowing = true;
    m_growingTarget = {};
    m_growingCluster = 0;
    const Summary all = summary();
    if (all.count == 0) {
        m_growing = {};
        return;
    }
    // All alike: a bar in the middle.
    const double margin = all.high > all.low ? 0.0 : std::max(std::abs(all.high) * 0.5, 1e-3);
    m_growing = Histogram(all.low - margin, all.high + margin, kBins);
}

/// A slice, from where the last one ended.
void ChangeValues::workOnHistogram() {
    if (!m_isGrowing) {
        startHistogram();
    }
    QElapsedTimer clock;
    clock.start();
    for (auto it = m_targets.lower_bound(m_growingTarget); it != m_targets.end(); ++it) {
        if (it->first != m_growingTarget) {
            m_growingTarget = it->first;
            m_growingCluster = 0;
        }
        const TargetValues& values = *it->second;
        const RenderMesh& render = values.target->deformed.render();
        for (; values.target->visible && m_growingCluster < render.clusters.size(); ++m_growingCluster) {
            if (values.tree.part(m_growingCluster).count == 0) {
                continue;
            }
            const Cluster& run = render.clusters[m_growingCluster];
            for (std::uint32_t vertex = run.first; vertex < run.first + run.count; ++vertex) {
                const std::uint32_t fileVertex = render.fileVertices[vertex];
                const std::span<const std::uint32_t> all = render.renderVerticesOf(fileVertex);
                if (vertex >= render.drawnVertices || all.front() != vertex) {
                    continue;
                }
                const float value = largestOf(all, [&](auto v) { return values.values[v]; });
                if (value != 0.0f || values.target->deformed.isChanged(fileVertex)) {
                    // Rounded to float it may lie just beyond the span.
                    m_growing.add(std::clamp(static_cast<double>(value), m_growing.low, m_growing.high));
                }
            }
            if (clock.nsecsElapsed() > kSlice) {
                ++m_growingCluster;
                m_histogramTimer.start(0);
                return;
            }
        }
    }
    m_isGrowing = false;
    m_histogram = m_growing;
    Q_EMIT histogramChanged();
    if (m_histogramStale) {
        m_histogramTimer.start(kHistogramPause);
    }
}

}  // namespace hitscope
