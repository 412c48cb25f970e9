// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "core/result.h"
#include "usage/usage.h"

namespace hitscope::cli {

/// One run of `shoot` that a plan asks for; it needs no other.
struct SweepJob {
    /// Of what goes into it, its files' content among that: 16 hexadecimal digits. Jobs with one key have one
    /// result, and only the first of them is run.
    QString key;
    QString scene;          ///< as the plan names it; empty: the paper's scene
    QStringList values;     ///< one an axis
    QStringList arguments;  ///< of hitscope-cli, but for where the report goes
};

/// What a plan comes to.
struct SweepPlan {
    QStringList axes;  ///< options with several values, in the order of the table's columns
    std::vector<SweepJob> jobs;

    static constexpr std::size_t kMostJobs = 1'000'000;
};

/// A plan is JSON: {"hitscope-sweep": 1, "scenes": ["a.obj", …], "options": {"random": 50, "seed": [1, 2],
/// "flat": true}}. Options are those of `shoot` but for its files to write; a list is an axis, and every
/// combination is a job, scenes first. Files are named from `folder`. The error says which member is wrong.
[[nodiscard]] Result<SweepPlan> readSweepPlan(const QByteArray& json, const QString& folder,
                                              const Usage& shoot);

/// The whole command, its report included, as a shell takes it.
[[nodiscard]] QString commandLine(const QString& program, const SweepJob& job, const QString& reportPath);
/// All arguments of hitscope-cli.
[[nodiscard]] QStringList commandArguments(const SweepJob& job, const QString& reportPath);

}  // namespace hitscope::cli
