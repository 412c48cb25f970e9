// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>
#include <optional>

namespace hitscope {

/// A table whose rows can be dragged to another place: a line over its whole width shows where they would go,
/// and a small label beside the cursor how many they are.
class HitTable : public QTableView {
    Q_OBJECT
public:
    using QTableView::QTableView;
    /// Shown in place of rows where there are none; empty: nothing is.
    void setEmptyText(const QString& text);

protected:
    void startDrag(Qt::DropActions actions) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void showPlace(std::optional<int> y);
    [[nodiscard]] QPixmap label(const QString& text) const;

    QString m_emptyText;
    std::optional<int> m_place;  ///< y of the line, in the viewport; nothing: no drag is over it
};

}  // namespace hitscope
