// SPDX-License-Identifier: GPL-3.0-or-later
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

void addResult(Report& report, const Check& check, const Result<double>& ratio) {
    const QString name = QString::fromStdString(check.name);
    const QString about = QString::fromStdString(check.about);
    const bool kept = ratio && ratio.value() <= check.atMost;
    const QString verdict = !ratio ? QStringLiteral("not measured")
                            : kept ? QStringLiteral("yes")
                                   : QStringLiteral("no");
    report.tables.front().rows.push_back(
        {name, ratio ? measured(ratio.value()) : QStringLiteral("-"), bound(check.atMost), verdict});
    report.tables.front().notes << name + QStringLiteral(": ") + about;
    if (!ratio) {
        report.notes << name + QStringLiteral(": ") + QString::fromStdString(ratio.error().message());
    }
    report.records.push_back({{QStringLiteral("name"), name},
                              {QStringLiteral("about"), about},
                              {QStringLiteral("ratio"), ratio ? QJsonValue(ratio.value()) : QJsonValue()},
                              {QStringLiteral("at_most"), check.atMost},
                              {QStringLiteral("kept"), ratio ? QJsonValue(kept) : QJsonValue()}});
}

cli::Outcome measureChecks(const CheckOptions& options, const BenchRoom& room, Report& report) {
    report.fields = {QStringLiteral("name"), QStringLiteral("about"), QStringLiteral("ratio"),
                     QStringLiteral("at_most"), QStringLiteral("kept")};
    report.tables.push_back(
        {QStringLiteral("Ratios of times"),
         {QStringLiteral("name"), QStringLiteral("ratio"), QStringLiteral("at most"), QStringLiteral("kept")},
         {},
         {}});
    bool allKept = true;
    for (const Check& check : allChecks()) {
        if (!options.only.contains(QString::fromStdString(check.name))) {
            continue;
        }
        const Result<double> ratio = check.measure(room, options.common.plan);
        room.say({});
        if (Status status = noGlErrors(); !status) {
            return cli::cannotDraw(status.error());
        }
        addResult(report, check, ratio);
        allKept = allKept && (!ratio || ratio.value() <= check.atMost);
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
    return {{.name = QStringLiteral("bench check"),
             .files = {},
             .about = QStringLiteral("the ratios that Hitscope promises, measured"),
             .description =
                 QStringLiteral("Measures the ratios of times that Hitscope promises, each in one run."),
             .options =
                 QList<UsageOption>{wordsOption("only", checkNames(), QStringLiteral("Promises to measure.")),
                                    strictOption(QStringLiteral("a promise"))} +
                 measuringOptions(),
             .examples = {{QStringLiteral("One promise, a few samples."),
                           QStringLiteral("hitscope-cli bench check --quick --only paper-way-8k")}}},
            runCheck};
}

}  // namespace hitscope::bench
