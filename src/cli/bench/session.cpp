// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs to keep a session: files, the journal, the steps to undo.
#include "cli/bench/bench_command.h"
#include "cli/bench/bench_options.h"
#include "cli/bench/session_cost.h"
#include "cli/standard_streams.h"

namespace hitscope::bench {

namespace {

constexpr int kMostHits = 1'000'000;
constexpr double kBytesPerHit = 3000.0;  // of the session, its copies and its texts

struct SessionOptions {
    CommonOptions common;
    int hits = 0;
};

struct Row {
    const char* what;
    const char* field;
    const Samples& samples;
};

std::vector<Row> rowsOf(const SessionFigures& figures) {
    return {{"save, with its sync", "save", figures.save},
            {"  of that on the window's thread", "capture", figures.capture},
            {"open, with its mesh", "open", figures.open},
            {"recover from a journal", "recover", figures.recover},
            {"undo all, in one go", "undo all", figures.back},
            {"redo all, in one go", "redo all", figures.forward},
            {"make one more hit", "hit", figures.hit},
            {"  with the journal", "hit with journal", figures.journalled},
            {"changed settings to the journal", "settings to journal", figures.flush}};
}

QString share(double seconds) {
    return QStringLiteral("%1 %").arg(100.0 * seconds / kFrame, 0, 'f', 2);
}

void addSession(const SessionFigures& figures, const SessionOptions& options, Report& report) {
    report.fields = {QStringLiteral("hits"), QStringLiteral("measured"), QStringLiteral("samples"),
                     QStringLiteral("seconds_median"), QStringLiteral("seconds_most")};
    report.keys = report.fields.first(2);
    Table table;
    table.title = QStringLiteral("A session of %1 hits, each a step to undo (%2 MB)")
                      .arg(grouped(static_cast<qulonglong>(options.hits)))
                      .arg(static_cast<double>(figures.fileBytes) * 1.0e-6, 0, 'f', 1);
    table.columns = {QString(), QStringLiteral("median"), QStringLiteral("longest")};
    for (const Row& row : rowsOf(figures)) {
        table.rows.push_back(
            {QLatin1String(row.what), shortTime(row.samples.median()), shortTime(row.samples.most())});
        report.records.push_back({{QStringLiteral("hits"), options.hits},
                                  {QStringLiteral("measured"), QLatin1String(row.field)},
                                  {QStringLiteral("samples"), static_cast<qint64>(row.samples.size())},
                                  {QStringLiteral("runs"), runsJson(row.samples)},
                                  {QStringLiteral("seconds_median"), row.samples.median()},
                                  {QStringLiteral("seconds_most"), row.samples.most()}});
    }
    const double hit = figures.journalled.median() - figures.hit.median();
    table.notes << QStringLiteral(
                       "The journal takes %1 of a frame at 60 Hz for a hit, and %2 for settings, which "
                       "come five times a second at most.")
                       .arg(share(hit), share(figures.flush.median()));
    report.tables.push_back(table);
}

cli::Outcome measureKeeping(const SessionOptions& options, Report& report) {
    const cli::ScratchFolder folder;
    if (Status made = folder.check(); !made) {
        return made;
    }
    const Result<SessionFigures> figures =
        measureSession(static_cast<std::size_t>(options.hits), folder.path(), options.common.plan);
    if (!figures) {
        return figures.error();
    }
    addSession(figures.value(), options, report);
    return Done{};
}

int runSession(Invocation& given) {
    SessionOptions options;
    options.common = takeMeasuringOptions(given);
    options.hits = takeCount(given, "hits", 1, kMostHits);
    if (!given.error().isEmpty()) {
        return cli::kWrongUsage;
    }
    if (const QString why = whyItDoesNotFit(kBytesPerHit * options.hits); !why.isEmpty()) {
        return cli::finish(
            Error{"This is left out: " + why.toStdString() + ".", "", "Ask for fewer --hits."});
    }
    return cli::finish(
        runBenchmark(QStringLiteral("session"), options.common, false,
                     [&](BenchRoom& /*room*/, Report& report) { return measureKeeping(options, report); }));
}

}  // namespace

cli::Verb sessionVerb() {
    return {{.name = QStringLiteral("bench session"),
             .files = {},
             .about = QStringLiteral("saving, opening and recovering a session, its journal and its undo"),
             .description = QStringLiteral(
                 "Measures saving and opening a session, recovering it, its journal, and its undo."),
             .options = QList<UsageOption>{valueOption("hits", "N", QStringLiteral("Hits in the session."),
                                                       QStringLiteral("100K"))} +
                        measuringOptions(),
             .examples = {{QStringLiteral("Measure a session of 500 hits with a few samples."),
                           QStringLiteral("hitscope-cli bench session --quick --hits 500")}}},
            runSession};
}

}  // namespace hitscope::bench
