// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/shoot.h"

#include <QDir>
#include <QTextStream>

#include "analysis/hit_files.h"
#include "cli/agreement.h"
#include "cli/common_options.h"
#include "cli/mesh_step_options.h"
#include "cli/opened_scene.h"
#include "cli/progress_line.h"
#include "cli/standard_streams.h"
#include "cli/verbs.h"
#include "document/capture.h"
#include "document/document_json.h"
#include "document/session_file.h"
#include "io/save_image.h"
#include "scene/picture.h"
#include "session/shots/shot_script_file.h"
#include "view/camera_text.h"

namespace hitscope::cli {

namespace {

/// As a file has them, or the standard input.
Result<HitRecords> hitsFrom(const QString& path) {
    if (!isStandardStream(path)) {
        return readHitFile(path);
    }
    const Result<QByteArray> bytes = readAllOf(path, static_cast<qint64>(kMostRecordBytes));
    if (!bytes) {
        return bytes.error();
    }
    Result<HitRecords> table = readHitRecords(
        {bytes.value().constData(), static_cast<std::size_t>(bytes.value().size())}, pipelineKeys());
    if (!table) {
        Error error = table.error();
        error.where = "standard input" + (error.where.empty() ? "" : ", " + error.where);
        return error;
    }
    return table;
}

}  // namespace

Status takeHits(Session& session, const QString& path) {
    const Result<HitRecords> table = hitsFrom(path);
    if (!table) {
        return table.error();
    }
    if (const QString other = otherTargetFor(session, table.value()); !other.isEmpty()) {
        note(QStringLiteral("note: the hits are of “%1”, and are applied to “%2”.")
                 .arg(QString::fromStdString(table.value().targets.begin()->second), other));
    }
    return appendRecords(session, table.value());
}

namespace {

/// Constants of the hits to come.
Status setConstants(Session& session, const ShootOptions& options) {
    ConstantsSetting setting = session.settings().constantsSetting();
    for (std::size_t i = 0; i < options.constants.size(); ++i) {
        if (options.constants[i]) {
            setParameterValue(setting.constants, i, *options.constants[i]);
        }
    }
    setting.relative = setting.relative && !options.absolute;
    setting.form = options.form.over(setting.form);
    return session.settings().setConstants(setting);
}

/// All that comes before the shots.
Status prepare(Session& session, const ShootOptions& options) {
    if (options.isZUp) {
        if (Status turned = turnAllUpright(session); !turned) {
            return turned;
        }
    }
    if (options.separates) {
        if (Status separated = separateAll(session); !separated) {
            return separated;
        }
    }
    if (Status changed = changeAll(session, options.meshSteps); !changed) {
        return changed;
    }
    if (Status set = setConstants(session, options); !set) {
        return set;
    }
    return options.hitsPath.isEmpty() ? Status(Done{}) : takeHits(session, options.hitsPath);
}

/// Until all shots have left and what they launched has hit or gone.
void play(Session& session, const ShotScript& script, ProgressLine& progress, int before) {
    schedule(session, script);
    const auto shots = static_cast<int>(script.shots.size());
    while (session.simulation().isMoving()) {
        session.simulation().stepOnce();
        progress.show(before + shots - static_cast<int>(session.simulation().shotsToCome()));
    }
}

Result<ShotScript> fireEach(Session& session, const ShootOptions& options) {
    if (options.shots == ShootOptions::Shots::Random) {
        ProgressLine progress(QStringLiteral("Shooting"), options.count);
        int before = 0;
        return shootAtSurface(session, options,
                              [&](const ShotScript& shot) { play(session, shot, progress, before++); });
    }
    Result<ShotScript> script = shotsOf(session, options);
    if (script) {
        ProgressLine progress(QStringLiteral("Shooting"), static_cast<int>(script.value().shots.size()));
        play(session, script.value(), progress, 0);
    }
    return script;
}

/// What was fired, and what came of it.
struct FiredShots {
    ShotScript script;
    std::size_t before = 0;  ///< hits that there were: of the session, of --hits
    std::size_t hits = 0;    ///< of these shots alone
};

/// All shots that are asked for, and their hits: there may be others already.
Result<FiredShots> fireAll(Session& session, const ShootOptions& options) {
    const std::size_t before = session.hits().history().size();
    Result<ShotScript> script = fireEach(session, options);
    if (!script) {
        return script.error();
    }
    return FiredShots{std::move(script).value(), before, session.hits().history().size() - before};
}

/// What comes after the shots, on the surface as they have left it; everything is read back then.
Outcome repeatHits(OpenedScene& scene, const ShootOptions& options) {
    Outcome synced = scene.sync();
    if (synced && options.repeat.scatters()) {
        const Status scattered = scatterHits(scene.session(), options.repeat, options.seed);
        synced = scattered ? scene.sync() : Outcome(scattered);
    }
    if (synced && options.repeat.mirror) {
        const Status mirrored = mirrorHits(scene.session(), options.repeat);
        synced = mirrored ? scene.sync() : Outcome(mirrored);
    }
    return synced;
}

/// That has all of the scene in it.
Camera cameraFor(const OpenedScene& scene, float aspect) {
    Camera camera;
    const Bounds bounds = scene.session().targets().bounds();
    camera.setSceneRadius(bounds.empty() ? 1.0f : bounds.diagonal());
    camera.frame(bounds, aspect);
    return camera;
}

/// As whoever opens it will see it.
CapturedView viewOf(const OpenedScene& scene) {
    if (const SessionDocument* document = scene.document()) {
        return {document->cameras, document->display};
    }
    return {{cameraText(cameraFor(scene, 16.0f / 9.0f)), {}}, {}};
}

Outcome writePicture(OpenedScene& scene, const QString& path, int samples) {
    PictureRequest request;
    request.samples = samples;
    request.options.shadows = samples > 1;  // as with picture
    request.camera = cameraFor(scene, static_cast<float>(request.width) / static_cast<float>(request.height));
    const Result<Image> image = drawPicture(scene.gpu(), request);
    return image ? Outcome(savePicture(image.value(), path)) : cannotDraw(image.error());
}

Status writeShots(const ShotScript& script, const QString& path) {
    if (!isStandardStream(path)) {
        return writeShotScript(script, path);
    }
    const QByteArray bytes = formatShotScript(script);
    return writeAllTo(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

Status writeHits(Session& session, const QString& path) {
    const WaitingLine waiting(QStringLiteral("Measuring hits"));
    HitEffects effects(session);
    effects.finish();
    const HitRecords table = recordsOf(session, &effects);
    return isStandardStream(path) ? writeAllTo(path, toCsv(table)) : writeHitFile(table, path);
}

Status writeSession(SessionDocument document, const QString& path) {
    if (!isStandardStream(path)) {
        return writeSessionFile(std::move(document), path);
    }
    const QByteArray bytes = writeDocument(document);
    return writeAllTo(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

/// All files that are asked for, but for the mesh.
Outcome writeFiles(OpenedScene& scene, const ShootOptions& options, const ShotScript& script) {
    Session& session = scene.session();
    if (!options.savePath.isEmpty()) {
        if (Status saved = writeShots(script, options.savePath); !saved) {
            return saved;
        }
    }
    if (!options.hitsOutPath.isEmpty()) {
        if (Status saved = writeHits(session, options.hitsOutPath); !saved) {
            return saved;
        }
    }
    if (!options.sessionPath.isEmpty()) {
        SessionDocument document = captureSession(session, viewOf(scene));
        document.simulation.pipeline = scene.pipeline();
        if (Status saved = writeSession(std::move(document), options.sessionPath); !saved) {
            return saved;
        }
    }
    return options.picturePath.isEmpty() ? Outcome(Done{})
                                         : writePicture(scene, options.picturePath, options.samples);
}

QString targetLines(const Session& session) {
    QString text;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const std::size_t hits = session.hits().history().hitsOn(target->id).size();
        if (hits > 0) {
            const std::size_t changed = target->deformed.statistics().changedVertices;
            text +=
                QStringLiteral("%1: %2, %3 changed\n")
                    .arg(target->name, counted(hits, "hit", "hits"), counted(changed, "vertex", "vertices"));
        }
    }
    return text;
}

/// "In dents.hitscope: the session", for each file that was written.
QString writtenLines(const ShootOptions& options) {
    QString text;
    for (const auto& [path, what] : {std::pair(options.savePath, QStringLiteral("the shots")),
                                     {options.hitsOutPath, QStringLiteral("the hits")},
                                     {options.sessionPath, QStringLiteral("the session")},
                                     {options.picturePath, QStringLiteral("the picture")}}) {
        if (!path.isEmpty() && !isStandardStream(path)) {
            text += QStringLiteral("In %1: %2\n").arg(QDir::toNativeSeparators(path), what);
        }
    }
    return text;
}

/// How many shots were to be fired, of which `fired` were.
std::size_t requestedShots(const ShootOptions& options, std::size_t fired) {
    return options.shots == ShootOptions::Shots::Random ? static_cast<std::size_t>(options.count) : fired;
}

void noteShots(const ShootOptions& options, const FiredShots& shots) {
    const std::size_t fired = shots.script.shots.size();
    if (const std::size_t requested = requestedShots(options, fired); fired < requested) {
        note(QStringLiteral("note: only %1 of %2: no other place that a shot could strike was found.")
                 .arg(fired)
                 .arg(counted(requested, "shot", "shots")));
    }
    if (fired > 0 && shots.hits == 0) {
        note(QStringLiteral("No shot hit a target."));
    }
}

/// What was hit, and whether the mesh is the reference's; then the mesh.
Outcome reportShots(Invocation& given, OpenedScene& scene, const ShootOptions& options,
                    const FiredShots& fired) {
    Session& session = scene.session();
    const std::size_t shots = fired.script.shots.size();
    const std::optional<ReferenceAgreement> agreement = agreementOfActive(session);
    JsonReport report("shoot");
    report.text("scene", options.scenePath).count("requested", requestedShots(options, shots));
    report.count("shots", shots);
    const std::size_t hits = session.hits().history().size();
    report.count("hits", hits).count("new_hits", hits - fired.before);
    addAgreement(report, session, agreement);
    addFingerprints(report, session);
    addTargets(report, session);
    QString text = shotsAndHits(shots, fired.hits, session) + u'\n' + targetLines(session) +
                   agreementLine(session, agreement) + u'\n' + fingerprintLines(session);
    text += writtenLines(options);
    Outcome result = Done{};
    if (!options.meshOutPath.isEmpty() && !session.targets().empty()) {
        const Target& exported = mostChangedTarget(session);
        if (Status status = exportNamed(session, exported, options.meshOutPath, NormalMode::True); !status) {
            return status;
        }
        text +=
            QStringLiteral("In %1: %2\n").arg(QDir::toNativeSeparators(options.meshOutPath), exported.name);
        result = exportAgrees(session, agreement, options.meshOutPath);
    }
    const Status said = giveReport(given, report, text);
    return said ? result : Outcome(said);
}

Outcome shoot(Invocation& given, const ShootOptions& options) {
    OpenedScene scene;
    if (Outcome opened = scene.open({.path = options.scenePath,
                                     .pipeline = options.pipeline,
                                     .isDrawn = !options.picturePath.isEmpty()});
        !opened) {
        return opened;
    }
    Session& session = scene.session();
    if (Status prepared = prepare(session, options); !prepared) {
        return prepared;
    }
    session.simulation().setPaused(false);  // as a session may have been saved
    const Result<FiredShots> fired = fireAll(session, options);
    if (!fired) {
        return fired.error();
    }
    if (Outcome repeated = repeatHits(scene, options); !repeated) {
        return repeated;
    }
    if (Outcome written = writeFiles(scene, options, fired.value().script); !written) {
        return written;
    }
    noteShots(options, fired.value());
    return reportShots(given, scene, options, fired.value());
}

int runShoot(Invocation& given) {
    const ShootOptions options = readShootOptions(given);
    if (!given.error().isEmpty()) {
        return kWrongUsage;
    }
    if (!options.picturePath.isEmpty()) {
        if (const Status known = checkPictureName(options.picturePath); !known) {
            given.complain(QString::fromStdString(known.error().message()));  // before the work
            return kWrongUsage;
        }
    }
    return finish(shoot(given, options));
}

}  // namespace

Verb shootVerb() {
    return {
        {.name = QStringLiteral("shoot"),
         .files = QStringLiteral("[MESH|SESSION]"),
         .about = QStringLiteral("shoot at a mesh or a session, print the hits, write hits and mesh"),
         .description = QStringLiteral(
             "Shoots without a display and prints the hits. Without a file, shoots at the paper's scene. "
             "Also prints fingerprints of the hits and of the positions: equal fingerprints mean equal "
             "results in every bit. The same command makes the same hits on every machine."),
         .options = shootOptions(),
         .examples =
             {{QStringLiteral("Fire fifty shots at random places and write the dented mesh."),
               QStringLiteral("hitscope-cli shoot --random 50 --seed 7 --out dented.obj bunny.obj")},
              {QStringLiteral("Fire one shot from above and write a session for the window."),
               QStringLiteral("hitscope-cli shoot --at 0,0.1,0 --direction 0,-1,0 --session one.hitscope "
                              "bunny.obj")},
              {QStringLiteral("Fire a burst with larger dents and report as JSON."),
               QStringLiteral("hitscope-cli shoot --burst 20 --cone 3 --max-distance 0.8 --json bunny.obj")}},
         .mostFiles = 1},
        runShoot};
}

}  // namespace hitscope::cli
