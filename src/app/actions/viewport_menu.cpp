// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/viewport_menu.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QCursor>
#include <QMenu>
#include <QMouseEvent>
#include <functional>
#include <vector>

#include "deform/attribution.h"
#include "models/quantity_text.h"
#include "models/vertex_facts.h"
#include "panels/help/help_text.h"
#include "session/session.h"
#include "viewport/inspect_tool.h"
#include "viewport/viewport.h"

namespace hitscope {

/// What is under the cursor.
struct ViewportMenu::Place {
    QPointF position;                           ///< logical pixels
    std::optional<VertexRef> vertex;            ///< the nearest of the surface there
    std::optional<PhysicsWorld::RayHit> solid;  ///< target or floor
    const Target* target = nullptr;
};

namespace {

QString plainName(const QString& name) {
    QString plain = name;
    return plain.replace(QLatin1Char('&'), QStringLiteral("&&"));
}

/// `why` it is disabled; empty: it is not.
void addEntry(QMenu& menu, const QString& text, const QString& why, std::function<void()> act) {
    QAction* action = menu.addAction(text);
    enableIf(*action, why.isEmpty(), why);
    QObject::connect(action, &QAction::triggered, &menu, [run = std::move(act)] { run(); });
}

}  // namespace

std::optional<std::size_t> lastHitThatMoved(const Session& session, const VertexRef& vertex) {
    const Target* target = session.targets().find(vertex.target);
    if (target == nullptr) {
        return std::nullopt;
    }
    const RenderMesh& mesh = target->deformed.render();
    Attribution attribution(mesh.vertices[mesh.renderVerticesOf(vertex.vertex).front()]);
    std::optional<std::size_t> last;
    const std::span<const Hit> hits = session.hits().shown();
    for (std::size_t index = 0; index < hits.size(); ++index) {
        if (hits[index].target != vertex.target || !hits[index].enabled ||
            session.readBack().isDropped(index)) {
            continue;
        }
        const glm::vec3 before = attribution.vertex().position;
        if (attribution.add(index, hits[index]) && attribution.vertex().position != before) {
            last = index;
        }
    }
    return last;
}

ViewportMenu::ViewportMenu(Session& session, Viewport& viewport, QObject* parent)
    : QObject(parent), m_session(session), m_viewport(viewport) {
    viewport.installEventFilter(this);
}

bool ViewportMenu::eventFilter(QObject* watched, QEvent* event) {
    if (watched != &m_viewport) {
        return false;
    }
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick) {
        const auto& mouse = *static_cast<QMouseEvent*>(event);
        m_pressedAt.reset();
        if (mouse.buttons() == Qt::RightButton && mouse.modifiers() == Qt::NoModifier) {
            m_pressedAt = mouse.position();
        }
    } else if (event->type() == QEvent::MouseMove && m_pressedAt) {
        const QPointF moved = static_cast<QMouseEvent*>(event)->position() - *m_pressedAt;
        if (moved.manhattanLength() >= QApplication::startDragDistance()) {
            m_pressedAt.reset();
        }
    } else if (event->type() == QEvent::MouseButtonRelease && m_pressedAt) {
        const QPointF at = *std::exchange(m_pressedAt, std::nullopt);
        // Later: the viewport ends its press first.
        QMetaObject::invokeMethod(
            this, [this, at] { open(at); }, Qt::QueuedConnection);
    } else if (event->type() == QEvent::ContextMenu) {
        // The mouse's comes with the press, before it is known to be no drag.
        if (static_cast<QContextMenuEvent*>(event)->reason() == QContextMenuEvent::Keyboard) {
            const QPoint cursor = m_viewport.mapFromGlobal(QCursor::pos());
            open(m_viewport.rect().contains(cursor) ? cursor : m_viewport.rect().center());
        }
        return true;
    }
    return false;
}

