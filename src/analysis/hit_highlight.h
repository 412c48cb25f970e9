// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "analysis/hit_effects.h"

namespace hitscope {

/// Selects the vertices that the selected hit moved, so that they light up wherever the selection is shown.
/// They follow the edits of the history, and stay selected until another hit is, or none; a selection made
/// otherwise meanwhile is left alone.
class HitHighlight : public QObject {
    Q_OBJECT
public:
    /// Both outlive this.
    HitHighlight(Session& session, HitEffects& effects, QObject* parent = nullptr);

private:
    void followHit();
    void followHistory();
    void light(TargetId target, const std::vector<std::uint32_t>& vertices);

    Session& m_session;
    HitEffects& m_effects;
    bool m_isLit = false;    ///< what is selected was selected here
    bool m_follows = false;  ///< nothing was selected otherwise since a hit was
    bool m_isSelecting = false;
};

}  // namespace hitscope
