// SPDX-License-Identifier: GPL-3.0-or-later
// What each way to look at a scene costs, over plain shading.
#include <QTextStream>
#include <array>

#include "cli/bench/bench_command.h"
#include "cli/bench/bench_options.h"
#include "cli/bench/bench_room.h"
#include "cli/bench/report_header.h"
#include "cli/command_line.h"
#include "gl/context.h"
#include "session/change_values.h"
#include "session/comparison.h"
#include "session/demo_shots.h"
#include "session/scene_gpu.h"

namespace hitscope::bench {

namespace {

/// 0 LP cubes, 6 HP cubes, 0 LP spheres, 10 HP spheres: the row with the most triangles to look at.
constexpr int kFullRow = 6;
constexpr int kHits = 100;

struct Mode {
    const char* name;
    void (*set)(DisplayOptions& options);
    bool compares = false;  ///< needs a second pipeline
};

constexpr std::array<Mode, 16> kModes{{
    {"plain shading", [](DisplayOptions&) {}},
    {"wireframe over", [](DisplayOptions& o) { o.wireframe = WireframeMode::Over; }},
    {"wireframe only", [](DisplayOptions& o) { o.wireframe = WireframeMode::Only; }},
    {"flat", [](DisplayOptions& o) { o.flat = true; }},
    {"back faces", [](DisplayOptions& o) { o.backFaces = true; }},
    {"needles", [](DisplayOptions& o) { o.needles = true; }},
    {"dots", [](DisplayOptions& o) { o.dots = true; }},
    {"shadows", [](DisplayOptions& o) { o.shadows = true; }},
    {"map of displacement", [](DisplayOptions& o) { o.change.on = true; }},
    {"map of normal rotation, isolines",
     [](DisplayOptions& o) {
         o.change.on = true;
         o.change.isolines = true;
         o.change.quantity = ChangeQuantity::NormalRotation;
     }},
    {"map of edge stretch",
     [](DisplayOptions& o) {
         o.change.on = true;
         o.change.quantity = ChangeQuantity::EdgeStretch;
     }},
    {"ghost, wire", [](DisplayOptions& o) { o.beforeAfter.ghost = GhostMode::Wire; }},
    {"ghost, translucent", [](DisplayOptions& o) { o.beforeAfter.ghost = GhostMode::Translucent; }},
    {"wipe", [](DisplayOptions& o) { o.beforeAfter.wipe = true; }},
    {"exaggeration", [](DisplayOptions& o) { o.beforeAfter.exaggeration = 5.0f; }},
    {"two pipelines side by side", [](DisplayOptions& o) { o.sideBySide = true; }, true},
}};

/// One scene, looked at in all modes in turn.
class ModesScene {
public:
    explicit ModesScene(const gl::RenderTarget& picture)
        : m_picture(picture), m_values(m_session), m_comparison(m_session) {}

    Status open(int row, PipelineKind pipeline) {
        m_session.loadPaperRow(row);
        m_session.setPipeline(pipeline);
        Result<std::unique_ptr<SceneGpu>> gpu = SceneGpu::create(m_session);
        if (!gpu) {
            return gpu.error();
        }
        m_gpu = std::move(gpu).value();
        shootAll(m_session, demoShots(m_session, kHits, 1));
        m_session.selectTarget({});
        m_view.width = m_picture.width();
        m_view.height = m_picture.height();
        m_view.changeValues = &m_values;
        m_view.camera.frame(m_session.sceneBounds(),
                            static_cast<float>(m_view.width) / static_cast<float>(m_view.height));
        return m_gpu->sync();
    }

    /// Draws until nothing is on its way.
    Status prepare(const Mode& mode) {
        m_view.options = {};
        mode.set(m_view.options);
        const ChangeMapOptions& change = m_view.options.change;
        m_values.setQuantity(change.on ? std::optional(change.quantity) : std::nullopt);
        m_values.finish();
        m_comparison.setOther(mode.compares ? std::optional(PipelineKind::TransformFeedback) : std::nullopt);
        m_view.comparison = mode.compares ? &m_comparison : nullptr;
        Status status = draw();
        while (status && m_gpu->isReadBackPending()) {
            status = draw();
        }
        return status;
    }

