// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <QPolygonF>
#include <QTimer>
#include <cstdint>
#include <memory>
#include <optional>

#include "session/vertex_selection.h"

class QKeyEvent;
class QMouseEvent;

namespace hitscope {

class OutlineOverlay;
class Session;
class Viewport;

/// Where there are several targets, the panels go by the vertex's from now on.
void selectTargetOf(Session& session, const VertexRef& vertex);

/// What the left button does in the viewport.
enum class Tool : std::uint8_t { Shoot, Inspect, Brush, Move };
/// What a drag of the Inspect tool draws around vertices.
enum class Outline : std::uint8_t { Rectangle, Lasso };

/// Pointing at vertices. Takes its events before the viewport does, and leaves the others to it.
///
/// With Inspect, the vertex under the cursor is the hovered one, a click picks it and selects it alone, a
/// drag selects the changed vertices within an outline; Ctrl adds to what is selected and Shift takes away.
/// Alt+click picks with either tool, Alt+drag moves the camera as a plain drag does with Shoot. Escape gives
/// a drag up, or else clears the selection.
class InspectTool : public QObject {
    Q_OBJECT
public:
    InspectTool(Viewport& viewport, Session& session);
    ~InspectTool() override;

    [[nodiscard]] Tool tool() const { return m_tool; }
    void setTool(Tool tool);
    [[nodiscard]] Outline outline() const { return m_outline; }
    void setOutline(Outline outline) { m_outline = outline; }
    /// Whether outlines select vertices behind surfaces too.
    [[nodiscard]] bool selectsHidden() const { return m_selectsHidden; }
    void setSelectsHidden(bool on) { m_selectsHidden = on; }

    /// The cursor of the viewport is the tool's, but for where a drag would move the wipe's line.
    void setOnWipeLine(bool on);

    /// Where the cursor was when it found the hovered vertex; logical pixels.
    [[nodiscard]] QPointF cursor() const { return m_cursor; }

Q_SIGNALS:
    void toolChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class Drag : std::uint8_t { None, Undecided, Outline, Camera };

    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    void showCursor();
    bool keyPress(const QKeyEvent& event);
    void beginDrag(const QMouseEvent& event);
    void extendOutline(const QPointF& to);
    void endDrag();
    void letGo();
    void click(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void selectWithin(const QPolygonF& outline, VertexSelection::Combine combine);
    void leave();
    void hover(const QPointF& position);
    void hoverAgain();
    void askForHovered();
    void takeHovered();

    Viewport& m_viewport;
    Session& m_session;
    VertexSelection& m_selection;
    OutlineOverlay* m_overlay;
    Tool m_tool = Tool::Shoot;
    Outline m_outline = Outline::Rectangle;
    bool m_selectsHidden = false;
    bool m_isOnWipeLine = false;

    Drag m_drag = Drag::None;
    QPointF m_pressedAt;
    Qt::KeyboardModifiers m_pressedWith;
    QPolygonF m_drawn;

    QPointF m_cursor;
    bool m_inside = false;  ///< the cursor is over the viewport, and hovers
    bool m_moved = false;   ///< since the vertex under it was last asked for
    QTimer m_arrivalTimer;  ///< looks whether the answer has come
    QTimer m_againTimer;    ///< the picture has changed under the cursor
};

}  // namespace hitscope
