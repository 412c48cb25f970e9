// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCommandLineParser>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QLocale>
#include <QTextStream>
#include <limits>
#include <memory>
#include <string_view>

#include "cli/bench/bench_command.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/pipeline_argument.h"
#include "cli/shoot.h"
#include "cli/verify.h"
#include "core/memory.h"

namespace {

using hitscope::cli::finish;
using hitscope::cli::wrongUsage;

int demo(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Shoots at the paper's scene, or at one mesh, with no display; compares the pipelines and writes\n"
        "before.png, after.png, wireframe.png and deformed.obj. The exit status is 1 where the mesh is not\n"
        "what the reference makes of the hits."));
    parser.addHelpOption();
    const QCommandLineOption out(QStringLiteral("out"), QStringLiteral("Folder for the results."),
                                 QStringLiteral("folder"), QStringLiteral("hitscope-demo"));
    const QCommandLineOption shots(QStringLiteral("shots"), QStringLiteral("Number of shots, 1 to 100000."),
                                   QStringLiteral("number"), QStringLiteral("50"));
    const QCommandLineOption seed(QStringLiteral("seed"), QStringLiteral("Another seed gives other shots."),
                                  QStringLiteral("number"), QStringLiteral("1"));
    const QCommandLineOption pipeline(QStringLiteral("pipeline"),
                                      QStringLiteral("Whose result is shown and exported: %1.")
                                          .arg(hitscope::cli::pipelineWords().join(QStringLiteral(", "))),
                                      QStringLiteral("name"), QStringLiteral("transform-feedback"));
    const QCommandLineOption normals(QStringLiteral("normals"),
                                     QStringLiteral("In pictures and mesh: true or paper."),
                                     QStringLiteral("kind"), QStringLiteral("true"));
    parser.addOptions({out, shots, seed, pipeline, normals});
    parser.addPositionalArgument(QStringLiteral("mesh"), QStringLiteral("Mesh file to shoot at."),
                                 QStringLiteral("[mesh]"));
    if (const std::optional<int> status = hitscope::cli::parse(parser, QStringLiteral("demo"), arguments)) {
        return *status;
    }
    hitscope::cli::DemoOptions options;
    bool shotsOk = false;
    bool seedOk = false;
    options.folder = parser.value(out);
    options.shots = parser.value(shots).toInt(&shotsOk);
    options.seed = parser.value(seed).toUInt(&seedOk);
    if (!shotsOk || options.shots < 1 || options.shots > 100000) {
        return wrongUsage(QStringLiteral("--shots takes a whole number from 1 to 100000."));
    }
    if (!seedOk) {
        return wrongUsage(QStringLiteral("--seed takes a whole number, 0 or more."));
    }
    const std::optional<hitscope::PipelineKind> kind = hitscope::cli::pipelineNamed(parser.value(pipeline));
    if (!kind) {
        return wrongUsage(QStringLiteral("--pipeline takes one of %1.")
                              .arg(hitscope::cli::pipelineWords().join(QStringLiteral(", "))));
    }
    options.pipeline = parser.isSet(pipeline) ? kind : std::nullopt;
    if (parser.value(normals) == QStringLiteral("paper")) {
        options.normals = hitscope::NormalMode::Paper;
    } else if (parser.value(normals) != QStringLiteral("true")) {
        return wrongUsage(QStringLiteral("--normals takes true or paper."));
    }
    if (parser.positionalArguments().size() > 1) {
        return wrongUsage(QStringLiteral("demo takes one mesh at most."));
    }
    options.meshPath = parser.positionalArguments().value(0);
    return finish(hitscope::cli::runDemo(options));
}

