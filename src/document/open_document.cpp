// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/open_document.h"

#include <QCoreApplication>
#include <QDir>
#include <algorithm>
#include <new>
#include <set>
#include <utility>

#include "document/capture.h"
#include "document/source_mesh.h"
#include "mesh/panel_texture.h"
#include "session/session.h"
#include "session/target_plan.h"

namespace hitscope {

namespace {

QString translated(const char* words) {
    return QCoreApplication::translate("hitscope::OpenDocument", words);
}

/// Where a target stands, what it is called, how it behaves: on top of what its mesh makes of it.
TargetState stateOf(const SavedTarget& saved, const TargetPlan& plan) {
    TargetState state = hitscope::stateOf(plan, saved.id);
    state.name = saved.name;
    state.transform = saved.transform;
    state.visible = saved.visible;
    state.physics = saved.physics;
    return state;
}

/// All of what is to be restored but the meshes.
void takeScene(PreparedSession& prepared) {
    SessionDocument& document = prepared.document;
    SceneState& scene = prepared.scene;
    scene.name = document.scene.name;
    scene.floorHeight = document.scene.floorHeight;
    scene.lightSpace = document.scene.lightSpace;
    scene.lights = document.lights;
    std::set<TargetId> there;
    for (const TargetState& target : scene.targets) {
        there.insert(target.id);
    }
    for (const Hit& hit : document.hits) {
        if (there.contains(hit.target)) {
            scene.hits.push_back(hit);
        }
    }
    scene.selected = there.contains(document.selection.target) ? document.selection.target : TargetId{};
}

/// The triangles that hits struck are numbers of another mesh, where the mesh has changed.
void forgetTriangles(PreparedSession& prepared) {
    std::set<TargetId> changed;
    for (const MeshTrouble& trouble : prepared.troubles) {
        if (trouble.kind == MeshTrouble::Kind::Changed) {
            changed.insert(trouble.targets.begin(), trouble.targets.end());
        }
    }
    for (Hit& hit : prepared.document.hits) {
        if (changed.contains(hit.target)) {
            hit.triangle = kNoIndex;
        }
    }
}

void countHits(PreparedSession& prepared) {
    for (MeshTrouble& trouble : prepared.troubles) {
        const auto isOnIt = [&trouble](const Hit& hit) {
            return std::find(trouble.targets.begin(), trouble.targets.end(), hit.target) !=
                   trouble.targets.end();
        };
        const auto& hits = prepared.document.hits;
        trouble.hits = static_cast<std::size_t>(std::count_if(hits.begin(), hits.end(), isOnIt));
    }
}

void number(PreparedSession& prepared, TargetId first) {
    TargetNumbers numbers = numberTargets(first.value, prepared.document);
    SceneState& scene = prepared.scene;
    for (TargetState& target : scene.targets) {
        target.id = numbers[target.id];
    }
    for (Hit& hit : scene.hits) {
        hit.target = numbers[hit.target];
    }
    scene.selected = numbers[scene.selected];  // none stays none
}

/// A collected session names its files from its own folder only.
void makeAbsolute(SessionDocument& document, const QString& folder) {
    const auto from = [&folder](QString& path) {
        if (!folder.isEmpty() && !path.isEmpty() && QDir::isRelativePath(path)) {
            path = QDir::cleanPath(QDir(folder).absoluteFilePath(path));
        }
    };
    for (SavedTarget& target : document.targets) {
        if (auto* file = std::get_if<MeshFile>(&target.source.mesh)) {
            from(file->path);
        }
        for (LocatedTexture& texture : target.textures) {
            from(texture.path);
        }
    }
}

/// A journal is told the time only now and then: no hit is later than now. Hits may come from elsewhere, with
/// a time so long that the next step would add nothing to it.
double timeOf(const SessionDocument& document) {
    double time = document.simulation.time;
    for (const Hit& hit : document.hits) {
        time = std::max(time, hit.time);
    }
    return std::min(time, SimulationSettings::kLongest);
}

Error cancelled() {
    return {"Opening the session was cancelled.", "", ""};
}

}  // namespace

bool PreparedSession::isWhole() const {
    return std::all_of(troubles.begin(), troubles.end(),
                       [](const MeshTrouble& trouble) { return trouble.kind == MeshTrouble::Kind::Changed; });
}

Result<PreparedSession> prepareSession(SessionDocument document, const MeshPlaces& places,
                                       const PrepareControl& control) try {
    PreparedSession prepared;
    prepared.document = std::move(document);
    for (const std::string& place : prepared.document.notKnown) {
        prepared.notes << translated(QT_TRANSLATE_NOOP("hitscope::OpenDocument",
                                                       "%1 is not known to this version and was left out."))
                              .arg(QString::fromStdString(place));
    }
    makeAbsolute(prepared.document, places.folder);
    const std::vector<SavedTarget>& targets = prepared.document.targets;
    SourceMeshes meshes(places, control, prepared.troubles, prepared.notes);
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (control.isCancelled()) {
            return cancelled();
        }
        if (control.progress) {
            control.progress(
                static_cast<double>(i) / static_cast<double>(targets.size()),
                translated(QT_TRANSLATE_NOOP("hitscope::OpenDocument", "Making %1")).arg(targets[i].name));
        }
        if (const TargetPlan* plan = meshes.planOf(targets[i])) {
            prepared.scene.targets.push_back(stateOf(targets[i], *plan));
        }
    }
    if (const int size = prepared.document.scene.coverTexture; size >= 4) {
        prepared.coverTexture = std::make_shared<const Image>(makePanelTexture(size));
    }
    forgetTriangles(prepared);
    takeScene(prepared);
    countHits(prepared);
    if (control.isCancelled()) {
        return cancelled();
    }
    return prepared;
} catch (const std::bad_alloc&) {
    return Error{"There is not enough memory for this session.", "", "Close other programs and try again."};
}

