// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <optional>

#include "session/vertex_selection.h"

class QMenu;
class QMouseEvent;

namespace hitscope {

class Session;
class Viewport;

/// The menu of what is under the cursor: a right click that does not move opens it, as does the Menu key. An
/// entry that has nothing to act on is disabled and says why.
class ViewportMenu : public QObject {
    Q_OBJECT
public:
    /// Both outlive this.
    ViewportMenu(Session& session, Viewport& viewport, QObject* parent);

Q_SIGNALS:
    void dockWanted(const QString& name);  ///< what it shows has been chosen

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Place;
    void open(const QPointF& position);
    void addPicking(QMenu& menu, const Place& place);
    void addTargets(QMenu& menu, const Place& place);
    void addView(QMenu& menu, const Place& place);
    void addDents(QMenu& menu, const Place& place);
    void pick(const VertexRef& vertex);
    void isolate(TargetId target);
    void showAll();

    Session& m_session;
    Viewport& m_viewport;
    std::optional<QPointF> m_pressedAt;  ///< of a right press that may be a click
};

/// The last enabled hit of those shown that moved a vertex; nothing if none did.
[[nodiscard]] std::optional<std::size_t> lastHitThatMoved(const Session& session, const VertexRef& vertex);

}  // namespace hitscope
