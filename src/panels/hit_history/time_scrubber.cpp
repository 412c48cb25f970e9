// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/hit_history/time_scrubber.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <algorithm>

#include "models/quantity_text.h"
#include "panels/help/help_text.h"
#include "panels/icons/themed_icon.h"

namespace hitscope {

namespace {

constexpr int kShortestSlider = 60;  // pixels

}  // namespace

TimeScrubber::TimeScrubber(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_slider(new QSlider(Qt::Horizontal, this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    m_play = addButton("scrub_play", tr("Replay the hits one after the other"), &TimeScrubber::togglePlay);
    m_back = addButton("scrub_back", tr("Previous hit"), &TimeScrubber::stepBack);
    m_on = addButton("scrub_forward", tr("Next hit"), &TimeScrubber::stepOn);
    m_play->setObjectName(QStringLiteral("play"));
    m_back->setObjectName(QStringLiteral("stepBack"));
    m_on->setObjectName(QStringLiteral("stepOn"));
    m_slider->setObjectName(QStringLiteral("time"));
    m_slider->setMinimumWidth(kShortestSlider);
    layout->addWidget(m_slider, 1);
    m_timer.setInterval(kTick);
    connect(&m_timer, &QTimer::timeout, this, &TimeScrubber::playOn);
    connect(m_slider, &QSlider::valueChanged, this, [this](int hits) {
        play(false);
        show(hits);
    });
    for (const auto signal : {&SessionHits::appended, &SessionHits::reset, &SessionHits::shownChanged}) {
        connect(&session.hits(), signal, this, &TimeScrubber::follow);
    }
    follow();
}

QToolButton* TimeScrubber::addButton(const char* icon, const QString& tip, void (TimeScrubber::*act)()) {
    auto* button = new QToolButton(this);
    button->setAutoRaise(true);
    button->setIcon(themedIcon(QString::fromLatin1(icon)));
    button->setToolTip(tip);
    connect(button, &QToolButton::clicked, this, act);
    layout()->addWidget(button);
    return button;
}

void TimeScrubber::follow() {
    {
        const QSignalBlocker blocker(m_slider);
        m_slider->setRange(0, all());
        m_slider->setPageStep(std::max(1, all() / 10));
        m_slider->setValue(shown());
    }
    if (!m_isShowing) {
        play(false);  // somebody else has chosen another moment, or shot
    }
    const QString none = tr("There are no hits yet.");
    enableIf(*m_play, all() > 0, none);
    enableIf(*m_slider, all() > 0, none);
    enableIf(*m_back, shown() > 0, all() > 0 ? tr("No hit is shown.") : none);
    enableIf(*m_on, shown() < all(), all() > 0 ? tr("All hits are shown.") : none);
    m_slider->setToolTip(
        tr("Show the targets as they were after hit %1 of %2; the history is not changed")
            .arg(countText(static_cast<std::size_t>(shown())), countText(static_cast<std::size_t>(all()))));
}

void TimeScrubber::show(int hits) {
    m_isShowing = true;
    m_session.hits().show(hits >= all() ? std::nullopt : std::optional(static_cast<std::size_t>(hits)));
    follow();
    m_isShowing = false;  // last: for anybody else's moment follow() stops the replay
}

void TimeScrubber::togglePlay() {
    play(!isPlaying());
    if (isPlaying()) {
        const int from = shown() == all() ? 0 : shown();
        m_place = from;
        show(from);
    }
}

void TimeScrubber::play(bool on) {
    if (on == m_timer.isActive()) {
        return;
    }
    if (on) {
        m_timer.start();
    } else {
        m_timer.stop();
    }
    m_play->setIcon(themedIcon(on ? QStringLiteral("scrub_pause") : QStringLiteral("scrub_play")));
    m_play->setToolTip(on ? tr("Stop") : tr("Replay the hits one after the other"));
}

void TimeScrubber::playOn() {
    constexpr double kSeconds = kTick / 1000.0;
    m_place += std::max(kSlowest, all() / kWhole) * kSeconds;
    const int hits = std::min(static_cast<int>(m_place), all());
    if (hits != shown()) {
        show(hits);
    }
    if (hits == all()) {
        play(false);
    }
}

void TimeScrubber::stepBack() {
    play(false);
    show(std::max(shown() - 1, 0));
}

void TimeScrubber::stepOn() {
    play(false);
    show(shown() + 1);
}

void TimeScrubber::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && !m_session.hits().showsAll()) {
        play(false);
        show(all());
        return;
    }
    QWidget::keyPressEvent(event);
}

}  // namespace hitscope
