// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/shoot.h"

#include <QDir>
#include <QTextStream>
#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "analysis/hit_files.h"
#include "cli/agreement.h"
#include "cli/load_scene.h"
#include "gl/context.h"
#include "session/export/export_target.h"
#include "session/shot_script_file.h"

namespace hitscope::cli {

namespace {

ShotScript burstAt(const Session& session, const ShootOptions& options) {
    constexpr float kPicture = 16.0f / 9.0f;
    constexpr float kFarthest = 1.0e7f;  // metres
    Camera camera;
    camera.frame(session.targets().bounds(), kPicture);
    const auto met = session.simulation().physics().castRay(camera.eye(), camera.forward(), kFarthest);
    const Target* target = met ? session.targets().find(met->target) : nullptr;
    const FlightMode flight =
        options.flight.value_or(options.meshPath.isEmpty() ? FlightMode::Paper : FlightMode::Quick);
    ShotScript script;
    script.projectile = projectileOf(flight, session.settings().projectile(),
                                     target != nullptr ? target->extent() : kUsualExtent,
                                     met ? glm::distance(met->point, camera.eye()) : camera.distance());
    script.projectile.mostAlive = std::max(script.projectile.mostAlive, options.burst);
    script.isInstant = flight == FlightMode::Instant;
    if (!options.form.isPaper()) {
        script.projectile.form = options.form;
    }
    script.shots = burst({camera.eye(), camera.forward()}, options.burst,
                         static_cast<float>(glm::radians(options.cone)), options.seed, options.interval);
    return script;
}

/// The shots there are, which may be none; saved where that is asked for.
Result<ShotScript> scriptOf(const Session& session, const ShootOptions& options) {
    ShotScript script;
    if (!options.scriptPath.isEmpty()) {
        Result<ShotScript> read = readShotScript(options.scriptPath);
        if (!read) {
            return read.error();
        }
        script = std::move(read).value();
    } else if (options.shoots) {
        script = burstAt(session, options);
    }
    if (!options.savePath.isEmpty()) {
        if (Status status = writeShotScript(script, options.savePath); !status) {
            return status.error();
        }
    }
    return script;
}

Status addHits(Session& session, const QString& path) {
    if (path.isEmpty()) {
        return Done{};
    }
    const Result<HitRecords> hits = readHitFile(path);
    return hits ? appendRecords(session, hits.value()) : Status(hits.error());
}

void printTargets(QTextStream& out, const Session& session) {
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const std::size_t hits = session.hits().history().hitsOn(target->id).size();
        if (hits > 0) {
            out << target->name << ": " << hits << " hits, " << target->deformed.statistics().changedVertices
                << " vertices changed\n";
        }
    }
}

/// The files asked for and the fingerprints; then whether the mesh is the reference's.
Status writeResults(QTextStream& out, Session& session, const ShootOptions& options) {
    if (!options.hitsOutPath.isEmpty()) {
        HitEffects effects(session);
        effects.finish();
        if (Status status = writeHitFile(recordsOf(session, &effects), options.hitsOutPath); !status) {
            return status;
        }
    }
    const std::optional<ReferenceAgreement> agreement = agreementOfActive(session);
    out << agreementLine(session, agreement) << "\n" << fingerprintLines(session);
    if (options.meshOutPath.isEmpty()) {
        return Done{};
    }
    const Target& exported = mostChangedTarget(session);
    if (Status status = exportNamed(session, exported, options.meshOutPath, NormalMode::True); !status) {
        return status;
    }
    out << "In " << QDir::toNativeSeparators(options.meshOutPath) << ": " << exported.name << "\n";
    out.flush();
    return exportAgrees(session, agreement, options.meshOutPath);
}

/// Until all shots have left and what they launched has hit or gone.
void play(Session& session) {
    while (session.simulation().isMoving()) {
        session.simulation().stepOnce();
    }
}

}  // namespace

Status runShoot(const ShootOptions& options) {
    QTextStream out(stdout);
    Result<std::unique_ptr<gl::OffscreenContext>> context = gl::OffscreenContext::create();
    if (!context) {
        return context.error();
    }
    Session session;
    QTextStream notes(stderr);
    if (Status status = loadScene(session, options.meshPath, notes); !status) {
        return status;
    }
    if (Status status = session.settings().setForm(options.form); !status) {
        return status;
    }
    const Result<ShotScript> script = scriptOf(session, options);
    if (!script) {
        return script.error();
    }
    Result<std::unique_ptr<SceneGpu>> gpu = SceneGpu::create(session);
    if (!gpu) {
        return gpu.error();
    }
    if (Status status = useAskedPipeline(session, *gpu.value(), options.pipeline); !status) {
        return status;
    }
    if (Status status = addHits(session, options.hitsPath); !status) {
        return status;
    }
    schedule(session, script.value());
    play(session);
    if (Status status = gpu.value()->sync(); !status) {
        return status;
    }
    out << script.value().shots.size() << " shots, " << session.hits().history().size() << " hits\n";
    printTargets(out, session);
    return writeResults(out, session, options);
}

}  // namespace hitscope::cli
