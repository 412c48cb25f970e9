// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/io_cost.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QThread>
#include <algorithm>
#include <array>
#include <memory>

#include "cli/bench/grid_files.h"
#include "cli/bench/other_readers.h"
#include "cli/bench/random_hits.h"
#include "cli/bench/window/bound_process.h"
#include "core/process_memory.h"
#include "io/import.h"
#include "scene/picture.h"
#include "session/export/export_target.h"
#include "session/session.h"
#include "session/target_plan.h"
#include "view/coarse_picture.h"
#include "view/lights.h"

namespace hitscope::bench {

namespace {

constexpr std::uint32_t kIoSeed = 1;

/// A window without a window: what a mesh is opened in.
class OpenedFile {
public:
    OpenedFile(const IoSizes& sizes, QString path) : m_sizes(sizes), m_path(std::move(path)) {}

    /// Empty, with all made that does not depend on the mesh.
    Status prepare() {
        m_gpu.reset();
        m_session = std::make_unique<Session>();
        Result<std::unique_ptr<SceneGpu>> gpu = SceneGpu::create(*m_session);
        if (!gpu) {
            return gpu.error();
        }
        m_gpu = std::move(gpu).value();
        return draw();
    }
    Status open() {
        Result<ImportedMesh> imported = importMesh(m_path);
        if (!imported) {
            return imported.error();
        }
        ScenePlan plan;
        plan.targets.push_back(planMesh(std::move(imported.value().mesh), m_path));
        m_session->loadScene(std::move(plan));
        return draw();
    }
    /// As far as the picture that the window shows while the rest is made.
    Status seeCoarsely() const {
        const Result<ImportedMesh> imported = importMesh(m_path);
        if (!imported) {
            return imported.error();
        }
        const MeshData& mesh = imported.value().mesh;
        Camera camera;
        camera.frame(mesh.bounds(), static_cast<float>(m_sizes.width) / static_cast<float>(m_sizes.height));
        const Image image =
            drawCoarsely(mesh, camera, DirectionalLight().direction, m_sizes.width / 2, m_sizes.height / 2);
        return image.empty() ? Status(Error{"Nothing was drawn.", m_path.toStdString(), ""}) : Status(Done{});
    }
    /// Hits of which each reaches so many times as far as the mesh is large.
    Status shoot(std::size_t count, float reach) {
        const Target& target = *m_session->targets().front();
        RandomHits random({{target.id, target.shape.render.get()}},
                          scaled(DeformationConstants{}, 2.0f * reach * target.extent()), kIoSeed);
        if (Status added = m_session->hits().add(random.next(count)); !added) {
            return added;
        }
        return m_gpu->sync();
    }
    Status exportTo(const QString& path) {
        const Result<ExportReport> written =
            exportTarget(*m_session, *m_session->targets().front(), path, {});
        return written ? Status(Done{}) : Status(written.error());
    }
    void close() {
        m_gpu.reset();
        m_session.reset();
    }

private:
    Status draw() {
        PictureRequest request;
        request.width = m_sizes.width;
        request.height = m_sizes.height;
        const Bounds bounds = m_session->targets().bounds();
        request.camera.setSceneRadius(bounds.empty() ? 1.0f : bounds.diagonal());
        request.camera.frame(bounds, static_cast<float>(request.width) / static_cast<float>(request.height));
        const Result<Image> image = drawPicture(*m_gpu, request);
        return image ? Status(Done{}) : Status(image.error());
    }

