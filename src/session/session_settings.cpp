// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_settings.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "session/session.h"

namespace hitscope {

namespace {

Status checked(const ConstantsSetting& setting) {
    if (!isValid(setting.constants)) {
        return Error{"A deformation constant is out of its range.", "",
                     "Keep to the ranges the panel shows."};
    }
    DentForm form = setting.form;
    form.radius = form.presses() ? kUsualExtent : 0.0f;  // it will be known of each shot
    if (const std::string_view fault = faultOf(form); !fault.empty()) {
        return Error{std::string(fault), "", "Choose another fall-off."};
    }
    return Done{};
}

}  // namespace

SessionSettings::SessionSettings(Session& session) : m_session(session) {}

void SessionSettings::change(const SettingsState& after, SessionUndo::Kind kind, SessionUndo::Merge merge) {
    const auto edit =
        std::make_shared<const ValueEdit<SettingsState>>(ValueEdit<SettingsState>{m_now, after});
    take(after);
    m_session.record({.name = {kind, 1}, .merge = merge, .settings = edit});
}

void SessionSettings::take(const SettingsState& state) {
    const SettingsState before = std::exchange(m_now, state);
    if (before.constants != m_now.constants) {
        Q_EMIT constantsChanged();
    }
    if (before.projectile != m_now.projectile) {
        Q_EMIT projectileChanged();
    }
    if (before.flightMode != m_now.flightMode) {
        Q_EMIT flightModeChanged();
    }
    if (before.coverTexture != m_now.coverTexture) {
        Q_EMIT coverTextureChanged();
    }
    if (before.cut != m_now.cut) {
        Q_EMIT cutChanged();
    }
    if (!(before.lights == m_now.lights)) {
        Q_EMIT lightsChanged();
    }
    if (!(before.lights == m_now.lights) || before.coverTexture != m_now.coverTexture) {
        Q_EMIT m_session.pictureChanged();
    }
}

// Constants

Status SessionSettings::setConstants(const ConstantsSetting& setting, SessionUndo::Merge merge) {
    if (Status status = checked(setting); !status) {
        return status;
    }
    SettingsState after = m_now;
    after.constants = setting;
    change(after, SessionUndo::Kind::Constants, merge);
    return Done{};
}

Status SessionSettings::restoreConstants(const ConstantsSetting& setting) {
    if (Status status = checked(setting); !status) {
        return status;
    }
    SettingsState after = m_now;
    after.constants = setting;
    take(after);
    return Done{};
}

DeformationConstants SessionSettings::constantsOn(const Target& target) const {
    return hitscope::constantsOn(target.extent(), m_now.constants);
}

// Lights

void SessionSettings::setLights(const Lights& lights, SessionUndo::Merge merge) {
    SettingsState after = m_now;
    after.lights = lights;
    change(after, SessionUndo::Kind::Lights, merge);
}

void SessionSettings::restoreLights(const Lights& lights) {
    SettingsState after = m_now;
    after.lights = lights;
    take(after);
}

void SessionSettings::standAround(const LightSpace& space) {
    m_now.lights = moved(m_now.lights, m_lightSpace, space);
    m_lightSpace = space;
}

void SessionSettings::stand(const Lights& lights, const LightSpace& space) {
    m_now.lights = lights;
    m_lightSpace = space;
}

// Others

void SessionSettings::setCoverTexture(std::shared_ptr<const Image> texture) {
    SettingsState after = m_now;
    after.coverTexture = std::move(texture);
    change(after, SessionUndo::Kind::CoverTexture);
}

void SessionSettings::restoreCoverTexture(std::shared_ptr<const Image> texture) {
    SettingsState after = m_now;
    after.coverTexture = std::move(texture);
    take(after);
}

void SessionSettings::setCut(const CuttingPlane& cut, SessionUndo::Merge merge) {
    SettingsState after = m_now;
    after.cut = cut;
    change(after, SessionUndo::Kind::CuttingPlane, merge);
}

void SessionSettings::restoreCut(const CuttingPlane& cut) {
    SettingsState after = m_now;
    after.cut = cut;
    take(after);
}

void SessionSettings::setProjectile(const ProjectileSettings& settings) {
    SettingsState after = m_now;
    after.projectile = clamped(settings);
    change(after, SessionUndo::Kind::Projectile, SessionUndo::Merge::WithSameKind);
}

void SessionSettings::setFlightMode(FlightMode mode) {
    SettingsState after = m_now;
    after.flightMode = mode;
    change(after, SessionUndo::Kind::FlightMode);
}

void SessionSettings::restoreProjectile(const ProjectileSettings& settings, FlightMode mode) {
    SettingsState after = m_now;
    after.projectile = clamped(settings);
    after.flightMode = mode;
    take(after);
}

void SessionSettings::setPipeline(PipelineKind kind) {
    if (kind != m_pipeline) {
        m_pipeline = kind;
        m_session.m_readBack->expectMoves();
        Q_EMIT pipelineChanged();
        Q_EMIT m_session.pictureChanged();
    }
}

}  // namespace hitscope
