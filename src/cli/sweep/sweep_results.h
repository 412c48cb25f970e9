// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "cli/sweep/sweep_plan.h"

namespace hitscope::cli {

/// What one job found, of all targets of its scene together; metres.
struct SweepResult {
    std::uint64_t shots = 0;
    std::uint64_t hits = 0;
    std::uint64_t changedVertices = 0;
    double largest = 0.0;
    double mean = 0.0;  ///< over the changed vertices
    double rootMeanSquare = 0.0;
    bool isExact = true;  ///< as the reference in every bit
    QString hitsFingerprint;
    QString positionsFingerprint;
};

/// Where a job's report is, below the sweep's folder.
[[nodiscard]] QString reportPathOf(const QString& folder, const SweepJob& job);
/// What it says; nothing: there is none, or none that can be read.
[[nodiscard]] std::optional<SweepResult> readResult(const QString& path);

/// A sweep's jobs beside what they found; those that found nothing yet are left out.
struct SweepTable {
    const SweepPlan& plan;
    std::vector<std::optional<SweepResult>> results;  ///< one a job
};
[[nodiscard]] std::string toCsv(const SweepTable& table);
[[nodiscard]] std::string toJson(const SweepTable& table);

/// Small multiples: largest displacement and number of changed vertices against the first axis of numbers, a
/// column a scene, a line a value of another axis; the points are the jobs, the lines their means. SVG
/// without scripts.
[[nodiscard]] std::string toSvg(const SweepTable& table);

}  // namespace hitscope::cli
