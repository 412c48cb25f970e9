// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/time_badge.h"

#include <QEvent>
#include <QStringList>

#include "session/shown_number.h"

namespace hitscope {

namespace {

QString timeText(const PhysicsWorld& physics) {
    const double scale = physics.clock().timeScale();
    if (physics.clock().isPaused()) {
        return TimeBadge::tr("Paused");
    }
    if (scale == 1.0) {
        return {};
    }
    const QString factor = shownNumber(scale, 'g', 3);
    return scale < 1.0 ? TimeBadge::tr("Slow motion %1×").arg(factor)
                       : TimeBadge::tr("Fast motion %1×").arg(factor);
}

}  // namespace

TimeBadge::TimeBadge(const Session& session, QWidget* over) : QLabel(over), m_session(session) {
    setObjectName(QStringLiteral("timeBadge"));
    setTextFormat(Qt::PlainText);
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setContentsMargins(6, 2, 6, 2);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    over->installEventFilter(this);
    connect(&session.simulation(), &Simulation::timeChanged, this, &TimeBadge::follow);
    connect(&session.simulation(), &Simulation::scheduleChanged, this, &TimeBadge::follow);
    connect(&session, &Session::sceneReplaced, this, &TimeBadge::follow);
    follow();
}

void TimeBadge::follow() {
    QStringList parts;
    if (const QString time = timeText(m_session.simulation().physics()); !time.isEmpty()) {
        parts << time;
    }
    if (const std::size_t toCome = m_session.simulation().shotsToCome(); toCome > 0) {
        parts << tr("%Ln pending {shot|shots}", nullptr, trCount(toCome));
    }
    setText(parts.join(QStringLiteral(" · ")));
    setVisible(!parts.isEmpty());
    place();
}

bool TimeBadge::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parent() && event->type() == QEvent::Resize) {
        place();
    }
    return QLabel::eventFilter(watched, event);
}

void TimeBadge::place() {
    constexpr int kMargin = 8;
    resize(sizeHint());
    move(kMargin, parentWidget()->height() - height() - kMargin);
}

}  // namespace hitscope
