// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/shot_actions.h"

#include <QAction>
#include <QComboBox>
#include <QFileDialog>
#include <QMenu>
#include <QSettings>
#include <QToolBar>
#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "analysis/changed_settings.h"
#include "analysis/hit_effects.h"
#include "app/actions/menu_building.h"
#include "app/dialogs/dialogs.h"
#include "app/dialogs/shot_series_dialog.h"
#include "app/flight_chooser.h"
#include "app/script_reader.h"
#include "app/shot_text.h"
#include "panels/fields/save_name.h"
#include "panels/help/help_text.h"
#include "session/shots/shot_script_file.h"
#include "viewport/aim_preview.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

const QString kPreviewKey = QStringLiteral("aimPreview");
constexpr float kFarthest = 1.0e7f;  // metres

/// Along the ray, metres; infinite when it misses the box.
float distanceTo(const Bounds& box, const Ray& ray) {
    constexpr float kNever = std::numeric_limits<float>::infinity();
    float enter = 0.0f;
    float leave = kNever;
    for (int axis = 0; axis < 3; ++axis) {
        const float a = (box.min[axis] - ray.origin[axis]) / ray.direction[axis];
        const float b = (box.max[axis] - ray.origin[axis]) / ray.direction[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave ? enter : kNever;
}

}  // namespace

ShotActions::ShotActions(Session& session, HitEffects& effects, Viewport& viewport, QWidget& window)
    : QObject(&window),
      m_session(session),
      m_effects(effects),
      m_viewport(viewport),
      m_window(window),
      m_aimPreview(new AimPreview(session, viewport)),
      m_scripts(new ScriptReader(session, this)),
      m_flight(new FlightChooser(session, this)) {
    m_aimPreview->setEnabled(QSettings().value(kPreviewKey, true).toBool());
    connect(&viewport, &Viewport::shot, this, &ShotActions::explainPass);
    connect(&session.simulation(), &Simulation::scheduleChanged, this, &ShotActions::follow);
    connect(&session, &Session::sceneReplaced, this, &ShotActions::follow);
    connect(m_flight, &FlightChooser::chosenInBox, this, &ShotActions::chosenInBox);
    connect(&session.simulation(), &Simulation::shotsWent, this, &ShotActions::tellShot);
    connect(&effects, &HitEffects::effectsChanged, this, &ShotActions::tellIdleHit);
    const auto forget = [this] { m_lastHit.reset(); };
    connect(&session.hits(), &SessionHits::rearranged, this, forget);
    connect(&session.hits(), &SessionHits::reset, this, forget);
}

void ShotActions::tellShot(const ShotCount& count) {
    const QString text = shotText(count, m_session);
    if (text.isEmpty()) {
        return;
    }
    Q_EMIT said(text);
    const std::size_t hits = m_session.hits().history().size();
    m_lastHit = count.shots == 1 && count.hits == 1 && hits > 0 ? std::optional(hits - 1) : std::nullopt;
    tellIdleHit();
}

/// A hit between the vertices of a coarse mesh changes nothing that could be seen.
void ShotActions::tellIdleHit() {
    const std::span<const Hit> hits = m_session.hits().history().hits();
    const std::optional<HitEffect> effect =
        m_lastHit && *m_lastHit < hits.size() ? m_effects.effect(*m_lastHit) : std::nullopt;
    if (!effect) {
        return;
    }
    const Hit& hit = hits[*std::exchange(m_lastHit, std::nullopt)];
    const Target* target = m_session.targets().find(hit.target);
    if (effect->affected > 0 || target == nullptr) {
        return;
    }
    Q_EMIT said(idleHitText(hit, *target));
}

void ShotActions::fill(QToolBar& bar) {
    bar.addWidget(m_flight->makeBox(&bar));
}

void ShotActions::fill(QMenu& menu) {
    addHeldKey(menu, tr("&Shoot at the Crosshair"), tr("Space"), this,
               [this] { m_viewport.shootAtCrosshair(); });
    m_flight->fill(menu);
    menu.addAction(tr("B&urst…"), tr("Ctrl+B"), this, [this] { showSeries(ShotSeries::Pattern::Burst); });
    menu.addAction(tr("Se&quence…"), this, [this] { showSeries(ShotSeries::Pattern::Line); });
    menu.addAction(tr("&Run Shot Script…"), this, &ShotActions::runScript);
    m_stop =
        menu.addAction(tr("&Cancel Pending Shots"), &m_session.simulation(), &Simulation::cancelScheduled);
    m_stop->setObjectName(QStringLiteral("stopShots"));
    menu.addSeparator();
    QAction* preview = menu.addAction(tr("Aim Pre&view"));
    preview->setObjectName(QStringLiteral("aimPreviewOn"));
    preview->setCheckable(true);
    preview->setChecked(m_aimPreview->isEnabled());
    preview->setToolTip(tr("While the cursor rests on a target, show the dent that a click would make"));
    connect(preview, &QAction::triggered, this, [this](bool on) {
        m_aimPreview->setEnabled(on);
        ChangedSettings()->setValue(kPreviewKey, on);
    });
    follow();
}

void ShotActions::showSeries(ShotSeries::Pattern pattern) {
    auto* dialog = m_window.findChild<ShotSeriesDialog*>();
    if (dialog == nullptr) {
        dialog = new ShotSeriesDialog(&m_window);
        connect(dialog, &ShotSeriesDialog::shotsWanted, this, &ShotActions::shoot);
        connect(dialog, &ShotSeriesDialog::saveWanted, this, &ShotActions::save);
        const auto followFlight = [this, dialog] {
            dialog->setShotsFly(m_session.settings().flightMode() != FlightMode::Instant);
        };
        connect(&m_session.settings(), &SessionSettings::flightModeChanged, dialog, followFlight);
        followFlight();
    }
    dialog->setPattern(pattern);
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

void ShotActions::shoot(const ShotSeries& series) {
    schedule(m_session, makeScript(series, m_viewport));
}

void ShotActions::save(const ShotSeries& series) {
    const QString path = askSaveName(&m_window, {.title = tr("Save Shot Script"),
                                                 .suggested = QStringLiteral("shots.json"),
                                                 .filters = {tr("Shot scripts (*.json)")},
                                                 .suffixes = {QStringLiteral("json")}});
    if (path.isEmpty()) {
        return;
    }
    const Status written = writeShotScript(makeScript(series, m_viewport), path);
    if (!written) {
        showError(&m_window, written.error());
    }
}

void ShotActions::runScript() {
    const QString path =
        QFileDialog::getOpenFileName(&m_window, tr("Run Shot Script"), {}, tr("Shot scripts (*.json)"));
    if (!path.isEmpty()) {
        run(path);
    }
}

void ShotActions::run(const QString& path, const std::function<void()>& otherwise) {
    m_scripts->read(path, [this, otherwise](const Result<ShotScript>& script) {
        if (script) {
            schedule(m_session, script.value());
        } else if (otherwise) {
            otherwise();
        } else {
            showError(&m_window, script.error());
        }
    });
}

void ShotActions::explainPass(const Ray& ray) {
    const auto met = m_session.simulation().physics().castRay(ray.origin, ray.direction, kFarthest);
    const float first = met ? glm::distance(ray.origin, met->point) : kFarthest;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        const QString reason = m_session.simulation().whyNotHittable(target->id);
        if (target->visible && !reason.isEmpty() && distanceTo(target->worldBounds(), ray) < first) {
            Q_EMIT noticeWanted(tr("%1 cannot be hit. %2").arg(target->name, reason));
            return;
        }
    }
}

void ShotActions::follow() {
    if (m_stop != nullptr) {
        enableIf(*m_stop, m_session.simulation().shotsToCome() > 0, tr("No shots are to come."));
    }
}

}  // namespace hitscope
