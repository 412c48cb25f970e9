// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <span>
#include <vector>

#include "session/session.h"

namespace hitscope {

/// The hits that are selected, and changing them while they are looked at: at most one edit of the history a
/// frame, and one step to undo for each gesture. Panels and the handles in the picture share it.
class HitEditing : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this.
    explicit HitEditing(Session& session, QObject* parent = nullptr);

    /// Selected hits of the history, ascending; SessionHits::selected() is one of them.
    [[nodiscard]] std::span<const std::size_t> rows() const { return m_rows; }
    /// Several at once. SessionHits::select() selects one alone, or none.
    void select(std::vector<std::size_t> rows);
    /// SessionHits::selected(), with what is about to be changed; null: none is selected.
    [[nodiscard]] const Hit* current() const;

    using Edit = std::function<void(Hit&)>;
    /// Does `edit` to all selected hits, as they were before the gesture, now or after the next frame; `part`
    /// (>= 0) tells the gestures apart. A hit that checkedHit() refuses stays as it was, and refused() says
    /// why.
    void change(int part, const Edit& edit, SessionUndo::Kind kind = SessionUndo::Kind::EditHit);
    /// What was changed last is done now, and is a step of its own.
    void endGesture();
    /// Takes back what the gesture that has not ended has changed.
    void cancelGesture();

Q_SIGNALS:
    void rowsChanged();
    void edited();  ///< current() is another, or rows() were changed
    void refused(const hitscope::Error& error);

private:
    void followSelected();
    void follow();
    void apply();
    void frameEnded();

    Session& m_session;
    std::vector<std::size_t> m_rows;
    UndoGesture m_gesture;
    int m_part = -1;            ///< of m_pending and of the gesture that goes on
    std::vector<Hit> m_before;  ///< the rows' hits, when the gesture began
    Edit m_pending;
    SessionUndo::Kind m_kind = SessionUndo::Kind::EditHit;
    bool m_isApplying = false;
    bool m_awaitsFrame = false;  ///< the last edit has not been drawn
    QTimer m_noFrameTimer;       ///< there may be none: the picture is hidden
};

}  // namespace hitscope
