// SPDX-License-Identifier: GPL-3.0-or-later
// Two reports of a benchmark, row by row.
#include "cli/bench/bench_command.h"
#include "cli/bench/bench_options.h"
#include "cli/bench/reports/compare_reports.h"
#include "cli/standard_streams.h"

namespace hitscope::bench {

namespace {

constexpr qint64 kMostBytes = qint64{1} << 30;

cli::Outcome compareFiles(const QStringList& paths, const Destinations& destinations,
                          const ComparisonRules& rules) {
    if (Status status = checkDestinations(destinations); !status) {
        return status;
    }
    std::vector<ReportFile> files;
    for (const QString& path : paths) {
        Result<QByteArray> json = cli::readAllOf(path, kMostBytes);
        if (!json) {
            return json.error();
        }
        files.push_back({path, std::move(json).value()});
    }
    const Result<ReportComparison> made = compareReports(files[0], files[1], rules);
    if (!made) {
        return made.error();
    }
    if (Status written = writeReport(made.value().report, destinations); !written) {
        return written;
    }
    const int slower = made.value().slowerRows;
    return slower == 0 ? cli::Outcome(Done{})
                       : cli::differs({std::to_string(slower) + (slower == 1 ? " row is" : " rows are") +
                                           " slower by more than the tolerance.",
                                       paths[1].toStdString(), ""});
}

int runCompare(Invocation& given) {
    const Destinations destinations = takeDestinations(given);
    ComparisonRules rules;
    rules.tolerance = given.number("tolerance", 0.0, 100.0);
    rules.confidence = given.number("confidence", 0.5, 0.999999);
    if (given.file(0) == given.file(1)) {
        given.complain(QStringLiteral("A and B are the same file."));
    }
    return given.error().isEmpty() ? cli::finish(compareFiles(given.files(), destinations, rules))
                                   : cli::kWrongUsage;
}

}  // namespace

cli::Verb compareReportsVerb() {
    return {
        {.name = QStringLiteral("bench compare"),
         .files = QStringLiteral("A.json B.json"),
         .about = QStringLiteral("compare two reports of a benchmark, row by row, with confidence intervals"),
         .description =
             QStringLiteral("Reads two reports of the same benchmark and prints, for each row, the ratio of "
                            "the times of B and A with its confidence interval. Exits with 1 if a row is "
                            "significantly slower by more than the tolerance. To compare two programs or two "
                            "machines, measure both with the same options, if possible several times."),
         .options =
             QList<UsageOption>{
                 valueOption("tolerance", "PART", QStringLiteral("Slowdown that is ignored: 0.05 is 5 %."),
                             QStringLiteral("0.05")),
                 valueOption(
                     "confidence", "PART",
                     QStringLiteral("Confidence level, 0.5 to 1; 0.99 needs at least five runs of each."),
                     QStringLiteral("0.99"))} +
             destinationOptions(),
         .examples = {{QStringLiteral("Find the rows that became slower."),
                       QStringLiteral("hitscope-cli bench compare before.json after.json")}},
         .leastFiles = 2,
         .mostFiles = 2},
        runCompare};
}

}  // namespace hitscope::bench
