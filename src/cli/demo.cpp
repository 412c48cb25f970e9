// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QStringList>
#include <QTextStream>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "cli/commands.h"
#include "cli/load_scene.h"
#include "deform/reference.h"
#include "gl/context.h"
#include "gl/render_target.h"
#include "io/save_image.h"
#include "session/demo_shots.h"
#include "session/export_target.h"
#include "session/scene_gpu.h"
#include "session/session.h"

namespace hitscope::cli {

namespace {

/// Every target's vertices as a pipeline made them.
using Meshes = std::vector<std::vector<DynamicVertex>>;

Meshes copyMeshes(const Session& session) {
    Meshes meshes;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const std::span<const DynamicVertex> vertices = target->deformed.vertices();
        meshes.emplace_back(vertices.begin(), vertices.end());
    }
    return meshes;
}

struct Agreement {
    double largest = 0.0;       ///< metres
    std::size_t different = 0;  ///< vertices whose position or normal differs in any bit
};

Agreement compare(const Meshes& a, const Meshes& b) {
    Agreement agreement;
    for (std::size_t t = 0; t < a.size(); ++t) {
        for (std::size_t i = 0; i < a[t].size(); ++i) {
            const double distance = glm::distance(a[t][i].position, b[t][i].position);
            agreement.largest = std::max(agreement.largest, distance);
            if (a[t][i].position != b[t][i].position || a[t][i].normal != b[t][i].normal) {
                ++agreement.different;
            }
        }
    }
    return agreement;
}

/// What the reference makes of the hits that the session's pipeline keeps.
Meshes referenceMeshes(const Session& session) {
    const std::span<const Hit> history = session.history().hits();
    Meshes meshes;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        std::vector<Hit> hits;
        for (std::size_t i = 0; i < history.size(); ++i) {
            if (history[i].target == target->id && session.isApplied(i)) {
                hits.push_back(history[i]);
            }
        }
        ReferenceDeformation reference(target->deformed.render());
        reference.apply(hits);
        meshes.emplace_back(reference.vertices().begin(), reference.vertices().end());
    }
    return meshes;
}

const Target& mostChangedTarget(const Session& session) {
    const auto changed = [](const std::unique_ptr<Target>& target) {
        return target->deformed.statistics().changedVertices;
    };
    return **std::max_element(session.targets().begin(), session.targets().end(),
                              [&](const auto& a, const auto& b) { return changed(a) < changed(b); });
}

/// The demo's parts that need the same things: the session on a GPU without a window, and where the results
/// go.
class Demo {
public:
    Demo(Session& session, SceneGpu& gpu, const DemoOptions& options)
        : m_session(session), m_gpu(gpu), m_options(options), m_target(options.width, options.height, 4) {
        m_view.options.normals = options.normals;
        m_view.width = options.width;
        m_view.height = options.height;
        m_view.camera.frame(session.sceneBounds(),
                            static_cast<float>(options.width) / static_cast<float>(options.height));
    }

    [[nodiscard]] Status picture(const QString& name, WireframeMode wireframe) {
        m_view.options.wireframe = wireframe;
        if (Status status = m_gpu.draw(m_view, m_target.framebuffer()); !status) {
            return status;
        }
        return savePicture(m_target.read(), path(name));
    }

    /// Applies the hits with this pipeline; how it agrees with the reference.
    [[nodiscard]] Result<Agreement> apply(PipelineKind kind) {
        m_session.setPipeline(kind);
        if (Status status = m_gpu.sync(); !status) {
            return status.error();
        }
        return compare(copyMeshes(m_session), referenceMeshes(m_session));
    }

    [[nodiscard]] QString path(const QString& name) const { return QDir(m_options.folder).filePath(name); }

private:
    Session& m_session;
    SceneGpu& m_gpu;
    const DemoOptions& m_options;
    gl::RenderTarget m_target;
    SceneGpu::View m_view;
};

