// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/hit_history/hit_table.h"

#include <QDrag>
#include <QDragMoveEvent>
#include <QItemSelection>
#include <QMimeData>
#include <QPainter>

#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr int kLine = 2;            // pixels
constexpr int kAround = 12;         // pixels, around the text of an empty list
constexpr int kLabelPadding = 6;    // around the label's text
constexpr QPoint kBeside(-14, -8);  // from the cursor to the label, so that neither it nor the line is hidden

}  // namespace

QPixmap HitTable::label(const QString& text) const {
    const QSize size = fontMetrics().size(Qt::TextSingleLine, text) + QSize(2 * kLabelPadding, kLabelPadding);
    QPixmap pixmap(size * devicePixelRatioF());
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    pixmap.fill(palette().color(QPalette::Highlight));
    QPainter painter(&pixmap);
    painter.setFont(font());
    painter.setPen(palette().color(QPalette::HighlightedText));
    painter.drawText(QRect(QPoint(), size), Qt::AlignCenter, text);
    return pixmap;
}

void HitTable::startDrag(Qt::DropActions actions) {
    QModelIndexList rows;
    for (const QItemSelectionRange& range : selectionModel()->selection()) {
        for (int row = range.top(); row <= range.bottom(); ++row) {
            rows.append(model()->index(row, 0));
        }
    }
    if (rows.isEmpty()) {
        return;
    }
    auto* drag = new QDrag(this);  // Qt deletes it
    drag->setMimeData(model()->mimeData(rows));
    const auto count = static_cast<std::size_t>(rows.size());
    drag->setPixmap(label(tr("%Ln {hit|hits}", nullptr, trCount(count))));
    drag->setHotSpot(kBeside);
    drag->exec(actions, Qt::MoveAction);
    showPlace(std::nullopt);
}

void HitTable::dragMoveEvent(QDragMoveEvent* event) {
    QTableView::dragMoveEvent(event);
    const QModelIndex over = indexAt(event->position().toPoint());
    const QRect row = visualRect(over.isValid() ? over : model()->index(model()->rowCount() - 1, 0));
    const bool above = over.isValid() && dropIndicatorPosition() == AboveItem;
    showPlace(event->isAccepted() ? std::optional(above ? row.top() : row.bottom() + 1) : std::nullopt);
}

void HitTable::dragLeaveEvent(QDragLeaveEvent* event) {
    QTableView::dragLeaveEvent(event);
    showPlace(std::nullopt);
}

void HitTable::dropEvent(QDropEvent* event) {
    showPlace(std::nullopt);
    QTableView::dropEvent(event);
}

void HitTable::showPlace(std::optional<int> y) {
    m_place = y;
    viewport()->update();
}

void HitTable::setEmptyText(const QString& text) {
    if (text != m_emptyText) {
        m_emptyText = text;
        viewport()->update();
    }
}

void HitTable::paintEvent(QPaintEvent* event) {
    QTableView::paintEvent(event);
    if (!m_emptyText.isEmpty() && model()->rowCount() == 0) {
        QPainter painter(viewport());
        painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
        painter.drawText(viewport()->rect().adjusted(kAround, kAround, -kAround, -kAround),
                         Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, m_emptyText);
    }
    if (m_place) {
        QPainter painter(viewport());
        painter.fillRect(0, *m_place - kLine / 2, viewport()->width(), kLine,
                         palette().color(QPalette::Text));
    }
}

}  // namespace hitscope
