// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>

namespace Ui {
class UndoHistory;
}

namespace hitscope {

class Session;
class UndoModel;

/// The dock "Undo history": all steps that can be undone or made again. A click goes to the state after a
/// step.
class UndoHistoryPanel : public QWidget {
    Q_OBJECT
public:
    /// `session` outlives the panel.
    explicit UndoHistoryPanel(Session& session, QWidget* parent = nullptr);
    ~UndoHistoryPanel() override;

private:
    void follow();

    Session& m_session;
    UndoModel* m_model = nullptr;
    std::unique_ptr<Ui::UndoHistory> m_ui;
};

}  // namespace hitscope