void printTable(QTextStream& out, const Session& session) {
    const int nameWidth = 24;
    out << QStringLiteral("target").leftJustified(nameWidth)
        << "  vertices  hits  affected  largest displacement\n";
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const DisplacementStatistics statistics = target->deformed.statistics();
        out << target->name.leftJustified(nameWidth, QLatin1Char(' '), true)
            << QString::number(target->deformed.original().vertexCount()).rightJustified(10)
            << QString::number(session.history().hitsOn(target->id).size()).rightJustified(6)
            << QString::number(statistics.changedVertices).rightJustified(10)
            << QStringLiteral("%1 m\n").arg(statistics.maximum, 20, 'f', 3);
    }
}

QString agreementText(const Agreement& agreement, const Session& session) {
    QString text = agreement.different == 0
                       ? QStringLiteral("as the reference in every bit")
                       : QStringLiteral("%1 vertices differ from the reference, by %2 m at most")
                             .arg(agreement.different)
                             .arg(agreement.largest);
    if (session.droppedHits() > 0) {
        text += QStringLiteral("; it keeps the last %1 hits%2")
                    .arg(session.capacity().used)
                    .arg(session.capacity().perTarget ? QStringLiteral(" on a target") : QString());
    }
    return text;
}

/// Applies the hits with every pipeline that runs here, and says how it agrees with the reference.
Result<QStringList> comparePipelines(Demo& demo, const Session& session) {
    QStringList lines;
    for (const PipelineTraits& traits : allPipelines()) {
        const QString name = QString::fromUtf8(traits.name);
        const QString unavailable = session.whyUnavailable(traits.kind);
        if (!unavailable.isEmpty()) {
            lines << QStringLiteral("%1: not here. %2").arg(name, unavailable);
            continue;
        }
        const Result<Agreement> agreement = demo.apply(traits.kind);
        if (!agreement) {
            return agreement.error();
        }
        lines << name + QStringLiteral(": ") + agreementText(agreement.value(), session);
    }
    return lines;
}

}  // namespace

Status runDemo(const DemoOptions& options) {
    QTextStream out(stdout);
    if (!QDir().mkpath(options.folder)) {
        return Error{"The folder cannot be made.", options.folder.toStdString(),
                     "Choose one you may write to."};
    }
    Result<std::unique_ptr<gl::OffscreenContext>> context = gl::OffscreenContext::create();
    if (!context) {
        return context.error();
    }
    gl::collectDebugMessages();
    Session session;
    if (Status status = loadScene(session, options.meshPath, out); !status) {
        return status;
    }
    Result<std::unique_ptr<SceneGpu>> gpu = SceneGpu::create(session);
    if (!gpu) {
        return gpu.error();
    }
    session.setCatchUp([&gpu] { static_cast<void>(gpu.value()->sync()); });
    Demo demo(session, *gpu.value(), options);
    if (Status status = demo.picture(QStringLiteral("before.png"), WireframeMode::Off); !status) {
        return status;
    }
    shootAll(session, demoShots(session, options.shots, options.seed));
    session.selectTarget({});

    const Result<QStringList> compared = comparePipelines(demo, session);
    if (!compared) {
        return compared.error();
    }
    if (const Result<Agreement> shown = demo.apply(options.pipeline); !shown) {
        return shown.error();
    }
    const Target& exported = mostChangedTarget(session);
    for (const Status& status :
         {demo.picture(QStringLiteral("after.png"), WireframeMode::Off),
          demo.picture(QStringLiteral("wireframe.png"), WireframeMode::Over),
          exportTarget(exported, demo.path(QStringLiteral("deformed.obj")), options.normals)}) {
        if (!status) {
            return status;
        }
    }
    if (const std::vector<std::string> errors = gl::takeErrors(); !errors.empty()) {
        return Error{"OpenGL reports: " + errors.front(), "", "Please report this with the renderer's name."};
    }

    out << "Renderer: " << QString::fromStdString(gl::rendererInfo().renderer);
    if (session.exactness()) {
        out << ", " << QString::fromStdString(describe(*session.exactness()));
    }
    out << "\n" << options.shots << " shots, " << session.history().size() << " hits\n\n";
    printTable(out, session);
    out << "\n" << compared.value().join(QLatin1Char('\n')) << "\n";
    out << "\nIn " << QDir::toNativeSeparators(QDir(options.folder).absolutePath())
        << ": before.png, after.png, wireframe.png, deformed.obj (" << exported.name << ")\n";
    return Done{};
}

}  // namespace hitscope::cli
