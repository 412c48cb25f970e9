// SPDX-License-Identifier: GPL-3.0-or-later
// hitscope-bench-window latency|memory FILE: started by hitscope-cli bench. One mesh; what was measured is
// JSON on the standard output.
#include <QApplication>
#include <QCommandLineParser>
#include <QJsonArray>
#include <QJsonDocument>
#include <cstdio>
#include <optional>
#include <utility>

#include "app/no_window.h"
#include "app/theme.h"
#include "bench_window/driven_window.h"
#include "bench_window/latency.h"
#include "bench_window/memory.h"
#include "bench_window/passing_folder.h"
#include "core/kept_libraries.h"
#include "core/memory.h"
#include "viewport/surface/surface_format.h"
#include "viewport/viewport.h"

namespace {

using hitscope::bench::DrivenWindow;

constexpr const char* kProgram = "hitscope-bench-window";

QCommandLineOption option(const char* name, const char* value) {
    return {QLatin1String(name), {}, QStringLiteral("n"), QLatin1String(value)};
}

int fail(const QString& why) {
    return hitscope::saysNo(kProgram, why);
}

QJsonObject measure(const QCommandLineParser& given, DrivenWindow& window) {
    const QString file = given.positionalArguments()[1];
    const auto number = [&](const char* name) { return given.value(QLatin1String(name)).toInt(); };
    if (given.positionalArguments()[0] == QLatin1String("memory")) {
        return hitscope::bench::measureMemory(window, file, number("hits"));
    }
    return hitscope::bench::measureLatency(
        window, file,
        {number("least"), number("most"), given.value(QStringLiteral("seconds")).toDouble(),
         number("scattered")});
}

}  // namespace

int main(int argc, char** argv) {
    hitscope::keepFreedMemory();
    QCoreApplication::setOrganizationName(QStringLiteral("Hitscope"));
    QCoreApplication::setApplicationName(QStringLiteral("hitscope-bench"));
    hitscope::MainWindow::setSurfaceFormat();
    std::optional<hitscope::DisplayRefusal> refusal(
        std::in_place, kProgram,
        QStringLiteral("Unset DISPLAY and WAYLAND_DISPLAY to measure on a display in memory."));
    const QApplication application(argc, argv);
    refusal.reset();
    hitscope::bench::leaveNothingBehind();
    QApplication::setStyle(hitscope::makeStyle());
    QCommandLineParser given;
    for (const auto& [name, value] :
         {std::pair{"width", "1280"}, std::pair{"height", "800"}, std::pair{"least", "3"},
          std::pair{"most", "10"}, std::pair{"seconds", "2"}, std::pair{"scattered", "10000"},
          std::pair{"hits", "500"}}) {
        given.addOption(option(name, value));
    }
    given.process(application);
    if (given.positionalArguments().size() != 2) {
        return fail(QStringLiteral("it is started by hitscope-cli bench latency and bench memory."));
    }
    if (const QString why = hitscope::whyNoWindows(); !why.isEmpty()) {
        return fail(why);
    }
    if (const hitscope::Status openGl = hitscope::checkOpenGl(); !openGl) {
        return fail(QString::fromStdString(openGl.error().message()));
    }
    DrivenWindow window(
        {given.value(QStringLiteral("width")).toInt(), given.value(QStringLiteral("height")).toInt()});
    QJsonObject measured = window.error().isEmpty() ? measure(given, window) : QJsonObject();
    if (!window.error().isEmpty()) {
        return fail(window.error());
    }
    measured[QStringLiteral("renderer")] = window.viewport().scene().rendererName();
    measured[QStringLiteral("version")] = window.viewport().scene().rendererVersion();
    std::fputs(QJsonDocument(measured).toJson(QJsonDocument::Compact).constData(), stdout);
    return std::fflush(stdout) == 0 ? 0 : 1;
}
