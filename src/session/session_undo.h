// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/image.h"
#include "deform/hit_history.h"
#include "physics/projectile_settings.h"
#include "session/constants_setting.h"
#include "session/flight_mode.h"
#include "session/target_state.h"
#include "session/undo_part.h"
#include "view/cutting_plane.h"
#include "view/lights.h"

namespace hitscope {

/// What a person sets in a session, apart from its scene.
struct SettingsState {
    ConstantsSetting constants = {};
    Lights lights = {};
    ProjectileSettings projectile = {};
    FlightMode flightMode = FlightMode::Quick;
    std::shared_ptr<const Image> coverTexture = {};
    CuttingPlane cut = {};

    bool operator==(const SettingsState&) const = default;
};

/// A whole scene with its hits: enough to come back to it.
struct SceneState {
    QString name;
    float floorHeight = 0.0f;  ///< metres, world y
    LightSpace lightSpace;
    Lights lights;  ///< as they stand there
    std::vector<TargetState> targets;
    TargetId selected;
    std::vector<Hit> hits;
    std::optional<CuttingPlane> cut;  ///< nothing: it stays as it is
};

/// Which targets are selected: the one that panels are about, and others beside it.
struct TargetSelection {
    TargetId target;  ///< none: no target is selected
    std::vector<TargetId> beside;
};

/// It was one and became the other.
template <typename Value>
struct ValueEdit {
    Value before;
    Value after;
};

/// The steps a person can go back and forward through: changes of the hit history, of the targets, of the
/// settings, and other scenes. A step costs what changed, not what there is, and one that only made hits does
/// not keep them a second time; the oldest are forgotten when all together take more than kMostBytes.
class SessionUndo {
public:
    static constexpr std::size_t kMostBytes = std::size_t{512} << 20U;
    explicit SessionUndo(std::size_t mostBytes = kMostBytes) : m_most(mostBytes) {}

    [[nodiscard]] bool canUndo() const { return !m_undo.empty(); }
    [[nodiscard]] bool canRedo() const { return !m_redo.empty(); }

    enum class Merge : std::uint8_t {
        Never,        ///< a step of its own
        WithSameKind  ///< with the last step, if that is of the same kind and about the same targets, and
                      ///< was neither undone nor finished in between
    };
    enum class Kind : std::uint8_t {
        Hit,
        Remove,
        Clear,
        Move,
        Enable,
        Disable,
        EditHit,
        HitConstants,  ///< of hits already made
        Mirror,
        Scatter,
        Stroke,  ///< of the brush
        Group,
        Ungroup,
        Constants,  ///< of the hits to come
        Lights,
        AddTarget,
        DuplicateTarget,
        PutOnTurntable,
        RemoveTarget,
        MoveTarget,
        RotateTarget,
        RenameTarget,
        ShowTarget,
        HideTarget,
        ResetTarget,
        TargetPhysics,
        TargetTexture,
        ReloadMesh,  ///< from a file that has changed
        RefineMesh,
        SimplifyMesh,
        SmoothMesh,
        ApplyHits,  ///< to the mesh, as its new original
        ScaleTarget,
        SeparateObjects,  ///< of a mesh, as targets of their own
        Projectile,
        FlightMode,
        CoverTexture,
        CuttingPlane,
        LoadScene,
        PlaceMesh
    };
    /// What a step is called where it is offered to be undone.
    struct Name {
        Kind kind = Kind::Hit;
        std::size_t count = 1;  ///< hits or targets that it is about
        std::size_t hit = 0;    ///< where it was about one hit: its number at that time, from 1; otherwise 0
        UndoPart part = UndoPart::None;  ///< record() finds it

