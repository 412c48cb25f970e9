// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "analysis/summary_tree.h"
#include "core/histogram.h"
#include "mesh/edge_neighbours.h"
#include "session/session.h"
#include "view/change_options.h"

namespace hitscope {

/// One quantity of change of every vertex as the session has read it back: its values, what they amount to,
/// how they are distributed. Counted are the vertices whose position changed or whose value is not 0. One
/// that is drawn with several normals counts once, by its value of largest magnitude.
///
/// Follows the read-back cluster by cluster, so that a hit costs what it reached. What would take longer than
/// a few milliseconds (another quantity, everything undone on a large mesh) is done in slices between the
/// window's events.
class ChangeValues : public QObject {
    Q_OBJECT
public:
    /// Of the session's targets as it has read them back. `session` outlives this.
    explicit ChangeValues(Session& session, QObject* parent = nullptr);
    /// A target as somebody else has it, with the same render mesh.
    struct Shape {
        const DeformedMesh* deformed = nullptr;
        const TrueNormals* normals = nullptr;
    };
    /// Nothing: it is as it was.
    using Shapes = std::function<std::optional<Shape>(const Target& target)>;
    /// Of those shapes; what changes is to be told by touch().
    ChangeValues(Session& session, Shapes shapes, QObject* parent = nullptr);
    ~ChangeValues() override;

    /// Nothing: rests, has no values and costs nothing.
    void setQuantity(std::optional<ChangeQuantity> quantity);
    [[nodiscard]] std::optional<ChangeQuantity> quantity() const { return m_quantity; }

    /// Where the numbers of hits come from: one a file vertex, or nothing where they are not known yet.
    using HitCounts = std::function<std::span<const std::uint32_t>(TargetId target)>;
    void setHitCounts(HitCounts counts);
    /// Where a second pipeline has a target's render vertices; empty: it has none.
    using OtherVertices = std::function<std::span<const DynamicVertex>(TargetId target)>;
    void setOtherVertices(OtherVertices vertices);

    /// Render vertices of a target have changed in what the session does not tell of: numbers of hits, the
    /// second pipeline.
    void touch(TargetId target, std::span<const std::uint32_t> renderVertices);
    void touchAll(TargetId target);

    /// Over the counted vertices of the visible targets; what is not done yet is as it was.
    [[nodiscard]] Summary summary() const;
    [[nodiscard]] bool isComplete() const { return m_waiting == 0; }
    /// Does at once what waits to be done.
    void finish();
    /// One a render vertex; empty while there is nothing on the target.
    [[nodiscard]] std::span<const float> values(TargetId target) const;
    /// Of the counted file vertices of the visible targets over the summary's span, as it was last made: it
    /// follows with histogramChanged().
    [[nodiscard]] const Histogram& histogram() const { return m_histogram; }
    /// Whether somebody looks at it.
    void setHistogramWanted(bool wanted);

    static constexpr std::size_t kBins = 64;

Q_SIGNALS:
    void summaryChanged();
    void valuesChanged(hitscope::TargetId target, std::span<const hitscope::VertexRange> ranges);
    void histogramChanged();

private:
    struct TargetValues;

    void start(const Target& target);
    void restart();
    void mark(TargetValues& values, std::size_t cluster);
    void work();
    bool workOn(TargetValues& values, const QElapsedTimer& clock, bool toTheEnd);
    void takeNeighbours(TargetId id, const std::shared_ptr<const RenderMesh>& of, EdgeNeighbours neighbours);
    void measure(TargetValues& values, std::size_t cluster);
    [[nodiscard]] double valueOf(const TargetValues& values, const Shape& shape,
                                 std::uint32_t renderVertex) const;
    void announce();
    void startHistogram();
    void workOnHistogram();

    Session& m_session;
    Shapes m_shapes;
    std::optional<ChangeQuantity> m_quantity;
    HitCounts m_hitCounts;
    OtherVertices m_otherVertices;
    std::map<TargetId, std::unique_ptr<TargetValues>> m_targets;
    std::size_t m_waiting = 0;  ///< clusters
    QTimer m_timer;
    Summary m_announced;

    bool m_histogramWanted = false;
    bool m_histogramStale = true;
    Histogram m_histogram;
    Histogram m_growing;  ///< the one being made
    TargetId m_growingTarget;
    std::size_t m_growingCluster = 0;
    bool m_isGrowing = false;
    QTimer m_histogramTimer;
};

/// Where a quantity's colour map starts and ends: the style's own range, or that of the values: from 0 up,
/// and for what has a sign as far below 0 as above.
[[nodiscard]] ChangeRange shownRange(const ChangeMapOptions& options, const Summary& summary);
/// As a frame draws it.
[[nodiscard]] ShownChange shownChange(const ChangeMapOptions& options, const Summary& summary);

}  // namespace hitscope
