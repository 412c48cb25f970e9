// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/shoot.h"

#include <QCommandLineParser>
#include <QFileInfo>
#include <QTextStream>
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "cli/command_line.h"
#include "gl/context.h"
#include "io/import.h"
#include "session/scene_gpu.h"
#include "session/session.h"
#include "session/shot_script_file.h"

namespace hitscope::cli {

namespace {

Status loadScene(Session& session, const QString& meshPath) {
    if (meshPath.isEmpty()) {
        session.loadPaperRow(kDefaultPaperRow);
        return Done{};
    }
    Result<ImportedMesh> imported = importMesh(meshPath);
    if (!imported) {
        return imported.error();
    }
    session.loadMesh(std::move(imported.value().mesh), QFileInfo(meshPath).absoluteFilePath());
    return Done{};
}

ShotScript burstAt(const Session& session, const ShootOptions& options) {
    constexpr float kPicture = 16.0f / 9.0f;
    constexpr float kFarthest = 1.0e7f;  // metres
    Camera camera;
    camera.frame(session.sceneBounds(), kPicture);
    const auto met = session.physics().castRay(camera.eye(), camera.forward(), kFarthest);
    const Target* target = met ? session.target(met->target) : nullptr;
    const FlightMode flight =
        options.flight.value_or(options.meshPath.isEmpty() ? FlightMode::Paper : FlightMode::Quick);
    ShotScript script;
    script.projectile = projectileOf(flight, session.projectileSettings(),
                                     target != nullptr ? target->extent() : kUsualExtent,
                                     met ? glm::distance(met->point, camera.eye()) : camera.distance());
    script.projectile.mostAlive = std::max(script.projectile.mostAlive, options.burst);
    script.isInstant = flight == FlightMode::Instant;
    script.shots = burst({camera.eye(), camera.forward()}, options.burst,
                         static_cast<float>(glm::radians(options.cone)), options.seed, options.interval);
    return script;
}

/// FNV-1a over what a hit is made of.
class Fingerprint {
public:
    template <class Number>
    void add(Number number) {
        unsigned char bytes[sizeof(Number)];
        std::memcpy(bytes, &number, sizeof(Number));
        for (const unsigned char byte : bytes) {
            m_value = (m_value ^ byte) * 1099511628211u;
        }
    }
    void add(const glm::vec3& v) {
        add(v.x);
        add(v.y);
        add(v.z);
    }
    [[nodiscard]] QString text() const { return QStringLiteral("%1").arg(m_value, 16, 16, QLatin1Char('0')); }

private:
    std::uint64_t m_value = 14695981039346656037u;
};

QString fingerprint(const Session& session) {
    Fingerprint print;
    for (const Hit& hit : session.history().hits()) {
        print.add(hit.target.value);
        print.add(hit.point);
        print.add(hit.direction);
        print.add(hit.normal);
        print.add(hit.time);
        print.add(hit.speed);
        print.add(hit.impulse);
        print.add(hit.triangle);
    }
    return print.text();
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

/// Until all shots have left and what they launched has hit or gone.
void play(Session& session, SceneGpu& gpu) {
    session.setCatchUp([&gpu] { static_cast<void>(gpu.syncPositions()); });
    while (session.isMoving()) {
        session.stepOnce();
    }
    session.setCatchUp({});
}

}  // namespace

Status runShoot(const ShootOptions& options) {
    QTextStream out(stdout);
    Result<std::unique_ptr<gl::OffscreenContext>> context = gl::OffscreenContext::create();
    if (!context) {
        return context.error();
    }
    Session session;
    if (Status status = loadScene(session, options.meshPath); !status) {
        return status;
    }
    ShotScript script;
    if (options.scriptPath.isEmpty()) {
        script = burstAt(session, options);
    } else {
        Result<ShotScript> read = readShotScript(options.scriptPath);
        if (!read) {
            return read.error();
        }
        script = std::move(read).value();
    }
    if (!options.savePath.isEmpty()) {
        if (Status status = writeShotScript(script, options.savePath); !status) {
            return status;
        }
    }
    Result<std::unique_ptr<SceneGpu>> gpu = SceneGpu::create(session);
    if (!gpu) {
        return gpu.error();
    }
    schedule(session, script);
    play(session, *gpu.value());
    if (Status status = gpu.value()->sync(); !status) {
        return status;
    }
    out << script.shots.size() << " shots, " << session.history().size() << " hits, fingerprint "
        << fingerprint(session) << "\n";
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const std::size_t hits = session.history().hitsOn(target->id).size();
        if (hits > 0) {
            out << target->name << ": " << hits << " hits, " << target->deformed.statistics().changedVertices
                << " vertices changed\n";
        }
    }
    return Done{};
}

int shootCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Shoots a burst or a saved script with no display, and prints what was hit."));
    parser.addHelpOption();
    const QString number = QStringLiteral("number");
    const QCommandLineOption script(QStringLiteral("script"), QStringLiteral("Shot script to run."),
                                    QStringLiteral("file"));
    const QCommandLineOption burst(QStringLiteral("burst"), QStringLiteral("Shots in a burst, 1 to 100000."),
                                   number, QStringLiteral("20"));
    const QCommandLineOption cone(QStringLiteral("cone"),
                                  QStringLiteral("Degrees from the burst's middle to its edge, 0 to 180."),
                                  number, QStringLiteral("5"));
    const QCommandLineOption seed(QStringLiteral("seed"), QStringLiteral("Another seed gives another burst."),
                                  number, QStringLiteral("1"));
    const QCommandLineOption every(QStringLiteral("every"),
                                   QStringLiteral("Seconds between a burst's shots, 0 to 10."), number,
                                   QStringLiteral("0"));
    const QCommandLineOption instant(QStringLiteral("instant"),
                                     QStringLiteral("Without flight: as --flight instant."));
    const QCommandLineOption flight(
        QStringLiteral("flight"),
        QStringLiteral(
            "How a burst flies: quick (there in 0.1 s, by the size of the mesh), instant, or paper "
            "(30 m/s, radius 0.1 m). Default: quick at a mesh, paper at the paper's scene."),
        QStringLiteral("mode"));
    const QCommandLineOption save(QStringLiteral("save"), QStringLiteral("Save the shots as a script."),
                                  QStringLiteral("file"));
    parser.addOptions({script, burst, cone, seed, every, instant, flight, save});
    parser.addPositionalArgument(QStringLiteral("mesh"), QStringLiteral("Mesh file to shoot at."),
                                 QStringLiteral("[mesh]"));
    if (const std::optional<int> status = parse(parser, QStringLiteral("shoot"), arguments)) {
        return *status;
    }
    ShootOptions options;
    bool ok = false;
    options.burst = parser.value(burst).toInt(&ok);
    if (!ok || options.burst < 1 || options.burst > ShotScript::kMostShots) {
        return wrongUsage(QStringLiteral("--burst takes a whole number from 1 to 100000."));
    }
    options.cone = parser.value(cone).toDouble(&ok);
    if (!ok || !(options.cone >= 0.0 && options.cone <= 180.0)) {
        return wrongUsage(QStringLiteral("--cone takes a number from 0 to 180."));
    }
    options.seed = parser.value(seed).toUInt(&ok);
    if (!ok) {
        return wrongUsage(QStringLiteral("--seed takes a whole number, 0 or more."));
    }
    options.interval = parser.value(every).toDouble(&ok);
    if (!ok || !(options.interval >= 0.0 && options.interval <= 10.0)) {
        return wrongUsage(QStringLiteral("--every takes a number from 0 to 10."));
    }
    if (parser.isSet(script) && (parser.isSet(burst) || parser.isSet(cone) || parser.isSet(seed))) {
        return wrongUsage(QStringLiteral("--script and --burst exclude each other."));
    }
    if (parser.positionalArguments().size() > 1) {
        return wrongUsage(QStringLiteral("shoot takes one mesh at most."));
    }
    if (parser.isSet(instant)) {
        options.flight = FlightMode::Instant;
    } else if (parser.isSet(flight)) {
        options.flight = flightNamed(parser.value(flight));
        if (!options.flight) {
            return wrongUsage(QStringLiteral("--flight takes quick, instant or paper."));
        }
    }
    options.scriptPath = parser.value(script);
    options.savePath = parser.value(save);
    options.meshPath = parser.positionalArguments().value(0);
    return finish(runShoot(options));
}

}  // namespace hitscope::cli
