// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_settings.h"

#include <algorithm>
#include <utility>

#include "session/session.h"

namespace hitscope {

SessionSettings::SessionSettings(Session& session) : m_session(session) {}

// Constants

Status SessionSettings::setConstants(const ConstantsSetting& setting, SessionUndo::Merge merge) {
    const ConstantsSetting before = m_constants;
    if (Status taken = restoreConstants(setting); !taken) {
        return taken;
    }
    SessionUndo::Change change{{SessionUndo::Kind::Constants, 1}, merge};
    change.constants = {before, setting};
    m_session.record(std::move(change));
    return Done{};
}

Status SessionSettings::restoreConstants(const ConstantsSetting& setting) {
    if (!isValid(setting.constants)) {
        return Error{"A deformation constant is out of its range.", "",
                     "Keep to the ranges the panel shows."};
    }
    takeConstants(setting);
    return Done{};
}

DeformationConstants SessionSettings::constantsOn(const Target& target) const {
    return hitscope::constantsOn(target.extent(), m_constants);
}

void SessionSettings::takeConstants(const ConstantsSetting& constants) {
    if (constants != m_constants) {
        m_constants = constants;
        Q_EMIT constantsChanged();
    }
}

// Lights

void SessionSettings::setLights(const Lights& lights, SessionUndo::Merge merge) {
    SessionUndo::Change change{{SessionUndo::Kind::Lights, 1}, merge};
    change.lights = {m_lights, lights};
    restoreLights(lights);
    m_session.record(std::move(change));
}

void SessionSettings::restoreLights(const Lights& lights) {
    m_lights = lights;
    Q_EMIT lightsChanged();
    Q_EMIT m_session.pictureChanged();
}

void SessionSettings::standAround(const Bounds& bounds) {
    const glm::vec3 size = bounds.size();
    const LightSpace space{bounds.centre(), std::max({size.x, size.y, size.z})};
    m_lights = moved(m_lights, m_lightSpace, space);
    m_lightSpace = space;
}

void SessionSettings::makeAgain(const SessionUndo::Change& change) {
    if (change.constants) {
        takeConstants(change.constants->after);
    }
    if (change.lights) {
        restoreLights(change.lights->after);
    }
}

// Others

void SessionSettings::setCoverTexture(std::shared_ptr<const Image> texture) {
    if (texture != m_coverTexture) {
        m_coverTexture = std::move(texture);
        Q_EMIT m_session.pictureChanged();
    }
}

void SessionSettings::setProjectile(const ProjectileSettings& settings) {
    m_projectile = clamped(settings);
    Q_EMIT projectileChanged();
}

void SessionSettings::setFlightMode(FlightMode mode) {
    if (mode != m_flightMode) {
        m_flightMode = mode;
        Q_EMIT flightModeChanged();
    }
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
