// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/costs_csv.h"

#include <initializer_list>

#include "models/quantity_text.h"

namespace hitscope {

namespace {

QByteArray milliseconds(std::optional<double> seconds) {
    return seconds ? QByteArray::number(*seconds * kMilliseconds, 'g', 9) : QByteArray();
}

QByteArray keyOf(PipelineKind pipeline) {
    const std::string_view key = pipelineTraits(pipeline).key;
    return {key.data(), static_cast<qsizetype>(key.size())};
}

void appendLine(QByteArray& csv, std::initializer_list<QByteArray> cells) {
    csv += QByteArrayList(cells).join(',');
    csv += '\n';
}

}  // namespace

QByteArray framesCsv(std::span<const FrameCost> frames) {
    QByteArray csv =
        "frame,end_s,pipeline,history_hits,arrived_hits,frame_ms,cpu_ms,gpu_ms,physics_ms,"
        "deformation_cpu_ms,deformation_gpu_ms,read_back_ms,drawing_ms,pipelines\n";
    for (const FrameCost& frame : frames) {
        appendLine(csv, {QByteArray::number(static_cast<qulonglong>(frame.number)),
                         QByteArray::number(frame.end, 'f', 6), keyOf(frame.pipeline),
                         QByteArray::number(frame.history), QByteArray::number(frame.hits),
                         milliseconds(frame.total), milliseconds(frame.cpu), milliseconds(frame.gpu),
                         milliseconds(frame.physics), milliseconds(frame.deformation),
                         milliseconds(frame.gpuDeformation), milliseconds(frame.readBack),
                         milliseconds(frame.drawing), QByteArray::number(static_cast<int>(frame.pipelines))});
    }
    return csv;
}

QByteArray curvesCsv(std::span<const NamedCurve> curves, CostAxis axis) {
    QByteArray csv = axis == CostAxis::Hits ? "pipeline,history_hits,frame_ms,hit_ms\n"
                                            : "pipeline,vertices,frame_ms,hit_ms\n";
    for (const NamedCurve& curve : curves) {
        for (const CostPoint& point : curve.points) {
            appendLine(csv, {keyOf(curve.pipeline), QByteArray::number(point.at, 'g', 9),
                             milliseconds(point.frame), milliseconds(point.hit)});
        }
    }
    return csv;
}

}  // namespace hitscope
