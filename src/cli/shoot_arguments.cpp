// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCommandLineParser>
#include <algorithm>

#include "cli/command_line.h"
#include "cli/pipeline_argument.h"
#include "cli/shoot.h"
#include "deform/dent_form_text.h"
#include "session/shot_script.h"

namespace hitscope::cli {

namespace {

QCommandLineOption option(const char* name, const QString& help, const char* value = "",
                          const char* usual = "") {
    return {QString::fromLatin1(name), help, QString::fromLatin1(value), QString::fromLatin1(usual)};
}

Error wrong(const char* what) {
    return {what, "", ""};
}

/// One that needs no numbers beside it.
std::optional<FlightMode> flightNamed(const QString& name) {
    for (const FlightModeTraits& traits : allFlightModes()) {
        if (traits.mode != FlightMode::Own && name == QLatin1String(traits.key)) {
            return traits.mode;
        }
    }
    return std::nullopt;
}

/// What shoot takes on the command line.
class ShootArguments {
public:
    void addTo(QCommandLineParser& parser) const;
    /// The error says which option is wrong.
    [[nodiscard]] Result<ShootOptions> read(const QCommandLineParser& parser) const;

private:
    [[nodiscard]] Status readBurst(const QCommandLineParser& parser, ShootOptions& options) const;
    [[nodiscard]] bool shoots(const QCommandLineParser& parser) const;
    [[nodiscard]] Result<DentForm> readForm(const QCommandLineParser& parser) const;

