// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/help_actions.h"

#include <QAction>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>

#include "app/actions/menu_building.h"
#include "app/dialogs/dialogs.h"
#include "app/dialogs/text_window.h"
#include "app/overlays/keys_overlay.h"
#include "models/verdict_text.h"
#include "panels/help/help_text.h"
#include "session/session.h"
#include "session/task_list.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kKillAfter = 1000;  // milliseconds

}  // namespace

QString commandLineProgram() {
    const QDir here(QCoreApplication::applicationDirPath());
    for (const QString& candidate :
         {qEnvironmentVariable("HITSCOPE_CLI"), here.filePath(QStringLiteral("hitscope-cli")),
          here.filePath(QStringLiteral("../bin/hitscope-cli"))}) {
        const QFileInfo info(candidate);
        if (info.isFile() && info.isExecutable()) {
            return candidate;
        }
    }
    return {};
}

HelpActions::HelpActions(Session& session, Viewport& viewport, QMainWindow& window)
    : QObject(&window), m_session(session), m_viewport(viewport), m_window(window) {}

HelpActions::~HelpActions() {
    if (m_process) {
        m_process->disconnect(this);
        m_process->kill();
        m_process->waitForFinished(kKillAfter);
    }
}

void HelpActions::fill(QMenu& menu) {
    addAction(menu, tr("&Keys and Mouse"), Qt::Key_F1, this, [this] { showKeys(); });
    menu.addSeparator();
    connect(menu.addAction(tr("&Graphics…")), &QAction::triggered, this, &HelpActions::showGraphics);
    m_measure = menu.addAction(tr("&Measure the Paper's Tables"));
    m_measure->setToolTip(
        tr("The frame rates of the paper's nine scenes under every pipeline, on this machine: takes some "
           "minutes"));
    connect(m_measure, &QAction::triggered, this, [this] { measurePaper(); });
    menu.addSeparator();
    addAction(menu, tr("&About Hitscope"), {}, this, [this] { showAboutProgram(); });
    follow();
}

void HelpActions::showKeys() {
    auto* overlay = m_window.findChild<KeysOverlay*>();
    if (overlay == nullptr) {
        overlay = new KeysOverlay(m_window);
    }
    const Navigation& navigation = m_viewport.navigation();
    overlay->toggle({mouseKeys(navigation.preset(), navigation.orbitMode()), heldKeys()});
}

void HelpActions::showAboutProgram() {
    showAbout(&m_window, m_viewport.scene().rendererName(), m_viewport.scene().rendererVersion(),
              verdictText(m_session.readBack().verdict(), m_session.settings().pipeline()));
}

void HelpActions::follow() {
    if (m_measure != nullptr) {
        enableIf(*m_measure, m_process == nullptr,
                 tr("They are being measured; the status bar can cancel it."));
    }
}

TextWindow* HelpActions::showText(const QString& name, const QString& title, const QString& text) {
    delete m_window.findChild<TextWindow*>(name);  // an earlier one says what was
    auto* window = new TextWindow(title, text, &m_window);
    window->setObjectName(name);
    window->show();
    return window;
}

void HelpActions::showGraphics() {
    const Result<QString> report = m_viewport.scene().graphicsReport();
    if (!report) {
        Q_EMIT failed(report.error());
        return;
    }
    showText(QStringLiteral("graphics"), tr("Graphics"), report.value());
}

void HelpActions::measurePaper(const QStringList& arguments) {
    if (m_process) {
        return;
    }
    const QString program = commandLineProgram();
    if (program.isEmpty()) {
        Q_EMIT failed(Error{"The program hitscope-cli, which measures, is missing.", "",
                            "Install Hitscope again, or put hitscope-cli beside it."});
        return;
    }
    m_said.clear();
    m_begun.clear();
    m_cancelled = false;
    m_process = std::make_unique<QProcess>();
    m_task = std::make_unique<TaskProgress>(
        m_session.tasks(), tr("Measuring the paper's tables"),
        [this] {
            m_cancelled = true;
            m_process->kill();
        },
        tr("Stop measuring; there are no tables then"));
    connect(m_process.get(), &QProcess::readyReadStandardError, this, &HelpActions::takeProgress);
    connect(m_process.get(), &QProcess::finished, this, &HelpActions::takeTables);
    connect(m_process.get(), &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) {
            const QString why = m_process->errorString();
            end();
            Q_EMIT failed(Error{"hitscope-cli cannot be started: " + why.toStdString() + ".", "", ""});
        }
    });
    m_process->start(
        program, QStringList{QStringLiteral("bench"), QStringLiteral("paper"), QStringLiteral("--progress")} +
                     arguments);
    follow();
}

/// Lines "progress 0.25 row 3: Compute", and what went wrong.
void HelpActions::takeProgress() {
    m_begun += m_process->readAllStandardError();
    for (qsizetype end = m_begun.indexOf('\n'); end >= 0; end = m_begun.indexOf('\n')) {
        const QByteArray line = m_begun.left(end);
        m_begun.remove(0, end + 1);
        const QList<QByteArray> words = line.split(' ');
        if (words.value(0) != "progress") {
            m_said += line + '\n';
            continue;
        }
        m_task->report(words.value(1).toDouble());
        QString what = QString::fromUtf8(words.mid(2).join(' '));
        what.remove(QStringLiteral(", textures none"));  // as always here
        m_task->say(tr("Paper's tables: %1").arg(what));
    }
}

void HelpActions::takeTables(int status, QProcess::ExitStatus how) {
    takeProgress();
    const QString tables = QString::fromUtf8(m_process->readAllStandardOutput());
    const QString said = QString::fromUtf8(m_said + m_begun).trimmed();
    end();
    if (m_cancelled) {
        return;
    }
    if (how != QProcess::NormalExit || status != 0) {
        Q_EMIT failed(Error{"The paper's tables could not be measured.", said.toStdString(), ""});
        return;
    }
    showText(QStringLiteral("paperTables"), tr("The Paper's Tables on This Machine"), tables)
        ->offerSaving(QStringLiteral("paper_tables.txt"));
}

void HelpActions::end() {
    m_task.reset();
    m_process.release()->deleteLater();  // it may be what calls
    follow();
}

}  // namespace hitscope
