// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFileInfo>
#include <QFontDatabase>
#include <QSet>
#include <QTextStream>
#include <algorithm>
#include <memory>
#include <utility>

#include "analysis/change_values.h"
#include "analysis/hit_effects.h"
#include "cli/agreement.h"
#include "cli/command_line.h"
#include "cli/film.h"
#include "cli/mesh_step_options.h"
#include "cli/outputs.h"
#include "cli/picture_arguments.h"
#include "cli/progress_line.h"
#include "cli/standard_streams.h"
#include "cli/verbs.h"
#include "io/import.h"
#include "io/save_image.h"
#include "scene/picture_sequence.h"
#include "session/shots/demo_shots.h"
#include "view/camera_text.h"

namespace hitscope::cli {

namespace {

constexpr int kMostTurntablePictures = 100'000;

/// A scene that can be drawn with no display.
struct Studio {
    OpenedScene opened;
    std::unique_ptr<HitEffects> effects;  // null: nobody asks for numbers of hits
    std::unique_ptr<ChangeValues> changeValues;
    PictureRequest request;
};

/// What the surfaces are coloured by, of the hits that there are.
Outcome measureChange(Studio& studio, ChangeQuantity quantity) {
    Session& session = studio.opened.session();
    if (Outcome current = studio.opened.sync(); !current) {
        return current;
    }
    studio.changeValues = std::make_unique<ChangeValues>(session);
    if (quantity == ChangeQuantity::HitCount) {
        studio.effects = std::make_unique<HitEffects>(session);
        studio.effects->finish();
        studio.changeValues->setHitCounts(
            [&effects = *studio.effects](TargetId target) { return effects.counts(target); });
    }
    studio.changeValues->setQuantity(quantity);
    studio.changeValues->finish();
    studio.request.changeValues = studio.changeValues.get();
    return Done{};
}

/// The session's camera, or all of the scene in the picture, or the one that was given.
Status placeCamera(Studio& studio, const PictureArguments& arguments) {
    PictureRequest& request = studio.request;
    const Bounds bounds = studio.opened.session().targets().bounds();
    request.camera.setSceneRadius(bounds.empty() ? 1.0f : bounds.diagonal());
    request.camera.frame(bounds, static_cast<float>(request.width) / static_cast<float>(request.height));
    const SessionDocument* document = studio.opened.document();
    const bool isGiven = !arguments.camera.isEmpty();
    const std::string text = isGiven               ? arguments.camera.toStdString()
                             : document != nullptr ? document->cameras.current
                                                   : std::string();
    if (text.empty()) {
        return Done{};
    }
    Result<Camera> camera = parseCamera(text, request.camera);
    if (!camera && isGiven) {
        return Error{camera.error().what, "--camera", camera.error().advice};
    }
    if (camera) {
        request.camera = camera.value();
    }
    return Done{};
}

Outcome open(Studio& studio, Invocation& given, const PictureArguments& arguments) {
    if (Outcome opened = studio.opened.open(arguments.scene); !opened) {
        return opened;
    }
    gl::collectDebugMessages();
    Session& session = studio.opened.session();
    if (arguments.isZUp) {
        if (Status turned = turnAllUpright(session); !turned) {
            return turned.error();
        }
    }
    shootAll(session, demoShots(session, arguments.shots, arguments.seed));
    session.targets().select({});

    const SessionDocument* document = studio.opened.document();
    PictureRequest& request = studio.request;
    request.width = arguments.width;
    request.height = arguments.height;
    request.samples = arguments.samples;
    request.options = readDisplay(given, document != nullptr ? document->display : DisplayOptions());
    if (!given.error().isEmpty()) {
        return Error{given.error().toStdString(), "", ""};  // which is what is said
    }
    if (request.options.change.on) {
        if (request.options.change.quantity ==
            ChangeQuantity::Difference) {  // of a session: takes two pipelines
            request.options.change.quantity = ChangeQuantity::Displacement;
        }
        if (Outcome measured = measureChange(studio, request.options.change.quantity); !measured) {
            return measured;
        }
        request.labels = arguments.labels && !QFontDatabase::families().isEmpty();
        if (arguments.labels && !request.labels) {
            note(QStringLiteral("No fonts are installed here, so there is no colour bar in the picture."));
        }
    }
    return placeCamera(studio, arguments);
}

Outcome glErrors() {
    const std::vector<std::string> errors = gl::takeErrors();
    return errors.empty() ? Outcome(Done{})
                          : cannotDraw({"OpenGL reports: " + errors.front(), "",
                                        "Please report this with the renderer's name."});
}

/// What was shot at the scene, to be compared between machines.
Outcome printFingerprints(Studio& studio, const PictureArguments& arguments) {
    if (arguments.shots == 0) {
        return Done{};
    }
    if (Outcome current = studio.opened.sync(); !current) {
        return current;
    }
    QTextStream(stdout) << fingerprintLines(studio.opened.session());
    return Done{};
}

Outcome drawOne(Invocation& given, const PictureArguments& arguments, const QString& path) {
    Studio studio;
    if (Outcome opened = open(studio, given, arguments); !opened) {
        return opened;
    }
    const Result<Image> image = drawPicture(studio.opened.gpu(), studio.request);
    if (!image) {
        return cannotDraw(image.error());
    }
    if (Outcome errors = glErrors(); !errors) {
        return errors;
    }
    if (Status saved = savePicture(image.value(), path); !saved) {
        return saved;
    }
    return printFingerprints(studio, arguments);
}

QString baseName(int turntable) {
    return turntable > 0 ? QStringLiteral("turntable") : QStringLiteral("replay");
}

/// The files in the folder that the pictures will be.
QStringList picturePaths(const QString& folder, int turntable, int count) {
    QStringList paths;
    for (int number = 1; number <= count; ++number) {
        paths << sequencePath(folder, baseName(turntable), number, count);
    }
    return paths;
}

/// Numbered PNG files in the folder, none of which is read. turntable: how many pictures; 0: a replay, as far
/// as `until`. Gives how many there are.
Result<int> drawPictures(Studio& studio, int turntable, std::optional<std::size_t> until,
                         const QString& folder) {
    Result<PictureSequence> sequence =
        turntable > 0 ? PictureSequence::turntable(studio.opened.gpu(), studio.request, turntable)
                      : PictureSequence::replay(studio.opened.session(), studio.request, until);
    if (!sequence) {
        return sequence.error();
    }
    const int count = sequence.value().count();
    const QStringList paths = picturePaths(folder, turntable, count);
    keepOutputs(QStringLiteral("FOLDER"), paths);
    if (Status free = checkSources(studio.opened.session()); !free) {
        return free.error();
    }
    ProgressLine progress(QStringLiteral("Drawing"), count);
    int drawn = 0;
    for (const QString& path : paths) {
        const Result<Image> image = sequence.value().next();
        if (!image) {
            return image.error();
        }
        if (Status saved = savePicture(image.value(), path); !saved) {
            return saved.error();
        }
        progress.show(++drawn);
    }
    return count;
}

/// Pictures there of the same name that belong to no picture of this sequence.
qsizetype leftBehind(const QString& folder, int turntable, int count) {
    QSet<QString> own;
    for (const QString& path : picturePaths(folder, turntable, count)) {
        own << QFileInfo(path).fileName();
    }
    const QStringList all =
        QDir(folder).entryList({baseName(turntable) + QStringLiteral("-*.png")}, QDir::Files);
    return std::count_if(all.begin(), all.end(), [&own](const QString& name) { return !own.contains(name); });
}

Outcome drawMany(Invocation& given, const PictureArguments& arguments, int turntable, const QString& place) {
    const bool isFilm = namesFilm(place);
    const ScratchFolder scratch;
    if (Status made = scratch.check(); isFilm && !made) {
        return made;
    }
    const QString folder = isFilm ? scratch.file(QStringLiteral("pictures")) : place;
    if (!QDir().mkpath(folder)) {
        return Error{"The folder cannot be made.", folder.toStdString(), "Choose one you may write to."};
    }
    Studio studio;
    if (Outcome opened = open(studio, given, arguments); !opened) {
        return opened;
    }
    const Result<int> count = drawPictures(studio, turntable, arguments.scene.until, folder);
    if (!count) {
        return count.error();
    }
    if (isFilm) {
        const QString pattern = sequencePath(folder, baseName(turntable), 1, count.value());
        if (Outcome filmed = writeFilm(pattern, given.number("rate", 0.1, 240.0), place); !filmed) {
            return filmed;
        }
    }
    if (const qsizetype left = leftBehind(folder, turntable, count.value()); !isFilm && left > 0) {
        note(QStringLiteral("note: the folder has %1 more %2 of an earlier sequence.")
                 .arg(left)
                 .arg(left == 1 ? "picture" : "pictures"));
    }
    QTextStream(stdout) << count.value() << (count.value() == 1 ? " picture in " : " pictures in ")
                        << QDir::toNativeSeparators(place) << "\n";
    if (Outcome printed = printFingerprints(studio, arguments); !printed) {
        return printed;
    }
    return glErrors();
}

int picture(Invocation& given) {
    const PictureArguments arguments = readPictureArguments(given, given.file(1));
    if (!given.error().isEmpty()) {
        return kWrongUsage;
    }
    if (Status known = checkPictureName(given.file(0)); !known) {
        Error error = known.error();
        if (namesSession(given.file(0)) ||
            importSuffixes().contains(QFileInfo(given.file(0)).suffix().toLower())) {
            error.advice += " The picture comes first, what it shows after it.";
        }
        given.complain(QString::fromStdString(error.message()));  // before the work
        return kWrongUsage;
    }
    const Outcome drawn = drawOne(given, arguments, given.file(0));
    return given.error().isEmpty() ? finish(drawn) : kWrongUsage;
}

int sequence(Invocation& given) {
    if (given.isSet("turntable") == given.isSet("replay")) {
        given.complain(QStringLiteral("sequence takes either --turntable or --replay."));
    }
    const int turntable =
        given.isSet("turntable") ? given.wholeNumber("turntable", 1, kMostTurntablePictures) : 0;
    static_cast<void>(given.number("rate", 0.1, 240.0));
    const PictureArguments arguments = readPictureArguments(given, given.file(1));
    if (!given.error().isEmpty()) {
        return kWrongUsage;
    }
    static const QStringList otherFilms{QStringLiteral("avi"),  QStringLiteral("mov"), QStringLiteral("mkv"),
                                        QStringLiteral("m4v"),  QStringLiteral("mpg"), QStringLiteral("wmv"),
                                        QStringLiteral("mpeg"), QStringLiteral("ogv")};
    const QFileInfo place(given.file(0));
    if (otherFilms.contains(place.suffix().toLower()) && !place.isDir()) {
        given.complain(QStringLiteral("sequence writes films as .%1, not .%2.")
                           .arg(filmSuffixes().join(QStringLiteral(", .")), place.suffix()));
        return kWrongUsage;
    }
    if (pictureSuffixes().contains(place.suffix().toLower()) && !place.isDir()) {
        given.complain(
            QStringLiteral("sequence writes pictures into a folder, or a film; %1 names a picture.")
                .arg(place.fileName()));
        return kWrongUsage;
    }
    if (namesFilm(given.file(0))) {
        if (Outcome ready = checkFilm(arguments.width, arguments.height); !ready) {
            return finish(ready);  // before the work
        }
    }
    const Outcome drawn = drawMany(given, arguments, turntable, given.file(0));
    return given.error().isEmpty() ? finish(drawn) : kWrongUsage;
}

}  // namespace

Verb pictureVerb() {
    return {
        {.name = QStringLiteral("picture"),
         .files = QStringLiteral("PICTURE [MESH|SESSION]"),
         .about = QStringLiteral("draw a picture of a scene in any size"),
         .description =
             QStringLiteral("Draws a picture of the paper's scene, of a mesh, or of a session with its saved "
                            "view, without a display. PICTURE is the file to write: .%1.")
                 .arg(pictureSuffixes().join(QStringLiteral(", ."))),
         .options = pictureOptions(),
         .examples = {{QStringLiteral("Draw a session, coloured by displacement."),
                       QStringLiteral("hitscope-cli picture --change displacement dents.png dents.hitscope")},
                      {QStringLiteral("Draw a mesh with its edges, on a transparent background."),
                       QStringLiteral(
                           "hitscope-cli picture --wireframe over --transparent --no-floor bunny.png "
                           "bunny.obj")}},
         .leastFiles = 1,
         .mostFiles = 2,
         .outputFile = 0},
        picture,
        true};
}

Verb sequenceVerb() {
    return {{.name = QStringLiteral("sequence"),
             .files = QStringLiteral("FOLDER|FILM [MESH|SESSION]"),
             .about = QStringLiteral("draw a turntable, or the hits one by one, as PNG files or a film"),
             .description = QStringLiteral("Draws a turntable, or the hits appearing one by one, without a "
                                           "display. Writes numbered PNG files into a folder, which it "
                                           "creates if needed, or, if ffmpeg is installed, a film: .%1.")
                                .arg(filmSuffixes().join(QStringLiteral(", ."))),
             .options =
                 QList<UsageOption>{
                     valueOption("turntable", "N",
                                 QStringLiteral("Number of pictures in one turn around the scene.")),
                     flagOption("replay",
                                QStringLiteral("Draw a picture before the hits and one after each hit.")),
                     valueOption("rate", "N", QStringLiteral("Pictures per second of a film, 0.1 to 240."),
                                 QStringLiteral("25"))} +
                 pictureOptions(),
             .examples =
                 {{QStringLiteral("Make a film of one turn around a mesh."),
                   QStringLiteral("hitscope-cli sequence --turntable 12 --size 320x180 turn.mp4 bunny.obj")},
                  {QStringLiteral("Draw the hits of a session one by one, as PNG files."),
                   QStringLiteral("hitscope-cli sequence --replay --size 320x180 frames dents.hitscope")}},
             .leastFiles = 1,
             .mostFiles = 2,
             .outputFile = 0},
            sequence,
            true};
}

}  // namespace hitscope::cli
