// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/time_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolBar>
#include <cmath>

#include "panels/icons/themed_icon.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr int kStepRates[] = {60, 120, 240, 480, 1000, 2000};  // steps a second

bool isNear(double a, double b) {
    return std::abs(a - b) < 1.0e-9;
}

QString withKey(const QString& text, const QAction& action) {
    return QStringLiteral("%1 (%2)").arg(text, action.shortcut().toString(QKeySequence::NativeText));
}

}  // namespace

TimeActions::TimeActions(Session& session, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_pause(makeAction(tr("P&ause"), Qt::Key_P, QStringLiteral("pause"))),
      m_step(makeAction(tr("Si&ngle Step"), Qt::Key_Period, QStringLiteral("step"))),
      m_slow(makeAction(tr("Slo&w Motion (%1×)").arg(shownNumber(kSlowMotion)), Qt::Key_Comma,
                        QStringLiteral("slow"))),
      m_steps(new QActionGroup(this)) {
    m_pause->setCheckable(true);
    m_slow->setCheckable(true);
    m_pause->setToolTip(withKey(tr("Pause the simulation"), *m_pause));
    m_step->setToolTip(withKey(tr("One physics step, then pause"), *m_step));
    m_slow->setToolTip(withKey(tr("Slow motion: a tenth of real time"), *m_slow));
    connect(m_pause, &QAction::triggered, &session.simulation(), &Simulation::setPaused);
    connect(m_step, &QAction::triggered, this, &TimeActions::stepOnce);
    connect(m_slow, &QAction::triggered, this,
            [this](bool on) { m_session.simulation().setTimeScale(on ? kSlowMotion : 1.0); });
    connect(&session.simulation(), &Simulation::timeChanged, this, &TimeActions::follow);
}

QAction* TimeActions::makeAction(const QString& text, const QKeySequence& key, const QString& icon) {
    auto* action = new QAction(themedIcon(icon), text, this);
    action->setObjectName(icon + QStringLiteral("Time"));
    action->setShortcut(key);
    action->setIconVisibleInMenu(false);  // it would hide the check mark
    return action;
}

void TimeActions::fill(QMenu& menu) {
    menu.addAction(m_pause);
    menu.addAction(m_step);
    menu.addAction(m_slow);
    fillStepMenu(*menu.addMenu(tr("Ph&ysics Step")));
    follow();
}

void TimeActions::fillStepMenu(QMenu& menu) {
    menu.setToolTipsVisible(true);
    for (const int rate : kStepRates) {
        const double seconds = 1.0 / rate;
        const bool isDefault = isNear(seconds, stepParameter().defaultValue);
        QAction* action =
            menu.addAction(isDefault ? tr("1/%1 s (default)").arg(rate) : tr("1/%1 s").arg(rate));
        action->setCheckable(true);
        action->setData(seconds);
        action->setToolTip(tr("Shorter steps follow flights and bounces more closely, and cost more"));
        m_steps->addAction(action);
        connect(action, &QAction::triggered, this,
                [this, seconds] { m_session.simulation().setStep(seconds); });
    }
}

void TimeActions::fill(QToolBar& bar) {
    bar.addAction(m_pause);
    bar.addAction(m_step);
    bar.addAction(m_slow);
    const ParameterDescriptor& range = timeScaleParameter();
    m_scale = new QDoubleSpinBox(&bar);
    m_scale->setObjectName(QStringLiteral("timeScale"));
    m_scale->setRange(range.minimum, range.maximum);
    m_scale->setDecimals(range.decimals);
    m_scale->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    m_scale->setSuffix(tr("×"));
    m_scale->setKeyboardTracking(false);
    m_scale->setToolTip(tr("Time scale: simulated time over real time"));
    connect(m_scale, &QDoubleSpinBox::valueChanged, &m_session.simulation(), &Simulation::setTimeScale);
    connect(m_scale->findChild<QLineEdit*>(), &QLineEdit::returnPressed, this, &TimeActions::numberTyped);
    bar.addWidget(m_scale);
    follow();
}

/// A step is something to look at: time does not run away after it.
void TimeActions::stepOnce() {
    m_session.simulation().setPaused(true);
    m_session.simulation().stepOnce();
}

void TimeActions::follow() {
    const double scale = m_session.simulation().physics().clock().timeScale();
    m_pause->setChecked(m_session.simulation().isPaused());
    m_slow->setChecked(isNear(scale, kSlowMotion));
    for (QAction* action : m_steps->actions()) {
        action->setChecked(
            isNear(action->data().toDouble(), m_session.simulation().physics().clock().step()));
    }
    if (m_scale != nullptr) {
        const QSignalBlocker quiet(m_scale);
        m_scale->setValue(scale);
    }
}

}  // namespace hitscope
