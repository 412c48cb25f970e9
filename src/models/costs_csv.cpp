// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/costs_csv.h"

#include "io/csv_writer.h"
#include "models/quantity_text.h"

namespace hitscope {

namespace {

constexpr int kDigits = 9;

std::optional<double> milliseconds(std::optional<double> seconds) {
    return seconds ? std::optional(*seconds * kMilliseconds) : std::nullopt;
}

}  // namespace

QByteArray framesCsv(std::span<const FrameCost> frames) {
    CsvWriter csv;
    csv.row({"frame", "end_s", "pipeline", "history_hits", "arrived_hits", "frame_ms", "cpu_ms", "gpu_ms",
             "physics_ms", "deformation_cpu_ms", "deformation_gpu_ms", "read_back_ms", "drawing_ms",
             "pipelines"});
    for (const FrameCost& frame : frames) {
        csv.count(frame.number).fixed(frame.end, 6).text(pipelineTraits(frame.pipeline).key);
        csv.count(frame.history).count(frame.hits);
        for (const std::optional<double> part :
             {std::optional(frame.total), std::optional(frame.cpu), frame.gpu, std::optional(frame.physics),
              std::optional(frame.deformation), frame.gpuDeformation, std::optional(frame.readBack),
              std::optional(frame.drawing)}) {
            csv.general(milliseconds(part), kDigits);
        }
        csv.count(static_cast<std::uint64_t>(frame.pipelines));
        csv.endRow();
    }
    return QByteArray::fromStdString(csv.take());
}

QByteArray curvesCsv(std::span<const NamedCurve> curves, CostAxis axis) {
    CsvWriter csv;
    csv.row({"pipeline", axis == CostAxis::Hits ? "history_hits" : "vertices", "frame_ms", "hit_ms"});
    for (const NamedCurve& curve : curves) {
        for (const CostPoint& point : curve.points) {
            csv.text(pipelineTraits(curve.pipeline).key).general(point.at, kDigits);
            csv.general(milliseconds(point.frame), kDigits).general(milliseconds(point.hit), kDigits);
            csv.endRow();
        }
    }
    return QByteArray::fromStdString(csv.take());
}

}  // namespace hitscope
