// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/bench_command.h"

#include "cli/bench/report_header.h"

namespace hitscope::bench {

cli::Outcome runBenchmark(const QString& name, const CommonOptions& options, bool drawsPicture,
                          const Measuring& measuring) {
    if (Status status = checkDestinations(options.destinations); !status) {
        return status;
    }
    const Result<std::unique_ptr<BenchRoom>> room = BenchRoom::open(options.width, options.height);
    if (!room) {
        return cli::cannotDraw(room.error());
    }
    Report report;
    report.benchmark = name;
    report.header =
        reportHeader(*room.value(), drawsPicture ? options.width : 0, drawsPicture ? options.height : 0);
    cli::Outcome outcome = measuring(*room.value(), report);
    room.value()->say({});
    if (!outcome && outcome.status() != cli::kDiffers) {
        return outcome;
    }
    const Status written = writeReport(report, options.destinations);
    return written ? outcome : cli::Outcome(written);
}

cli::Outcome whatCameOf(Report& report) {
    report.notes.removeDuplicates();  // a pipeline that does not run does so on no size
    if (!report.records.empty()) {
        return Done{};
    }
    return cli::cannotDraw(
        {"Nothing was measured.", "", report.notes.isEmpty() ? "" : report.notes.last().toStdString()});
}

QString sameAgain(int wanted, const QString& what, std::size_t made) {
    return QStringLiteral("%1 %2 make the same mesh as a size before, of %3: it was not measured again.")
        .arg(grouped(static_cast<qulonglong>(wanted)), what, grouped(made));
}

}  // namespace hitscope::bench

namespace hitscope::cli {

Verb benchVerb() {
    using namespace bench;
    Verb verb{
        {.name = QStringLiteral("bench"),
         .files = QStringLiteral("WHAT"),
         .about = QStringLiteral("measure the pipelines: frames, hits, the paper's tables"),
         .description = QStringLiteral(
             "Measures on this machine. Runs the variants of a comparison alternately, A B A B, so that "
             "drift of the machine affects all of them; ratios within one run are more reliable than times."),
         .options = {},
         .examples = {}},
        {}};
    verb.verbs = {paperVerb(), frameVerb(),   modesVerb(),  hitVerb(),   physicsVerb(),       sessionVerb(),
                  ioVerb(),    latencyVerb(), memoryVerb(), checkVerb(), compareReportsVerb()};
    for (const Verb& within : verb.verbs) {
        verb.usage.verbs.push_back(within.usage);
    }
    return verb;
}

}  // namespace hitscope::cli
