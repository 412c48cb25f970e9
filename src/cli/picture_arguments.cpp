// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/picture_arguments.h"

#include <array>
#include <cmath>

#include "cli/common_options.h"
#include "cli/cut_argument.h"
#include "cli/mesh_step_options.h"
#include "cli/scene_options.h"
#include "deform/change_quantity.h"
#include "document/view_fields.h"
#include "scene/picture.h"
#include "view/camera_text.h"

namespace hitscope::cli {

namespace {

constexpr int kMostShots = 100'000;
constexpr int kLargestSide = 1'000'000;  // pixels; what the driver can draw is asked for later

QStringList words(std::initializer_list<const char*> list) {
    QStringList made;
    for (const char* word : list) {
        made << QString::fromLatin1(word);
    }
    return made;
}

/// By ChangeQuantity; but for the difference to a second pipeline, which is its last.
QStringList changeKeys() {
    QStringList keys;
    for (const ChangeTraits& traits : allChangeQuantities()) {
        if (traits.quantity != ChangeQuantity::Difference) {
            keys << QString::fromUtf8(traits.key);
        }
    }
    return keys;
}

/// Ways to draw that are on or off.
struct DrawingFlag {
    const char* option;
    const char* help;
    bool DisplayOptions::*member;
    bool turnsOn;
};
constexpr std::array<DrawingFlag, 9> kFlags{
    {{"transparent", "No background.", &DisplayOptions::transparent, true},
     {"no-floor", "No floor.", &DisplayOptions::floor, false},
     {"no-textures", "No textures of the meshes.", &DisplayOptions::textures, false},
     {"no-colours", "No vertex colours of the meshes.", &DisplayOptions::vertexColours, false},
     {"shadows", "Soft shadows of the directional light.", &DisplayOptions::shadows, true},
     {"flat", "Flat shading: one normal for each triangle.", &DisplayOptions::flat, true},
     {"back-faces", "Show back faces in red.", &DisplayOptions::backFaces, true},
     {"needles", "Show normals as needles.", &DisplayOptions::needles, true},
     {"dots", "Show vertices as dots.", &DisplayOptions::dots, true}}};

QList<UsageOption> changeOptions() {
    return {
        wordOption("change", "QUANTITY", changeKeys(), QStringLiteral("Colour the surface by this change.")),
        wordOption("colour-map", "MAP", wordsOf(document_words::kColourMapWords),
                   QStringLiteral("Colour map of --change.")),
        valueOption("range", "LOW,HIGH",
                    QStringLiteral(
                        "Values at the ends of the colour map; default: the range of the changed vertices.")),
        flagOption("isolines", QStringLiteral("Draw lines of equal change.")),
        flagOption("no-labels", QStringLiteral("No colour bar in the picture.")),
        wordOption("ghost", "MODE", words({"off", "wire", "translucent"}),
                   QStringLiteral("Draw the original over the deformed mesh.")),
        valueOption("wipe", "SHARE",
                    QStringLiteral("Draw the original left of a line at this part of the width, 0 to 1, and "
                                   "the deformed mesh right of it.")),
        valueOption("exaggerate", "FACTOR",
                    QStringLiteral("Multiply displacements by this factor, 1 to 20."))};
}

void readSize(Invocation& given, PictureArguments& arguments) {
    const QStringList sides = given.text("size").split(u'x');
    bool isWidth = false;
    bool isHeight = false;
    arguments.width = sides.value(0).toInt(&isWidth);
    arguments.height = sides.value(1).toInt(&isHeight);
    const auto fits = [](int side) { return side >= 1 && side <= kLargestSide; };
    if (sides.size() != 2 || !isWidth || !isHeight || !fits(arguments.width) || !fits(arguments.height)) {
        given.complain(QStringLiteral("--size takes width and height in pixels, as in 1920x1080."));
    }
}

/// What has no effect without --change or --cut, or what a session has of them.
void refuseIdle(Invocation& given, const DisplayOptions& options) {
    for (const char* name : {"colour-map", "range", "isolines", "no-labels"}) {
        if (!options.change.on && given.isSet(name)) {
            given.complain(QStringLiteral("--%1 goes with --change.").arg(QLatin1String(name)));
        }
    }
    if (!options.cut.on && given.isSet("fill-cut")) {
        given.complain(QStringLiteral("--fill-cut goes with --cut."));
    }
}

void readChange(Invocation& given, ChangeMapOptions& change) {
    if (given.isSet("change")) {
        change.on = true;
        change.quantity = allChangeQuantities()[given.word("change")].quantity;
    }
    change.isolines = change.isolines || given.isSet("isolines");
    if (given.isSet("colour-map")) {
        change.style().map = static_cast<ColourMap>(given.word("colour-map"));
    }
    if (given.isSet("range")) {
        const QStringList ends = given.text("range").split(u',');
        bool isLow = false;
        bool isHigh = false;
        const ChangeRange range{ends.value(0).toFloat(&isLow), ends.value(1).toFloat(&isHigh)};
        const bool isFinite = std::isfinite(range.high - range.low);
        if (ends.size() != 2 || !isLow || !isHigh || !isFinite || !(range.low < range.high)) {
            given.complain(QStringLiteral("--range takes two numbers, the lower first, as in 0,0.3."));
        }
        change.style().automatic = false;
        change.style().fixed = range;
    }
}

void readBeforeAfter(Invocation& given, BeforeAfterOptions& options) {
    if (given.isSet("ghost")) {
        options.ghost = static_cast<GhostMode>(given.word("ghost"));
    }
    if (given.isSet("wipe")) {
        options.wipe = true;
        options.wipeAt = static_cast<float>(given.number("wipe", 0.0, 1.0));
    }
    if (given.isSet("exaggerate")) {
        options.exaggeration = static_cast<float>(given.number("exaggerate", 1.0, kLargestExaggeration));
    }
}

}  // namespace

UsageOption samplesOption() {
    return valueOption("samples", "N",
                       QStringLiteral("Refine the picture: average this number of samples, 1 to %1; from 2 "
                                      "on, with soft shadows and ambient occlusion.")
                           .arg(kMostSamples),
                       QStringLiteral("1"));
}

QList<UsageOption> pictureOptions() {
    QList<UsageOption> options{
        valueOption("size", "WxH", QStringLiteral("Size of the picture in pixels."),
                    QStringLiteral("1280x720")),
        valueOption(
            "camera", "TEXT",
            QStringLiteral(
                "Camera, as copied by Edit > Copy Camera: \"camera pivot 0 0 0 yaw 35 pitch 20 distance 12 "
                "fov 50 perspective\"; default: the session's, or a view of the whole scene.")),
        valueOption("cut", "PLANE",
                    QStringLiteral("Cut the targets: x=0.1 hides everything beyond 0.1 m along x, -x=0.1 the "
                                   "other side; 1,1,0=0.5 cuts perpendicular to that direction.")),
        flagOption("fill-cut", QStringLiteral("Fill the cut, as if targets were solid.")),
        wordOption("theme", "NAME", words({"light", "dark"}), QStringLiteral("Background."),
                   QStringLiteral("dark")),
        wordOption("wireframe", "MODE", words({"off", "over", "only"}),
                   QStringLiteral("Draw the edges of the file's polygons.")),
        wordOption("normals", "KIND", words({"true", "paper"}), QStringLiteral("Normals for shading."))};
    options << upOption() << samplesOption()
            << wordOption("material", "NAME", words({"file", "matcap", "clay", "metal"}),
                          QStringLiteral("Material of the surfaces."))
            << flagOption("environment", QStringLiteral("Light the scene with a studio environment."));
    for (const DrawingFlag& flag : kFlags) {
        options << flagOption(flag.option, QString::fromLatin1(flag.help));
    }
    options << changeOptions() << pipelineOption(QStringLiteral("the session's, or transform-feedback"))
            << untilOption()
            << valueOption("shots", "N", QStringLiteral("Number of shots before the picture, 0 to 100000."),
                           QStringLiteral("0"))
            << valueOption("seed", "NUMBER", QStringLiteral("Seed of the random shots."),
                           QStringLiteral("1"));
    return options << quietOption();
}

PictureArguments readPictureArguments(Invocation& given, const QString& scene) {
    PictureArguments arguments;
    arguments.scene = givenScene(given, scene);
    arguments.scene.isDrawn = true;
    arguments.isZUp = givenZUp(given);
    readSize(given, arguments);
    arguments.samples = given.wholeNumber("samples", 1, kMostSamples);
    arguments.labels = !given.isSet("no-labels");
    arguments.shots = given.wholeNumber("shots", 0, kMostShots);
    arguments.seed = given.seed("seed");
    arguments.camera = given.text("camera");
    if (const Result<Camera> camera = parseCamera(arguments.camera.toStdString(), Camera());
        given.isSet("camera") && !camera) {
        given.complain(QStringLiteral("--camera: ") + QString::fromStdString(camera.error().message()));
    }
    if (given.isSet("seed") && arguments.shots == 0) {
        given.complain(QStringLiteral("--seed goes with --shots."));
    }
    DisplayOptions any;  // what is wrong with it is said before the work
    any.change.on = any.cut.on = namesSession(scene);
    static_cast<void>(readDisplay(given, any));
    return arguments;
}

DisplayOptions readDisplay(Invocation& given, DisplayOptions options) {
    options.theme = static_cast<Theme>(given.word("theme"));
    if (given.isSet("wireframe")) {
        options.wireframe = static_cast<WireframeMode>(given.word("wireframe"));
    }
    if (given.isSet("normals")) {
        options.normals = static_cast<NormalMode>(given.word("normals"));
    }
    options.shadows = options.shadows || given.wholeNumber("samples", 1, kMostSamples) > 1;
    if (given.isSet("material")) {
        options.look = static_cast<SurfaceLook>(given.word("material"));
    }
    options.environment = options.environment || given.isSet("environment");
    for (const DrawingFlag& flag : kFlags) {
        if (given.isSet(flag.option)) {
            options.*flag.member = flag.turnsOn;
        }
    }
    readChange(given, options.change);
    readBeforeAfter(given, options.beforeAfter);
    if (given.isSet("cut")) {
        const std::optional<CuttingPlane> cut = parseCut(given.text("cut"));
        if (!cut) {
            given.complain(
                QStringLiteral("--cut takes an axis or a direction, and metres, as in x=0.1 or 1,1,0=0.5."));
        }
        options.cut = cut.value_or(CuttingPlane{});
    }
    options.cut.fill = options.cut.fill || given.isSet("fill-cut");
    options.sideBySide = false;
    refuseIdle(given, options);
    return options;
}

}  // namespace hitscope::cli
