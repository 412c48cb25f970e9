// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "deform/hit.h"
#include "deform/pipeline_kind.h"
#include "physics/collider.h"
#include "physics/projectile_settings.h"
#include "session/constants_setting.h"
#include "session/flight_mode.h"
#include "session/mesh_steps/mesh_step.h"
#include "session/target_source.h"
#include "session/vertex_selection.h"
#include "view/display_options.h"
#include "view/lights.h"

namespace hitscope {

/// What a target's mesh is made from again.
struct SavedSource {
    TargetSource mesh;
    QString relativePath;  ///< of a file: from the session file's folder, with '/'; empty: not known

    bool operator==(const SavedSource&) const = default;
};

/// A target apart from its hits: where its mesh comes from, and what was done to it.
struct SavedTarget {
    TargetId id;  ///< by which hits name it; 1 to kMostId, and no other target's
    QString name;
    SavedSource source;
    Placement placement;          ///< of the file's coordinates; scale > 0
    std::vector<MeshStep> steps;  ///< done to that mesh, in their order
    std::vector<LocatedTexture> textures;
    RigidTransform transform;
    bool visible = true;
    TargetPhysics physics;
};

/// The scene as a whole.
struct SceneSettings {
    QString name;              ///< for the window's title
    float floorHeight = 0.0f;  ///< metres, world y
    LightSpace lightSpace;     ///< what the lights stand around

    static constexpr int kLargestCover = 16384;
    int coverTexture = 0;  ///< pixels each way of the panels that cover all targets; 0: their own materials
};

/// How time goes and what applies the hits.
struct SimulationSettings {
    PipelineKind pipeline = PipelineKind::TransformFeedback;
    FlightMode flight = FlightMode::Quick;
    double physicsStep = 1.0 / 240.0;  ///< seconds; within stepParameter()
    double timeScale = 1.0;            ///< within timeScaleParameter()
    bool paused = false;
    double time = 0.0;  ///< seconds simulated

    static constexpr double kLongest = 1.0e12;  ///< seconds
    bool operator==(const SimulationSettings&) const = default;
};

/// Cameras as parseCamera() reads them; an empty text is none.
struct SavedCameras {
    std::string current;
    std::vector<std::string> kept;  ///< by the number of the bookmark

    bool operator==(const SavedCameras&) const = default;
};

/// What a person has selected, which panels go by.
struct SavedSelection {
    struct Vertices {
        TargetId target;
        std::vector<std::uint32_t> vertices;  ///< ascending
        bool operator==(const Vertices&) const = default;
    };

    TargetId target;                   ///< 0: none
    std::optional<std::size_t> hit;    ///< index into the hits
    std::optional<std::size_t> shown;  ///< as after so many hits; nothing: after all
    std::optional<VertexRef> picked;
    std::vector<Vertices> vertices;

    bool operator==(const SavedSelection&) const = default;
};

/// What a target's positions were: positionsFingerprint() of it alone.
struct SavedPositions {
    TargetId target;
    std::uint64_t fingerprint = 0;

    bool operator==(const SavedPositions&) const = default;
};

/// All that a session file holds; plain data, which nothing follows.
struct SessionDocument {
    SceneSettings scene;
    std::vector<SavedTarget> targets;
    ConstantsSetting constants;  ///< of the hits to come
    ProjectileSettings projectile;
    SimulationSettings simulation;
    Lights lights;
    SavedCameras cameras;
    DisplayOptions display;  ///< but for theme, transparent, refine, reduceInMotion: these are the window's
    SavedSelection selection;
    std::vector<SavedPositions>
        positions;          ///< as the pipeline made them; those that are not there: not known
    std::vector<Hit> hits;  ///< in order; each has passed checkedHit()
    /// Of what was read: where it has values that this version does not know ("line 3, hit 1, powr"). They
    /// are lost when it is saved.
    std::vector<std::string> notKnown;

    // What a document may hold at most.
    static constexpr std::uint32_t kMostId = 0x7fffffffu;  ///< of a target
    static constexpr std::size_t kMostTargets = 100'000;
    static constexpr std::size_t kMostHits = 10'000'000;
    static constexpr std::size_t kMostTextures = 10'000;    ///< of a target
    static constexpr std::size_t kMostCameras = 1'000;      ///< kept
    static constexpr std::size_t kMostText = 10'000;        ///< bytes of a name or a path
    static constexpr std::size_t kMostBytes = 0xfffff000u;  ///< of the file
};

}  // namespace hitscope