        bool operator==(const Name&) const = default;
    };
    /// What one action of a person changed.
    struct Change {
        Name name = {};
        Merge merge = Merge::Never;
        std::vector<HistoryEdit> edits = {};                               ///< in the order made
        std::vector<TargetEdit> targets = {};                              ///< likewise
        std::shared_ptr<const ValueEdit<SettingsState>> settings = {};     ///< null: they stay
        std::shared_ptr<const ValueEdit<SceneState>> scene = {};           ///< null: it stays
        std::shared_ptr<const ValueEdit<TargetSelection>> selection = {};  ///< null: what came is selected
        /// Where dynamic targets are to be; recorded, where they were before hits knocked them about.
        std::vector<TargetPlace> places = {};
    };
    /// Where nothing changed nothing is recorded; steps that merge and come to nothing go, and what could be
    /// made again before them can be again.
    void record(Change change);
    /// Of the state that the steps have led to: two of the same number are equal. Never 0.
    [[nodiscard]] std::uint64_t state() const { return m_undo.empty() ? m_first : m_undo.back().number; }
    /// Of the scene that the steps have led to: state() as it was when another scene took its place; two of
    /// the same number are equal. Never 0.
    [[nodiscard]] std::uint64_t scene() const { return m_scenes.empty() ? m_firstScene : m_scenes.back(); }
    /// All steps in the order made: those that can be undone, then those that can be made again.
    [[nodiscard]] std::size_t size() const { return m_undo.size() + m_redo.size(); }
    [[nodiscard]] std::size_t done() const { return m_undo.size(); }  ///< how many can be undone
    [[nodiscard]] const Name& name(std::size_t step) const;           ///< step < size()
    /// state() as it is, or will be, after that step; step < size().
    [[nodiscard]] std::uint64_t stateAfter(std::size_t step) const;
    /// As the target was called that the step is about; empty: it is about none, or several. step < size().
    [[nodiscard]] QString target(std::size_t step) const;
    /// What all steps together take at most, about, and how many were forgotten to keep within kMostBytes.
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }
    [[nodiscard]] std::size_t forgotten() const { return m_forgotten; }
    /// Nothing merges with the last step any more.
    void finishStep();
    /// Of what undo() or redo() would take back or make again; nothing: there is nothing.
    [[nodiscard]] std::optional<Name> toUndo() const;
    [[nodiscard]] std::optional<Name> toRedo() const;

    using Places = std::function<std::vector<TargetPlace>()>;
    /// What to do to take the last change back. canUndo(). `hits`: the history as it is now. `places`: where
    /// the dynamic targets are now; asked for only where the step has places.
    [[nodiscard]] Change undo(std::span<const Hit> hits, const Places& places = {});
    /// What to do to make the last change taken back again. canRedo(). It brings targets back to where they
    /// were when it was taken back.
    [[nodiscard]] Change redo(const Places& places = {});
    void clear();

private:
    struct Step {
        Name name;
        std::unique_ptr<Change> change;  ///< null: it made name.count hits, the first of them is `first`
        std::size_t first = 0;
        std::uint64_t number = 0;
        bool finished = false;  ///< nothing merges with it any more

        [[nodiscard]] std::size_t bytes() const;  ///< undone
    };
    static Step step(Change change, std::uint64_t number);
    [[nodiscard]] static std::size_t bytesOfAll(std::span<const Step> steps);
    [[nodiscard]] const Step& stepAt(std::size_t step) const;
    bool absorbHits(const Change& change);
    bool absorb(Change& change);
    void forgetOldest();

    std::size_t m_most;
    std::deque<Step> m_undo;
    std::vector<Step> m_redo;
    std::vector<Step> m_aside;  ///< could be made again until the last step, which may come to nothing
    std::vector<std::uint64_t> m_scenes;  ///< numbers of the steps done that loaded one, ascending
    std::uint64_t m_last = 1;             ///< number given
    std::uint64_t m_first = 1;            ///< of the state before the first step
    std::uint64_t m_firstScene = 1;       ///< before the first of m_scenes
    std::size_t m_bytes = 0;
    std::size_t m_forgotten = 0;
};

/// Makes one step of what a person does in one go: the first change of a part begins a step, further ones of
/// the same part merge with it until the gesture ends.
class UndoGesture {
public:
    /// Of a change of this part (>= 0): one slider, one box.
    [[nodiscard]] SessionUndo::Merge change(int part) {
        const bool goesOn = part == m_part;
        m_part = part;
        return goesOn ? SessionUndo::Merge::WithSameKind : SessionUndo::Merge::Never;
    }
    void end() { m_part = -1; }

private:
    int m_part = -1;
};

}  // namespace hitscope
