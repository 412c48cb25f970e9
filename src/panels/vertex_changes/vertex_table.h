// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>
#include <optional>

#include "session/vertex_selection.h"

namespace hitscope {

/// A table of vertices whose selection is the session's, not the view's own: a view keeps ranges of rows, and
/// a hundred thousand vertices selected in the viewport are as many ranges. Mouse and keys do what they do in
/// any table and come out as signals; what is selected is drawn as the model's SelectedRole says.
class VertexTable : public QTableView {
    Q_OBJECT
public:
    explicit VertexTable(QWidget* parent = nullptr);

Q_SIGNALS:
    /// Rows [first, last]; `at` is the one that was clicked or moved to.
    void rowsChosen(int first, int last, int at, hitscope::VertexSelection::Combine combine);
    void noneChosen();
    void rowHovered(std::optional<int> row);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void choose(int row, Qt::KeyboardModifiers modifiers);
    void extendTo(int row, VertexSelection::Combine combine);

    int m_anchor = 0;  ///< row that a range starts from
    std::optional<int> m_hovered;
};

}  // namespace hitscope
