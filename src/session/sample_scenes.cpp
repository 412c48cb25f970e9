// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sample_scenes.h"

#include <QCoreApplication>
#include <array>
#include <numbers>

#include "session/primitive_target.h"

namespace hitscope {

namespace {

QString translated(const char* words) {
    return QCoreApplication::translate("hitscope::SampleScene", words);
}

ScenePlan planTurntable() {
    TargetPlan teapot = planBuiltIn(BuiltInMesh::Teapot);
    const Bounds bounds = teapot.shape.render->bounds;
    teapot.name = translated(QT_TRANSLATE_NOOP("hitscope::SampleScene", "Utah teapot"));
    teapot.transform.position = -bounds.centre();
    teapot.transform.position.y = kTurntableHeight - bounds.min.y;
    TargetPlan table = planBuiltIn(BuiltInMesh::TurntableStand);
    table.name = translated(QT_TRANSLATE_NOOP("hitscope::SampleScene", "Turntable"));
    table.transform.position.y = 0.5f * kTurntableHeight;
    return {{}, {std::move(teapot), std::move(table)}, 0.0f};
}

ScenePlan planWall() {
    constexpr int kAcross = 10;
    constexpr float kSize = 2.0f;     // metres
    constexpr float kSpacing = 2.5f;  // metres
    const TargetPlan kinds[] = {planPrimitive({PrimitiveKind::Cube, 14, kSize}),
                                planPrimitive({PrimitiveKind::GeodesicSphere, 11, kSize})};
    ScenePlan scene{{}, {}, 0.0f};
    for (int row = 0; row < kAcross; ++row) {
        for (int column = 0; column < kAcross; ++column) {
            TargetPlan target = kinds[(row + column) % 2];
            target.name = QStringLiteral("%1 %2").arg(target.name).arg(scene.targets.size() / 2 + 1);
            target.transform.position.x = (static_cast<float>(column) - 0.5f * (kAcross - 1)) * kSpacing;
            target.transform.position.y += static_cast<float>(row) * kSpacing;
            scene.targets.push_back(std::move(target));
        }
    }
    return scene;
}

ScenePlan planTwoMillion() {
    TargetPlan torus = planBuiltIn(BuiltInMesh::FineTorus);
    torus.name = translated(QT_TRANSLATE_NOOP("hitscope::SampleScene", "Fine torus"));
    // Upright, so that shots go through its hole.
    torus.transform.rotation = glm::angleAxis(0.5f * std::numbers::pi_v<float>, glm::vec3(1, 0, 0));
    torus.transform.position.y = kFineTorusRadius + kFineTorusTube;
    return {{}, {std::move(torus)}, 0.0f};
}

}  // namespace

std::span<const SampleScene> allSampleScenes() {
    static constexpr std::array<SampleScene, 3> kScenes = {SampleScene::Turntable, SampleScene::Wall,
                                                           SampleScene::TwoMillion};
    return kScenes;
}

QString sampleSceneName(SampleScene scene) {
    constexpr std::array<const char*, 3> kNames = {
        QT_TRANSLATE_NOOP("hitscope::SampleScene", "Teapot on a turntable"),
        QT_TRANSLATE_NOOP("hitscope::SampleScene", "Wall of 100 targets"),
        QT_TRANSLATE_NOOP("hitscope::SampleScene", "Torus of 2,000,000 triangles")};
    return translated(kNames[static_cast<std::size_t>(scene)]);
}

ScenePlan planSampleScene(SampleScene scene) {
    ScenePlan plan = scene == SampleScene::Turntable ? planTurntable()
                     : scene == SampleScene::Wall    ? planWall()
                                                     : planTwoMillion();
    plan.name = sampleSceneName(scene);
    return plan;
}

}  // namespace hitscope
