// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/hit_history/hit_delegate.h"

#include "models/hit_history_model.h"

namespace hitscope {

void HitDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    QStyledItemDelegate::initStyleOption(option, index);
    if (index.data(HitHistoryModel::HitStateRole).toInt() != HitHistoryModel::Applied) {
        option->palette.setColor(QPalette::Text, option->palette.color(QPalette::Disabled, QPalette::Text));
    }
}

}  // namespace hitscope
