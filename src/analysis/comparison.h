// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <map>
#include <memory>
#include <optional>

#include "analysis/change_values.h"
#include "session/session.h"

namespace hitscope {

/// The session's targets as a second pipeline has them, B, beside those of the active one, A: what came back
/// of its vertices, and how far apart the two are. SceneGpu keeps it up while it draws.
class Comparison : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this.
    explicit Comparison(Session& session, QObject* parent = nullptr);
    ~Comparison() override;

    /// Nothing: no comparison, and no cost.
    void setOther(std::optional<PipelineKind> other);
    [[nodiscard]] std::optional<PipelineKind> other() const { return m_other; }
    [[nodiscard]] PipelineKind first() const { return m_session.settings().pipeline(); }  ///< A

    /// Of the vertices that moved under A, or are elsewhere under B. Kept from when both had arrived last.
    struct Report {
        std::size_t vertices = 0;        ///< compared
        double largest = 0.0;            ///< metres
        double rootMeanSquare = 0.0;     ///< metres
        std::size_t droppedByFirst = 0;  ///< hits that A no longer keeps
        std::size_t droppedHits = 0;     ///< that B no longer keeps
        bool operator==(const Report&) const = default;
    };
    [[nodiscard]] const Report& report() const { return m_report; }
    /// Render vertices of B; empty: none have come.
    [[nodiscard]] std::span<const DynamicVertex> vertices(TargetId target) const;
    /// What colour maps show of B where its vertices alone do not tell; null: what they show of A holds for
    /// both.
    [[nodiscard]] const ChangeValues* values() const { return m_values.quantity() ? &m_values : nullptr; }
    /// A target as B has it; null: it is as it was.
    [[nodiscard]] const DeformedMesh* deformed(TargetId target) const;
    /// Both pictures are coloured by numbers of hits, which are those of A, and B keeps others.
    [[nodiscard]] bool showsCountsOfFirst() const {
        return m_shown == ChangeQuantity::HitCount && m_report.droppedByFirst + m_report.droppedHits > 0;
    }
    /// Why there is no B, in words for people; empty: there is.
    [[nodiscard]] const QString& failure() const { return m_failure; }

    // For SceneGpu.
    /// What is shown of B by colours; nothing: none, and no cost.
    void setShownQuantity(std::optional<ChangeQuantity> quantity);
    void restart();  ///< B is at the originals
    void take(TargetId target, std::uint32_t first, std::span<const DynamicVertex> vertices);
    /// As ReadBack::finish().
    std::vector<ReadBack::ChangedNormals> finishReadBack();
    [[nodiscard]] const TurnedNormals& normals(TargetId target) const;
    void settle(std::size_t droppedHits);  ///< everything has arrived, of both
    void setFailure(const QString& failure);

Q_SIGNALS:
    void otherChanged();
    void reportChanged();
    void valuesChanged();  ///< those of values()
    void verticesChanged(hitscope::TargetId target, const std::vector<std::uint32_t>& renderVertices);

private:
    struct Shape {
        explicit Shape(const Target& target)
            : deformed(target.deformed.sharedOriginal(), target.deformed.sharedRender()),
              trueNormals(target.deformed.sharedOriginal(), target.deformed.sharedRender()) {}
        DeformedMesh deformed;
        TrueNormals trueNormals;
        std::vector<std::uint32_t> moved;  ///< file vertices, since finishReadBack()
    };

    [[nodiscard]] std::optional<ChangeValues::Shape> shapeOf(const Target& target) const;

    Session& m_session;
    std::optional<PipelineKind> m_other;
    std::map<TargetId, std::unique_ptr<Shape>> m_shapes;
    ChangeValues m_difference;
    ChangeValues m_values;
    std::optional<ChangeQuantity> m_shown;
    Report m_report;
    QString m_failure;
};

}  // namespace hitscope
