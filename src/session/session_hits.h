// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/result.h"
#include "deform/applied_history.h"
#include "deform/hit_history.h"
#include "session/hit_rows.h"
#include "session/session_undo.h"

namespace hitscope {

class Session;

/// The hits of a session: their history and its changes, which of them are shown, which one is selected. Each
/// change is one step to undo, however many hits it is about; indices out of range are passed over.
class SessionHits : public QObject {
    Q_OBJECT
public:
    explicit SessionHits(Session& session);  ///< `session` owns it

    [[nodiscard]] const HitHistory& history() const { return m_history; }
    [[nodiscard]] std::size_t disabled() const { return m_disabled; }  ///< how many are

    /// Appends a hit made elsewhere (a file, a script); refused as checkedHit() says, or if there is no such
    /// target.
    [[nodiscard]] Status add(const Hit& hit) { return add(std::span<const Hit>(&hit, 1)); }
    [[nodiscard]] Status add(std::span<const Hit> hits);  ///< likewise, all or none
    /// Likewise as a group of this kind (not None), whatever groups they were of. Returns the group; without
    /// hits nothing happens.
    [[nodiscard]] Result<HitGroup> addGroup(HitGroupKind kind, std::span<const Hit> hits);
    /// One more hit of a stroke that goes on: one step to undo with those before, until
    /// Session::finishUndoStep(). `stroke` is newGroup()'s.
    [[nodiscard]] Status extendStroke(const HitGroup& stroke, const Hit& hit);
    /// The next one that no hit in the history is of. Each kind has numbers of its own, and they depend on
    /// nothing but the history: undo and saved sessions make no difference.
    [[nodiscard]] HitGroup newGroup(HitGroupKind kind) const;
    /// The hits of a group, ascending.
    [[nodiscard]] std::vector<std::size_t> of(const HitGroup& group) const;
    void group(std::span<const std::size_t> indices);    ///< they become a new one
    void ungroup(std::span<const std::size_t> indices);  ///< they are of none
    void setEnabled(std::span<const std::size_t> indices, bool enabled);
    void enableAll();
    /// The hits come to stand together, in their order, before the hit that is now at `to` (<= size()).
    void move(std::span<const std::size_t> indices, std::size_t to);
    /// Each goes past the hit before it that is not among them; those at the top stay.
    void moveUp(std::span<const std::size_t> indices);
    void moveDown(std::span<const std::size_t> indices);  ///< likewise, the hit after it
    void remove(std::span<const std::size_t> indices);
    void remove(std::size_t index) { remove(std::span<const std::size_t>(&index, 1)); }
    void clear();
    /// The hit at `index` becomes `hit`. Refused as add() does.
    [[nodiscard]] Status replace(std::size_t index, const Hit& hit) {
        return replace({&index, 1}, {&hit, 1}, SessionUndo::Kind::EditHit);
    }
    /// Likewise, all or none: the hit at indices[i] becomes hits[i]. `indices` ascend. `kind` names the step.
    [[nodiscard]] Status replace(std::span<const std::size_t> indices, std::span<const Hit> hits,
                                 SessionUndo::Kind kind,
                                 SessionUndo::Merge merge = SessionUndo::Merge::Never);
    /// The hits get the constants and the form that a hit like each of them is made with now (usual_dent.h).
    void giveConstants(std::span<const std::size_t> indices);
    void giveConstantsToAll();

    /// Shows the targets as they were after the first `count` hits; nothing: after all. The history stays as
    /// it is, and hits that come end it.
    void show(std::optional<std::size_t> count);
    [[nodiscard]] std::span<const Hit> shown() const;  ///< the first ones of the history, or all
    [[nodiscard]] bool showsAll() const { return !m_shown; }
    /// Which hits made what is shown, for all that says something about it: the first ones (show()), less
    /// those that the pipeline dropped. Valid until either changes.
    [[nodiscard]] AppliedHits applied() const;
    /// That it is one of them, and enabled; false for one that is not in the history.
    [[nodiscard]] bool isApplied(std::size_t index) const;

    [[nodiscard]] std::optional<std::size_t> selected() const { return m_selected; }
    void select(std::optional<std::size_t> index);

Q_SIGNALS:
    void aboutToBeAppended(int first, int last);
    void appended();
    /// Hits [first, last] are where they were; they were enabled, disabled or edited.
    void changed(int first, int last);
    void rearranged(const hitscope::HitRows& rows);  ///< removed, put back, moved
    void reset();                                    ///< after either of these, and with a new scene
    void selectedChanged();
    /// show(), not the history; with it, or with ReadBack::capacityChanged(), applied() are others.
    void shownChanged();

private:
    friend class Session;
    friend class SessionTargets;
    friend class Simulation;

    void forgetAll();
    /// As append(), and nothing to undo. Into a history without hits.
    void bringBack(std::span<const Hit> hits);
    HistoryEdit appendQuietly(std::span<const Hit> hits);
    /// As a group of `kind` where that is one. The hits have passed checkedHit(), on targets that there are.
    /// `places`: where dynamic targets were before the hits.
    void append(std::span<const Hit> hits, SessionUndo::Kind kind = SessionUndo::Kind::Hit,
                SessionUndo::Merge merge = SessionUndo::Merge::Never, std::vector<TargetPlace> places = {});
    [[nodiscard]] Result<std::vector<Hit>> checked(std::span<const Hit> hits) const;
    void setGroup(std::span<const std::size_t> indices, const HitGroup& group, SessionUndo::Kind kind);
    /// The history has these edits already.
    void record(std::vector<HistoryEdit> edits, SessionUndo::Name name,
                SessionUndo::Merge merge = SessionUndo::Merge::Never);
    void announce(std::span<const HistoryEdit> edits);
    void announceRows(const HitRows& rows);
    void makeAgain(std::span<const HistoryEdit> edits);  ///< announces nothing
    [[nodiscard]] std::vector<std::size_t> on(std::span<const TargetId> targets) const;
    /// Announces nothing; `hits` ascend.
    std::vector<HistoryEdit> takeOut(std::span<const std::size_t> hits);
    HistoryEdit putIn(std::span<const Hit> hits);  ///< likewise

    Session& m_session;
    HitHistory m_history;
    std::size_t m_disabled = 0;
    std::optional<std::size_t> m_selected;
    std::optional<std::size_t> m_shown;  ///< nothing: all
};

}  // namespace hitscope
