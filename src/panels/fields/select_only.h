// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemView>
#include <QItemSelectionModel>

namespace hitscope {

/// Selects a row and no other, whatever key is held: with Ctrl, QTableView::selectRow() adds it to those that
/// are selected, and Ctrl is held where Ctrl+D or Ctrl+Z selects.
inline void selectOnly(QAbstractItemView& view, const QModelIndex& row) {
    view.selectionModel()->setCurrentIndex(row,
                                           QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
}

}  // namespace hitscope
