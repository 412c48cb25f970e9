// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QElapsedTimer>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "session/session.h"

namespace hitscope {

/// What there is to know about the target in focus (focusTarget()): original and deformed, side by side.
/// Follows the session; measured at most five times a second, and on another thread where the mesh is large.
class MeshStatisticsModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column : int { PropertyColumn, OriginalColumn, DeformedColumn, ColumnCount };
    enum Row : int {
        DisplacementHeading,
        ChangedVerticesRow,
        LargestDisplacementRow,
        MeanDisplacementRow,
        RmsDisplacementRow,
        ShapeHeading,
        SizeXRow,
        SizeYRow,
        SizeZRow,
        SurfaceAreaRow,
        VolumeRow,
        TopologyHeading,
        VerticesRow,
        EdgesRow,
        FacesRow,
        TrianglesRow,
        QuadsRow,
        LargerPolygonsRow,
        BoundaryEdgesRow,
        ComponentsRow,
        EulerRow,
        WatertightRow,
        UnreferencedRow,
        DegenerateRow,
        NonManifoldRow,
        RowCount
    };
    enum Role : int {
        HeadingRole = Qt::UserRole,  ///< bool: the row is the title of the rows below it
        SharedRole,  ///< bool: no hit changes this; the value in OriginalColumn holds for both
    };

    /// Meshes of more faces than this are measured on another thread.
    static constexpr std::size_t kImmediateFaces = 200'000;

    /// `session` outlives the model.
    explicit MeshStatisticsModel(const Session& session, std::size_t immediateFaces = kImmediateFaces,
                                 QObject* parent = nullptr);

    /// The target that the values are of; 0: the scene is empty.
    [[nodiscard]] TargetId shownTarget() const { return m_target; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role = Qt::DisplayRole) const override;

Q_SIGNALS:
    void shownTargetChanged();

private:
    struct Values {
        std::optional<TopologyStatistics> topology;
        std::optional<GeometryStatistics> original;
        std::optional<GeometryStatistics> deformed;
        DisplacementStatistics displacement;
    };
    struct Measurement;

    void follow();
    void startOver();
    void schedule();
    void measure();
    void measureElsewhere(const Target& target);
    void take(const Measurement& measurement);
    void announceValues();
    [[nodiscard]] QString topologyText(int row) const;
    [[nodiscard]] QString shapeText(int row, const std::optional<GeometryStatistics>& geometry) const;
    [[nodiscard]] QString displacementText(int row) const;
    [[nodiscard]] QString cellText(int row, int column) const;

    const Session& m_session;
    std::size_t m_immediateFaces;
    TargetId m_target;
    Values m_values;
    QTimer m_timer;
    QElapsedTimer m_sinceMeasured;
    bool m_measuringElsewhere = false;
};

}  // namespace hitscope
