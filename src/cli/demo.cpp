// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QStringList>
#include <QTextStream>

#include "cli/agreement.h"
#include "cli/common_options.h"
#include "cli/json_report.h"
#include "cli/opened_scene.h"
#include "cli/verbs.h"
#include "gl/context.h"
#include "gl/render_target.h"
#include "io/save_image.h"
#include "scene/picture.h"
#include "scene/scene_gpu.h"
#include "session/export/export_target.h"
#include "session/session.h"
#include "session/shots/demo_shots.h"

namespace hitscope::cli {

namespace {

struct DemoOptions {
    QString folder;    ///< where pictures and mesh go; made if missing
    QString meshPath;  ///< empty: the paper's scene
    int shots = 50;
    unsigned seed = 1;
    std::optional<PipelineKind> pipeline;   ///< what is shown and exported; nothing: the usual one
    NormalMode normals = NormalMode::True;  ///< of pictures and mesh
    int width = 1280;                       ///< pixels
    int height = 720;                       ///< pixels
};

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

QString tableOf(const Session& session) {
    const int nameWidth = 24;
    QString text;
    QTextStream out(&text);
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
    out.flush();
    return text;
}

/// Applies the hits with every pipeline that runs here, and says how it agrees with the reference.
Result<QStringList> comparePipelines(Demo& demo, const Session& session, JsonReport& report) {
    QStringList lines;
    report.beginArray("pipelines");
    for (const PipelineTraits& traits : allPipelines()) {
        const QString name = QString::fromUtf8(traits.name);
        const QString unavailable = session.readBack().whyUnavailable(traits.kind);
        if (!unavailable.isEmpty()) {
            lines << QStringLiteral("%1: not here. %2").arg(name, unavailable);
            report.beginObject().text("pipeline", QString::fromUtf8(traits.key));
            report.text("not_here", unavailable).endObject();
            continue;
        }
        const Result<std::optional<ReferenceAgreement>> agreement = demo.apply(traits.kind);
        if (!agreement) {
            return agreement.error();
        }
        lines << agreementLine(session, agreement.value());
        report.beginObject();
        addAgreement(report, session, agreement.value());
        report.endObject();
    }
    report.endArray();
    return lines;
}

/// Shoots, lets each pipeline apply the hits, and writes what the one asked for made of them.
Outcome writeResults(Demo& demo, OpenedScene& scene, const DemoOptions& options, const Invocation& given) {
    Session& session = scene.session();
    JsonReport report("demo");
    const QString renderer = QString::fromStdString(gl::rendererInfo().renderer);
    const QString folder = QDir(options.folder).absolutePath();
    report.text("scene", options.meshPath).text("renderer", renderer).text("folder", folder);
    report.count("shots", static_cast<std::uint64_t>(options.shots));
    report.count("hits", session.hits().history().size());
    const Result<QStringList> compared = comparePipelines(demo, session, report);
    if (!compared) {
        return cannotDraw(compared.error());
    }
    if (Outcome used = scene.useAsked(options.pipeline); !used) {
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
        return cannotDraw(
            {"OpenGL reports: " + errors.front(), "", "Please report this with the renderer's name."});
    }
    addFingerprints(report, session);
    addTargets(report, session);
    const QString verdict =
        QString::fromStdString(describe(session.readBack().verdict(), session.settings().pipeline()));
    const QString text = QStringLiteral("Renderer: %1\n%2\n%3\n\n")
                             .arg(renderer, verdict,
                                  shotsAndHits(static_cast<std::size_t>(options.shots),
                                               session.hits().history().size(), session)) +
                         tableOf(session) + u'\n' + compared.value().join(u'\n') + QStringLiteral("\n\n") +
                         fingerprintLines(session) +
                         QStringLiteral("\nIn %1: before.png, after.png, wireframe.png, deformed.obj (%2)\n")
                             .arg(QDir::toNativeSeparators(folder), exported.name);
    if (Status said = giveReport(given, report, text); !said) {
        return said;
    }
    return exportAgrees(session, shown, meshPath);
}

Outcome shootDemo(const DemoOptions& options, const Invocation& given) {
    if (!QDir().mkpath(options.folder)) {
        return Error{"The folder cannot be made.", options.folder.toStdString(),
                     "Choose one you may write to."};
    }
    OpenedScene scene;
    if (Outcome opened =
            scene.open({.path = options.meshPath, .pipeline = PipelineKind::Reference, .isDrawn = true});
        !opened) {
        return opened;
    }
    gl::collectDebugMessages();
    Demo demo(scene.session(), scene.gpu(), options);
    if (Status status = demo.picture(QStringLiteral("before.png"), WireframeMode::Off); !status) {
        return status;
    }
    shootAll(scene.session(), demoShots(scene.session(), options.shots, options.seed));
    scene.session().targets().select({});
    return writeResults(demo, scene, options, given);
}

QStringList normalWords() {
    return {QStringLiteral("true"), QStringLiteral("paper")};  // by NormalMode
}

int runDemo(Invocation& given) {
    DemoOptions options;
    options.folder = given.text("out");
    options.shots = given.wholeNumber("shots", 1, 100000);
    options.seed = given.seed("seed");
    options.pipeline = givenPipeline(given);
    options.normals = static_cast<NormalMode>(given.word("normals"));
    options.meshPath = given.file(0);
    return given.error().isEmpty() ? finish(shootDemo(options, given)) : kWrongUsage;
}

}  // namespace

Verb demoVerb() {
    return {{.name = QStringLiteral("demo"),
             .files = QStringLiteral("[MESH]"),
             .about = QStringLiteral("shoot, compare the pipelines, write pictures and the deformed mesh"),
             .description =
                 QStringLiteral("Shoots at the paper's scene, or at one mesh, without a display. Compares "
                                "the pipelines and writes before.png, after.png, wireframe.png and "
                                "deformed.obj. Exits with 1 if the mesh differs from the reference's."),
             .options =
                 QList<UsageOption>{
                     folderOption("out", QStringLiteral("Folder for the results; created if needed."),
                                  QStringLiteral("hitscope-demo"),
                                  {QStringLiteral("before.png"), QStringLiteral("after.png"),
                                   QStringLiteral("wireframe.png"), QStringLiteral("deformed.obj")}),
                     valueOption("shots", "N", QStringLiteral("Number of shots, 1 to 100000."),
                                 QStringLiteral("50")),
                     valueOption("seed", "NUMBER", QStringLiteral("Seed of the random shots."),
                                 QStringLiteral("1")),
                     pipelineOption(QStringLiteral("transform-feedback")),
                     wordOption("normals", "KIND", normalWords(),
                                QStringLiteral("Normals of the pictures and the mesh."),
                                QStringLiteral("true"))} +
                 reportOptions(),
             .examples = {{QStringLiteral("Shoot at the paper's scene."),
                           QStringLiteral("hitscope-cli demo --out results")}},
             .mostFiles = 1},
            runDemo};
}

}  // namespace hitscope::cli
