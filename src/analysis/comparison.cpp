// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/comparison.h"

#include <algorithm>

namespace hitscope {

Comparison::Comparison(Session& session, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_difference(session),
      m_values(session, [this](const Target& target) { return shapeOf(target); }) {
    m_difference.setOtherVertices([this](TargetId target) { return vertices(target); });
    connect(this, &Comparison::verticesChanged, &m_difference, &ChangeValues::touch);
    connect(this, &Comparison::verticesChanged, &m_values, &ChangeValues::touch);
    connect(&m_values, &ChangeValues::valuesChanged, this, &Comparison::valuesChanged);
    connect(&session.targets(), &SessionTargets::removed, this,
            [this](TargetId target) { m_shapes.erase(target); });
    connect(&session, &Session::sceneReplaced, this, [this] {
        m_shapes.clear();
        m_report = {};
        Q_EMIT reportChanged();
    });
}

Comparison::~Comparison() = default;

void Comparison::setOther(std::optional<PipelineKind> other) {
    if (other == m_other) {
        return;
    }
    m_other = other;
    m_failure.clear();
    restart();
    m_difference.setQuantity(other ? std::optional(ChangeQuantity::Difference) : std::nullopt);
    m_report = {};
    Q_EMIT otherChanged();
    Q_EMIT reportChanged();
}

void Comparison::restart() {
    std::map<TargetId, std::unique_ptr<Shape>> before = std::exchange(m_shapes, {});
    for (const auto& [target, shape] : before) {
        std::vector<std::uint32_t> touched;
        for (const std::uint32_t vertex : shape->deformed.onceChanged()) {
            const auto drawn = shape->deformed.render().renderVerticesOf(vertex);
            touched.insert(touched.end(), drawn.begin(), drawn.end());
        }
        Q_EMIT verticesChanged(target, touched);
    }
}

std::span<const DynamicVertex> Comparison::vertices(TargetId target) const {
    const auto known = m_shapes.find(target);
    if (known != m_shapes.end()) {
        return known->second->deformed.vertices();
    }
    // Nothing has come: it is as it was.
    const Target* original = m_other ? m_session.targets().find(target) : nullptr;
    return original != nullptr ? std::span<const DynamicVertex>(original->deformed.render().vertices)
                               : std::span<const DynamicVertex>();
}

const DeformedMesh* Comparison::deformed(TargetId target) const {
    const auto known = m_shapes.find(target);
    return known == m_shapes.end() ? nullptr : &known->second->deformed;
}

std::optional<ChangeValues::Shape> Comparison::shapeOf(const Target& target) const {
    const auto known = m_shapes.find(target.id);
    return known == m_shapes.end()
               ? std::nullopt
               : std::optional(ChangeValues::Shape{&known->second->deformed, &known->second->trueNormals});
}

/// Numbers of hits are those of A, and a difference is one from either side.
void Comparison::setShownQuantity(std::optional<ChangeQuantity> quantity) {
    const bool showedCounts = showsCountsOfFirst();
    m_shown = m_other ? quantity : std::nullopt;
    if (showsCountsOfFirst() != showedCounts) {
        Q_EMIT reportChanged();
    }
    const bool isOwn = m_other && quantity == ChangeQuantity::EdgeStretch;
    m_values.setQuantity(isOwn ? quantity : std::nullopt);
}

const TurnedNormals& Comparison::normals(TargetId target) const {
    return m_shapes.at(target)->trueNormals.normals();
}

void Comparison::take(TargetId id, std::uint32_t first, std::span<const DynamicVertex> vertices) {
    const Target* target = m_session.targets().find(id);
    if (target == nullptr) {
        return;
    }
    std::unique_ptr<Shape>& shape = m_shapes[id];
    if (!shape) {
        shape = std::make_unique<Shape>(*target);
    }
    shape->deformed.write(first, vertices, shape->moved);
}

std::vector<ReadBack::ChangedNormals> Comparison::finishReadBack() {
    std::vector<ReadBack::ChangedNormals> changes;
    for (const auto& [id, shape] : m_shapes) {
        if (!shape->moved.empty()) {
            ReadBack::ChangedNormals change{id, {}};
            shape->trueNormals.update(shape->deformed.positions(), shape->moved, change.renderVertices);
            std::sort(change.renderVertices.begin(), change.renderVertices.end());
            shape->moved.clear();
            changes.push_back(std::move(change));
        }
    }
    for (const ReadBack::ChangedNormals& change : changes) {
        Q_EMIT verticesChanged(change.target, change.renderVertices);
    }
    return changes;
}

void Comparison::settle(std::size_t droppedHits) {
    if (!m_difference.isComplete()) {
        return;
    }
    const Summary summary = m_difference.summary();
    const Report now{summary.count, summary.count == 0 ? 0.0 : summary.high, summary.rootMeanSquare(),
                     m_session.readBack().droppedHits(), droppedHits};
    if (now != m_report) {
        m_report = now;
        Q_EMIT reportChanged();
    }
}

void Comparison::setFailure(const QString& failure) {
    if (failure != m_failure) {
        m_failure = failure;
        Q_EMIT reportChanged();
    }
}

}  // namespace hitscope
