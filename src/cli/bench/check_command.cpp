// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>
#include <vector>

#include "cli/bench/bench_command.h"
#include "cli/bench/bench_options.h"
#include "cli/bench/check_report.h"

namespace hitscope::bench {

namespace {

struct CheckOptions {
    CommonOptions common;
    QStringList only;
    bool strict = false;
};

cli::Outcome measureChecks(const CheckOptions& options, const BenchRoom& room, Report& report) {
    std::vector<Check> checks;
    std::copy_if(allChecks().begin(), allChecks().end(), std::back_inserter(checks), [&](const Check& check) {
        return options.only.contains(QString::fromStdString(check.name));
    });
    const Result<bool> allKept = reportChecks(checks, room, options.common.plan, report);
    if (!allKept) {
        return cli::cannotDraw(allKept.error());
    }
    return options.strict && !allKept.value()
               ? cli::differs({"A promise is not kept, or could not be measured.", "bench check",
                               "The column \"kept\" says which."})
               : cli::Outcome(Done{});
}

int runCheck(Invocation& given) {
    CheckOptions options;
    options.common = takeMeasuringOptions(given);
    options.common.width = kCheckWidth;
    options.common.height = kCheckHeight;
    options.only = takeWords(given, "only");
    options.strict = given.isSet("strict");
    if (!given.error().isEmpty()) {
        return cli::kWrongUsage;
    }
    return cli::finish(
        runBenchmark(QStringLiteral("check"), options.common, true,
                     [&](BenchRoom& room, Report& report) { return measureChecks(options, room, report); }));
}

QStringList checkNames() {
    QStringList names;
    for (const Check& check : allChecks()) {
        names << QString::fromStdString(check.name);
    }
    return names;
}

}  // namespace

cli::Verb checkVerb() {
    return {
        {.name = QStringLiteral("bench check"),
         .files = {},
         .about = QStringLiteral("measure the ratios that Hitscope promises"),
         .description = QStringLiteral("Measures the ratios of times that Hitscope promises, each within one "
                                       "run, on every row, size or pipeline that the promise covers. This "
                                       "takes about ten minutes on two cores; select promises with --only. "
                                       "A promise that cannot be measured is not kept, unless it is one of a "
                                       "pipeline that does not run here."),
         .options =
             QList<UsageOption>{wordsOption("only", checkNames(), QStringLiteral("Promises to measure.")),
                                strictOption(QStringLiteral("a promise"))} +
             measuringOptions(),
         .examples = {{QStringLiteral("Measure one promise with a few samples."),
                       QStringLiteral("hitscope-cli bench check --quick --only paper-way-8k")}}},
        runCheck};
}

}  // namespace hitscope::bench
