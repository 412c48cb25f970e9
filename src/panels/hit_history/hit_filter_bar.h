// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "models/hit_list.h"
#include "session/once_a_turn.h"

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace hitscope {

/// Which hits the table lists: those with a text in their number, target or pipeline; on one target; enabled
/// ones only. Hidden until it is wanted; Escape closes it, and then all are listed.
class HitFilterBar : public QWidget {
    Q_OBJECT
public:
    /// Both outlive the bar.
    HitFilterBar(Session& session, HitList& list, QWidget* parent = nullptr);

    void open();
    void close();

Q_SIGNALS:
    void opened(bool isOpen);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void listTargets();
    void apply();

    Session& m_session;
    HitList& m_list;
    QLineEdit* m_text = nullptr;
    QComboBox* m_target = nullptr;
    QCheckBox* m_enabled = nullptr;
    OnceATurn m_listing{[this] { listTargets(); }};
};

}  // namespace hitscope
