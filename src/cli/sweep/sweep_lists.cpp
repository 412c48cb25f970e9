// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep_lists.h"

#include <QFileInfo>
#include <algorithm>

#include "cli/json_report.h"

namespace hitscope::cli {

namespace {

constexpr std::size_t kMostTasks = 1000;  // of a job array, as slurm comes

QString shellQuoted(QString text) {
    return u'\'' + text.replace(u'\'', QStringLiteral("'\\''")) + u'\'';
}

/// What stands behind --output= in a job script: sbatch reads quotes and backslashes, and replaces %.
QString slurmPath(QString folder) {
    folder.replace(u'\\', QStringLiteral("\\\\"))
        .replace(u'"', QStringLiteral("\\\""))
        .replace(u'%', QStringLiteral("%%"));
    return u'"' + folder + QStringLiteral("/slurm-%A_%a.log\"");
}

QString pythonText(const QString& text) {
    return QString::fromStdString(jsonText(text));
}

}  // namespace

QString slurmScript(const std::vector<SweepCommand>& commands, const QString& folder) {
    const std::size_t tasks = std::clamp<std::size_t>(commands.size(), 1, kMostTasks);
    QString text = QStringLiteral(
                       "#!/bin/bash\n#SBATCH --job-name=hitscope-sweep\n#SBATCH --array=0-%1\n"
                       "#SBATCH --output=%2\n#SBATCH --cpus-per-task=1\n"
                       "export LP_NUM_THREADS=1\ncommands=(\n")
                       .arg(tasks - 1)
                       .replace(QStringLiteral("%2"), slurmPath(folder));
    for (const SweepCommand& command : commands) {
        text += QStringLiteral("    ") + shellQuoted(command.line) + u'\n';
    }
    text += QStringLiteral(")\nworst=0\nfor ((i = SLURM_ARRAY_TASK_ID; i < ${#commands[@]}; i += ");
    text += QString::number(tasks);
    return text + QStringLiteral(")); do\n    eval \"${commands[i]}\" || worst=$?\ndone\nexit \"$worst\"\n");
}

QString snakefile(const std::vector<SweepCommand>& commands) {
    QString text = QStringLiteral("rule all:\n    input:\n");
    for (const SweepCommand& command : commands) {
        text += QStringLiteral("        %1,\n").arg(pythonText(command.report));
    }
    for (const SweepCommand& command : commands) {
        QString line = command.line;
        line.replace(u'{', QStringLiteral("{{")).replace(u'}', QStringLiteral("}}"));
        // A job whose mesh is not the reference's ends with 1, and has a result all the same.
        text += QStringLiteral("\nrule job_%1:\n    output: ").arg(QFileInfo(command.report).baseName());
        text += pythonText(command.report) + QStringLiteral("\n    shell: ");
        text += pythonText(QStringLiteral("LP_NUM_THREADS=1 ") + line + QStringLiteral(" || test $? -eq 1")) +
                u'\n';
    }
    return text;
}

}  // namespace hitscope::cli
