// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace hitscope::cli {

/// A job for others to run.
struct SweepCommand {
    QString line;    ///< as a shell takes it
    QString report;  ///< the file that it writes
};

/// A job array for sbatch; where there are many, each of its tasks runs several.
[[nodiscard]] QString slurmScript(const std::vector<SweepCommand>& commands, const QString& folder);
/// A workflow for snakemake with a rule a job.
[[nodiscard]] QString snakefile(const std::vector<SweepCommand>& commands);

}  // namespace hitscope::cli
