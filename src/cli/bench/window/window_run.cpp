// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/window/window_run.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QProcessEnvironment>
#include <QStandardPaths>

#include "cli/bench/report_header.h"
#include "cli/bench/window/bound_process.h"
#include "gl/context.h"

namespace hitscope::bench {

namespace {

constexpr int kServerPatience = 30'000;  // milliseconds

bool isDisplayAtHand() {
    return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
}

}  // namespace

QString windowProgramPath() {
    const QDir here(QCoreApplication::applicationDirPath());
    for (const QString& candidate :
         {qEnvironmentVariable("HITSCOPE_BENCH_WINDOW"),
          here.filePath(QStringLiteral("hitscope-bench-window")),
          here.filePath(QStringLiteral("../libexec/hitscope/hitscope-bench-window"))}) {
        const QFileInfo program(candidate);
        if (program.isFile() && program.isExecutable()) {
            return candidate;
        }
    }
    return {};
}

Result<std::unique_ptr<WindowRoom>> WindowRoom::open(int width, int height) {
    const QString program = windowProgramPath();
    if (program.isEmpty()) {
        return Error{"The program hitscope-bench-window, which uses the window, is missing.", "",
                     "Install Hitscope again, or set HITSCOPE_BENCH_WINDOW to where it is."};
    }
    std::unique_ptr<WindowRoom> room(new WindowRoom(program, width, height));
    if (!isDisplayAtHand()) {
        if (Status started = room->startServer(); !started) {
            return started.error();
        }
    }
    return room;
}

WindowRoom::~WindowRoom() {
    if (m_server) {
        m_server->terminate();
        m_server->waitForFinished(kServerPatience);
    }
}

Status WindowRoom::startServer() {
    const QString xvfb = QStandardPaths::findExecutable(QStringLiteral("Xvfb"));
    if (xvfb.isEmpty()) {
        return Error{"There is no display to open a window on, and no Xvfb to make one in memory.", "",
                     "Set DISPLAY, or install Xvfb (on Debian: apt-get install xvfb)."};
    }
    m_server = std::make_unique<QProcess>();
    bindToThis(*m_server);
    m_server->setStandardErrorFile(QProcess::nullDevice());
    // The server chooses a free number, and writes it when it is ready.
    m_server->start(xvfb, {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"),
                           QStringLiteral("0"), QStringLiteral("%1x%2x24").arg(m_width).arg(m_height),
                           QStringLiteral("-nolisten"), QStringLiteral("tcp")});
    QByteArray number;
    while (!number.endsWith('\n') && m_server->waitForReadyRead(kServerPatience)) {
        number += m_server->readAllStandardOutput();
    }
    if (!number.endsWith('\n')) {
        return Error{"Xvfb does not start.", xvfb.toStdString(),
                     "Run \"Xvfb -displayfd 1\" to see why, or set DISPLAY."};
    }
    m_display = QLatin1Char(':') + QString::fromLatin1(number.trimmed());
    return Done{};
}

Result<QJsonObject> WindowRoom::measure(const QString& what, const QString& mesh,
                                        const QStringList& options) const {
    QProcess window;
    bindToThis(window);
    if (isVirtual()) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("DISPLAY"), m_display);
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("xcb"));
        window.setProcessEnvironment(environment);
    }
    window.start(m_program, QStringList{what, mesh, QStringLiteral("--width"), QString::number(m_width),
                                        QStringLiteral("--height"), QString::number(m_height)} +
                                options);
    if (!window.waitForFinished(-1) || window.exitStatus() != QProcess::NormalExit) {
        const QByteArray said = window.readAllStandardError().trimmed().split('\n').first();
        return Error{
            "The program that uses the window ended by itself: " + window.errorString().toStdString() +
                (said.isEmpty() ? "." : ". It said: " + said.toStdString()),
            m_program.toStdString(),
            "Check DISPLAY; otherwise, please report this with the renderer's name."};
    }
    const QJsonObject measured = QJsonDocument::fromJson(window.readAllStandardOutput()).object();
    if (window.exitCode() != 0 || measured.isEmpty()) {
        return Error{"The window could not be measured: " +
                         window.readAllStandardError().trimmed().split('\n').last().toStdString(),
                     "", ""};
    }
    return measured;
}

std::vector<std::pair<QString, QString>> windowReportHeader(const WindowRoom& room,
                                                            const QJsonObject& measured, int width,
                                                            int height) {
    gl::RendererInfo renderer;
    renderer.renderer = measured[QStringLiteral("renderer")].toString().toStdString();
    renderer.version = measured[QStringLiteral("version")].toString().toStdString();
    return machineHeader(
        renderer, QStringLiteral("a window of %1x%2 pixels%3")
                      .arg(width)
                      .arg(height)
                      .arg(room.isVirtual() ? QStringLiteral(", on a display in memory (Xvfb)") : QString()));
}

}  // namespace hitscope::bench
