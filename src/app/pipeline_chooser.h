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
    /// What draws is known: leaves a pipeline that is not exact here for one that is, unless it was chosen
    /// here.
    void leaveInexact();

Q_SIGNALS:
    void chosenInBox();
    /// The pipeline that was set, which is the one remembered from the last time, cannot run here or is not
    /// exact here; another was chosen. `notice` says it.
    void fellBack(const QString& notice);

private:
    void choose(PipelineKind kind);
    void follow();
    void leaveUnavailable();
    [[nodiscard]] QString toolTip(const PipelineTraits& traits) const;

    Session& m_session;
    QActionGroup* m_actions = nullptr;
    QComboBox* m_box = nullptr;
    bool m_isChosen = false;  ///< by a person, since the window opened
};

}  // namespace hitscope
