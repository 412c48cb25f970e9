// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QStringList>
#include <QTextStream>

#include "cli/agreement.h"
#include "cli/commands.h"
#include "cli/load_scene.h"
#include "gl/context.h"
#include "gl/render_target.h"
#include "io/save_image.h"
#include "scene/picture.h"
#include "scene/scene_gpu.h"
#include "session/demo_shots.h"
#include "session/export/export_target.h"
#include "session/session.h"

namespace hitscope::cli {

namespace {

/// The demo's parts that need the same things: the session on a GPU without a window, and where the results
/// go.
class Demo {
public:
    Demo(Session& session, SceneGpu& gpu, const DemoOptions& options)
        : m_session(session), m_gpu(gpu), m_options(options), m_target(options.width, options.height, 4) {
        m_view.options.normals = options.normals;
        m_view.width = options.width;
        m_view.height = options.height;
        m_view.camera.frame(session.targets().bounds(),
                            static_cast<float>(options.width) / static_cast<float>(options.height));
    }

    [[nodiscard]] Status picture(const QString& name, WireframeMode wireframe) {
        m_view.options.wireframe = wireframe;
        if (Status status = m_gpu.draw(m_view, m_target.framebuffer()); !status) {
            return status;
        }
        Image image = m_target.read();
        image.notes = pictureNotes(m_session);
        return savePicture(image, path(name));
    }

    /// Applies the hits with this pipeline; how it agrees with the reference (agreementOfActive()).
    [[nodiscard]] Result<std::optional<ReferenceAgreement>> apply(PipelineKind kind) {
        if (Status status = usePipeline(m_session, m_gpu, kind); !status) {
            return status.error();
        }
        return agreementOfActive(m_session);
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
            << QString::number(session.hits().history().hitsOn(target->id).size()).rightJustified(6)
            << QString::number(statistics.changedVertices).rightJustified(10)
            << QStringLiteral("%1 m\n").arg(statistics.maximum, 20, 'f', 3);
    }
}

/// Applies the hits with every pipeline that runs here, and says how it agrees with the reference.
Result<QStringList> comparePipelines(Demo& demo, const Session& session) {
    QStringList lines;
    for (const PipelineTraits& traits : allPipelines()) {
        const QString name = QString::fromUtf8(traits.name);
        const QString unavailable = session.readBack().whyUnavailable(traits.kind);
        if (!unavailable.isEmpty()) {
            lines << QStringLiteral("%1: not here. %2").arg(name, unavailable);
            continue;
        }
        const Result<std::optional<ReferenceAgreement>> agreement = demo.apply(traits.kind);
        if (!agreement) {
            return agreement.error();
        }
        lines << agreementLine(session, agreement.value());
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
    Demo demo(session, *gpu.value(), options);
    if (Status status = demo.picture(QStringLiteral("before.png"), WireframeMode::Off); !status) {
        return status;
    }
    shootAll(session, demoShots(session, options.shots, options.seed));
    session.targets().select({});

    const Result<QStringList> compared = comparePipelines(demo, session);
    if (!compared) {
        return compared.error();
    }
    if (Status used = useAskedPipeline(session, *gpu.value(), options.pipeline); !used) {
        return used;
    }
    const std::optional<ReferenceAgreement> shown = agreementOfActive(session);
    const Target& exported = mostChangedTarget(session);
    const QString meshPath = demo.path(QStringLiteral("deformed.obj"));
    for (const Status& status : {demo.picture(QStringLiteral("after.png"), WireframeMode::Off),
                                 demo.picture(QStringLiteral("wireframe.png"), WireframeMode::Over),
                                 exportNamed(session, exported, meshPath, options.normals)}) {
        if (!status) {
            return status;
        }
    }
    if (const std::vector<std::string> errors = gl::takeErrors(); !errors.empty()) {
        return Error{"OpenGL reports: " + errors.front(), "", "Please report this with the renderer's name."};
    }

    out << "Renderer: " << QString::fromStdString(gl::rendererInfo().renderer);
    out << "\n"
        << QString::fromStdString(describe(session.readBack().verdict(), session.settings().pipeline()))
        << "\n"
        << options.shots << " shots, " << session.hits().history().size() << " hits\n\n";
    printTable(out, session);
    out << "\n" << compared.value().join(QLatin1Char('\n')) << "\n\n" << fingerprintLines(session);
    out << "\nIn " << QDir::toNativeSeparators(QDir(options.folder).absolutePath())
        << ": before.png, after.png, wireframe.png, deformed.obj (" << exported.name << ")\n";
    out.flush();
    return exportAgrees(session, shown, meshPath);
}

}  // namespace hitscope::cli
