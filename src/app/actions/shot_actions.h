// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "app/shot_series.h"
#include "session/session.h"

class QAction;
class QMenu;
class QToolBar;
class QWidget;

namespace hitscope {

class AimPreview;
class FlightChooser;
class HitEffects;
class ScriptReader;
class Viewport;

/// Shots: at the crosshair, how they fly, bursts, sequences, scripts, the aim preview. Says what becomes of
/// them.
class ShotActions : public QObject {
    Q_OBJECT
public:
    /// `session`, `effects`, `viewport` and `window`, the dialogs' parent, outlive this.
    ShotActions(Session& session, HitEffects& effects, Viewport& viewport, QWidget& window);

    void fill(QMenu& menu);    ///< once
    void fill(QToolBar& bar);  ///< once
    /// A shot script, read on another thread. Where it is none, `otherwise` is done; without that, what is
    /// wrong is said.
    void run(const QString& path, const std::function<void()>& otherwise = {});
    [[nodiscard]] AimPreview& aimPreview() { return *m_aimPreview; }

Q_SIGNALS:
    void noticeWanted(const QString& text);  ///< why the shot just made passes what it was aimed at
    void said(const QString& text);          ///< what has become of shots, for the status bar
    void chosenInBox();                      ///< in the tool bar

private:
    void explainPass(const Ray& ray);
    void showSeries(ShotSeries::Pattern pattern);
    void shoot(const ShotSeries& series);
    void save(const ShotSeries& series);
    void runScript();
    void follow();
    void tellShot(const ShotCount& count);
    void tellIdleHit();

    Session& m_session;
    HitEffects& m_effects;
    Viewport& m_viewport;
    QWidget& m_window;
    AimPreview* m_aimPreview = nullptr;
    ScriptReader* m_scripts = nullptr;
    FlightChooser* m_flight = nullptr;
    QAction* m_stop = nullptr;
    std::optional<std::size_t> m_lastHit;  ///< row of a lone shot's hit, until it is known what that did
};

}  // namespace hitscope
