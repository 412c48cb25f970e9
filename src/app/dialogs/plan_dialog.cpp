// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/plan_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "models/group_name.h"
#include "panels/help/help_text.h"
#include "session/shown_number.h"
#include "viewport/viewport.h"

namespace hitscope {

PlanDialog::PlanDialog(Session& session, Viewport& viewport, const QString& title, const QString& apply,
                       QWidget* parent)
    : QDialog(parent),
      m_session(session),
      m_viewport(viewport),
      m_planner(session),
      m_fields(new QFormLayout),
      m_summary(new QLabel) {
    setWindowTitle(title);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    m_apply = buttons->addButton(apply, QDialogButtonBox::ActionRole);
    m_apply->setObjectName(QStringLiteral("apply"));
    m_summary->setObjectName(QStringLiteral("summary"));
    m_summary->setTextFormat(Qt::PlainText);
    m_summary->setWordWrap(true);
    m_summary->setMinimumWidth(36 * fontMetrics().averageCharWidth());
    // Two lines from the beginning: the dialog does not grow under the cursor.
    m_summary->setMinimumHeight(2 * fontMetrics().lineSpacing());
    m_summary->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* column = new QVBoxLayout(this);
    column->addLayout(m_fields);
    column->addWidget(m_summary);
    column->addWidget(buttons);
    // In the dialog by now, which would take another button for Return otherwise: Close.
    buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
    m_apply->setDefault(true);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(m_apply, &QPushButton::clicked, this, &PlanDialog::apply);
    connect(&m_planner, &HitPlanner::planned, this, &PlanDialog::showPlan);
    followTargets();
}

PlanDialog::~PlanDialog() = default;

/// What is planned is in the local frames of targets, which may turn, go, or get another mesh. The planner
/// drops its plan at once, so what no longer fits cannot be made meanwhile.
void PlanDialog::followTargets() {
    m_replan.setSingleShot(true);
    connect(&m_replan, &QTimer::timeout, this, [this] { replan(); });
    const auto replanSoon = [this] { m_replan.start(0); };
    connect(&m_session.targets(), &SessionTargets::changed, this, replanSoon);
    connect(&m_session.targets(), &SessionTargets::removed, this, replanSoon);
    connect(&m_session, &Session::sceneReplaced, this, replanSoon);
}

void PlanDialog::showPlan() {
    const HitPlanner::Plan* plan = m_planner.current();
    const bool isReady = plan != nullptr && !plan->hits.empty();
    if (plan != nullptr) {
        m_summary->setText(!isReady ? plan->why : summary(*plan));
        m_viewport.decorations().setPlannedGhosts(isVisible() ? plan->ghosts : nullptr);
    }
    enableIf(*m_apply, isReady, plan != nullptr ? plan->why : tr("The hits are being placed."));
}

void PlanDialog::apply() {
    const HitPlanner::Plan* plan = m_planner.current();
    if (plan == nullptr || plan->hits.empty()) {
        return;
    }
    const std::size_t count = plan->hits.size();
    const Result<HitGroup> group = m_session.hits().addGroup(kind(), plan->hits);
    if (!group) {
        Q_EMIT failed(group.error());
        return;
    }
    close();
    Q_EMIT made(
        tr("%Ln {hit|hits} made as group “%1”", nullptr, trCount(count)).arg(groupName(group.value())));
}

void PlanDialog::showEvent(QShowEvent* event) {
    QDialog::showEvent(event);
    showPlan();
    replan();
}

void PlanDialog::hideEvent(QHideEvent* event) {
    m_planner.clear();
    m_viewport.decorations().setPlannedGhosts(nullptr);
    QDialog::hideEvent(event);
}

}  // namespace hitscope
