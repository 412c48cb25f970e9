// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/status_line.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>

#include "models/frame_rate_text.h"
#include "models/progress_text.h"
#include "models/quantity_text.h"
#include "models/verdict_text.h"
#include "session/shown_number.h"
#include "session/task_list.h"

namespace hitscope {

namespace {

constexpr int kProgressDelay = 500;     // milliseconds
constexpr int kBetweenFractions = 200;  // milliseconds: each has the whole window composed again
constexpr int kDone = 100;              // per cent
constexpr int kBetweenCells = 6;        // logical pixels, as QStatusBar has them
constexpr int kAroundMessage = 24;      // likewise, and the size grip

}  // namespace

StatusLine::StatusLine(const Session& session, QStatusBar& bar, QObject* parent)
    : QObject(parent), m_session(session), m_bar(bar) {
    makeProgress();
    m_pipeline = addCell(tr("Pipeline that applies the hits"));
    m_renderer = addCell({});
    m_target = addCell(tr("Selected target, and its vertices"));
    m_vertices = addCell(tr("Vertices of all targets"));
    m_hits = addCell(tr("Hits made so far"));
    m_frameRate = addCell(tr("Frames drawn in the last second"));
    setFrameRate({});
    connect(&session, &Session::sceneReplaced, this, &StatusLine::showScene);
    connect(&session.targets(), &SessionTargets::added, this, &StatusLine::showScene);
    connect(&session.targets(), &SessionTargets::removed, this, &StatusLine::showScene);
    connect(&session.targets(), &SessionTargets::changed, this, &StatusLine::showTarget);
    connect(&session.targets(), &SessionTargets::selectedChanged, this, &StatusLine::showTarget);
    connect(&session.hits(), &SessionHits::appended, this, &StatusLine::showHits);
    connect(&session.hits(), &SessionHits::reset, this, &StatusLine::showHits);
    connect(&session.readBack(), &ReadBack::capacityChanged, this, &StatusLine::showHits);
    connect(&session.settings(), &SessionSettings::pipelineChanged, this, &StatusLine::showPipeline);
    connect(&session.readBack(), &ReadBack::verdictChanged, this, &StatusLine::showRenderer);
    connect(&session.settings(), &SessionSettings::pipelineChanged, this, &StatusLine::showRenderer);
    connect(&bar, &QStatusBar::messageChanged, this, &StatusLine::makeRoom);
    showScene();
    showPipeline();
    showRenderer();
}

QLabel* StatusLine::addCell(const QString& toolTip) {
    auto* label = new QLabel(&m_bar);
    label->setTextFormat(Qt::PlainText);
    label->setToolTip(toolTip);
    label->setContentsMargins(6, 0, 6, 0);
    m_bar.addPermanentWidget(label);
    return label;
}

void StatusLine::makeProgress() {
    m_progress = new QWidget(&m_bar);
    m_doing = new QLabel(m_progress);
    m_doing->setTextFormat(Qt::PlainText);
    m_fraction = new QProgressBar(m_progress);
    m_fraction->setFixedWidth(140);
    m_fraction->setTextVisible(false);
    m_cancel = new QToolButton(m_progress);
    m_cancel->setObjectName(QStringLiteral("cancelTask"));
    m_cancel->setText(tr("Cancel"));
    auto* layout = new QHBoxLayout(m_progress);
    layout->setContentsMargins(6, 0, 0, 0);
    layout->addWidget(m_doing);
    layout->addWidget(m_fraction);
    layout->addWidget(m_cancel);
    m_bar.addWidget(m_progress);
    m_progress->hide();
    m_progressDelay.setSingleShot(true);
    m_progressDelay.setInterval(kProgressDelay);
    connect(&m_progressDelay, &QTimer::timeout, m_progress, [this] {
        m_bar.clearMessage();
        m_progress->show();
        makeRoom();
    });
    connect(m_cancel, &QToolButton::clicked, this, [this] { m_session.tasks().cancel(m_task); });
    // Not at once: a task can begin, go on and end in the middle of drawing a frame, and a QProgressBar
    // paints itself at once, which makes the context of the window current.
    m_taskChanged.setSingleShot(true);
    connect(&m_taskChanged, &QTimer::timeout, this, &StatusLine::showTask);
    connect(&m_session.tasks(), &TaskList::changed, this, [this] {
        const TaskList::Task* task = m_session.tasks().current();
        if (task == nullptr || task->id != m_task) {
            m_taskChanged.start(0);
        } else if (!m_taskChanged.isActive()) {
            m_taskChanged.start(kBetweenFractions);
        }
    });
}

/// Shown only if it is not over soon.
void StatusLine::showTask() {
    const TaskList::Task* task = m_session.tasks().current();
    if (task == nullptr) {
        m_task = 0;
        m_progressDelay.stop();
        m_progress->hide();
        makeRoom();
        return;
    }
    if (task->id != m_task) {
        m_task = task->id;
        m_taskTime.start();
        if (!m_progress->isVisible()) {
            m_progressDelay.start();
        }
    }
    const std::size_t others = m_session.tasks().size() - 1;
    const QString what =
        withRemaining(task->what, task->fraction, 1.0e-3 * static_cast<double>(m_taskTime.elapsed()));
    m_doing->setText(others == 0 ? what : tr("%1 (%2 more)").arg(what, QString::number(others)));
    m_fraction->setMaximum(task->fraction < 0.0 ? 0 : kDone);
    m_fraction->setValue(task->fraction < 0.0 ? 0 : static_cast<int>(std::lround(task->fraction * kDone)));
    m_cancel->setVisible(static_cast<bool>(task->cancel));
    m_cancel->setToolTip(task->cancelHelp);
    makeRoom();
}

/// In a narrow window neither the renderer nor, if need be, the pipeline is shown while something takes a
/// while or is said: what they are does not change.
void StatusLine::makeRoom() {
    const QString said = m_bar.currentMessage();
    const bool isWanted = m_progress->isVisible() || !said.isEmpty();
    int wanted = said.isEmpty() ? m_progress->sizeHint().width()
                                : m_bar.fontMetrics().horizontalAdvance(said) + kAroundMessage;
    for (const QLabel* cell : {m_pipeline, m_renderer, m_target, m_vertices, m_hits, m_frameRate}) {
        if (cell == m_renderer || cell == m_pipeline || cell->isVisible()) {
            wanted += cell->sizeHint().width() + kBetweenCells;
        }
    }
    const bool fits = !isWanted || wanted <= m_bar.width();
    const int withoutRenderer = wanted - m_renderer->sizeHint().width() - kBetweenCells;
    m_renderer->setVisible(!m_rendererName.isEmpty() && fits);
    m_pipeline->setVisible(fits || withoutRenderer <= m_bar.width());
    layOut();
    if (m_progress->isVisible() && m_doing->width() < m_doing->sizeHint().width()) {
        m_renderer->hide();  // the bar's edges take some, too
        layOut();
    }
}

/// Now: the next turn of the event loop may draw for long, and new words would be cut off meanwhile.
void StatusLine::layOut() {
    for (QLayout* layout : {m_progress->layout(), m_bar.layout()}) {
        layout->activate();
    }
}

void StatusLine::setRenderer(const QString& name) {
    m_rendererName = name;
    showRenderer();
}

/// "bit-exact" is said of the active pipeline, and only of what was compared.
void StatusLine::showRenderer() {
    const RendererVerdict& verdict = m_session.readBack().verdict();
    const PipelineVerdict* active = verdict.of(m_session.settings().pipeline());
    QString text = m_rendererName;
    if (active != nullptr && active->whyNot.empty()) {
        text += active->isExact() ? tr(", bit-exact") : tr(", not bit-exact");
    }
    QString toolTip = tr("Graphics driver, and how the pipelines compare with the reference on it");
    for (const PipelineTraits& traits : allPipelines()) {
        toolTip += u'\n' + verdictText(verdict, traits.kind);
    }
    if (verdict.picking) {
        toolTip += u'\n' + tr("Picking: %1").arg(verdictText(*verdict.picking));
    }
    m_renderer->setText(text);
    m_renderer->setToolTip(toolTip);
    makeRoom();
}

void StatusLine::setFrameRate(const FrameTimes::Summary& summary, const PictureDetail& detail) {
    m_frameRate->setText(frameRateText(summary, detail));
}

void StatusLine::showScene() {
    std::size_t vertices = 0;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        vertices += target->deformed.original().vertexCount();
    }
    m_vertices->setText(tr("%Ln {vertex|vertices} in all", nullptr, trCount(vertices)));
    m_vertices->setToolTip(tr("Vertices of all targets (%1)").arg(countText(m_session.targets().size())));
    showTarget();
    showHits();
}

