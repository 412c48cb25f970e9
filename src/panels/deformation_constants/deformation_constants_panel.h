// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "models/constants_presets.h"
#include "session/session.h"

namespace Ui {
class DeformationConstantsForm;
}

namespace hitscope {

class ParameterEditor;

/// The dock "Deformation constants": the three constants of the paper's function, live, as presets, and what
/// they come to on the target in focus.
class DeformationConstantsPanel : public QWidget {
    Q_OBJECT
public:
    /// `session` outlives the panel. Presets are read from and saved to the application's QSettings.
    explicit DeformationConstantsPanel(Session& session, QWidget* parent = nullptr);
    ~DeformationConstantsPanel() override;

private:
    void makeEditors();
    void makePresetMenu();
    void listPresets();
    void showConstants();
    void showInForce();
    void apply(const ConstantsSetting& setting);
    void choosePreset(int row);
    void savePreset();
    void deletePreset();

    Session& m_session;
    std::unique_ptr<Ui::DeformationConstantsForm> m_ui;
    std::vector<ParameterEditor*> m_editors;  ///< in the order of deformationParameters()
    ConstantsPresets m_presets;
    QAction* m_delete = nullptr;
};

}  // namespace hitscope
