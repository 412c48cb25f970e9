// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <memory>

#include "analysis/pipeline_agreement.h"

namespace Ui {
class PipelineAgreement;
}

namespace hitscope {

/// The dock "Pipeline agreement": whether the active pipeline made what the reference makes, and where not.
class PipelineAgreementPanel : public QWidget {
    Q_OBJECT
public:
    /// `session` outlives the panel. `sync`: see PipelineAgreement::setSync().
    PipelineAgreementPanel(Session& session, std::function<bool()> sync, QWidget* parent = nullptr);
    ~PipelineAgreementPanel() override;

Q_SIGNALS:
    /// Somebody wants to see this box (world).
    void lookWanted(const hitscope::Bounds& bounds);

private:
    void showReport();
    void lookAtWorst();
    [[nodiscard]] QString verdict() const;

    Session& m_session;
    PipelineAgreement m_agreement;
    std::unique_ptr<Ui::PipelineAgreement> m_ui;
};

}  // namespace hitscope