int info(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Describes a mesh file or the graphics driver."));
    parser.addHelpOption();
    const QCommandLineOption renderer(
        QStringLiteral("renderer"),
        QStringLiteral("Describe the graphics driver, and whether pipelines are bit-exact on it."));
    parser.addOption(renderer);
    parser.addPositionalArgument(QStringLiteral("mesh"), QStringLiteral("Mesh file."),
                                 QStringLiteral("[mesh]"));
    if (const std::optional<int> status = hitscope::cli::parse(parser, QStringLiteral("info"), arguments)) {
        return *status;
    }
    if (parser.positionalArguments().size() != (parser.isSet(renderer) ? 0 : 1)) {
        return wrongUsage(QStringLiteral("info takes one mesh file, or --renderer alone."));
    }
    if (parser.isSet(renderer)) {
        return finish(hitscope::cli::runRendererInfo());
    }
    return finish(hitscope::cli::runInfo(parser.positionalArguments().constFirst()));
}

int printUsage() {
    QTextStream(stdout)
        << "Usage: hitscope-cli COMMAND [options]\n\n"
        << "Commands:\n"
        << "  demo      shoot at the paper's scene or a mesh, compare the pipelines, write pictures\n"
        << "            and the deformed mesh\n"
        << "  shoot     shoot a burst or a saved script, print what was hit; hits and mesh in and out\n"
        << "  verify    compare every pipeline with the reference, vertex by vertex\n"
        << "  replay    open a session, apply its hits again, compare the positions with those saved\n"
        << "  collect   put a session, its meshes and textures into one folder\n"
        << "  picture   draw a scene into a picture of any size\n"
        << "  sequence  draw a turntable, or the hits one by one, into PNG files\n"
        << "  info      describe a mesh file or the graphics driver (--renderer)\n"
        << "  bench     measure the pipelines: frames, hits, the paper's tables\n\n"
        << "Options:\n"
        << "  --help     this text; hitscope-cli COMMAND --help for a command's options\n"
        << "  --version  the version\n";
    return 0;
}

/// Pictures may have text in them, for which Qt wants fonts, and for these a platform: one without windows.
std::unique_ptr<QCoreApplication> makeApplication(int& argc, char** argv) {
    const std::string_view command = argc > 1 ? argv[1] : "";
    if (command != "picture" && command != "sequence") {
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

int run(QStringList arguments) {
    const QString command = arguments.value(1);
    if (command == QLatin1String("--help") || command == QLatin1String("-h") ||
        command == QLatin1String("help")) {
        return printUsage();
    }
    if (command == QLatin1String("--version") || command == QLatin1String("-v")) {
        QTextStream(stdout) << "hitscope-cli " << QCoreApplication::applicationVersion() << "\n";
        return 0;
    }
    if (command.isEmpty()) {
        return wrongUsage(QStringLiteral("a command is missing."));
    }
    arguments.removeAt(1);
    if (command == QLatin1String("demo")) {
        return demo(arguments);
    }
    if (command == QLatin1String("shoot")) {
        return hitscope::cli::shootCommand(arguments);
    }
    if (command == QLatin1String("verify")) {
        return hitscope::cli::verifyCommand(arguments);
    }
    if (command == QLatin1String("replay")) {
        return hitscope::cli::replayCommand(arguments);
    }
    if (command == QLatin1String("collect")) {
        return hitscope::cli::collectCommand(arguments);
    }
    if (command == QLatin1String("info")) {
        return info(arguments);
    }
    if (command == QLatin1String("picture")) {
        return hitscope::cli::pictureCommand(arguments);
    }
    if (command == QLatin1String("sequence")) {
        return hitscope::cli::sequenceCommand(arguments);
    }
    if (command == QLatin1String("bench")) {
        return hitscope::bench::benchCommand(arguments);
    }
    return wrongUsage(QStringLiteral("there is no command \"%1\".").arg(command));
}

}  // namespace

int main(int argc, char** argv) {
    hitscope::keepFreedMemory();
    const std::unique_ptr<QCoreApplication> app = makeApplication(argc, argv);
    QLocale::setDefault(QLocale::c());  // scripts read what it writes, pictures among it
    QCoreApplication::setApplicationName(QStringLiteral("hitscope-cli"));
    QCoreApplication::setApplicationVersion(QStringLiteral(HITSCOPE_VERSION));

    return hitscope::cli::flushOutput(run(QCoreApplication::arguments()));
}
