// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "analysis/mesh_measuring.h"

namespace hitscope {

/// The faces that hits have harmed: flipped, degenerated, stretched over the limit; one row a face and harm,
/// at most MeshMeasurement::kMostHarms of them.
class MeshHealthModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column : int { FaceColumn, HarmColumn, StretchColumn, HitColumn, ColumnCount };

    /// Both outlive the model.
    MeshHealthModel(const Session& session, const MeshMeasuring& measuring, QObject* parent = nullptr);

    [[nodiscard]] const HarmRow& harmAt(int row) const { return m_rows[static_cast<std::size_t>(row)]; }
    [[nodiscard]] std::size_t found() const { return m_found; }  ///< also those that are not listed

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role = Qt::DisplayRole) const override;

Q_SIGNALS:
    void foundChanged();

private:
    void follow();
    [[nodiscard]] QString text(const HarmRow& row, int column) const;
    [[nodiscard]] QString toolTip(const HarmRow& row) const;

    const Session& m_session;
    const MeshMeasuring& m_measuring;
    std::vector<HarmRow> m_rows;
    std::size_t m_found = 0;
};

}  // namespace hitscope
