// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "cli/common_options.h"
#include "cli/form_options.h"
#include "cli/mesh_step_options.h"
#include "cli/repeat_options.h"
#include "cli/shoot.h"

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
                       QStringLiteral("%1%2, from %3 to %4; without it, %5.")
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

}  // namespace

QList<UsageOption> shootOptions() {
    QList<UsageOption> options{
        valueOption("burst", "N", QStringLiteral("A burst at the middle of the scene, of 1 to 100000 shots."),
                    QStringLiteral("20")),
        valueOption("random", "N",
                    QStringLiteral("Shots at random places of the surface, 1 to 100000, each "
                                   "within 30 degrees of its normal and with nothing in its way.")),
        valueOption("at", "X,Y,Z", QStringLiteral("One shot through that place, metres, along --direction.")),
        valueOption("direction", "X,Y,Z", QStringLiteral("Where the shot of --at goes."),
                    QStringLiteral("0,0,-1")),
        fileOption("script", QStringLiteral("The shots of a script, as --save and the window write it.")),
        fileOption("hits",
                   QStringLiteral("Begin with the hits of a CSV or JSON file, as the window exports them. "
                                  "Shots follow where something is said about shots.")),
        valueOption("cone", "DEGREES", QStringLiteral("From a burst's middle to its edge, 0 to 180."),
                    QStringLiteral("5")),
        valueOption("seed", "NUMBER", QStringLiteral("Another seed gives another burst, other random shots."),
                    QStringLiteral("1")),
        valueOption("every", "SECONDS", QStringLiteral("Time between shots, 0 to 10."), QStringLiteral("0")),
        wordOption(
            "flight", "MODE", flightWords(),
            QStringLiteral("How shots fly: quick, there in 0.1 s, by the size of the mesh; instant; or as in "
                           "the paper, 30 m/s, radius 0.1 m. Without it, paper at the paper's scene, instant "
                           "with --at, else quick.")),
        flagOption("instant", QStringLiteral("As --flight instant."))};
    for (const ParameterDescriptor& parameter : deformationParameters()) {
        options << parameterOption(
            parameter, QStringLiteral("as the session has it, or %1").arg(parameter.defaultValue));
    }
    options << formOptions() << meshStepOptions() << repeatOptions();
    options << flagOption("absolute",
                          QStringLiteral("Constants are in metres on any target. Otherwise they are those "
                                         "of a target 5 m across, and grow and shrink with the target."));
    for (const ParameterDescriptor& parameter : projectileParameters()) {
        if (isOfShots(parameter)) {
            options << parameterOption(parameter, QStringLiteral("as --flight says"));
        }
    }
    options << pipelineOption(QStringLiteral("transform-feedback, or that of the session"))
            << fileOption(
                   "out",
                   QStringLiteral("Write the deformed mesh: OBJ, PLY, STL, GLB, glTF or CSV, by its suffix; "
                                  "of several, the one with most changed vertices. The exit status is 1 "
                                  "where it is not what the reference makes of the hits."))
            << fileOption("session", QStringLiteral("Write a session (.hitscope) that the window opens."))
            << fileOption("hits-out",
                          QStringLiteral("Write all hits: as JSON to a name with .json, else as CSV."))
            << fileOption("picture", QStringLiteral("Write a picture of the scene, 1280 by 720 pixels."))
            << fileOption("save", QStringLiteral("Save the shots as a script."));
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
    if (options.shots == Shots::Script && (given.isSet("cone") || given.isSet("seed"))) {
        given.complain(QStringLiteral("--cone and --seed are not for --script."));
    }
    if (given.isSet("flight")) {
        options.flight = allFlightModes()[given.word("flight")].mode;
    }
    if (given.isSet("instant")) {
        options.flight = FlightMode::Instant;
    }
    options.constants = parametersOf(given, deformationParameters(), true);
    options.form = givenForm(given);
    options.separates = given.isSet("separate");
    options.refineTo = givenRefinement(given);
    options.repeat = givenRepeat(given);
    options.absolute = given.isSet("absolute");
    options.projectile = parametersOf(given, projectileParameters(), false);
    options.pipeline = givenPipeline(given);
    options.hitsPath = given.text("hits");
    options.scriptPath = given.text("script");
    options.savePath = given.text("save");
    options.meshOutPath = given.text("out");
    options.hitsOutPath = given.text("hits-out");
    options.sessionPath = given.text("session");
    options.picturePath = given.text("picture");
    return options;
}

}  // namespace hitscope::cli
