// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/target_plan.h"

#include <openssl/evp.h>

#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>
#include <string>
#include <utility>

#include "core/give_up.h"
#include "core/memory.h"
#include "core/parallel.h"

namespace hitscope {

namespace {

constexpr std::size_t kLarge = 100'000;  // vertices of a mesh whose making takes much memory for a while
constexpr float kGap = 0.1f;             // of the smaller of the two widths
constexpr float kFlat = 0.15f;           // as high in widths: higher ones stand on the floor
constexpr float kClearance = 0.25f;      // widths

bool overlap(const Bounds& a, const Bounds& b) {
    return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y &&
           a.min.z < b.max.z && b.min.z < a.max.z;
}

/// How far along x `wanted` has to go. Each thing in the way is passed once, so it ends.
float wayOut(Bounds wanted, const std::vector<Bounds>& taken) {
    const float start = wanted.min.x;
    const auto inTheWay = [&wanted](const Bounds& other) { return overlap(wanted, other); };
    for (auto other = std::find_if(taken.begin(), taken.end(), inTheWay); other != taken.end();
         other = std::find_if(taken.begin(), taken.end(), inTheWay)) {
        const float width = wanted.size().x;
        wanted.min.x = other->max.x + kGap * std::min(width, other->size().x);
        wanted.max.x = wanted.min.x + width;
        if (wanted.min.x < other->max.x) {
            break;  // so far out that floats cannot tell
        }
    }
    return wanted.min.x - start;
}

/// In hexadecimal; empty: it cannot be read. By OpenSSL, as Qt's own takes ten times as long where the
/// processor knows SHA: longer than reading a large mesh.
std::string sha256Of(QFile& file) {
    const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> hash(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
    bool good = hash && EVP_DigestInit_ex(hash.get(), EVP_sha256(), nullptr) == 1;
    std::vector<char> piece(std::size_t{1} << 20);
    while (good && !file.atEnd()) {
        mayGiveUp();
        const qint64 count = file.read(piece.data(), static_cast<qint64>(piece.size()));
        good = count > 0 && EVP_DigestUpdate(hash.get(), piece.data(), static_cast<std::size_t>(count)) == 1;
    }
    QByteArray result(EVP_MAX_MD_SIZE, '\0');
    unsigned size = 0;
    good =
        good && EVP_DigestFinal_ex(hash.get(), reinterpret_cast<unsigned char*>(result.data()), &size) == 1;
    return good ? result.first(static_cast<qsizetype>(size)).toHex().toStdString() : std::string();
}

}  // namespace

TargetPlan planMesh(MeshData mesh, const QString& sourcePath) {
    PreparedMesh prepared;
    TargetSource source;
    bothAtOnce(
        [&] {
            if (!sourcePath.isEmpty()) {
                source = meshFileAt(sourcePath);
            }
        },
        [&] { prepared = prepareMesh(std::move(mesh)); });
    if (prepared.mesh->vertexCount() > kLarge) {
        giveBackFreedMemory();
    }
    return planMesh(prepared, source);
}

TargetPlan planMesh(const PreparedMesh& mesh, const QString& sourcePath) {
    return planMesh(mesh, sourcePath.isEmpty() ? TargetSource() : meshFileAt(sourcePath));
}

TargetPlan planMesh(const PreparedMesh& mesh, const TargetSource& source, MeshSteps steps) {
    const auto* file = std::get_if<MeshFile>(&source);
    return {QString::fromStdString(mesh.mesh->name),
            mesh,
            {},
            MeshCollider{mesh.collision},
            file != nullptr ? file->path : QString(),
            source,
            std::move(steps)};
}

TargetState stateOf(TargetPlan plan, TargetId id) {
    TargetState state;
    state.id = id;
    state.name = std::move(plan.name);
    state.transform = plan.transform;
    state.sourcePath = std::move(plan.sourcePath);
    state.source = std::move(plan.source);
    state.steps = std::move(plan.steps);
    state.textures = std::move(plan.textures);
    state.shape = std::move(plan.shape);
    // A primitive is struck as what it is until its first dent, then as its triangles.
    std::visit([&state](auto& collider) { collider.surface = state.shape.collision; }, plan.collider);
    state.collider = std::make_shared<const Collider>(std::move(plan.collider));
    return state;
}

MeshFile meshFileAt(const QString& path) {
    MeshFile known{path};
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly | QIODevice::Unbuffered)) {
        return known;
    }
    if (std::string hash = sha256Of(file); !hash.empty()) {
        known.size = static_cast<std::uint64_t>(file.size());
        known.sha256 = std::move(hash);
    }
    return known;
}

Bounds worldBounds(const RenderMesh& mesh, const RigidTransform& transform) {
    const Bounds& local = mesh.bounds;
    Bounds world;
    if (local.empty()) {
        return world;
    }
    for (int corner = 0; corner < 8; ++corner) {
        world.add(transform.toWorld({(corner & 1) != 0 ? local.max.x : local.min.x,
                                     (corner & 2) != 0 ? local.max.y : local.min.y,
                                     (corner & 4) != 0 ? local.max.z : local.min.z}));
    }
    return world;
}

float floorUnder(const Bounds& target) {
    const float width = std::max(target.size().x, target.size().z);
    return target.min.y - (target.size().y < kFlat * width ? kClearance * width : 0.0f);
}

void bringNear(TargetPlan& plan, const Bounds& scene, float floor) {
    const Bounds bounds = worldBounds(*plan.shape.render, plan.transform);
    if (bounds.empty()) {
        return;
    }
    const bool isFar = glm::distance(bounds.centre(), scene.centre()) >= bounds.diagonal() + scene.diagonal();
    const glm::vec3 way = isFar ? scene.centre() - bounds.centre() : glm::vec3(0.0f);
    plan.transform.position += glm::vec3(way.x, floor - floorUnder(bounds), way.z);
}

void makeRoom(std::vector<TargetPlan>& plans, std::vector<Bounds> taken, std::optional<float> floor) {
    for (TargetPlan& plan : plans) {
        Bounds bounds = worldBounds(*plan.shape.render, plan.transform);
        if (bounds.empty()) {
            continue;
        }
        if (const float under = floorUnder(bounds); floor && under < *floor) {
            plan.transform.position.y += *floor - under;
            bounds = worldBounds(*plan.shape.render, plan.transform);
        }
        plan.transform.position.x += wayOut(bounds, taken);
        taken.push_back(worldBounds(*plan.shape.render, plan.transform));
    }
}

}  // namespace hitscope
