// SPDX-License-Identifier: GPL-3.0-or-later
#include <QByteArrayView>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QLocale>
#include <QTextStream>
#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

#include "cli/command_line.h"
#include "cli/interruption.h"
#include "cli/outputs.h"
#include "cli/verbs.h"
#include "core/memory.h"
#include "usage/help_text.h"

namespace {

using namespace hitscope::cli;

const Verb* verbNamed(const std::vector<Verb>& verbs, const QString& name) {
    const auto found = std::find_if(verbs.begin(), verbs.end(),
                                    [&name](const Verb& verb) { return verb.usage.lastWord() == name; });
    return found == verbs.end() ? nullptr : &*found;
}

/// Pictures may have text in them, for which Qt wants fonts, and for these a platform: one without windows.
/// Help is for who waits for it, and takes neither.
std::unique_ptr<QCoreApplication> makeApplication(int& argc, char** argv) {
    const Verb* verb = argc > 1 ? verbNamed(verbs(), QString::fromLocal8Bit(argv[1])) : nullptr;
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
        given.complain(wrongOutputs(given));
    }
    if (given.error().isEmpty()) {
        keepOutputs(given);
        const hitscope::Status there = checkFolders(given);
        status = there ? verb.run(given) : finish(there.error());
    }
    return given.error().isEmpty() ? status : wrongUsage(given.error(), verb.usage.name);
}

/// Qt would read it as some other name, and a file of that name would be written.
const char* firstNotUtf8(int argc, char** argv) {
    const auto found = std::find_if(
        argv + 1, argv + argc, [](const char* argument) { return !QByteArrayView(argument).isValidUtf8(); });
    return found == argv + argc ? nullptr : *found;
}

bool isHelp(const QString& word) {
    return word == QLatin1String("--help") || word == QLatin1String("-h");
}

/// "a, b or c"
QString enumerated(const std::vector<Verb>& verbs) {
    QStringList names;
    for (const Verb& verb : verbs) {
        names << verb.usage.lastWord();
    }
    const QString last = names.takeLast();
    return names.isEmpty() ? last : names.join(QStringLiteral(", ")) + QStringLiteral(" or ") + last;
}

/// `words`: what follows the verb, another one.
int runWithin(const Verb& verb, const QStringList& words) {
    const QString name = words.value(0);
    if (isHelp(name)) {
        QTextStream(stdout) << helpText(programUsage(), verb.usage);
        return kGood;
    }
    const Verb* within = verbNamed(verb.verbs, name);
    if (within == nullptr) {
        return wrongUsage((name.isEmpty() ? QString() : QStringLiteral("there is no \"%1\"; ").arg(name)) +
                              QStringLiteral("%1 takes %2.").arg(verb.usage.name, enumerated(verb.verbs)),
                          verb.usage.name);
    }
    return runVerb(*within, words.mid(1));
}

int run(const QStringList& arguments) {
    const QString name = arguments.value(1);
    if (isHelp(name)) {
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
    const Verb* verb = verbNamed(verbs(), name);
    if (verb == nullptr) {
        return wrongUsage(QStringLiteral("there is no verb \"%1\".").arg(name));
    }
    return verb->verbs.empty() ? runVerb(*verb, arguments.mid(2)) : runWithin(*verb, arguments.mid(2));
}

}  // namespace

int main(int argc, char** argv) {
    hitscope::keepFreedMemory();
    if (const char* const name = firstNotUtf8(argc, argv)) {
        return finish(hitscope::Error{"The file's name is not UTF-8.", QString::fromUtf8(name).toStdString(),
                                      "Rename the file."});
    }
    const std::unique_ptr<QCoreApplication> app = makeApplication(argc, argv);
    QLocale::setDefault(QLocale::c());  // scripts read what it writes, pictures among it
    QCoreApplication::setApplicationName(QStringLiteral("hitscope-cli"));
    QCoreApplication::setApplicationVersion(QStringLiteral(HITSCOPE_VERSION));
    endInOrder();

    return flushOutput(run(QCoreApplication::arguments()));
}
