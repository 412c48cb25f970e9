// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>
#include <QTimer>

#include "analysis/mesh_measuring.h"
#include "models/statistics_rows.h"

namespace hitscope {

/// What there is to know about the target in focus (focusTarget()), or about all together: original, deformed
/// and the change, in sections. Follows the session; measured on another thread (MeshMeasuring). Views are
/// told kSoon after numbers went out of date: painting all rows would hold up the picture of the hit that did
/// it, and most are measured again by then. The header says so at once.
class MeshStatisticsModel : public QAbstractItemModel {
    Q_OBJECT
public:
    enum Column : int { PropertyColumn, OriginalColumn, DeformedColumn, ChangeColumn, ColumnCount };
    enum Role : int {
        ValueRole = Qt::UserRole,  ///< double, where there is one: the number behind the text
        SharedRole,                ///< bool: no hit changes this; both columns say the same
        OutOfDateRole,             ///< bool: a number that is being recalculated
    };

    static constexpr int kSoon = 100;  ///< milliseconds

    /// `session` outlives the model.
    explicit MeshStatisticsModel(Session& session, QObject* parent = nullptr);

    /// The target that the values are of; 0: of all together, or the scene is empty.
    [[nodiscard]] TargetId shownTarget() const { return m_target; }
    [[nodiscard]] bool showsAll() const { return m_showsAll; }
    void setShowsAll(bool all);
    [[nodiscard]] MeshMeasuring& measuring() { return m_measuring; }
    [[nodiscard]] const MeshMeasuring& measuring() const { return m_measuring; }
    /// Of the row with that key, which exists (statisticsRows()).
    [[nodiscard]] QModelIndex find(const char* key, int column) const;

    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex& child) const override;
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role = Qt::DisplayRole) const override;

Q_SIGNALS:
    void shownTargetChanged();

private:
    struct Section {
        StatisticsRow::Section section;
        std::size_t first = 0;  ///< of statisticsRows()
        int count = 0;
    };
    void follow();
    void announceValues();
    void announceSoon();
    void followMeasured();
    [[nodiscard]] const StatisticsRow* rowAt(const QModelIndex& index) const;
    [[nodiscard]] QString cellText(const StatisticsRow& row, int column) const;
    [[nodiscard]] QString cellToolTip(const StatisticsRow& row, int column) const;

    Session& m_session;
    MeshMeasuring m_measuring;
    std::vector<Section> m_sections;
    TargetId m_target;
    bool m_showsAll = false;
    QTimer m_soon;                ///< to announceValues()
    bool m_hasAnnounced = false;  ///< numbers, of the targets that are shown
};

}  // namespace hitscope
