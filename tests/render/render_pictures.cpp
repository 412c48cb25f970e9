// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the scenes that lights and colours are judged by and writes them as PNG files.
#include <QDebug>
#include <QDir>
#include <utility>

#include "mesh/primitives.h"
#include "mesh/teapot.h"
#include "render_support.h"

using namespace hitscope;
using namespace hitscope::test;

namespace {

void save(const QDir& folder, const QString& name, const QImage& image) {
    const QString path = folder.filePath(name + QStringLiteral(".png"));
    if (image.isNull() || !image.save(path)) {
        qCritical("%s was not written", qPrintable(path));
    }
}

void drawScene(const QDir& folder, const QString& name, Renderer& renderer, TestScene& scene,
               std::span<const Hit> hits) {
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, hits);
    Frame frame = frameOf(scene, 1200, 720);
    scene.showTrueNormals(hits);
    const glm::vec3 orange(0.9f, 0.58f, 0.29f);
    const ProjectileItem projectiles[] = {
        {{scene.bounds().centre() + glm::vec3(1.5f, 2.4f, 2.2f), 0.1f}, orange, {}},
        {{scene.bounds().centre() + glm::vec3(2.0f, 1.4f, 2.9f), 0.1f}, orange, {}}};
    frame.projectiles = projectiles;
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        const QString suffix = theme == Theme::Dark ? QStringLiteral("-dark") : QStringLiteral("-light");
        frame.options.theme = theme;
        frame.options.wireframe = WireframeMode::Off;
        save(folder, name + suffix, picture(renderer, frame, *pipeline));
        frame.options.wireframe = WireframeMode::Over;
        frame.options.crosshair = true;
        if (!hits.empty()) {
            frame.highlightedHit = Sphere{scene.items().front().model * glm::vec4(hits.front().point, 1.0f),
                                          hits.front().constants.maxDistance};
        }
        scene.select(0, true);
        save(folder, name + suffix + QStringLiteral("-over"), picture(renderer, frame, *pipeline));
        frame.options.wireframe = WireframeMode::Only;
        save(folder, name + suffix + QStringLiteral("-only"), picture(renderer, frame, *pipeline));
        scene.select(0, false);
        frame.highlightedHit.reset();
        frame.options.crosshair = false;
        frame.options.wireframe = WireframeMode::Off;
        const std::pair<const char*, bool DisplayOptions::*> modes[] = {
            {"-shadows", &DisplayOptions::shadows},
            {"-flat", &DisplayOptions::flat},
            {"-needles", &DisplayOptions::needles},
            {"-dots", &DisplayOptions::dots},
            {"-backs", &DisplayOptions::backFaces}};
        for (const auto& [mode, option] : modes) {
            frame.options.*option = true;
            save(folder, name + suffix + QLatin1String(mode), picture(renderer, frame, *pipeline));
            frame.options.*option = false;
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        qCritical("Usage: render_pictures FOLDER");
        return 1;
    }
    const QDir folder(QString::fromLocal8Bit(argv[1]));
    folder.mkpath(QStringLiteral("."));
    const auto context = gl::OffscreenContext::create();
    if (!context) {
        qCritical("%s", context.error().message().c_str());
        return 1;
    }
    const auto renderer = Renderer::create();
    if (!renderer) {
        qCritical("%s", renderer.error().message().c_str());
        return 1;
    }
    TestScene sphere;
    addSphere(sphere, *renderer.value());
    drawScene(folder, QStringLiteral("sphere"), *renderer.value(), sphere, dents({1}, 12));
    TestScene paper;
    addPaperScene(paper, *renderer.value());
    drawScene(folder, QStringLiteral("paper"), *renderer.value(), paper, dents({1}, 12));
    TestScene teapot;
    teapot.add(*renderer.value(), makeTeapot(), glm::vec3(0.0f));
    drawScene(folder, QStringLiteral("teapot"), *renderer.value(), teapot, {});
    return 0;
}
