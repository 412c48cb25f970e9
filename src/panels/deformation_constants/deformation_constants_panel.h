// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "models/constants_presets.h"
#include "session/once_a_turn.h"
#include "session/session.h"

namespace Ui {
class DeformationConstantsForm;
}

namespace hitscope {

class HitEditing;
class FormFields;
class ParameterEditor;

/// The dock "Deformation constants": the three constants of the paper's function for the hits to come, live,
/// in per cent of a target or in metres, as presets, and what they come to. Hits already made get them only
/// when asked for.
class DeformationConstantsPanel : public QWidget {
    Q_OBJECT
public:
    /// Both outlive the panel. Presets are read from and saved to the application's QSettings.
    DeformationConstantsPanel(Session& session, HitEditing& editing, QWidget* parent = nullptr);
    ~DeformationConstantsPanel() override;

Q_SIGNALS:
    void presetsChanged();  ///< one was saved or deleted

private:
    void makeEditors();
    void makeForm();
    void setForm(const DentForm& form, SessionUndo::Merge merge = SessionUndo::Merge::Never);
    void showForm();
    /// The form in force on a target of that id; 0: on one of the usual size.
    [[nodiscard]] DentForm formOn(TargetId target) const;
    void makePresetMenu();
    void listPresets();
    void showConstants();
    void showInForce();
    [[nodiscard]] QString inForceText() const;
    void showHits();
    void apply(const ConstantsSetting& setting, SessionUndo::Merge merge = SessionUndo::Merge::Never);
    void choosePreset(int row);
    [[nodiscard]] std::optional<std::size_t> presetInForce() const;
    void takePresetsOfOthers(QSettings& settings);
    void savePreset();
    void deletePreset();

    Session& m_session;
    HitEditing& m_editing;
    UndoGesture m_gesture;
    std::unique_ptr<Ui::DeformationConstantsForm> m_ui;
    FormFields* m_form = nullptr;
    std::vector<ParameterEditor*> m_editors;  ///< in the order of deformationParameters()
    ConstantsPresets m_presets;
    QAction* m_delete = nullptr;
    OnceATurn m_showing{[this] { showInForce(); }};
};

}  // namespace hitscope
