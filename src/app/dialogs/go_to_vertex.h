// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QObject>
#include <optional>

#include "session/vertex_selection.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QMenu;

namespace hitscope {

class Session;
class Viewport;

/// Asks for a vertex by its number, from 1 as everywhere in the window, and for the target where there are
/// several.
class GoToVertexDialog : public QDialog {
    Q_OBJECT
public:
    /// `session` outlives the dialog.
    explicit GoToVertexDialog(const Session& session, QWidget* parent = nullptr);

    /// The vertex asked for; nothing while there is none of that number.
    [[nodiscard]] std::optional<VertexRef> vertex() const;

Q_SIGNALS:
    void chosen(const hitscope::VertexRef& vertex);

public Q_SLOTS:
    void accept() override;

private:
    [[nodiscard]] TargetId target() const;
    void followTarget();

    const Session& m_session;
    QComboBox* m_targets = nullptr;
    QLineEdit* m_number = nullptr;
    QLabel* m_range = nullptr;
};

/// The action Go to Vertex: a number gives the view, the row and the attribution of that vertex.
class GoToVertex : public QObject {
    Q_OBJECT
public:
    /// Both outlive this but `parent`.
    GoToVertex(Session& session, Viewport& viewport, QWidget* parent);

    void fill(QMenu& menu);
    /// Picks the vertex and brings it before the camera.
    void go(const VertexRef& vertex);

Q_SIGNALS:
    void arrived();  ///< its row and attribution are worth showing

private:
    void ask();

    Session& m_session;
    Viewport& m_viewport;
    QWidget* m_parent;
};

}  // namespace hitscope
