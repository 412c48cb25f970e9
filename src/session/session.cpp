// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "session/frame_costs.h"
#include "session/task_list.h"
#include "session/vertex_selection.h"

namespace hitscope {

Session::Session(QObject* parent)
    : QObject(parent),
      m_readBack(std::make_unique<ReadBack>(m_targets)),
      m_frameCosts(std::make_unique<FrameCosts>(*this)),
      m_selection(std::make_unique<VertexSelection>(*this)),
      m_tasks(std::make_unique<TaskList>()) {}

Session::~Session() = default;

// Settings

Status Session::setConstants(const ConstantsSetting& setting, SessionUndo::Merge merge) {
    const ConstantsSetting before = m_constants;
    if (Status taken = restoreConstants(setting); !taken) {
        return taken;
    }
    recordUndo({{}, before, setting, merge, {SessionUndo::Kind::Constants, 1}});
    return Done{};
}

Status Session::restoreConstants(const ConstantsSetting& setting) {
    if (!isValid(setting.constants)) {
        return Error{"A deformation constant is out of its range.", "",
                     "Keep to the ranges the panel shows."};
    }
    takeConstants(setting);
    return Done{};
}

DeformationConstants Session::constantsOn(const Target& target) const {
    return hitscope::constantsOn(target.extent(), m_constants);
}

DeformationConstants Session::constantsOf(const Hit& hit) const {
    const Target* on = target(hit.target);
    DeformationConstants constants = on != nullptr ? constantsOn(*on) : m_constants.constants;
    if (m_projectileSettings.powerFollowsImpulse) {
        ConstantsSetting most = m_constants;
        most.constants.power = static_cast<float>(deformationParameters()[1].maximum);
        const float cap =
            on != nullptr ? hitscope::constantsOn(on->extent(), most).power : most.constants.power;
        const float power = constants.power * (hit.impulse / m_projectileSettings.referenceImpulse);
        constants.power = std::clamp(power, 0.0f, cap);
    }
    return constants;
}

void Session::takeConstants(const ConstantsSetting& constants) {
    if (constants != m_constants) {
        m_constants = constants;
        Q_EMIT constantsChanged();
    }
}

void Session::setLights(const Lights& lights, SessionUndo::Merge merge) {
    const LightsEdit edit{m_lights, lights};
    restoreLights(lights);
    recordUndo({{}, m_constants, m_constants, merge, {SessionUndo::Kind::Lights, 1}, {}, {edit}});
}

void Session::restoreLights(const Lights& lights) {
    m_lights = lights;
    Q_EMIT lightsChanged();
    Q_EMIT pictureChanged();
}

void Session::setCoverTexture(std::shared_ptr<const Image> texture) {
    if (texture != m_coverTexture) {
        m_coverTexture = std::move(texture);
        Q_EMIT pictureChanged();
    }
}

void Session::setProjectileSettings(const ProjectileSettings& settings) {
    m_projectileSettings = clamped(settings);
    Q_EMIT projectileSettingsChanged();
}

void Session::setFlightMode(FlightMode mode) {
    if (mode != m_flightMode) {
        m_flightMode = mode;
        Q_EMIT flightModeChanged();
    }
}

void Session::setPipeline(PipelineKind kind) {
    if (kind != m_pipeline) {
        m_pipeline = kind;
        m_readBack->expectMoves();
        Q_EMIT pipelineChanged();
        Q_EMIT pictureChanged();
    }
}

}  // namespace hitscope
