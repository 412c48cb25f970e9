// SPDX-License-Identifier: GPL-3.0-or-later
// The session's targets on the GPU, and meshes that are about to be theirs.
#include <algorithm>
#include <utility>

#include "scene/scene_gpu_private.h"

namespace hitscope {

std::shared_ptr<const MaterialSet> SceneGpu::Private::materialsOf(const DeformedMesh& mesh) {
    std::weak_ptr<const MaterialSet>& known = materials[&mesh.original()];
    std::shared_ptr<const MaterialSet> set = known.lock();
    if (!set) {
        set = renderer->makeMaterials(mesh.original());
        known = set;
    }
    return set;
}

void SceneGpu::Private::followMaterials(const Target& target, GpuTarget& gpu) {
    if (gpu.dressed != target.deformed.sharedOriginal()) {
        gpu.dressed = target.deformed.sharedOriginal();
        gpu.materials = materialsOf(target.deformed);
        ++dataRevision;
    }
}

void SceneGpu::bringBeside(std::function<std::unique_ptr<gl::SideContext>()> make) {
    d->makeSide = std::move(make);
}

bool SceneGpu::bring(const std::shared_ptr<const MeshData>& mesh,
                     const std::shared_ptr<const RenderMesh>& render) {
    const auto known = std::find_if(d->coming.begin(), d->coming.end(),
                                    [&render](const auto& one) { return one->mesh() == render; });
    if (known == d->coming.end()) {
        if (const auto make = std::exchange(d->makeSide, nullptr)) {
            d->side = make();
        }
        d->coming.push_back(std::make_unique<Bringing>(*mesh, render, d->side.get()));
        return false;
    }
    return (*known)->more();
}

void SceneGpu::dropUnusedMeshes() {
    std::erase_if(d->coming, [this](const std::unique_ptr<Bringing>& coming) {
        return std::none_of(d->session.targets().begin(), d->session.targets().end(),
                            [&coming](const std::unique_ptr<Target>& target) {
                                return target->deformed.sharedRender() == coming->mesh();
                            });
    });
}

/// What has been brought, or new ones.
std::unique_ptr<TargetBuffers> SceneGpu::Private::buffersFor(const Target& target) {
    const auto known = std::find_if(coming.begin(), coming.end(), [&target](const auto& one) {
        return one->mesh() == target.deformed.sharedRender();
    });
    if (known == coming.end()) {
        return std::make_unique<TargetBuffers>(target.deformed.render(), target.deformed.original().colours);
    }
    std::unique_ptr<TargetBuffers> buffers = (*known)->take();
    coming.erase(known);
    return buffers;
}

bool SceneGpu::Private::hasNewTargets() const {
    return std::any_of(
        session.targets().begin(), session.targets().end(),
        [this](const std::unique_ptr<Target>& target) { return !targets.contains(target->id); });
}

void SceneGpu::Private::followTargets() {
    for (auto it = targets.begin(); it != targets.end();) {
        if (session.targets().find(it->first) == nullptr) {
            if (pipeline) {
                pipeline->removeTarget(it->first);
            }
            it = targets.erase(it);
            ++dataRevision;
        } else {
            ++it;
        }
    }
    std::erase_if(materials, [](const auto& entry) { return entry.second.expired(); });
    for (const std::unique_ptr<Target>& target : session.targets()) {
        if (const auto known = targets.find(target->id); known != targets.end()) {
            followMaterials(*target, known->second);
            continue;
        }
        isWarm = false;
        changeUpload.forget(target->id);
        GpuTarget& made =
            targets
                .try_emplace(target->id,
                             GpuTarget{nullptr, nullptr, ChangedParts(target->deformed.sharedRender())})
                .first->second;
        made.buffers = buffersFor(*target);
        if (!target->trueNormals.areOriginal()) {
            made.buffers->writeShadingNormals(0, target->trueNormals.normals().all());
        }
        followMaterials(*target, made);
        if (pipeline) {
            pipeline->addTarget(target->id, *made.buffers);
        }
    }
}

void SceneGpu::Private::followCover() {
    if (coverImage != session.settings().coverTexture()) {
        coverImage = session.settings().coverTexture();
        cover = coverImage ? renderer->makeCover(*coverImage) : nullptr;
        ++dataRevision;
    }
}

const MaterialSet* SceneGpu::Private::materialsToDraw(const Target& target) const {
    const bool covered = cover && !target.deformed.original().cornerTexcoords.empty();
    return covered ? cover.get() : targets.at(target.id).materials.get();
}

}  // namespace hitscope
