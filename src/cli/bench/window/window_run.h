// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QProcess>
#include <QStringList>
#include <memory>
#include <utility>
#include <vector>

#include "core/result.h"

namespace hitscope::bench {

/// Where hitscope-bench-window is: HITSCOPE_BENCH_WINDOW in the environment, beside the running program, or
/// in ../libexec/hitscope, in this order; empty when it is in none of them.
[[nodiscard]] QString windowProgramPath();

/// What windows are measured on: the display at hand, or, where there is none, one in memory (Xvfb), which
/// ends with this.
class WindowRoom {
public:
    /// width, height: of the window, pixels. The error says what to install.
    [[nodiscard]] static Result<std::unique_ptr<WindowRoom>> open(int width, int height);
    ~WindowRoom();

    /// Runs the program of the window on one mesh file. `what`: "latency" or "memory". Returns what it
    /// measured; the error is in its words.
    [[nodiscard]] Result<QJsonObject> measure(const QString& what, const QString& mesh,
                                              const QStringList& options) const;
    [[nodiscard]] bool isVirtual() const { return m_server != nullptr; }

private:
    WindowRoom(QString program, int width, int height)
        : m_program(std::move(program)), m_width(width), m_height(height) {}
    Status startServer();

    QString m_program;
    int m_width;
    int m_height;
    std::unique_ptr<QProcess> m_server;  ///< null: the display at hand
    QString m_display;                   ///< ":7", of the server
};

/// What a report of windows starts with. `measured` is what the program of the window said of its renderer.
[[nodiscard]] std::vector<std::pair<QString, QString>> windowReportHeader(const WindowRoom& room,
                                                                          const QJsonObject& measured,
                                                                          int width, int height);

}  // namespace hitscope::bench
