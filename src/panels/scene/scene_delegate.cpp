// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/scene/scene_delegate.h"

#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>

#include "models/scene_model.h"
#include "panels/icons/themed_icon.h"

namespace hitscope {

namespace {

constexpr int kEye = 16;  // pixels

}  // namespace

void SceneDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    QStyledItemDelegate::initStyleOption(option, index);
    option->features &= ~QStyleOptionViewItem::HasCheckIndicator;
    if (!index.data(SceneModel::VisibleRole).toBool()) {
        option->palette.setColor(QPalette::Text, option->palette.color(QPalette::Disabled, QPalette::Text));
    }
    if (index.column() == SceneModel::NameColumn &&
        !index.data(SceneModel::WhyNotHittableRole).toString().isEmpty()) {
        option->features |= QStyleOptionViewItem::HasDecoration;
        option->icon = themedIcon(QStringLiteral("warning"));
        option->decorationSize = QSize(kEye, kEye);
    }
}

void SceneDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
    QStyledItemDelegate::paint(painter, option, index);
    if (index.column() != SceneModel::VisibleColumn) {
        return;
    }
    const bool visible = index.data(SceneModel::VisibleRole).toBool();
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    QRect place(0, 0, kEye, kEye);
    place.moveCenter(option.rect.center());
    themedIcon(visible ? QStringLiteral("eye") : QStringLiteral("eye_off"))
        .paint(painter, place, Qt::AlignCenter,
               selected  ? QIcon::Selected
               : visible ? QIcon::Normal
                         : QIcon::Disabled);
}

void SceneDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    const auto* line = qobject_cast<const QLineEdit*>(editor);
    if (line == nullptr || !line->isModified()) {
        QStyledItemDelegate::setEditorData(editor, index);
    }
}

bool SceneDelegate::editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                                const QModelIndex& index) {
    if (index.column() != SceneModel::VisibleColumn) {
        return QStyledItemDelegate::editorEvent(event, model, option, index);
    }
    if (event->type() == QEvent::MouseButtonRelease &&
        static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton) {
        const bool visible = index.data(SceneModel::VisibleRole).toBool();
        return model->setData(index, visible ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
    }
    return false;
}

}  // namespace hitscope
