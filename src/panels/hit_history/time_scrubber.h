// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

#include "session/session.h"

class QSlider;
class QToolButton;

namespace hitscope {

/// Goes back and forth through the hit history: a slider over its hits, one step back or on, and play. The
/// targets are shown as they were after the hit; the history stays as it is. At its end all hits are shown,
/// also those to come; Escape goes there.
class TimeScrubber : public QWidget {
    Q_OBJECT
public:
    /// `session` outlives the scrubber.
    explicit TimeScrubber(Session& session, QWidget* parent = nullptr);

    [[nodiscard]] bool isPlaying() const { return m_timer.isActive(); }

    static constexpr int kTick = 40;         ///< milliseconds between two pictures while playing
    static constexpr double kWhole = 12.0;   ///< seconds that a long history takes
    static constexpr double kSlowest = 8.0;  ///< hits a second at least

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QToolButton* addButton(const char* icon, const QString& tip, void (TimeScrubber::*act)());
    void follow();
    void show(int hits);
    void togglePlay();
    void play(bool on);
    void playOn();
    void stepBack();
    void stepOn();
    [[nodiscard]] int shown() const { return static_cast<int>(m_session.hits().shown().size()); }
    [[nodiscard]] int all() const { return static_cast<int>(m_session.hits().history().size()); }

    Session& m_session;
    QToolButton* m_play = nullptr;
    QToolButton* m_back = nullptr;
    QToolButton* m_on = nullptr;
    QSlider* m_slider = nullptr;
    QTimer m_timer;
    double m_place = 0.0;  ///< hits, while playing
    bool m_isShowing = false;
};

}  // namespace hitscope
