// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "core/image.h"
#include "core/result.h"
#include "deform/pipeline_kind.h"
#include "physics/projectile_settings.h"
#include "session/constants_setting.h"
#include "session/flight_mode.h"
#include "session/session_undo.h"
#include "session/target.h"
#include "view/lights.h"

namespace hitscope {

class Session;

/// What a person sets in a session: the constants and projectiles of the hits to come, the lights, a picture
/// on all targets, the pipeline.
class SessionSettings : public QObject {
    Q_OBJECT
public:
    explicit SessionSettings(Session& session);  ///< `session` owns it

    [[nodiscard]] const DeformationConstants& constants() const { return m_constants.constants; }
    [[nodiscard]] const ConstantsSetting& constantsSetting() const { return m_constants; }
    /// Those that a hit on this target is made with now.
    [[nodiscard]] DeformationConstants constantsOn(const Target& target) const;
    /// Constants of the hits to come; those made keep theirs. One step to undo. Refused when out of range.
    [[nodiscard]] Status setConstants(const DeformationConstants& constants,
                                      SessionUndo::Merge merge = SessionUndo::Merge::Never) {
        return setConstants(ConstantsSetting{constants, m_constants.relative}, merge);
    }
    [[nodiscard]] Status setConstants(const ConstantsSetting& setting,
                                      SessionUndo::Merge merge = SessionUndo::Merge::Never);
    /// Likewise, and nothing to undo: as they were when the program ended.
    [[nodiscard]] Status restoreConstants(const ConstantsSetting& setting);

    [[nodiscard]] const Lights& lights() const { return m_lights; }
    /// One step to undo.
    void setLights(const Lights& lights, SessionUndo::Merge merge = SessionUndo::Merge::Never);
    void restoreLights(const Lights& lights);  ///< and nothing to undo
    /// What the lights stand around: the scene as it was opened.
    [[nodiscard]] const LightSpace& lightSpace() const { return m_lightSpace; }

    /// A picture on all targets that have texture coordinates, instead of their own materials; null: none.
    [[nodiscard]] const std::shared_ptr<const Image>& coverTexture() const { return m_coverTexture; }
    void setCoverTexture(std::shared_ptr<const Image> texture);

    [[nodiscard]] const ProjectileSettings& projectile() const { return m_projectile; }
    void setProjectile(const ProjectileSettings& settings);  ///< clamped to projectileParameters()
    /// How shots by hand fly; what is shot by Simulation::shoot() and hitscan() goes by projectile() alone.
    [[nodiscard]] FlightMode flightMode() const { return m_flightMode; }
    void setFlightMode(FlightMode mode);

    [[nodiscard]] PipelineKind pipeline() const { return m_pipeline; }
    void setPipeline(PipelineKind kind);

Q_SIGNALS:
    void constantsChanged();
    void lightsChanged();
    void projectileChanged();
    void flightModeChanged();
    void pipelineChanged();

private:
    friend class Session;

    void makeAgain(const SessionUndo::Change& change);
    /// The lights stand around the new scene as they stood around the one before; announces nothing.
    void standAround(const Bounds& bounds);
    void takeConstants(const ConstantsSetting& constants);

    Session& m_session;
    ConstantsSetting m_constants;
    LightSpace m_lightSpace;
    Lights m_lights = defaultLights(m_lightSpace);
    std::shared_ptr<const Image> m_coverTexture;
    ProjectileSettings m_projectile;
    FlightMode m_flightMode = FlightMode::Quick;
    PipelineKind m_pipeline = PipelineKind::TransformFeedback;
};

}  // namespace hitscope
