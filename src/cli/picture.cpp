// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFontDatabase>
#include <QTextStream>
#include <memory>
#include <utility>

#include "analysis/change_values.h"
#include "analysis/hit_effects.h"
#include "cli/agreement.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/load_scene.h"
#include "cli/picture_arguments.h"
#include "gl/context.h"
#include "io/save_image.h"
#include "scene/picture_sequence.h"
#include "session/demo_shots.h"
#include "view/camera_text.h"

namespace hitscope::cli {

namespace {

constexpr int kMostTurntablePictures = 100'000;

/// A scene that can be drawn with no display.
struct Studio {
    std::unique_ptr<gl::OffscreenContext> context;
    Session session;
    std::unique_ptr<HitEffects> effects;  // null: nobody asks for numbers of hits
    std::unique_ptr<ChangeValues> changeValues;
    std::unique_ptr<SceneGpu> scene;  // below the session and the context, so that it goes first
    PictureRequest request;
};

/// What the surfaces are coloured by, of the hits that there are.
Status measureChange(Studio& studio, ChangeQuantity quantity) {
    if (Status current = studio.scene->sync(); !current) {
        return current;
    }
    studio.changeValues = std::make_unique<ChangeValues>(studio.session);
    if (quantity == ChangeQuantity::HitCount) {
        studio.effects = std::make_unique<HitEffects>(studio.session);
        studio.effects->finish();
        studio.changeValues->setHitCounts(
            [&effects = *studio.effects](TargetId target) { return effects.counts(target); });
    }
    studio.changeValues->setQuantity(quantity);
    studio.changeValues->finish();
    studio.request.changeValues = studio.changeValues.get();
    return Done{};
}

Status open(Studio& studio, const PictureArguments& arguments) {
    Result<std::unique_ptr<gl::OffscreenContext>> context = gl::OffscreenContext::create();
    if (!context) {
        return context.error();
    }
    studio.context = std::move(context).value();
    gl::collectDebugMessages();
    QTextStream notes(stderr);
    if (Status loaded = loadScene(studio.session, arguments.meshPath, notes); !loaded) {
        return loaded;
    }
    Result<std::unique_ptr<SceneGpu>> scene = SceneGpu::create(studio.session);
    if (!scene) {
        return scene.error();
    }
    studio.scene = std::move(scene).value();
    if (Status used = useAskedPipeline(studio.session, *studio.scene, arguments.pipeline); !used) {
        return used;
    }
    shootAll(studio.session, demoShots(studio.session, arguments.shots, arguments.seed));
    studio.session.targets().select({});

    PictureRequest& request = studio.request;
    request.width = arguments.width;
    request.height = arguments.height;
    request.options = arguments.options;
    if (arguments.options.change.on) {
        if (Status measured = measureChange(studio, arguments.options.change.quantity); !measured) {
            return measured;
        }
        request.labels = arguments.labels && !QFontDatabase::families().isEmpty();
        if (arguments.labels && !request.labels) {
            notes << "No fonts are installed here, so there is no colour bar in the picture.\n";
        }
    }
    const Bounds bounds = studio.session.targets().bounds();
    request.camera.setSceneRadius(bounds.empty() ? 1.0f : bounds.diagonal());
    if (arguments.camera.isEmpty()) {
        request.camera.frame(bounds, static_cast<float>(request.width) / static_cast<float>(request.height));
        return Done{};
    }
    Result<Camera> camera = parseCamera(arguments.camera.toStdString(), request.camera);
    if (!camera) {
        return Error{camera.error().what, "--camera", camera.error().advice};
    }
    request.camera = camera.value();
    return Done{};
}

Status glErrors() {
    const std::vector<std::string> errors = gl::takeErrors();
    return errors.empty() ? Status(Done{})
                          : Error{"OpenGL reports: " + errors.front(), "",
                                  "Please report this with the renderer's name."};
}

/// What was shot at the scene, to be compared between machines.
Status printFingerprints(Studio& studio, const PictureArguments& arguments) {
    if (arguments.shots == 0) {
        return Done{};
    }
    if (Status current = studio.scene->sync(); !current) {
        return current;
    }
    QTextStream(stdout) << fingerprintLines(studio.session);
    return Done{};
}

Status drawOne(const PictureArguments& arguments, const QString& path) {
    Studio studio;
    if (Status opened = open(studio, arguments); !opened) {
        return opened;
    }
    const Result<Image> image = drawPicture(*studio.scene, studio.request);
    if (!image) {
        return image.error();
    }
    if (Status errors = glErrors(); !errors) {
        return errors;
    }
    if (Status saved = savePicture(image.value(), path); !saved) {
        return saved;
    }
    return printFingerprints(studio, arguments);
}

/// turntable: how many pictures; 0: a replay.
Status drawMany(const PictureArguments& arguments, int turntable, const QString& folder) {
    if (!QDir().mkpath(folder)) {
        return Error{"The folder cannot be made.", folder.toStdString(), "Choose one you may write to."};
    }
    Studio studio;
    if (Status opened = open(studio, arguments); !opened) {
        return opened;
    }
    Result<PictureSequence> sequence =
        turntable > 0 ? PictureSequence::turntable(*studio.scene, studio.request, turntable)
                      : PictureSequence::replay(studio.session, studio.request);
    if (!sequence) {
        return sequence.error();
    }
    const int count = sequence.value().count();
    for (int number = 1; number <= count; ++number) {
        const Result<Image> image = sequence.value().next();
        if (!image) {
            return image.error();
        }
        const QString base = turntable > 0 ? QStringLiteral("turntable") : QStringLiteral("replay");
        if (Status saved = savePicture(image.value(), sequencePath(folder, base, number, count)); !saved) {
            return saved;
        }
    }
    QTextStream(stdout) << count << " pictures in " << QDir::toNativeSeparators(folder) << "\n";
    if (Status printed = printFingerprints(studio, arguments); !printed) {
        return printed;
    }
    return glErrors();
}

}  // namespace

int pictureCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Draws the paper's scene, or a mesh, into a picture, with no display."));
    parser.addHelpOption();
    const PictureOptions options(parser);
    parser.addPositionalArgument(
        QStringLiteral("picture"),
        QStringLiteral("File to write: .%1.").arg(pictureSuffixes().join(QStringLiteral(", ."))));
    parser.addPositionalArgument(QStringLiteral("mesh"), QStringLiteral("Mesh file."),
                                 QStringLiteral("[mesh]"));
    if (const std::optional<int> status = parse(parser, QStringLiteral("picture"), arguments)) {
        return *status;
    }
    const QStringList paths = parser.positionalArguments();
    if (paths.isEmpty() || paths.size() > 2) {
        return wrongUsage(QStringLiteral("picture takes the file to write, and one mesh at most."));
    }
    Result<PictureArguments> read = options.read(parser);
    if (!read) {
        return wrongUsage(QString::fromStdString(read.error().what));
    }
    read.value().meshPath = paths.value(1);
    if (Status known = checkPictureName(paths.constFirst()); !known) {
        return finish(known);  // before the work
    }
    return finish(drawOne(read.value(), paths.constFirst()));
}

int sequenceCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Draws a turntable, or the hits appearing one by one, into numbered PNG files, with no display."));
    parser.addHelpOption();
    const QCommandLineOption turntable(QStringLiteral("turntable"),
                                       QStringLiteral("Number of pictures in one turn around the scene."),
                                       QStringLiteral("number"));
    const QCommandLineOption replay(QStringLiteral("replay"),
                                    QStringLiteral("A picture before the hits, and one after each."));
    parser.addOptions({turntable, replay});
    const PictureOptions options(parser);
    parser.addPositionalArgument(QStringLiteral("folder"),
                                 QStringLiteral("Where the pictures go; made if missing."));
    parser.addPositionalArgument(QStringLiteral("mesh"), QStringLiteral("Mesh file."),
                                 QStringLiteral("[mesh]"));
    if (const std::optional<int> status = parse(parser, QStringLiteral("sequence"), arguments)) {
        return *status;
    }
    if (parser.isSet(turntable) == parser.isSet(replay)) {
        return wrongUsage(QStringLiteral("sequence takes either --turntable or --replay."));
    }
    const std::optional<int> count = wholeNumber(parser.value(turntable), 1, kMostTurntablePictures);
    if (parser.isSet(turntable) && !count) {
        return wrongUsage(
            QStringLiteral("--turntable takes a whole number from 1 to %1.").arg(kMostTurntablePictures));
    }
    const QStringList paths = parser.positionalArguments();
    if (paths.isEmpty() || paths.size() > 2) {
        return wrongUsage(QStringLiteral("sequence takes the folder to write to, and one mesh at most."));
    }
    Result<PictureArguments> read = options.read(parser);
    if (!read) {
        return wrongUsage(QString::fromStdString(read.error().what));
    }
    read.value().meshPath = paths.value(1);
    return finish(drawMany(read.value(), count.value_or(0), paths.constFirst()));
}

}  // namespace hitscope::cli