    IoSizes m_sizes;
    QString m_path;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<SceneGpu> m_gpu;  ///< below the session, so that it goes first
};

/// What hitscope-cli picture and its worker take at most, bytes.
Result<double> peakOfPicture(const IoSizes& sizes, const QString& folder, const QString& mesh) {
    constexpr int kLook = 20;  // milliseconds
    QProcess program;
    bindToThis(program);
    program.setStandardInputFile(QProcess::nullDevice());
    program.start(QCoreApplication::applicationFilePath(),
                  {QStringLiteral("picture"), QStringLiteral("--size"),
                   QStringLiteral("%1x%2").arg(sizes.width).arg(sizes.height),
                   QDir(folder).filePath(QStringLiteral("picture.png")), mesh});
    double most = 0.0;
    while (program.state() != QProcess::NotRunning && !program.waitForFinished(kLook)) {
        most = std::max(most, memoryOfAll(program.processId()));
    }
    if (program.exitStatus() != QProcess::NormalExit || program.exitCode() != 0) {
        return Error{"The picture whose memory is measured was not drawn.",
                     program.readAllStandardError().toStdString(), ""};
    }
    return most;
}

Status measureOpening(const BenchRoom& room, const QString& obj, OpenedFile& mesh, const Plan& plan,
                      IoFigures& figures) {
    Result<std::vector<Samples>> samples =
        room.measure(QStringLiteral("opening"),
                     {Variant{"tinyobjloader", 1.0, {}, [&] { return readWithTinyObjLoader(obj); }},
                      Variant{"Assimp", 1.0, {}, [&] { return readWithAssimp(obj); }},
                      Variant{"coarse", 1.0, {}, [&] { return mesh.seeCoarsely(); }},
                      Variant{"picture", 1.0, [&] { return mesh.prepare(); }, [&] { return mesh.open(); }}},
                     plan);
    if (!samples) {
        return samples.error();
    }
    figures.tiny = std::move(samples.value()[0]);
    figures.assimp = std::move(samples.value()[1]);
    figures.coarse = std::move(samples.value()[2]);
    figures.picture = std::move(samples.value()[3]);
    return Done{};
}

Status measureExports(const BenchRoom& room, const QString& obj, OpenedFile& mesh, const Plan& plan,
                      IoFigures& figures) {
    constexpr float kFar = 4.0f;    // every vertex is within reach
    constexpr float kNear = 0.01f;  // of the mesh
    const QString copied = obj + QStringLiteral(".copied.obj");
    const QString exported = obj + QStringLiteral(".exported.obj");
    // The export's old file is freed beside: that must slow down neither.
    const auto settle = []() -> Status {
        QThread::msleep(100);
        return Done{};
    };
    const std::vector<Variant> variants{
        Variant{"cp", 1.0, settle, [&] { return copyAndSync(obj, copied); }},
        Variant{"export", 1.0, settle, [&] { return mesh.exportTo(exported); }}};
    for (const bool everywhere : {false, true}) {
        if (Status shot = mesh.shoot(everywhere ? 1 : 3, everywhere ? kFar : kNear); !shot) {
            return shot;
        }
        Result<std::vector<Samples>> samples = room.measure(QStringLiteral("exporting"), variants, plan);
        if (!samples) {
            return samples.error();
        }
        (everywhere ? figures.copyAgain : figures.copy) = std::move(samples.value()[0]);
        (everywhere ? figures.exportAll : figures.exportFew) = std::move(samples.value()[1]);
    }
    QFile::remove(copied);
    QFile::remove(exported);
    return Done{};
}

Status measurePly(const BenchRoom& room, const IoSizes& sizes, const QString& folder, IoFigures& figures) {
    const QString ply = QDir(folder).filePath(QStringLiteral("grid.ply"));
    if (Status written = writeGridPly(ply, sizes.plyTriangles); !written) {
        return written;
    }
    OpenedFile large(sizes, ply);
    const Plan once{0, 1, 1, 0.0};
    Result<std::vector<Samples>> samples = room.measure(
        QStringLiteral("opening a PLY"),
        {Variant{"PLY", 1.0, [&] { return large.prepare(); }, [&] { return large.open(); }}}, once);
    if (!samples) {
        return samples.error();
    }
    figures.ply = std::move(samples.value()[0]);
    return Done{};
}

}  // namespace

Result<IoFigures> measureIo(const BenchRoom& room, const IoSizes& sizes, const QString& folder,
                            const Plan& plan) {
    const QString obj = QDir(folder).filePath(QStringLiteral("grid.obj"));
    if (Status written = writeGridObj(obj, sizes.quads); !written) {
        return written.error();
    }
    IoFigures figures;
    figures.objBytes = QFileInfo(obj).size();
    OpenedFile mesh(sizes, obj);
    if (Status measured = measureOpening(room, obj, mesh, plan, figures); !measured) {
        return measured.error();
    }
    if (Status measured = measureExports(room, obj, mesh, plan, figures); !measured) {
        return measured.error();
    }
    mesh.close();
    const Result<double> peak = peakOfPicture(sizes, folder, obj);
    if (!peak) {
        return peak.error();
    }
    figures.peakBytes = peak.value();
    if (sizes.plyTriangles > 0) {
        if (Status measured = measurePly(room, sizes, folder, figures); !measured) {
            return measured.error();
        }
    }
    return figures;
}

}  // namespace hitscope::bench
