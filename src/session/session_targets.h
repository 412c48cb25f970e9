// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "core/bounds.h"
#include "core/result.h"
#include "session/session_undo.h"
#include "session/target.h"

namespace hitscope {

class Session;

/// The targets of a session, in their order: what stands in the scene, and which one is selected. Each change
/// is one step to undo; ids of no target are passed over.
class SessionTargets : public QObject {
    Q_OBJECT
public:
    explicit SessionTargets(Session& session);  ///< `session` owns it

    using List = std::vector<std::unique_ptr<Target>>;
    [[nodiscard]] std::span<const std::unique_ptr<Target>> all() const { return m_targets; }
    [[nodiscard]] List::const_iterator begin() const { return m_targets.begin(); }
    [[nodiscard]] List::const_iterator end() const { return m_targets.end(); }
    [[nodiscard]] std::size_t size() const { return m_targets.size(); }
    [[nodiscard]] bool empty() const { return m_targets.empty(); }
    [[nodiscard]] const std::unique_ptr<Target>& operator[](std::size_t index) const {
        return m_targets[index];  // index < size()
    }
    [[nodiscard]] const std::unique_ptr<Target>& front() const { return m_targets.front(); }
    [[nodiscard]] const std::unique_ptr<Target>& back() const { return m_targets.back(); }
    [[nodiscard]] const Target* find(TargetId id) const;  ///< null: no such target
    /// That the next target will have; no target had it or a later one before.
    [[nodiscard]] TargetId nextId() const { return {m_next}; }

    /// World, original shapes; of the hidden ones only if there are no others.
    [[nodiscard]] Bounds bounds() const;
    [[nodiscard]] float floorHeight() const { return m_floorHeight; }  ///< metres, world y

    /// The one that panels are about; none where nothing is selected.
    [[nodiscard]] TargetId selected() const { return m_selected; }
    /// Whether it is that one, or selected beside it.
    [[nodiscard]] bool isSelected(TargetId id) const {
        return id && (id == m_selected || m_beside.count(id));
    }
    [[nodiscard]] std::vector<TargetId> allSelected() const;  ///< in the order of the targets
    /// `beside`: those that are selected with it.
    void select(TargetId id, std::span<const TargetId> beside = {});

    /// Adds them where they are clear of the others and of the floor (makeRoom()), under names of their own.
    /// The last one is selected.
    void add(std::vector<TargetPlan> plans);
    /// Adds one where its plan says, and moves a target onto it, in one step. `raised`: checked, and unit.
    void putUnder(TargetId above, const RigidTransform& raised, TargetPlan plan);
    /// Adds copies as they are now, hits included, beside the others.
    void duplicate(std::span<const TargetId> ids);
    void remove(std::span<const TargetId> ids);  ///< and their hits
    void reset(std::span<const TargetId> ids);   ///< to their original shape: removes their hits
    /// Spaces at the ends are dropped; an empty name is refused.
    [[nodiscard]] Status rename(TargetId id, const QString& name);
    void setVisible(std::span<const TargetId> ids, bool visible);
    /// Gives them `mesh`, which is theirs with the picture that was located.
    void setTexture(std::span<const TargetId> ids, const std::shared_ptr<const MeshData>& mesh,
                    const LocatedTexture& located);
    /// Gives targets other meshes: shape, collider and source of the state with the target's id, all else
    /// stays. As each is then another mesh it gets an id of its own, which is returned by the one before.
    /// Each hit on them, in their order, becomes `carried` of it, on the target of the new id; nothing: it
    /// goes.
    std::map<TargetId, TargetId> replaceMeshes(std::span<const TargetState> meshes,
                                               const std::function<std::optional<Hit>(const Hit&)>& carried,
                                               SessionUndo::Kind kind = SessionUndo::Kind::ReloadMesh);
    /// Puts parts of a target in its place, under names and ids of their own, which are returned; each of its
    /// hits, in their order, goes to those parts (by index). The first one is selected.
    std::vector<TargetId> replaceByParts(TargetId id, std::vector<TargetState> parts,
                                         std::span<const std::vector<std::uint32_t>> partsOfHit);
    /// Hits go along, since they are kept in the local frame. Rotations are made unit. Nothing is done, and
    /// an error returned, where a number is not finite or a rotation is none.
    [[nodiscard]] Status setTransforms(std::span<const TargetPlace> places,
                                       SessionUndo::Merge merge = SessionUndo::Merge::Never);
    [[nodiscard]] Status setTransform(TargetId id, const RigidTransform& transform,
                                      SessionUndo::Merge merge = SessionUndo::Merge::Never);
    /// Applies `change` to the physics of each. Those too large to be dynamic stay as they are; the error is
    /// the first one's.
    [[nodiscard]] Status setPhysics(std::span<const TargetId> ids,
                                    const std::function<void(TargetPhysics&)>& change);
    [[nodiscard]] Status setPhysics(TargetId id, const TargetPhysics& physics);

Q_SIGNALS:
    void added(hitscope::TargetId target);
    void removed(hitscope::TargetId target);          ///< its hits went before it
    void changed(hitscope::TargetId target);          ///< name, transform or visibility
    void renamed(hitscope::TargetId target);          ///< after changed(), which motion causes in every frame
    void textured(hitscope::TargetId target);         ///< likewise: its mesh has other pictures
    void scaled(hitscope::TargetId target);           ///< it was added in place of the one of another size
    void selectedChanged(hitscope::TargetId target);  ///< or which ones are selected beside it

private:
    friend class Session;
    friend class Simulation;

    void clear();
    /// `floorHeight`: nothing: under the lowest target.
    void replace(std::vector<TargetPlan> plans, std::optional<float> floorHeight);
    void restore(std::span<const TargetState> states, float floorHeight, TargetId selected);
    /// A change has been made, undone or made again.
    void follow(const TargetEdit& edit);
    /// The physics has moved it.
    void moveTo(TargetId id, const RigidTransform& transform);

    TargetState newTarget(TargetPlan plan);
    Target& insert(std::size_t index, const TargetState& state);
    void erase(std::size_t index);
    [[nodiscard]] std::optional<std::size_t> indexOf(TargetId id) const;
    [[nodiscard]] std::vector<std::size_t> indicesOf(std::span<const TargetId> ids) const;
    /// The names that are taken while targets are made.
    struct Names {
        std::set<QString> taken;
        std::map<QString, int> next;  ///< by stem: all numbers from 2 to below it are taken
    };
    [[nodiscard]] Names names() const;
    /// `wanted`, with a number where it is taken; from now on it is.
    static QString freeName(const QString& wanted, Names& names);
    void change(const SessionUndo::Change& change);
    void change(std::vector<TargetEdit> targets, SessionUndo::Name name, std::vector<HistoryEdit> edits = {},
                SessionUndo::Merge merge = SessionUndo::Merge::Never);
    void change(const Target& target, TargetState after, SessionUndo::Name name,
                SessionUndo::Merge merge = SessionUndo::Merge::Never);

    Session& m_session;
    List m_targets;
    std::uint32_t m_next = 1;  ///< id of the next one that is made
    float m_floorHeight = 0.0f;
    TargetId m_selected;
    std::set<TargetId> m_beside;  ///< never the selected one, and empty without it
};

}  // namespace hitscope
