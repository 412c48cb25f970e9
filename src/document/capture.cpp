// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/capture.h"

#include <QDir>
#include <algorithm>
#include <memory>

#include "core/parallel.h"
#include "deform/fingerprint.h"
#include "session/session.h"

namespace hitscope {

namespace {

constexpr int kLongestName = 1000;  // characters: longer ones would be refused when they are read

SavedTarget saved(const Target& target) {
    SavedTarget saved;
    saved.id = target.id;
    saved.name = target.name.left(kLongestName);
    saved.source.mesh = target.source;
    for (const std::shared_ptr<const MeshStep>& step : target.steps) {
        saved.steps.push_back(*step);
    }
    saved.textures = target.textures;
    saved.placement = target.deformed.original().placement;
    saved.transform = target.transform;
    saved.visible = target.visible;
    saved.physics = target.physics;
    return saved;
}

SavedSelection selectionOf(const Session& session) {
    SavedSelection saved;
    saved.target = session.targets().selected();
    saved.hit = session.hits().selected();
    if (!session.hits().showsAll()) {
        saved.shown = session.hits().shown().size();
    }
    saved.picked = session.selection().picked();
    for (const TargetId target : session.selection().targets()) {
        const std::span<const std::uint32_t> vertices = session.selection().vertices(target);
        saved.vertices.push_back({target, {vertices.begin(), vertices.end()}});
    }
    return saved;
}

}  // namespace

SessionDocument captureSettings(const Session& session, const CapturedView& view) {
    const SessionSettings& settings = session.settings();
    const PhysicsWorld& physics = session.simulation().physics();
    SessionDocument document;
    document.scene = {session.sceneName().left(kLongestName), session.targets().floorHeight(),
                      settings.lightSpace(), settings.coverTexture() ? settings.coverTexture()->width : 0};
    for (const std::unique_ptr<Target>& target : session.targets()) {
        document.targets.push_back(saved(*target));
    }
    document.constants = settings.constantsSetting();
    document.projectile = settings.projectile();
    document.simulation = {
        settings.pipeline(),        settings.flightMode(),
        physics.clock().step(),     physics.clock().timeScale(),
        physics.clock().isPaused(), std::min(physics.clock().time(), SimulationSettings::kLongest)};
    document.lights = settings.lights();
    document.cameras = view.cameras;
    document.display = view.display;
    document.selection = selectionOf(session);
    return document;
}

SessionDocument captureTargets(const Session& session, const std::set<TargetId>& targets) {
    SessionDocument document;
    for (const TargetId id : targets) {
        if (const Target* target = session.targets().find(id)) {
            document.targets.push_back(saved(*target));
        }
    }
    return document;
}

SessionDocument captureHits(const Session& session, const CapturedView& view) {
    SessionDocument document = captureSettings(session, view);
    const std::span<const Hit> hits = session.hits().history().hits();
    document.hits.assign(hits.begin(), hits.end());
    return document;
}

SessionDocument captureSession(const Session& session, const CapturedView& view) {
    SessionDocument document = captureHits(session, view);
    document.positions = capturePositions(session);
    return document;
}

std::vector<CopiedPositions> copyPositions(const Session& session) {
    constexpr std::size_t kLeastPart = std::size_t{1} << 18;  // vertices
    std::vector<CopiedPositions> copies;
    if (!session.readBack().isUpToDate()) {
        return copies;
    }
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const std::span<const glm::vec3> from = target->deformed.positions();
        std::vector<glm::vec3>& to = copies.emplace_back(CopiedPositions{target->id, {}}).positions;
        to.resize(from.size());
        inParts(from.size(), kLeastPart, [&](std::size_t first, std::size_t end) {
            std::copy(from.data() + first, from.data() + end, to.data() + first);
        });
    }
    return copies;
}

std::vector<SavedPositions> fingerprintsOf(std::span<const CopiedPositions> copies) {
    std::vector<SavedPositions> positions;
    for (const CopiedPositions& copy : copies) {
        positions.push_back({copy.target, positionsFingerprint(copy.positions)});
    }
    return positions;
}

std::vector<SavedPositions> capturePositions(const Session& session) {
    std::vector<SavedPositions> positions;
    if (session.readBack().isUpToDate()) {
        for (const std::unique_ptr<Target>& target : session.targets()) {
            const DeformedMesh* mesh = &target->deformed;
            positions.push_back({target->id, positionsFingerprint({&mesh, 1})});
        }
    }
    return positions;
}

TargetNumbers numberTargets(std::uint32_t first, SessionDocument& document) {
    TargetNumbers numbers;
    for (SavedTarget& target : document.targets) {
        const TargetId id{first++};
        numbers[target.id] = id;
        target.id = id;
    }
    const auto renumber = [&numbers](TargetId& id) {
        const auto found = numbers.find(id);
        id = found != numbers.end() ? found->second : TargetId{};
    };
    for (Hit& hit : document.hits) {
        renumber(hit.target);
    }
    for (SavedPositions& positions : document.positions) {
        renumber(positions.target);
    }
    renumber(document.selection.target);
    if (document.selection.picked) {
        renumber(document.selection.picked->target);
    }
    for (SavedSelection::Vertices& vertices : document.selection.vertices) {
        renumber(vertices.target);
    }
    return numbers;
}

void nameFilesFrom(const QString& folder, SessionDocument& document) {
    for (SavedTarget& target : document.targets) {
        if (const auto* file = std::get_if<MeshFile>(&target.source.mesh)) {
            target.source.relativePath = QDir(folder).relativeFilePath(file->path);
        }
        for (LocatedTexture& texture : target.textures) {
            texture.relativePath = QDir(folder).relativeFilePath(texture.path);
        }
    }
}

}  // namespace hitscope
