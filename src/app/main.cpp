// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QMessageBox>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
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

/// Returns the status to end with.
int saysNo(const QString& why) {
    std::fprintf(stderr, "hitscope: %s\n", qPrintable(why));
    return 1;
}

/// While Qt connects to the display: where it cannot, it ends the program by a signal, after a page of
/// advice.
void sayWhyThereIsNoWindow(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    static QString reason;
    const bool isOfPlatform =
        context.category != nullptr && std::string_view(context.category).starts_with("qt.qpa");
    if (type == QtFatalMsg) {
        std::_Exit(saysNo(QStringLiteral("no window can be opened: %1. hitscope-cli works without a display.")
                              .arg(reason.isEmpty() ? text.section(u'\n', 0, 0) : reason)));
    }
    if (isOfPlatform && reason.isEmpty()) {
        reason = text.trimmed();
    } else if (!isOfPlatform) {
        std::fprintf(stderr, "%s\n", qPrintable(text));
    }
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
        return saysNo(
            QStringLiteral("there is no display to open a window on. hitscope-cli works without one."));
    }

    // Before the application: Qt makes its shared context with the default format.
    hitscope::MainWindow::setSurfaceFormat();
    qInstallMessageHandler(sayWhyThereIsNoWindow);
    const QApplication application(argc, argv);
    qInstallMessageHandler(nullptr);
    QApplication::setApplicationDisplayName(QStringLiteral("Hitscope"));
    QApplication::setDesktopFileName(QStringLiteral("hitscope"));
    QApplication::setStyle(hitscope::makeStyle());
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/hitscope.svg")));
    describe(parser);
    parser.process(application);

    if (const QString platform = QGuiApplication::platformName(); !hasWindows(platform)) {
        return saysNo(QStringLiteral("Qt's platform \"%1\" has no windows to draw into. Unset "
                                     "QT_QPA_PLATFORM, or set it to xcb or wayland; hitscope-cli works "
                                     "without a display.")
                          .arg(platform));
    }
    if (const hitscope::Status openGl = hitscope::checkOpenGl(); !openGl) {
        const QString text = QString::fromStdString(openGl.error().message());
        const int status = saysNo(text);  // for who sees no box
        QMessageBox::critical(nullptr, QApplication::applicationDisplayName(), text);
        return status;
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