void ViewportMenu::open(const QPointF& position) {
    Place place;
    place.position = position;
    place.vertex = m_viewport.picking().vertexAt(position);
    place.solid = m_viewport.aiming().met(m_viewport.navigation().rayAt(position));
    place.target = m_session.targets().find(place.vertex ? place.vertex->target : TargetId{});
    auto* menu = new QMenu(&m_viewport);
    menu->setObjectName(QStringLiteral("viewportMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    addPicking(*menu, place);
    addTargets(*menu, place);
    addView(*menu, place);
    addDents(*menu, place);
    menu->popup(m_viewport.mapToGlobal(position.toPoint()));
}

void ViewportMenu::addPicking(QMenu& menu, const Place& place) {
    const QString none = place.vertex ? QString() : tr("There is no target here.");
    const QString text =
        place.vertex ? tr("&Pick Vertex %1").arg(vertexNumberText(place.vertex->vertex)) : tr("&Pick Vertex");
    addEntry(menu, text, none, [this, vertex = place.vertex] { pick(*vertex); });
    menu.addSeparator();
}

void ViewportMenu::addTargets(QMenu& menu, const Place& place) {
    const QString none = place.target != nullptr ? QString() : tr("There is no target here.");
    const QString name = place.target != nullptr ? plainName(place.target->name) : tr("Target");
    const TargetId id = place.target != nullptr ? place.target->id : TargetId{};
    const bool isSelected = id && m_session.targets().selected() == id;
    addEntry(menu, tr("&Select %1").arg(name), isSelected ? tr("It is selected already.") : none,
             [this, id] { m_session.targets().select(id); });
    int visible = 0;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        visible += target->visible ? 1 : 0;
    }
    const bool isAlone = place.target != nullptr && visible == 1;
    addEntry(menu, tr("&Isolate %1").arg(name), isAlone ? tr("No other target is shown.") : none,
             [this, id] { isolate(id); });
    const bool isAny = static_cast<std::size_t>(visible) < m_session.targets().size();
    addEntry(menu, tr("Show &All Targets"), isAny ? QString() : tr("All targets are shown."),
             [this] { showAll(); });
    menu.addSeparator();
}

void ViewportMenu::addView(QMenu& menu, const Place& place) {
    const QString name = place.target != nullptr ? plainName(place.target->name) : tr("Target");
    const Bounds bounds = place.target != nullptr ? place.target->worldBounds() : Bounds();
    addEntry(menu, tr("&Frame %1").arg(name),
             place.target != nullptr ? QString() : tr("There is no target here."),
             [this, bounds] { m_viewport.navigation().frame(bounds); });
    addEntry(menu, tr("&Centre View Here"), place.solid ? QString() : tr("There is no surface here."),
             [this, at = place.position] { m_viewport.centreAt(at); });
    menu.addSeparator();
}

void ViewportMenu::addDents(QMenu& menu, const Place& place) {
    const auto last = place.vertex ? lastHitThatMoved(m_session, *place.vertex) : std::nullopt;
    const QString why = !place.vertex ? tr("There is no target here.")
                        : !last       ? tr("No hit has moved the vertex here.")
                                      : QString();
    addEntry(menu, tr("&Measure Dent Here"), why, [this, vertex = place.vertex] {
        pick(*vertex);
        Q_EMIT dockWanted(QStringLiteral("dentMeasurement"));
    });
    const QString remove =
        last ? tr("&Remove Hit %1, the Last One Here").arg(countText(*last + 1)) : tr("&Remove Dent Here");
    addEntry(menu, remove, why, [this, last] { m_session.hits().remove(*last); });
    addEntry(menu, tr("S&hoot Here"), {}, [this, at = place.position] { m_viewport.shootAt(at); });
}

void ViewportMenu::pick(const VertexRef& vertex) {
    VertexSelection& selection = m_session.selection();
    selectTargetOf(m_session, vertex);
    selection.setPicked(vertex);
    selection.select(vertex.target, {vertex.vertex}, VertexSelection::Combine::Replace);
}

void ViewportMenu::isolate(TargetId id) {
    std::vector<TargetId> others;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        if (target->id != id && target->visible) {
            others.push_back(target->id);
        }
    }
    m_session.targets().setVisible(others, false);
}

void ViewportMenu::showAll() {
    std::vector<TargetId> hidden;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        if (!target->visible) {
            hidden.push_back(target->id);
        }
    }
    m_session.targets().setVisible(hidden, true);
}

}  // namespace hitscope
