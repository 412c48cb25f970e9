// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/hit_history/hit_delegate.h"

#include "models/hit_history_model.h"

namespace hitscope {

void HitDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    QStyledItemDelegate::initStyleOption(option, index);
    const QColor dim = option->palette.color(QPalette::Disabled, QPalette::Text);
    // The style derives the check box's edge from it; a dark theme's own would leave an empty box invisible.
    option->palette.setColor(QPalette::Window, dim);
    if (index.data(HitHistoryModel::HitStateRole).toInt() != HitHistoryModel::Applied) {
        option->palette.setColor(QPalette::Text, dim);
    }
}

}  // namespace hitscope
