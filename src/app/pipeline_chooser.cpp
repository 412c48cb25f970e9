// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pipeline_chooser.h"
#include "models/verdict_text.h"
#include "panels/help/help_text.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QMenu>
#include <QStandardItemModel>

namespace hitscope {

namespace {

constexpr PipelineKind kFallback = PipelineKind::TransformFeedback;  // what OpenGL 3.3 has everywhere

}  // namespace

PipelineChooser::PipelineChooser(Session& session, QObject* parent)
    : QObject(parent), m_session(session), m_actions(new QActionGroup(this)) {
    connect(&session.settings(), &SessionSettings::pipelineChanged, this, &PipelineChooser::follow);
    connect(&session.readBack(), &ReadBack::unavailablePipelinesChanged, this, &PipelineChooser::follow);
    connect(&session.readBack(), &ReadBack::unavailablePipelinesChanged, this,
            &PipelineChooser::leaveUnavailable);
    connect(&session.readBack(), &ReadBack::verdictChanged, this, &PipelineChooser::follow);
}

void PipelineChooser::fill(QMenu& menu) {
    menu.setToolTipsVisible(true);
    for (const PipelineTraits& traits : allPipelines()) {
        QAction* action = menu.addAction(QString::fromUtf8(traits.name));
        action->setCheckable(true);
        action->setData(static_cast<int>(traits.kind));
        m_actions->addAction(action);
        connect(action, &QAction::triggered, this, [this, kind = traits.kind] { choose(kind); });
    }
    follow();
}

QComboBox* PipelineChooser::makeBox(QWidget* parent) {
    m_box = new QComboBox(parent);
    m_box->setObjectName(QStringLiteral("pipeline"));
    for (const PipelineTraits& traits : allPipelines()) {
        m_box->addItem(QString::fromUtf8(traits.name), static_cast<int>(traits.kind));
    }
    connect(m_box, &QComboBox::activated, this, [this](int index) {
        choose(static_cast<PipelineKind>(m_box->itemData(index).toInt()));
        Q_EMIT chosenInBox();
    });
    follow();
    return m_box;
}

void PipelineChooser::choose(PipelineKind kind) {
    m_isChosen = true;
    m_session.settings().setPipeline(kind);
}

/// Rich text, which is broken into lines.
QString PipelineChooser::toolTip(const PipelineTraits& traits) const {
    const auto paragraph = [](const QString& words) {
        return QStringLiteral("<p>%1</p>").arg(words.toHtmlEscaped());
    };
    const QString reason = m_session.readBack().whyUnavailable(traits.kind);
    const PipelineVerdict* verdict = m_session.readBack().verdict().of(traits.kind);
    const QString found = !reason.isEmpty() ? tr("Not available here: %1").arg(reason)
                          : verdict == nullptr
                              ? tr("Not compared with the reference yet.")
                              : tr("With this graphics driver: %1.").arg(verdictText(*verdict));
    return paragraph(found) + paragraph(QString::fromUtf8(traits.description)) +
           paragraph(tr("Needs %1. Keeps %2.")
                         .arg(QString::fromUtf8(traits.needs), QString::fromUtf8(traits.keeps)));
}

void PipelineChooser::follow() {
    for (QAction* action : m_actions->actions()) {
        const auto kind = static_cast<PipelineKind>(action->data().toInt());
        action->setChecked(kind == m_session.settings().pipeline());
        enableIf(*action, m_session.readBack().whyUnavailable(kind).isEmpty(),
                 m_session.readBack().whyUnavailable(kind));
        action->setToolTip(toolTip(pipelineTraits(kind)));
    }
    if (m_box == nullptr) {
        return;
    }
    const auto* items = qobject_cast<const QStandardItemModel*>(m_box->model());
    for (int row = 0; row < m_box->count(); ++row) {
        const auto kind = static_cast<PipelineKind>(m_box->itemData(row).toInt());
        items->item(row)->setEnabled(m_session.readBack().whyUnavailable(kind).isEmpty());
        items->item(row)->setToolTip(toolTip(pipelineTraits(kind)));
    }
    m_box->setCurrentIndex(m_box->findData(static_cast<int>(m_session.settings().pipeline())));
    m_box->setToolTip(toolTip(pipelineTraits(m_session.settings().pipeline())));
}

void PipelineChooser::leaveInexact() {
    const PipelineTraits& traits = pipelineTraits(m_session.settings().pipeline());
    const std::optional<PipelineKind> better = m_session.readBack().verdict().insteadOf(traits.kind);
    if (m_isChosen || !better) {
        return;
    }
    const QString found = verdictText(*m_session.readBack().verdict().of(traits.kind));
    m_session.settings().setPipeline(*better);
    Q_EMIT fellBack(
        tr("The pipeline “%1” is %2.\nUsing “%3” instead; Mesh > Pipeline has all of them.")
            .arg(QString::fromUtf8(traits.name), found, QString::fromUtf8(pipelineTraits(*better).name)));
}

void PipelineChooser::leaveUnavailable() {
    const PipelineTraits& traits = pipelineTraits(m_session.settings().pipeline());
    const QString reason = m_session.readBack().whyUnavailable(traits.kind);
    if (reason.isEmpty() || !m_session.readBack().whyUnavailable(kFallback).isEmpty()) {
        return;
    }
    m_session.settings().setPipeline(kFallback);
    Q_EMIT fellBack(
        tr("The pipeline “%1” cannot run here: %2\nUsing “%3” instead.")
            .arg(QString::fromUtf8(traits.name), reason, QString::fromUtf8(pipelineTraits(kFallback).name)));
}

}  // namespace hitscope
