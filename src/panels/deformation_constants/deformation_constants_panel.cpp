// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/deformation_constants/deformation_constants_panel.h"

#include "panels/deformation_constants/parameter_editor.h"
#include "ui_deformation_constants.h"

namespace hitscope {

DeformationConstantsPanel::DeformationConstantsPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_ui(std::make_unique<Ui::DeformationConstantsForm>()) {
    m_ui->setupUi(this);
    const auto& parameters = deformationParameters();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        auto* editor = new ParameterEditor(parameters[i], *m_ui->parameters, static_cast<int>(i), this);
        connect(editor, &ParameterEditor::edited, this, [this, i](double value) {
            DeformationConstants constants = m_session.constants();
            setParameterValue(constants, i, value);
            apply(constants);
        });
        m_editors.push_back(editor);
    }
    connect(m_ui->reset, &QPushButton::clicked, this, [this] { apply(DeformationConstants{}); });
    connect(m_ui->past, &QCheckBox::toggled, this, [this](bool past) {
        if (past) {
            apply(m_session.constants());
        }
    });
    connect(&session, &Session::constantsChanged, this, &DeformationConstantsPanel::showConstants);
    showConstants();
}

DeformationConstantsPanel::~DeformationConstantsPanel() = default;

void DeformationConstantsPanel::showConstants() {
    for (std::size_t i = 0; i < m_editors.size(); ++i) {
        m_editors[i]->setValue(parameterValue(m_session.constants(), i));
    }
}

void DeformationConstantsPanel::apply(const DeformationConstants& constants) {
    // The editors keep to the ranges that the session checks; should it refuse, they show what holds.
    if (!m_session.setConstants(constants, m_ui->past->isChecked())) {
        showConstants();
    }
}

}  // namespace hitscope
