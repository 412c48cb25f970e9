// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/dialogs/plan_dialog.h"

class QMenu;
class QSettings;

namespace hitscope {

class HitEditing;

/// Many hits at once: scattered, mirrored, and with the brush.
class RepeatActions : public QObject {
    Q_OBJECT
public:
    /// All outlive this, and so does `window`, which dialogs belong to.
    RepeatActions(Session& session, Viewport& viewport, HitEditing& editing, QWidget& window);

    void fill(QMenu& menu);
    void save(QSettings& settings) const;
    void showScatter();
    void showMirror();
    void showBrush();

Q_SIGNALS:
    void said(const QString& text);
    void failed(const hitscope::Error& error);

private:
    void load(const QSettings& settings);
    void open(PlanDialog* dialog);

    Session& m_session;
    Viewport& m_viewport;
    HitEditing& m_editing;
    QWidget& m_window;
};

}  // namespace hitscope
