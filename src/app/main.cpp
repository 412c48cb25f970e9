// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QMessageBox>
#include <algorithm>
#include <cstdio>
#include <span>
#include <string_view>

#include "app/end_signals.h"
#include "app/main_window.h"
#include "app/theme.h"
#include "core/kept_libraries.h"
#include "core/memory.h"
#include "session/session.h"
#include "session/welcome.h"
#include "usage/usage.h"
#include "viewport/surface/surface_format.h"

namespace {

void describe(QCommandLineParser& parser) {
    const hitscope::Usage& usage = hitscope::windowUsage().all;
    parser.setApplicationDescription(usage.description);
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("file"), QStringLiteral("Session or mesh to open."),
                                 usage.files);
}

/// Help and version are for terminals, where there may be no display.
bool asksOnlyForWords(std::span<char*> arguments) {
    return std::any_of(arguments.begin(), arguments.end(), [](std::string_view argument) {
        return argument == "-h" || argument == "--help" || argument == "--help-all" || argument == "-v" ||
               argument == "--version";
    });
}

/// Qt's platforms without windows that OpenGL draws into; a QOpenGLWidget crashes there.
bool hasWindows(const QString& platform) {
    return platform != QLatin1String("offscreen") && !platform.startsWith(QLatin1String("minimal")) &&
           platform != QLatin1String("vnc") && platform != QLatin1String("linuxfb");
}

bool hasDisplay() {
    return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") ||
           !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
}

}  // namespace

int main(int argc, char** argv) {
    hitscope::keepFreedMemory();
    QCoreApplication::setOrganizationName(QStringLiteral("Hitscope"));
    QCoreApplication::setApplicationName(QStringLiteral("hitscope"));
    QCoreApplication::setApplicationVersion(QStringLiteral(HITSCOPE_VERSION));
    QCommandLineParser parser;
    if (asksOnlyForWords({argv, static_cast<std::size_t>(argc)})) {
        const QCoreApplication application(argc, argv);
        describe(parser);
        parser.process(application);
        return 0;
    }
    if (!hasDisplay()) {
        std::fputs("hitscope: there is no display to open a window on. hitscope-cli works without one.\n",
                   stderr);
        return 1;
    }

    // Before the application: Qt makes its shared context with the default format.
    hitscope::MainWindow::setSurfaceFormat();
    const QApplication application(argc, argv);
    QApplication::setApplicationDisplayName(QStringLiteral("Hitscope"));
    QApplication::setDesktopFileName(QStringLiteral("hitscope"));
    QApplication::setStyle(hitscope::makeStyle());
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/hitscope.svg")));
    describe(parser);
    parser.process(application);

    if (const QString platform = QGuiApplication::platformName(); !hasWindows(platform)) {
        std::fprintf(
            stderr,
            "hitscope: Qt's platform \"%s\" has no windows to draw into. Unset QT_QPA_PLATFORM, or set "
            "it to xcb or wayland; hitscope-cli works without a display.\n",
            qPrintable(platform));
        return 1;
    }
    if (const hitscope::Status openGl = hitscope::checkOpenGl(); !openGl) {
        std::fprintf(stderr, "hitscope: %s\n", openGl.error().message().c_str());
        QMessageBox::critical(nullptr, QApplication::applicationDisplayName(),
                              QString::fromStdString(openGl.error().message()));
        return 1;
    }

    hitscope::Session session;
    const bool isBare = parser.positionalArguments().isEmpty();
    if (isBare) {  // else undo would lead to a scene that nobody asked for
        hitscope::loadWelcomeScene(session);
    }
    hitscope::MainWindow window(session);
    window.show();
    if (isBare) {
        window.showFirstSteps();
    }
    window.offerRecovery();
    window.openFiles(parser.positionalArguments());
    const hitscope::EndSignals signalsToEnd;
    QObject::connect(&signalsToEnd, &hitscope::EndSignals::caught, &window, [&window](int signal) {
        window.endInOrder();
        QApplication::exit(128 + signal);  // as shells say it; a running export is finished first
    });
    return QApplication::exec();
}
