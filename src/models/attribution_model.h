// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QTimer>
#include <optional>
#include <vector>

#include "deform/attribution.h"
#include "session/session.h"
#include "session/vertex_selection.h"

namespace hitscope {

/// Why the picked vertex is where it is: a row for each hit that reached it, in order, with that hit's own
/// part. Hits on other targets and those that made nothing of what is shown (SessionHits::isApplied()) have
/// none.
///
/// Follows hits that come at the cost of those; any other change of the history takes the vertex through all
/// hits again, which is 100,000 in about a millisecond.
class AttributionModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column : int {
        HitColumn,        ///< as the hit history numbers it, 1 for the oldest
        DistanceColumn,   ///< r, metres
        MagnitudeColumn,  ///< m, metres
        CapColumn,        ///< whether max_magnitude applied
        DisplacementColumn,
        PositionColumn,  ///< after the hit
        ColumnCount
    };
    enum Role : int {
        HitRole = Qt::UserRole,  ///< qulonglong: the hit's index in the history
        RawValueRole  ///< double for lengths (m), bool for the cap, QVariantList of three doubles for vectors
    };

    /// `session` outlives the model.
    explicit AttributionModel(Session& session, QObject* parent = nullptr);

    [[nodiscard]] const std::optional<VertexRef>& vertex() const { return m_vertex; }
    [[nodiscard]] std::span<const VertexContribution> contributions() const {
        return m_attribution.contributions();
    }
    /// Original position plus all contributions in order, float by float: where the vertex is according to
    /// the hits.
    [[nodiscard]] const glm::vec3& position() const { return m_attribution.vertex().position; }
    /// Whether that is what the buffer was last read back to hold, in every bit.
    [[nodiscard]] bool isBuffers() const;
    /// What it comes to, in words for the interface; empty: no vertex is picked.
    [[nodiscard]] QString summary() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role = Qt::DisplayRole) const override;

Q_SIGNALS:
    /// A moment after anything it says may have changed, so that the buffer has followed the hits.
    void summaryChanged();

private:
    void startOver();
    void followHits();
    void takeHits(Attribution& attribution);
    [[nodiscard]] QString text(const VertexContribution& row, int column) const;

    Session& m_session;
    std::optional<VertexRef> m_vertex;
    Attribution m_attribution;
    std::size_t m_taken = 0;             ///< hits of the history
    std::vector<std::size_t> m_dropped;  ///< by the pipeline, at the last restart for it
    QTimer m_summaryTimer;
    QTimer m_restartTimer;  ///< many edits in a row are one change
};

}  // namespace hitscope
