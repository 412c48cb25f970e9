// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "session/session.h"

class QActionGroup;
class QComboBox;
class QMenu;

namespace hitscope {

/// Menu and box to choose a pipeline from, each with what it needs and keeps; those the driver cannot run are
/// greyed out and say why.
class PipelineChooser : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this.
    explicit PipelineChooser(Session& session, QObject* parent = nullptr);

    void fill(QMenu& menu);                             ///< once
    [[nodiscard]] QComboBox* makeBox(QWidget* parent);  ///< once

Q_SIGNALS:
    void chosenInBox();
    /// The pipeline that was set, which is the one remembered from the last time, cannot run here; another
    /// was chosen. `notice` says it.
    void fellBack(const QString& notice);

private:
    void follow();
    void leaveUnavailable();
    [[nodiscard]] QString toolTip(const PipelineTraits& traits) const;

    Session& m_session;
    QActionGroup* m_actions = nullptr;
    QComboBox* m_box = nullptr;
};

}  // namespace hitscope
