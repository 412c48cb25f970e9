// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;
class QMenu;

namespace hitscope {

class BrushTool;
class MeshEditor;
class Session;

/// Undo and redo, which say what they would be about, and what concerns all hits.
class EditActions : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this.
    explicit EditActions(Session& session, QObject* parent = nullptr);

    void fill(QMenu& menu);  ///< once
    /// While it changes a mesh, Undo cancels that. Once; it outlives this.
    void setEditor(MeshEditor& editor);
    /// While it paints, Undo takes the stroke back, and Redo does nothing. Likewise.
    void setBrush(BrushTool& brush) { m_brush = &brush; }
    [[nodiscard]] QAction* undo() const { return m_undo; }
    [[nodiscard]] QAction* redo() const { return m_redo; }

Q_SIGNALS:
    void said(const QString& text);

private:
    void undoLast();
    void redoNext();
    void follow();

    Session& m_session;
    MeshEditor* m_editor = nullptr;
    BrushTool* m_brush = nullptr;
    QAction* m_undo = nullptr;
    QAction* m_redo = nullptr;
    QAction* m_enableAll = nullptr;
    QAction* m_clear = nullptr;
};

}  // namespace hitscope