    QCommandLineOption m_script = option("script", QStringLiteral("Shot script to run."), "file");
    QCommandLineOption m_burst =
        option("burst", QStringLiteral("Shots in a burst, 1 to 100000."), "number", "20");
    QCommandLineOption m_cone = option(
        "cone", QStringLiteral("Degrees from the burst's middle to its edge, 0 to 180."), "number", "5");
    QCommandLineOption m_seed =
        option("seed", QStringLiteral("Another seed gives another burst."), "number", "1");
    QCommandLineOption m_every =
        option("every", QStringLiteral("Seconds between a burst's shots, 0 to 10."), "number", "0");
    QCommandLineOption m_instant = option("instant", QStringLiteral("Without flight: as --flight instant."));
    QCommandLineOption m_flight =
        option("flight",
               QStringLiteral(
                   "How a burst flies: quick (there in 0.1 s, by the size of the mesh), instant, or paper "
                   "(30 m/s, radius 0.1 m). Default: quick at a mesh, paper at the paper's scene."),
               "mode");
    QCommandLineOption m_save = option("save", QStringLiteral("Save the shots as a script."), "file");
    QCommandLineOption m_pipeline = option(
        "pipeline",
        QStringLiteral("Pipeline that applies the hits: %1.").arg(pipelineWords().join(QStringLiteral(", "))),
        "name", "transform-feedback");
    QCommandLineOption m_out = option(
        "out",
        QStringLiteral(
            "Write the deformed mesh: OBJ, PLY, STL, GLB, glTF or CSV, by its suffix; of several, the one "
            "with most changed vertices. The "
            "exit status is 1 where it is not what the reference makes of the hits."),
        "file");
    QCommandLineOption m_profile = option(
        "profile",
        QStringLiteral(
            "How far vertices move by their distance from the hit: paper, smooth, wendland, linear, crater, "
            "or curve."),
        "name", "paper");
    QCommandLineOption m_direction = option(
        "dent-direction",
        QStringLiteral("Which way vertices move: projectile, surface (against its normal), or press (out of "
                       "the projectile's sphere)."),
        "name", "projectile");
    QCommandLineOption m_curve =
        option("curve",
               QStringLiteral("The curve of --profile curve: eight numbers from -1 to 1 with commas between, "
                              "from the hit to max_distance, in parts of max_magnitude."),
               "numbers");
    QCommandLineOption m_hits =
        option("hits",
               QStringLiteral("Begin with the hits of a CSV or JSON file, as the window exports them. Shots "
                              "follow where a script or a burst is asked for."),
               "file");
    QCommandLineOption m_hitsOut = option(
        "hits-out", QStringLiteral("Write all hits: as JSON to a name with .json, else as CSV."), "file");
};

void ShootArguments::addTo(QCommandLineParser& parser) const {
    parser.addOptions({m_script, m_burst, m_cone, m_seed, m_every, m_instant, m_flight, m_save, m_pipeline,
                       m_out, m_hits, m_hitsOut, m_profile, m_direction, m_curve});
}

Status ShootArguments::readBurst(const QCommandLineParser& parser, ShootOptions& options) const {
    bool ok = false;
    options.burst = parser.value(m_burst).toInt(&ok);
    if (!ok || options.burst < 1 || options.burst > ShotScript::kMostShots) {
        return wrong("--burst takes a whole number from 1 to 100000.");
    }
    options.cone = parser.value(m_cone).toDouble(&ok);
    if (!ok || !(options.cone >= 0.0 && options.cone <= 180.0)) {
        return wrong("--cone takes a number from 0 to 180.");
    }
    options.seed = parser.value(m_seed).toUInt(&ok);
    if (!ok) {
        return wrong("--seed takes a whole number, 0 or more.");
    }
    options.interval = parser.value(m_every).toDouble(&ok);
    if (!ok || !(options.interval >= 0.0 && options.interval <= 10.0)) {
        return wrong("--every takes a number from 0 to 10.");
    }
    return Done{};
}

/// With hits from a file, only where something is said about shots.
bool ShootArguments::shoots(const QCommandLineParser& parser) const {
    const QList<QCommandLineOption> about{m_script, m_burst, m_cone,    m_seed,      m_every, m_instant,
                                          m_flight, m_save,  m_profile, m_direction, m_curve};
    return !parser.isSet(m_hits) ||
           std::any_of(about.begin(), about.end(), [&](const auto& one) { return parser.isSet(one); });
}

Result<DentForm> ShootArguments::readForm(const QCommandLineParser& parser) const {
    DentForm form;
    const auto profile = profileNamed(parser.value(m_profile).toStdString());
    if (!profile) {
        return wrong("--profile takes paper, smooth, wendland, linear, crater or curve.");
    }
    const auto direction = directionNamed(parser.value(m_direction).toStdString());
    if (!direction) {
        return wrong("--dent-direction takes projectile, surface or press.");
    }
    if (*direction == DentDirection::Press && (parser.isSet(m_profile) || parser.isSet(m_curve))) {
        return wrong("--dent-direction press has the projectile's shape, and takes no --profile.");
    }
    if (parser.isSet(m_curve)) {
        const auto curve = curveFrom(parser.value(m_curve).toStdString());
        if (!curve) {
            return wrong("--curve takes eight numbers from -1 to 1 with commas between.");
        }
        if (parser.isSet(m_profile) && *profile != DentProfile::Curve) {
            return wrong("--curve needs --profile curve.");
        }
        form.curve = *curve;
    }
    form.profile = parser.isSet(m_curve) ? DentProfile::Curve : *profile;
    form.direction = *direction;
    return form;
}

Result<ShootOptions> ShootArguments::read(const QCommandLineParser& parser) const {
    ShootOptions options;
    const Result<DentForm> form = readForm(parser);
    if (!form) {
        return form.error();
    }
    options.form = form.value();
    if (Status read = readBurst(parser, options); !read) {
        return read.error();
    }
    if (parser.isSet(m_script) && (parser.isSet(m_burst) || parser.isSet(m_cone) || parser.isSet(m_seed))) {
        return wrong("--script and --burst exclude each other.");
    }
    if (parser.positionalArguments().size() > 1) {
        return wrong("shoot takes one mesh at most.");
    }
    if (parser.isSet(m_instant)) {
        options.flight = FlightMode::Instant;
    } else if (parser.isSet(m_flight)) {
        options.flight = flightNamed(parser.value(m_flight));
        if (!options.flight) {
            return wrong("--flight takes quick, instant or paper.");
        }
    }
    const std::optional<PipelineKind> pipeline = pipelineNamed(parser.value(m_pipeline));
    if (!pipeline) {
        return Error{
            "--pipeline takes one of " + pipelineWords().join(QStringLiteral(", ")).toStdString() + ".", "",
            ""};
    }
    options.pipeline = parser.isSet(m_pipeline) ? pipeline : std::nullopt;
    options.shoots = shoots(parser);
    options.hitsPath = parser.value(m_hits);
    options.scriptPath = parser.value(m_script);
    options.savePath = parser.value(m_save);
    options.meshOutPath = parser.value(m_out);
    options.hitsOutPath = parser.value(m_hitsOut);
    options.meshPath = parser.positionalArguments().value(0);
    return options;
}

}  // namespace

int shootCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Shoots a burst or a saved script with no display, and prints what was hit, and a fingerprint each\n"
        "of the hits and of the positions: equal ones mean equal results, in every bit."));
    parser.addHelpOption();
    const ShootArguments taken;
    taken.addTo(parser);
    parser.addPositionalArgument(QStringLiteral("mesh"), QStringLiteral("Mesh file to shoot at."),
                                 QStringLiteral("[mesh]"));
    if (const std::optional<int> status = parse(parser, QStringLiteral("shoot"), arguments)) {
        return *status;
    }
    const Result<ShootOptions> options = taken.read(parser);
    return options ? finish(runShoot(options.value()))
                   : wrongUsage(QString::fromStdString(options.error().what));
}

}  // namespace hitscope::cli
