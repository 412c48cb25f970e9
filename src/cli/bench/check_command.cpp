// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "cli/bench/bench_command.h"
#include "cli/bench/bench_options.h"
#include "cli/bench/checks.h"

namespace hitscope::bench {

namespace {

struct CheckOptions {
    CommonOptions common;
    QStringList only;
    bool strict = false;
};

/// 0.125 as "1/8", 2 as "2".
QString bound(double ratio) {
    return ratio < 1.0 ? QStringLiteral("1/%1").arg(shortNumber(1.0 / ratio)) : QString::number(ratio);
}

/// Ratios near one need their decimals.
QString measured(double ratio) {
    if (ratio >= 0.5 && ratio < 2.0) {
        return QString::number(ratio, 'f', 3);
    }
    return ratio < 1.0 ? QStringLiteral("1/%1").arg(shortNumber(1.0 / ratio)) : shortNumber(ratio);
}

void addUnmeasured(Report& report, const Check& check, const Error& why) {
    const QString name = QString::fromStdString(check.name);
    report.tables.front().rows.push_back(
        {name, {}, QStringLiteral("-"), bound(check.atMost), QStringLiteral("not measured")});
    report.notes << name + QStringLiteral(": ") + QString::fromStdString(why.message());
    report.records.push_back({{QStringLiteral("name"), name},
                              {QStringLiteral("where"), QString()},
                              {QStringLiteral("about"), QString::fromStdString(check.about)},
                              {QStringLiteral("ratio"), QJsonValue()},
                              {QStringLiteral("at_most"), check.atMost},
                              {QStringLiteral("kept"), QJsonValue()}});
}

void addRow(Report& report, const Check& check, const CheckRow& row, bool isWorst) {
    const QString name = QString::fromStdString(check.name);
    const QString where = QString::fromStdString(row.where);
    const double ratio = row.ratio.value;
    const bool kept = ratio <= check.atMost;
    report.tables.front().rows.push_back({name, where + (isWorst ? QStringLiteral(" (worst)") : QString()),
                                          measured(ratio), bound(check.atMost),
                                          kept ? QStringLiteral("yes") : QStringLiteral("no")});
    report.records.push_back({{QStringLiteral("name"), name},
                              {QStringLiteral("where"), where},
                              {QStringLiteral("about"), QString::fromStdString(check.about)},
                              {QStringLiteral("ratio"), ratio},
                              {QStringLiteral("at_most"), check.atMost},
                              {QStringLiteral("kept"), kept},
                              {QStringLiteral("unit"), QStringLiteral("times")},
                              {QStringLiteral("runs"), runsJson(row.ratio.rounds)}});
    report.marks.push_back({where.isEmpty() ? name : name + QStringLiteral(", ") + where,
                            row.ratio.rounds.least() / check.atMost, ratio / check.atMost,
                            row.ratio.rounds.most() / check.atMost, 1.0});
}

/// A row for each that the promise speaks of. Whether all of them keep it.
bool addResult(Report& report, const Check& check, const Result<std::vector<CheckRow>>& rows) {
    report.tables.front().notes << QStringLiteral("%1: %2").arg(QString::fromStdString(check.name),
                                                                QString::fromStdString(check.about));
    if (!rows || rows.value().empty()) {
        addUnmeasured(report, check, rows ? Error{"Nothing of it runs here.", "", ""} : rows.error());
        return true;
    }
    double worst = 0.0;
    for (const CheckRow& row : rows.value()) {
        worst = std::max(worst, row.ratio.value);
    }
    for (const CheckRow& row : rows.value()) {
        addRow(report, check, row, rows.value().size() > 1 && row.ratio.value >= worst);
    }
    return worst <= check.atMost;
}

cli::Outcome measureChecks(const CheckOptions& options, const BenchRoom& room, Report& report) {
    report.fields = {QStringLiteral("name"),  QStringLiteral("where"),   QStringLiteral("about"),
                     QStringLiteral("ratio"), QStringLiteral("at_most"), QStringLiteral("kept")};
    report.keys = report.fields.first(2);
    report.marksAxis = QStringLiteral("Part of what is promised: the median of the rounds, and their range");
    report.tables.push_back({QStringLiteral("Ratios of times"),
                             {QStringLiteral("name"), QString(), QStringLiteral("ratio"),
                              QStringLiteral("at most"), QStringLiteral("kept")},
                             {},
                             {}});
    bool allKept = true;
    for (const Check& check : allChecks()) {
        if (!options.only.contains(QString::fromStdString(check.name))) {
            continue;
        }
        const Result<std::vector<CheckRow>> rows = check.measure(room, options.common.plan);
        room.say({});
        if (Status status = noGlErrors(); !status) {
            return cli::cannotDraw(status.error());
        }
        allKept = addResult(report, check, rows) && allKept;
    }
    return options.strict && !allKept
               ? cli::differs({"A promise is not kept.", "bench check", "The column \"kept\" says which."})
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
                                       "takes about ten minutes on two cores; select promises with --only."),
         .options =
             QList<UsageOption>{wordsOption("only", checkNames(), QStringLiteral("Promises to measure.")),
                                strictOption(QStringLiteral("a promise"))} +
             measuringOptions(),
         .examples = {{QStringLiteral("Measure one promise with a few samples."),
                       QStringLiteral("hitscope-cli bench check --quick --only paper-way-8k")}}},
        runCheck};
}

}  // namespace hitscope::bench