    Status draw() {
        Status status = m_gpu->draw(m_view, m_picture.framebuffer());
        gl::finish();
        return status;
    }

    [[nodiscard]] qulonglong vertices() const {
        qulonglong count = 0;
        for (const std::unique_ptr<Target>& target : m_session.targets()) {
            count += target->deformed.original().vertexCount();
        }
        return count;
    }

private:
    const gl::RenderTarget& m_picture;
    Session m_session;
    ChangeValues m_values;
    Comparison m_comparison;
    std::unique_ptr<SceneGpu> m_gpu;
    SceneGpu::View m_view;
};

void describe(Report& report, const std::vector<Samples>& samples, PipelineKind pipeline,
              const QString& scene) {
    Table table;
    table.title = QStringLiteral("%1; %2").arg(pipelineName(pipeline), scene);
    table.columns = {QStringLiteral("mode"), QStringLiteral("frame"), QStringLiteral("over plain shading")};
    for (std::size_t i = 0; i < kModes.size(); ++i) {
        const double ratio = timeRatio(samples[i], samples[0]);
        const QString name = QLatin1String(kModes[i].name);
        table.rows.push_back(
            {name, shortTime(samples[i].median()), QStringLiteral("x%1").arg(ratio, 0, 'f', 2)});
        report.records.push_back({{QStringLiteral("pipeline"), pipelineKey(pipeline)},
                                  {QStringLiteral("mode"), name},
                                  {QStringLiteral("frame_seconds_median"), samples[i].median()},
                                  {QStringLiteral("time_ratio_to_plain"), ratio}});
    }
    report.tables.push_back(table);
}

Status runModes(const CommonOptions& options, int row) {
    if (Status status = checkDestinations(options.destinations); !status) {
        return status;
    }
    Result<std::unique_ptr<BenchRoom>> room = BenchRoom::open(options.width, options.height);
    if (!room) {
        return room.error();
    }
    Report report;
    report.benchmark = QStringLiteral("modes");
    report.header = reportHeader(*room.value(), options.width, options.height);
    report.fields = {QStringLiteral("pipeline"), QStringLiteral("mode"),
                     QStringLiteral("frame_seconds_median"), QStringLiteral("time_ratio_to_plain")};
    for (const PipelineKind pipeline : options.pipelines) {
        ModesScene scene(room.value()->picture());
        if (Status status = scene.open(row, pipeline); !status) {
            return status;
        }
        std::vector<Variant> variants;
        for (const Mode& mode : kModes) {
            variants.push_back({QLatin1String(mode.name).data(), 1.0,
                                [&scene, &mode] { return scene.prepare(mode); },
                                [&scene] { return scene.draw(); }});
        }
        Result<std::vector<Samples>> samples =
            room.value()->measure(pipelineName(pipeline), variants, options.plan);
        if (!samples) {
            return samples.error();
        }
        describe(report, samples.value(), pipeline,
                 QStringLiteral("%1, %2 vertices")
                     .arg(paperRows()[static_cast<std::size_t>(row)].label(), grouped(scene.vertices())));
    }
    return writeReport(report, options.destinations);
}

}  // namespace

int modesCommand(const QStringList& list) {
    Arguments arguments(
        QStringLiteral("Measures frames of a dented scene in each mode against plain shading."));
    addCommonOptions(arguments, true);
    arguments.addOption(QStringLiteral("row"), QStringLiteral("Row of the paper's tables to show."),
                        QStringLiteral("number"), QString::number(kFullRow + 1));
    parseBenchArguments(arguments, list);
    if (arguments.error().isEmpty() && arguments.wantsHelp()) {
        QTextStream(stdout) << arguments.help();
        return 0;
    }
    const CommonOptions options = takeCommonOptions(arguments, true);
    const int row = arguments.wholeNumber(QStringLiteral("row"), 1, static_cast<int>(paperRows().size())) - 1;
    if (!arguments.error().isEmpty()) {
        return cli::wrongUsage(arguments.error());
    }
    return cli::finish(runModes(options, row));
}

}  // namespace hitscope::bench