void StatusLine::showTarget() {
    const Target* target = m_session.targets().find(m_session.targets().selected());
    m_target->setText(target != nullptr ? tr("%1: %Ln {vertex|vertices}", nullptr,
                                             trCount(target->deformed.original().vertexCount()))
                                              .arg(target->name)
                                        : tr("no target selected"));
    m_vertices->setVisible(target == nullptr || m_session.targets().size() > 1);
}

void StatusLine::showHits() {
    const std::size_t hits = m_session.hits().history().size();
    QString text = tr("%Ln {hit|hits}", nullptr, trCount(hits));
    const CapacityReport& report = m_session.readBack().capacity();
    if (report.capacity) {
        text = report.perTarget ? tr("%1, max %2 on a target").arg(text, countText(*report.capacity))
                                : tr("%1 of %2").arg(text, countText(*report.capacity));
    }
    if (m_session.hits().disabled() > 0) {
        text += tr(", %1 disabled").arg(countText(m_session.hits().disabled()));
    }
    if (m_session.readBack().droppedHits() > 0) {
        text += tr(", %1 dropped").arg(countText(m_session.readBack().droppedHits()));
    }
    m_hits->setText(text);
    QString tip = tr("Hits made so far");
    if (report.capacity) {
        tip += u'\n' + (report.perTarget ? tr("The pipeline keeps the last %1 on each target.")
                                         : tr("The pipeline keeps the last %1 of the scene."))
                           .arg(countText(*report.capacity));
        if (report.byDriver) {
            tip += u'\n' + tr("This graphics driver has room for no more.");
        }
    }
    m_hits->setToolTip(tip);
}

void StatusLine::showPipeline() {
    for (const PipelineTraits& traits : allPipelines()) {
        if (traits.kind == m_session.settings().pipeline()) {
            m_pipeline->setText(QString::fromUtf8(traits.name));
        }
    }
}

}  // namespace hitscope
