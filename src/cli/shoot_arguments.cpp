// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "cli/common_options.h"
#include "cli/form_options.h"
#include "cli/mesh_step_options.h"
#include "cli/picture_arguments.h"
#include "cli/repeat_options.h"
#include "cli/shoot.h"
#include "scene/picture.h"

namespace hitscope::cli {

namespace {

using Shots = ShootOptions::Shots;

/// "max_distance" as an option: "max-distance".
QByteArray optionName(const ParameterDescriptor& parameter) {
    return QByteArray(parameter.key.data(), static_cast<qsizetype>(parameter.key.size())).replace('_', '-');
}

QString text(std::string_view words) {
    return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

/// Of a projectile, what a shot alone is made with.
bool isOfShots(const ParameterDescriptor& parameter) {
    return parameter.key == "speed" || parameter.key == "radius" || parameter.key == "mass" ||
           parameter.key == "gravity";
}

UsageOption parameterOption(const ParameterDescriptor& parameter, const QString& without) {
    const QString unit = parameter.unit.empty() ? QString() : QStringLiteral(", in ") + text(parameter.unit);
    return valueOption(optionName(parameter).constData(), "NUMBER",
                       QStringLiteral("%1%2, from %3 to %4; default: %5.")
                           .arg(text(parameter.label), unit)
                           .arg(parameter.minimum)
                           .arg(parameter.maximum)
                           .arg(without));
}

QStringList flightWords() {
    QStringList words;
    for (const FlightModeTraits& traits : allFlightModes()) {
        if (traits.mode != FlightMode::Own) {
            words << text(traits.key);
        }
    }
    return words;
}

/// By the descriptors; those that are no options are never there.
template <class Parameters>
std::vector<std::optional<double>> parametersOf(Invocation& given, const Parameters& parameters,
                                                bool allOfThem) {
    std::vector<std::optional<double>> values;
    for (const ParameterDescriptor& parameter : parameters) {
        const QByteArray name = optionName(parameter);
        values.push_back(allOfThem || isOfShots(parameter)
                             ? given.numberIfSet(name.constData(), parameter.minimum, parameter.maximum)
                             : std::nullopt);
    }
    return values;
}

glm::vec3 givenVector(Invocation& given, const char* name) {
    const std::optional<glm::vec3> vector = vectorOf(given.text(name));
    if (!vector) {
        given.complain(QStringLiteral("--%1 takes three numbers, as in 0,1.5,-2.").arg(QLatin1String(name)));
    }
    return vector.value_or(glm::vec3(0.0f));
}

/// Which of the ways to shoot is asked for: one at most.
Shots givenShots(Invocation& given) {
    constexpr std::array<std::pair<const char*, Shots>, 4> kWays{
        {{"script", Shots::Script}, {"burst", Shots::Burst}, {"random", Shots::Random}, {"at", Shots::At}}};
    std::optional<Shots> asked;
    for (const auto& [name, way] : kWays) {
        if (given.isSet(name) && asked) {
            given.complain(QStringLiteral("--script, --burst, --random and --at exclude each other."));
        } else if (given.isSet(name)) {
            asked = way;
        }
    }
    // With hits from elsewhere, only where something is said about shots.
    const bool scatters = given.isSet("scatter") || given.isSet("density");
    constexpr std::array<const char*, 8> kAbout{"cone", "every",   "instant",        "flight",
                                                "save", "profile", "dent-direction", "curve"};
    const bool saysMore = (given.isSet("seed") && !scatters) ||
                          (!scatters && std::any_of(kAbout.begin(), kAbout.end(),
                                                    [&](const char* name) { return given.isSet(name); }));
    const bool hasOthers = given.isSet("hits") || scatters;
    return asked.value_or(hasOthers && !saysMore ? Shots::None : Shots::Burst);
}

void readAim(Invocation& given, ShootOptions& options) {
    if (options.shots != Shots::At) {
        if (given.isSet("direction")) {
            given.complain(QStringLiteral("--direction goes with --at."));
        }
        return;
    }
    options.at = givenVector(given, "at");
    options.direction = givenVector(given, "direction");
    if (const float length = glm::length(options.direction); length > 0.0f) {
        options.direction /= length;
    } else {
        given.complain(QStringLiteral("--direction takes a direction, which 0,0,0 is not."));
    }
}

/// What says how shots fly, where it would change nothing.
void complainOfIdle(Invocation& given, Shots shots) {
    const auto complain = [&given](const char* name, const char* why) {
        if (given.isSet(name)) {
            given.complain(QStringLiteral("--%1 %2").arg(QLatin1String(name), QLatin1String(why)));
        }
    };
    if (shots == Shots::At) {
        complain("every", "is not for --at, which fires one shot.");
        return;
    }
    if (shots != Shots::Script && shots != Shots::None) {
        return;
    }
    const char* const why = shots == Shots::Script ? "is not for --script, which says it of each shot."
                                                   : "goes with shots, and none are asked for.";
    for (const char* name : {"flight", "instant", "every"}) {
        complain(name, why);
    }
    for (const ParameterDescriptor& parameter : projectileParameters()) {
        if (isOfShots(parameter)) {
            complain(optionName(parameter).constData(), why);
        }
    }
}

}  // namespace

QList<UsageOption> shootOptions() {
    QList<UsageOption> options{
        valueOption("burst", "N",
                    QStringLiteral("Fire a burst of 1 to 100000 shots at the middle of the scene."),
                    QStringLiteral("20")),
        valueOption("random", "N",
                    QStringLiteral("Fire 1 to 100000 shots at random places of the surface, each within 30 "
                                   "degrees of its normal and unobstructed.")),
        valueOption(
            "at", "X,Y,Z",
            QStringLiteral("Fire one shot through this point of the scene, in metres, along --direction and "
                           "from outside all targets.")),
        valueOption("direction", "X,Y,Z", QStringLiteral("Direction of the shot of --at."),
                    QStringLiteral("0,0,-1")),
        fileOption("script",
                   QStringLiteral("Fire the shots of a script, as written by --save and the window.")),
        fileOption("hits", QStringLiteral("Begin with the hits of a CSV or JSON file, as exported by the "
                                          "window. Shots follow only if an option about shots is given.")),
        valueOption("cone", "DEGREES",
                    QStringLiteral("Angle from the middle of a burst to its edge, 0 to 180."),
                    QStringLiteral("5")),
        valueOption("seed", "NUMBER", QStringLiteral("Seed of the burst or the random shots."),
                    QStringLiteral("1")),
        valueOption("every", "SECONDS", QStringLiteral("Time between shots, 0 to 10."), QStringLiteral("0")),
        wordOption("flight", "MODE", flightWords(),
                   QStringLiteral("Flight of shots: quick (arrives in 0.1 s, scales with the mesh), instant, "
                                  "or as in the paper (30 m/s, radius 0.1 m). Default: paper for the paper's "
                                  "scene, instant with --at, otherwise quick.")),
        flagOption("instant", QStringLiteral("Same as --flight instant."))};
    for (const ParameterDescriptor& parameter : deformationParameters()) {
        options << parameterOption(parameter,
                                   QStringLiteral("the session's, or %1").arg(parameter.defaultValue));
    }
    options << formOptions() << upOption() << separateOption() << meshStepOptions() << repeatOptions();
    options << flagOption("absolute",
                          QStringLiteral("Use the constants in metres on any target. Otherwise they apply to "
                                         "a target of 5 m and scale with the target."));
    for (const ParameterDescriptor& parameter : projectileParameters()) {
        if (isOfShots(parameter)) {
            options << parameterOption(parameter, QStringLiteral("by --flight"));
        }
    }
    options << pipelineOption(QStringLiteral("the session's, or transform-feedback"))
            << outputOption(
                   "out", QStringLiteral("Write the deformed mesh as OBJ, PLY, STL, GLB, glTF or CSV, by the "
                                         "suffix; of several targets, the one with the most changed "
                                         "vertices. Exits with 1 if the mesh differs from the reference's."))
            << outputOption("session",
                            QStringLiteral("Write a session (.hitscope), which the window can open."))
            << outputOption(
                   "hits-out",
                   QStringLiteral("Write all hits, as JSON if the name ends in .json, otherwise as CSV."))
            << outputOption("picture", QStringLiteral("Write a picture of the scene, 1280 by 720 pixels."))
            << samplesOption() << outputOption("save", QStringLiteral("Save the shots as a script."));
    return options + reportOptions();
}

ShootOptions readShootOptions(Invocation& given) {
    ShootOptions options;
    options.scenePath = given.file(0);
    options.shots = givenShots(given);
    readAim(given, options);
    options.count = given.wholeNumber("burst", 1, ShotScript::kMostShots);
    if (options.shots == Shots::Random) {
        options.count = given.wholeNumber("random", 1, ShotScript::kMostShots);
    }
    options.cone = given.number("cone", 0.0, 180.0);
    options.seed = given.seed("seed");
    options.interval = given.number("every", 0.0, 10.0);
    if (options.shots == Shots::Script && given.isSet("seed")) {
        given.complain(QStringLiteral("--seed is not for --script."));
    }
    if (options.shots != Shots::Burst && given.isSet("cone")) {
        given.complain(QStringLiteral("--cone goes with --burst."));
    }
    if (given.isSet("flight")) {
        options.flight = allFlightModes()[given.word("flight")].mode;
    }
    if (given.isSet("instant")) {
        if (options.flight.value_or(FlightMode::Instant) != FlightMode::Instant) {
            given.complain(QStringLiteral("--instant and another --flight exclude each other."));
        }
        options.flight = FlightMode::Instant;
    }
    complainOfIdle(given, options.shots);
    options.constants = parametersOf(given, deformationParameters(), true);
    options.form = givenForm(given);
    options.isZUp = givenZUp(given);
    options.separates = given.isSet("separate");
    options.meshSteps = givenMeshSteps(given);
    options.repeat = givenRepeat(given);
    options.absolute = given.isSet("absolute");
    options.projectile = parametersOf(given, projectileParameters(), false);
    options.pipeline = givenPipeline(given);
    options.hitsPath = given.text("hits");
    options.scriptPath = given.text("script");
    options.savePath = given.text("save");
    options.meshOutPath = givenMeshFile(given);
    options.hitsOutPath = given.text("hits-out");
    options.sessionPath = given.text("session");
    options.picturePath = given.text("picture");
    options.samples = given.wholeNumber("samples", 1, kMostSamples);
    if (given.isSet("samples") && options.picturePath.isEmpty()) {
        given.complain(QStringLiteral("--samples goes with --picture."));
    }
    return options;
}

}  // namespace hitscope::cli