std::vector<MeshFile> meshFilesOf(SessionDocument document, const MeshPlaces& places) {
    makeAbsolute(document, places.folder);
    std::vector<MeshFile> files;
    for (const SavedTarget& target : document.targets) {
        if (std::optional<MeshFile> found = findMesh(target, places)) {
            files.push_back(std::move(*found));
        }
    }
    return files;
}

void restoreSession(Session& session, PreparedSession& prepared) {
    number(prepared, session.targets().nextId());
    const SessionDocument& document = prepared.document;
    SessionSettings& settings = session.settings();
    // Ranges were checked when the document was read.
    static_cast<void>(settings.restoreConstants(document.constants));
    settings.restoreProjectile(document.projectile, document.simulation.flight);
    settings.restoreCoverTexture(prepared.coverTexture);
    settings.setPipeline(document.simulation.pipeline);
    Simulation& simulation = session.simulation();
    simulation.setStep(document.simulation.physicsStep);
    simulation.setTimeScale(document.simulation.timeScale);
    simulation.setPaused(document.simulation.paused);
    session.restoreScene(prepared.scene);
    simulation.setTime(timeOf(document));
    // With hits left out, the numbers of hits mean others.
    if (prepared.scene.hits.size() == document.hits.size()) {
        session.hits().show(document.selection.shown);
        session.hits().select(document.selection.hit);
    }
    session.selection().clear();
    for (const SavedSelection::Vertices& vertices : document.selection.vertices) {
        session.selection().select(vertices.target, vertices.vertices, VertexSelection::Combine::Add);
    }
    session.selection().setPicked(document.selection.picked);
    session.targets().select(prepared.scene.selected);
}

std::vector<TargetId> differingTargets(const Session& session, const SessionDocument& document) {
    std::vector<TargetId> differing;
    const std::vector<SavedPositions> now = capturePositions(session);
    for (const SavedPositions& saved : document.positions) {
        const auto known = std::find_if(now.begin(), now.end(), [&saved](const SavedPositions& positions) {
            return positions.target == saved.target;
        });
        if (known != now.end() && known->fingerprint != saved.fingerprint) {
            differing.push_back(saved.target);
        }
    }
    return differing;
}

}  // namespace hitscope
