// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

#include "session/session.h"

namespace hitscope {

/// Says in a corner of another widget that time does not go as real time does, and how many scheduled shots
/// are to come. Not there while there is nothing to say.
class TimeBadge : public QLabel {
    Q_OBJECT
public:
    /// `session` outlives this.
    TimeBadge(const Session& session, QWidget* over);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow();
    void place();

    const Session& m_session;
};

}  // namespace hitscope
