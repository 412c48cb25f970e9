// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/report_header.h"

#include <QDateTime>
#include <QFile>
#include <QSysInfo>
#include <thread>

#include "pipeline/pipeline_trial.h"

namespace hitscope::bench {

namespace {

/// As Linux names it; elsewhere the architecture has to do.
QString processorName() {
    QFile file(QStringLiteral("/proc/cpuinfo"));
    if (file.open(QIODevice::ReadOnly)) {
        const QList<QByteArray> lines = file.readAll().split('\n');
        for (const QByteArray& line : lines) {
            if (line.startsWith("model name")) {
                return QString::fromUtf8(line.mid(line.indexOf(':') + 1)).simplified();
            }
        }
    }
    return QSysInfo::currentCpuArchitecture();
}

}  // namespace

std::vector<std::pair<QString, QString>> machineHeader(const gl::RendererInfo& renderer,
                                                       const QString& picture) {
    const unsigned threads = std::thread::hardware_concurrency();
    return {
        {QStringLiteral("program"), QStringLiteral("Hitscope " HITSCOPE_VERSION)},
        {QStringLiteral("renderer"), QString::fromStdString(renderer.renderer)},
        {QStringLiteral("OpenGL"), QString::fromStdString(renderer.version)},
        {QStringLiteral("processor"),
         QStringLiteral("%1, %2 %3")
             .arg(processorName())
             .arg(threads)
             .arg(threads == 1 ? QStringLiteral("thread") : QStringLiteral("threads"))},
        {QStringLiteral("picture"), picture},
        {QStringLiteral("date"), QDateTime::currentDateTimeUtc().toString(Qt::ISODate)},
        {QStringLiteral("note"),
         renderer.isSoftware()
             ? QStringLiteral("the figures are of this renderer, which draws on the processor; ratios say "
                              "more than frame rates, and neither speaks for a GPU")
             : QStringLiteral("the figures are of this renderer on this machine")}};
}

std::vector<std::pair<QString, QString>> reportHeader(const BenchRoom& room, int width, int height) {
    std::vector<std::pair<QString, QString>> header = machineHeader(
        gl::rendererInfo(), width > 0 ? QStringLiteral("%1x%2 pixels, no vsync").arg(width).arg(height)
                                      : QStringLiteral("none is drawn"));
    for (const PipelineTraits& traits : allPipelines()) {
        header.emplace_back(
            QString::fromUtf8(traits.name),
            QString::fromStdString(describe(tryPipeline(traits.kind, room.pipelineOptions()))));
    }
    return header;
}

}  // namespace hitscope::bench
