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

    [[nodiscard]] const DeformationConstants& constants() const { return m_now.constants.constants; }
    [[nodiscard]] const ConstantsSetting& constantsSetting() const { return m_now.constants; }
    /// Those that a hit on this target is made with now.
    [[nodiscard]] DeformationConstants constantsOn(const Target& target) const;
    /// Constants of the hits to come; those made keep theirs. One step to undo. Refused when out of range.
    [[nodiscard]] Status setConstants(const DeformationConstants& constants,
                                      SessionUndo::Merge merge = SessionUndo::Merge::Never) {
        return setConstants(ConstantsSetting{constants, m_now.constants.relative, m_now.constants.form},
                            merge);
    }
    [[nodiscard]] Status setConstants(const ConstantsSetting& setting,
                                      SessionUndo::Merge merge = SessionUndo::Merge::Never);
    /// Of the dents of the hits to come; likewise.
    [[nodiscard]] Status setForm(const DentForm& form, SessionUndo::Merge merge = SessionUndo::Merge::Never) {
        return setConstants(ConstantsSetting{m_now.constants.constants, m_now.constants.relative, form},
                            merge);
    }
    /// Likewise, and nothing to undo: as they were when the program ended.
    [[nodiscard]] Status restoreConstants(const ConstantsSetting& setting);

    [[nodiscard]] const Lights& lights() const { return m_now.lights; }
    /// One step to undo.
    void setLights(const Lights& lights, SessionUndo::Merge merge = SessionUndo::Merge::Never);
    void restoreLights(const Lights& lights);  ///< and nothing to undo
    /// What the lights stand around: the scene as it was opened.
    [[nodiscard]] const LightSpace& lightSpace() const { return m_lightSpace; }

    /// A picture on all targets that have texture coordinates, instead of their own materials; null: none.
    [[nodiscard]] const std::shared_ptr<const Image>& coverTexture() const { return m_now.coverTexture; }
    void setCoverTexture(std::shared_ptr<const Image> texture);      ///< one step to undo
    void restoreCoverTexture(std::shared_ptr<const Image> texture);  ///< and nothing to undo

    /// What opens the targets; who shows them goes by it.
    [[nodiscard]] const CuttingPlane& cut() const { return m_now.cut; }
    /// One step to undo.
    void setCut(const CuttingPlane& cut, SessionUndo::Merge merge = SessionUndo::Merge::Never);
    void restoreCut(const CuttingPlane& cut);  ///< and nothing to undo

    [[nodiscard]] const ProjectileSettings& projectile() const { return m_now.projectile; }
    /// Clamped to projectileParameters(). Changes of one after the other are one step to undo.
    void setProjectile(const ProjectileSettings& settings);
    /// How shots by hand fly; what is shot by Simulation::shoot() and hitscan() goes by projectile() alone.
    [[nodiscard]] FlightMode flightMode() const { return m_now.flightMode; }
    void setFlightMode(FlightMode mode);                                          ///< one step to undo
    void restoreProjectile(const ProjectileSettings& settings, FlightMode mode);  ///< and nothing to undo

    [[nodiscard]] PipelineKind pipeline() const { return m_pipeline; }
    void setPipeline(PipelineKind kind);

Q_SIGNALS:
    void constantsChanged();
    void lightsChanged();
    void projectileChanged();
    void flightModeChanged();
    void coverTextureChanged();
    void cutChanged();
    void pipelineChanged();

private:
    friend class Session;

    /// Announces what is another.
    void take(const SettingsState& state);
    void change(const SettingsState& after, SessionUndo::Kind kind,
                SessionUndo::Merge merge = SessionUndo::Merge::Never);
    /// The lights stand around the new scene as they stood around the one before; announces nothing.
    void standAround(const LightSpace& space);
    void stand(const Lights& lights, const LightSpace& space);  ///< likewise

    Session& m_session;
    LightSpace m_lightSpace;
    SettingsState m_now{.lights = defaultLights(m_lightSpace)};
    PipelineKind m_pipeline = PipelineKind::TransformFeedback;
};

}  // namespace hitscope
