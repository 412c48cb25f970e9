// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "session/session.h"

namespace Ui {
class DeformationConstantsForm;
}

namespace hitscope {

class ParameterEditor;

/// The dock "Deformation constants": the three constants of the paper's function, live.
class DeformationConstantsPanel : public QWidget {
    Q_OBJECT
public:
    /// `session` outlives the panel.
    explicit DeformationConstantsPanel(Session& session, QWidget* parent = nullptr);
    ~DeformationConstantsPanel() override;

private:
    void showConstants();
    void apply(const DeformationConstants& constants);

    Session& m_session;
    std::unique_ptr<Ui::DeformationConstantsForm> m_ui;
    std::vector<ParameterEditor*> m_editors;  ///< in the order of deformationParameters()
};

}  // namespace hitscope
