// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QMessageBox>
#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "app/end_signals.h"
#include "app/main_window.h"
#include "app/no_window.h"
#include "app/theme.h"
#include "core/kept_libraries.h"
#include "core/memory.h"
#include "models/plain_text.h"
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

bool hasDisplay() {
    return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") ||
           !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
}

constexpr const char* kProgram = "hitscope";

/// Returns the status to end with.
int saysNo(const QString& why) {
    return hitscope::saysNo(kProgram, why);
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
    std::optional<hitscope::DisplayRefusal> refusal(std::in_place, kProgram,
                                                    QStringLiteral("hitscope-cli works without a display."));
    const QApplication application(argc, argv);
    refusal.reset();
    QApplication::setApplicationDisplayName(QStringLiteral("Hitscope"));
    QApplication::setDesktopFileName(QStringLiteral("hitscope"));
    QApplication::setStyle(hitscope::makeStyle());
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/hitscope.svg")));
    describe(parser);
    parser.process(application);

    if (const QString why = hitscope::whyNoWindows(); !why.isEmpty()) {
        return saysNo(why + QStringLiteral(" hitscope-cli works without a display."));
    }
    if (const hitscope::Status openGl = hitscope::checkOpenGl(); !openGl) {
        const QString text = QString::fromStdString(openGl.error().message());
        const int status = saysNo(text);  // for who sees no box
        QMessageBox::critical(nullptr, QApplication::applicationDisplayName(), hitscope::asPlainText(text));
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
