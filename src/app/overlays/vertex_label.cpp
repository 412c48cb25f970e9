// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/vertex_label.h"

#include <glm/trigonometric.hpp>

#include "models/quantity_text.h"
#include "models/vertex_facts.h"
#include "session/shown_number.h"
#include "session/vertex_selection.h"
#include "viewport/inspect_tool.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kBeside = 18;  // logical pixels from the cursor
constexpr int kMargin = 4;   // to the viewport's edge

QString row(const QString& name, const QString& value) {
    return QStringLiteral("<tr><td style=\"padding-right:10px\">%1</td><td><nobr>%2</nobr></td></tr>")
        .arg(name, value);
}

}  // namespace

VertexLabel::VertexLabel(Session& session, Viewport& viewport)
    : QLabel(&viewport), m_session(session), m_viewport(viewport) {
    setObjectName(QStringLiteral("vertexLabel"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setTextFormat(Qt::RichText);
    setMargin(5);
    hide();
    connect(&session.selection(), &VertexSelection::hoveredChanged, this, &VertexLabel::follow);
    connect(&session.readBack(), &ReadBack::meshChanged, this, [this](TargetId target) {
        const auto& hovered = m_session.selection().hovered();
        if (hovered && hovered->target == target) {
            follow();
        }
    });
}

QString VertexLabel::describe(const Target& target, std::uint32_t vertex) {
    const VertexFacts facts = vertexFacts(target.deformed, vertex);
    QString text = tr("<b>Vertex %1</b> of %2").arg(vertexNumberText(vertex), target.name.toHtmlEscaped());
    text += QStringLiteral("<table cellspacing=\"1\">");
    if (target.deformed.isChanged(vertex)) {
        text += row(tr("Original"), tr("%1 m").arg(vectorText(facts.original)));
        text += row(tr("Current"), tr("%1 m").arg(vectorText(facts.current)));
        text += row(tr("Moved by"), tr("%1 m").arg(quantityText(facts.length)));
        text += row(QString(), tr("%1 m").arg(vectorText(facts.displacement)));
    } else {
        text += row(tr("Position"), tr("%1 m, not moved").arg(vectorText(facts.original)));
    }
    text += row(tr("Normal"),
                facts.turned == 0.0
                    ? vectorText(facts.normal)
                    : tr("%1, turned by %2°")
                          .arg(vectorText(facts.normal), shownNumber(glm::degrees(facts.turned), 'f', 1)));
    return text + QStringLiteral("</table>");
}

void VertexLabel::follow() {
    const auto& hovered = m_session.selection().hovered();
    const Target* target = hovered ? m_session.targets().find(hovered->target) : nullptr;
    // Hovered in a table, say: there is no cursor to stand beside.
    if (target == nullptr || !m_viewport.underMouse()) {
        hide();
        return;
    }
    setText(describe(*target, hovered->vertex));
    adjustSize();
    place();
    show();
    raise();
}

void VertexLabel::place() {
    const QPoint cursor = m_viewport.inspectTool().cursor().toPoint();
    const QRect room = parentWidget()->rect().adjusted(kMargin, kMargin, -kMargin, -kMargin);
    QRect label(cursor + QPoint(kBeside, kBeside), size());
    if (label.right() > room.right()) {
        label.moveRight(cursor.x() - kBeside);
    }
    if (label.bottom() > room.bottom()) {
        label.moveBottom(cursor.y() - kBeside);
    }
    label.moveLeft(std::max(label.left(), room.left()));
    label.moveTop(std::max(label.top(), room.top()));
    move(label.topLeft());
}

}  // namespace hitscope
