// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QPointer>
#include <vector>

#include "app/overlays/keys_lines.h"

class QGridLayout;
class QMainWindow;
class QScrollArea;

namespace hitscope {

/// A translucent sheet over a window that lists all its keys; it goes with F1, Escape or a click. What it
/// lists is asked for whenever it opens, so it cannot be out of date.
class KeysOverlay : public QFrame {
    Q_OBJECT
public:
    explicit KeysOverlay(QMainWindow& window);

    /// Opens with these sections before the window's own; closes if it is open.
    void toggle(std::vector<KeysSection> first);

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void place();
    void fill();
    void closeSheet();

    QMainWindow& m_window;
    QScrollArea* m_area = nullptr;
    std::vector<KeysSection> m_sections;
    QPointer<QWidget> m_before;  ///< had the focus
};

}  // namespace hitscope
