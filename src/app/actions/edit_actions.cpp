// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/edit_actions.h"

#include <QAction>
#include <QMenu>

#include "app/actions/menu_building.h"
#include "app/mesh_editor.h"
#include "models/undo_text.h"
#include "panels/help/help_text.h"
#include "session/session.h"
#include "viewport/brush_tool.h"

namespace hitscope {

EditActions::EditActions(Session& session, QObject* parent) : QObject(parent), m_session(session) {}

void EditActions::fill(QMenu& menu) {
    m_undo = addAction(
        menu, tr("&Undo"), QKeySequence::Undo, this, [this] { undoLast(); }, QStringLiteral("undo"));
    m_redo = addAction(
        menu, tr("&Redo"), tr("Ctrl+Shift+Z"), this, [this] { redoNext(); }, QStringLiteral("redo"));
    menu.addSeparator();
    m_enableAll = addAction(menu, tr("&Enable All Hits"), {}, this, [this] { m_session.hits().enableAll(); });
    m_clear = addAction(
        menu, tr("&Clear Hits"), tr("Ctrl+Shift+Del"), this, [this] { m_session.hits().clear(); },
        QStringLiteral("remove"));
    menu.addSeparator();
    connect(&m_session, &Session::undoChanged, this, &EditActions::follow);
    connect(&m_session.hits(), &SessionHits::appended, this, &EditActions::follow);
    connect(&m_session.hits(), &SessionHits::reset, this, &EditActions::follow);
    connect(&m_session.simulation(), &Simulation::shotsWent, this, &EditActions::follow);
    follow();
}

void EditActions::setEditor(MeshEditor& editor) {
    m_editor = &editor;
    connect(&editor, &MeshEditor::busyChanged, this, &EditActions::follow);
}

// What was said of the step before would be untrue now.

void EditActions::undoLast() {
    if (m_editor != nullptr && m_editor->isBusy()) {
        m_editor->cancel();
        return;
    }
    if (m_brush != nullptr && m_brush->isPainting()) {
        m_brush->cancelStroke();
        return;
    }
    if (m_session.simulation().recallShots()) {
        follow();
        Q_EMIT said(tr("The shot in flight was taken back."));
        return;
    }
    if (const auto step = m_session.steps().toUndo()) {
        m_session.undo();
        Q_EMIT said(tr("Undone: %1").arg(undoText(*step)));
    }
}

void EditActions::redoNext() {
    if (m_brush != nullptr && m_brush->isPainting()) {
        return;
    }
    if (const auto step = m_session.steps().toRedo()) {
        m_session.redo();
        Q_EMIT said(tr("Redone: %1").arg(undoText(*step)));
    }
}

void EditActions::follow() {
    const auto name = [](QAction& action, const QString& text, const auto& step, const QString& why) {
        enableIf(action, step.has_value(), why);
        action.setText(step ? text + u' ' + undoText(*step) : text);
    };
    const std::optional<SessionUndo::Name> running = m_editor != nullptr ? m_editor->running() : std::nullopt;
    name(*m_undo, tr("&Undo"), running ? running : m_session.steps().toUndo(),
         tr("There is nothing to undo."));
    if (!running && m_session.simulation().hasShotsInAir()) {
        enableIf(*m_undo, true, {});
        m_undo->setText(tr("&Undo Shot in Flight"));
    }
    name(*m_redo, tr("&Redo"), m_session.steps().toRedo(), tr("There is nothing to redo."));
    enableIf(*m_enableAll, m_session.hits().disabled() > 0, tr("No hit is disabled."));
    enableIf(*m_clear, m_session.hits().history().size() > 0, tr("There are no hits yet."));
}

}  // namespace hitscope
