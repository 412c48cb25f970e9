// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/vertex_changes/vertex_table.h"

#include <QMouseEvent>
#include <QStyledItemDelegate>
#include <algorithm>

#include "models/vertex_changes_model.h"

namespace hitscope {

namespace {

using Combine = VertexSelection::Combine;

class VertexDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        option->state.setFlag(QStyle::State_Selected, index.data(VertexChangesModel::SelectedRole).toBool());
        option->state.setFlag(QStyle::State_Active);  // selected in the viewport as well
        option->font.setBold(index.data(VertexChangesModel::PickedRole).toBool());
    }
};

bool movesCursor(int key) {
    switch (key) {
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
        case Qt::Key_Home:
        case Qt::Key_End:
            return true;
        default:
            return false;
    }
}

}  // namespace

VertexTable::VertexTable(QWidget* parent) : QTableView(parent) {
    setSelectionMode(NoSelection);
    setItemDelegate(new VertexDelegate(this));
    setMouseTracking(true);
    setTabKeyNavigation(false);
}

void VertexTable::choose(int row, Qt::KeyboardModifiers modifiers) {
    const bool add = modifiers.testFlag(Qt::ControlModifier);
    if (modifiers.testFlag(Qt::ShiftModifier)) {
        extendTo(row, add ? Combine::Add : Combine::Replace);
        return;
    }
    m_anchor = row;
    const bool selected = model()->index(row, 0).data(VertexChangesModel::SelectedRole).toBool();
    Q_EMIT rowsChosen(row, row, row, !add ? Combine::Replace : selected ? Combine::Remove : Combine::Add);
}

void VertexTable::extendTo(int row, Combine combine) {
    m_anchor = std::min(m_anchor, model()->rowCount() - 1);
    Q_EMIT rowsChosen(std::min(m_anchor, row), std::max(m_anchor, row), row, combine);
}

void VertexTable::mousePressEvent(QMouseEvent* event) {
    QTableView::mousePressEvent(event);
    const QModelIndex index = indexAt(event->position().toPoint());
    if (event->button() != Qt::LeftButton) {
        return;
    }
    if (index.isValid()) {
        choose(index.row(), event->modifiers());
    } else if (event->modifiers() == Qt::NoModifier) {
        Q_EMIT noneChosen();
    }
}

void VertexTable::mouseMoveEvent(QMouseEvent* event) {
    const QModelIndex index = indexAt(event->position().toPoint());
    if (event->buttons() == Qt::NoButton) {
        const std::optional<int> row = index.isValid() ? std::optional(index.row()) : std::nullopt;
        if (row != m_hovered) {
            m_hovered = row;
            Q_EMIT rowHovered(row);
        }
    } else if (event->buttons() == Qt::LeftButton && index.isValid() && index.row() != currentIndex().row()) {
        setCurrentIndex(index);
        extendTo(index.row(),
                 event->modifiers().testFlag(Qt::ControlModifier) ? Combine::Add : Combine::Replace);
    }
}

void VertexTable::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::SelectAll) && model()->rowCount() > 0) {
        Q_EMIT rowsChosen(0, model()->rowCount() - 1, currentIndex().row(), Combine::Replace);
        return;
    }
    if (event->key() == Qt::Key_Escape) {
        Q_EMIT noneChosen();
        return;
    }
    QTableView::keyPressEvent(event);
    if (movesCursor(event->key()) && currentIndex().isValid()) {
        choose(currentIndex().row(), event->modifiers() & Qt::ShiftModifier);
    }
}

void VertexTable::leaveEvent(QEvent* event) {
    QTableView::leaveEvent(event);
    if (m_hovered) {
        m_hovered.reset();
        Q_EMIT rowHovered(m_hovered);
    }
}

}  // namespace hitscope
