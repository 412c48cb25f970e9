// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QGuiApplication>
#include <QLocale>
#include <QTextStream>
#include <algorithm>
#include <memory>
#include <string_view>

#include "cli/bench/bench_command.h"
#include "cli/command_line.h"
#include "cli/interruption.h"
#include "cli/verbs.h"
#include "core/memory.h"
#include "usage/help_text.h"

namespace {

using namespace hitscope::cli;

const Verb* verbNamed(const QString& name) {
    const auto found = std::find_if(verbs().begin(), verbs().end(),
                                    [&name](const Verb& verb) { return verb.usage.name == name; });
    return found == verbs().end() ? nullptr : &*found;
}

/// Pictures may have text in them, for which Qt wants fonts, and for these a platform: one without windows.
/// Help is for who waits for it, and takes neither.
std::unique_ptr<QCoreApplication> makeApplication(int& argc, char** argv) {
    const Verb* verb = argc > 1 ? verbNamed(QString::fromLocal8Bit(argv[1])) : nullptr;
    const bool asksForHelp = std::any_of(argv + 1, argv + argc, [](std::string_view argument) {
        return argument == "--help" || argument == "-h";
    });
    if (verb == nullptr || !verb->needsFonts || asksForHelp) {
        return std::make_unique<QCoreApplication>(argc, argv);
    }
    qputenv("QT_QPA_PLATFORM", "offscreen");
    // Qt warns where there is no XDG_RUNTIME_DIR, as on servers, though nothing here needs one.
    static QtMessageHandler usual = nullptr;
    usual =
        qInstallMessageHandler([](QtMsgType type, const QMessageLogContext& context, const QString& text) {
            if (type != QtWarningMsg) {
                usual(type, context, text);
            }
        });
    auto application = std::make_unique<QGuiApplication>(argc, argv);
    qInstallMessageHandler(usual);
    return application;
}

int runVerb(const Verb& verb, const QStringList& arguments) {
    hitscope::Invocation given(verb.usage, arguments);
    if (given.error().isEmpty() && given.wantsHelp()) {
        QTextStream(stdout) << helpText(programUsage(), verb.usage);
        return kGood;
    }
    int status = kWrongUsage;
    if (given.error().isEmpty()) {
        setQuiet(verb.usage.find(QStringLiteral("quiet")) != nullptr && given.isSet("quiet"));
        status = verb.run(given);
    }
    return given.error().isEmpty() ? status : wrongUsage(given.error(), verb.usage.name);
}

int run(QStringList arguments) {
    const QString name = arguments.value(1);
    if (name == QLatin1String("--help") || name == QLatin1String("-h")) {
        QTextStream(stdout) << helpText(programUsage());
        return kGood;
    }
    if (name == QLatin1String("--version") || name == QLatin1String("-v")) {
        QTextStream(stdout) << "hitscope-cli " << QCoreApplication::applicationVersion() << "\n";
        return kGood;
    }
    if (name.isEmpty()) {
        return wrongUsage(QStringLiteral("a verb is missing."));
    }
    const Verb* verb = verbNamed(name);
    if (verb == nullptr) {
        return wrongUsage(QStringLiteral("there is no verb \"%1\".").arg(name));
    }
    arguments.removeAt(1);
    if (!verb->run) {
        return hitscope::bench::benchCommand(arguments);
    }
    arguments.removeFirst();
    return runVerb(*verb, arguments);
}

}  // namespace

int main(int argc, char** argv) {
    hitscope::keepFreedMemory();
    const std::unique_ptr<QCoreApplication> app = makeApplication(argc, argv);
    QLocale::setDefault(QLocale::c());  // scripts read what it writes, pictures among it
    QCoreApplication::setApplicationName(QStringLiteral("hitscope-cli"));
    QCoreApplication::setApplicationVersion(QStringLiteral(HITSCOPE_VERSION));
    endInOrder();

    return flushOutput(run(QCoreApplication::arguments()));
}
