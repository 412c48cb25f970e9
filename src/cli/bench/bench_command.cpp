// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/bench_command.h"

#include <QTextStream>
#include <array>

#include "cli/command_line.h"

namespace hitscope::bench {

namespace {

struct Benchmark {
    const char* name;
    const char* about;
    int (*run)(const QStringList&);
};

constexpr std::array<Benchmark, 8> kBenchmarks{
    {{"paper", "the paper's tables 1 and 2: frame rates of its nine scenes", paperCommand},
     {"frame", "frame time against the number of hits", frameCommand},
     {"modes", "frame time of each way to look at a scene, against plain shading", modesCommand},
     {"hit", "time a hit takes against the size of the mesh", hitCommand},
     {"physics", "steps and frames with 2,000 projectiles, colliders that follow the dents", physicsCommand},
     {"session", "saving, opening and recovering a session, its journal and its undo", sessionCommand},
     {"io", "opening and exporting large files, beside other programs; memory", ioCommand},
     {"check", "the ratios that Hitscope promises, measured", checkCommand}}};

int printUsage() {
    QTextStream out(stdout);
    out << "Usage: hitscope-cli bench WHAT [options]\n\n";
    for (const Benchmark& benchmark : kBenchmarks) {
        out << "  " << QString::fromLatin1(benchmark.name).leftJustified(7) << benchmark.about << "\n";
    }
    out << "\nhitscope-cli bench WHAT --help tells the options of each.\n";
    return 0;
}

}  // namespace

int benchCommand(QStringList arguments) {
    const QString what = arguments.value(1);
    if (what == QLatin1String("--help") || what == QLatin1String("-h")) {
        return printUsage();
    }
    if (what.isEmpty()) {
        return cli::wrongUsage(
            QStringLiteral("bench takes paper, frame, modes, hit, physics, session, io or check."));
    }
    arguments.removeAt(1);
    for (const Benchmark& benchmark : kBenchmarks) {
        if (what == QLatin1String(benchmark.name)) {
            return benchmark.run(arguments);
        }
    }
    return cli::wrongUsage(
        QStringLiteral(
            "there is no benchmark \"%1\"; bench takes paper, frame, modes, hit, physics, session, io "
            "or check.")
            .arg(what));
}

}  // namespace hitscope::bench
