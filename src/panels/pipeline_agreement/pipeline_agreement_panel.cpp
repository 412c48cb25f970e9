// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/pipeline_agreement/pipeline_agreement_panel.h"

#include <utility>

#include "models/quantity_text.h"
#include "panels/help/help_text.h"
#include "session/shown_number.h"
#include "ui_pipeline_agreement.h"

namespace hitscope {

PipelineAgreementPanel::PipelineAgreementPanel(Session& session, std::function<bool()> sync, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_agreement(session),
      m_ui(std::make_unique<Ui::PipelineAgreement>()) {
    m_ui->setupUi(this);
    m_agreement.setSync(std::move(sync));
    connect(&m_agreement, &PipelineAgreement::reported, this, &PipelineAgreementPanel::showReport);
    connect(m_ui->compare, &QPushButton::clicked, &m_agreement, &PipelineAgreement::compare);
    connect(m_ui->continuous, &QCheckBox::toggled, &m_agreement, &PipelineAgreement::setContinuous);
    connect(m_ui->worst, &QToolButton::clicked, this, &PipelineAgreementPanel::lookAtWorst);
    showReport();
}

PipelineAgreementPanel::~PipelineAgreementPanel() = default;

QString PipelineAgreementPanel::verdict() const {
    const std::optional<AgreementReport>& report = m_agreement.report();
    if (!report) {
        return m_agreement.isComparing() ? tr("Comparing…") : tr("Not compared yet.");
    }
    const std::string_view name = pipelineTraits(report->pipeline).name;
    QString text = report->different == 0
                       ? tr("%1: all %2 vertices are identical to the reference (bit-exact).")
                       : tr("%1: of %2 vertices, some differ from the reference.");
    text = text.arg(QString::fromUtf8(name), countText(report->vertices));
    if (report->dropped > 0) {
        text += u' ' + tr("Without the {hit|%Ln hits} that the pipeline has dropped.", nullptr,
                          trCount(report->dropped));
    }
    if (report->later > 0) {
        text += u' ' +
                tr("Without the {hit that is|%Ln hits that are} not shown.", nullptr, trCount(report->later));
    }
    if (m_agreement.isOutOfDate()) {
        text += u' ' + (m_agreement.isComparing() ? tr("Updating…") : tr("The scene has changed since."));
    }
    return text;
}

void PipelineAgreementPanel::showReport() {
    enableIf(*m_ui->compare, !m_agreement.isComparing(), tr("The pipelines are being compared."));
    m_ui->verdict->setText(verdict());
    for (QWidget* number : {static_cast<QWidget*>(m_ui->largest), static_cast<QWidget*>(m_ui->rms),
                            static_cast<QWidget*>(m_ui->different)}) {
        number->setEnabled(!m_agreement.isOutOfDate());
    }
    const std::optional<AgreementReport>& report = m_agreement.report();
    const QString nothing = QStringLiteral("–");
    const auto metres = [](double value) { return tr("%1 m").arg(quantityText(value)); };
    m_ui->largest->setText(report ? metres(report->largest) : nothing);
    m_ui->rms->setText(report ? metres(report->rootMeanSquare) : nothing);
    m_ui->different->setText(report ? countText(report->different) : nothing);
    const Target* target =
        report && report->worst ? m_session.targets().find(report->worst->target) : nullptr;
    enableIf(*m_ui->worst, target != nullptr,
             report ? tr("No vertex differs.") : tr("Nothing has been compared yet."));
    m_ui->worst->setText(
        target != nullptr
            ? tr("vertex %1 of %2").arg(countText(std::size_t{report->worst->vertex} + 1), target->name)
            : nothing);
}

void PipelineAgreementPanel::lookAtWorst() {
    const std::optional<AgreementReport>& report = m_agreement.report();
    const Target* target =
        report && report->worst ? m_session.targets().find(report->worst->target) : nullptr;
    if (target == nullptr) {
        return;
    }
    m_session.selection().setPicked(report->worst);
    constexpr float kAround = 0.05f;  // of the target's extent
    const float around = kAround * target->extent();
    const glm::vec3 place = target->transform.toWorld(target->deformed.positions()[report->worst->vertex]);
    Bounds bounds;
    bounds.add(place - glm::vec3(around));
    bounds.add(place + glm::vec3(around));
    Q_EMIT lookWanted(bounds);
}

}  // namespace hitscope
