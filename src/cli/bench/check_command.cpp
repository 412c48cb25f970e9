// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTextStream>

#include "cli/bench/bench_command.h"
#include "cli/bench/checks.h"
#include "cli/bench/report_header.h"
#include "cli/command_line.h"

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

/// Whether all that were measured are kept.
Result<bool> runChecks(const CheckOptions& options) {
    if (Status status = checkDestinations(options.common.destinations); !status) {
        return status.error();
    }
    Result<std::unique_ptr<BenchRoom>> room = BenchRoom::open(kCheckWidth, kCheckHeight);
    if (!room) {
        return room.error();
    }
    Report report;
    report.benchmark = QStringLiteral("check");
    report.header = reportHeader(*room.value(), kCheckWidth, kCheckHeight);
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
        const Result<double> ratio = check.measure(*room.value(), options.common.plan);
        room.value()->say({});
        if (Status status = noGlErrors(); !status) {
            return status.error();
        }
        addResult(report, check, ratio);
        allKept = allKept && (!ratio || ratio.value() <= check.atMost);
    }
    if (Status status = writeReport(report, options.common.destinations); !status) {
        return status.error();
    }
    return allKept;
}

}  // namespace

int checkCommand(const QStringList& list) {
    QStringList names;
    for (const Check& check : allChecks()) {
        names << QString::fromStdString(check.name);
    }
    Arguments arguments(QStringLiteral("Measures the ratios that Hitscope promises, each in one run."));
    addMeasuringOptions(arguments);
    arguments.addOption(QStringLiteral("only"),
                        QStringLiteral("These: %1.").arg(names.join(QStringLiteral(", "))),
                        QStringLiteral("list"), names.join(QLatin1Char(',')));
    arguments.addFlag(QStringLiteral("strict"), QStringLiteral("Exit status 1 if one is not kept."));
    parseBenchArguments(arguments, list);
    if (arguments.error().isEmpty() && arguments.wantsHelp()) {
        QTextStream(stdout) << arguments.help(QStringLiteral("check"));
        return 0;
    }
    CheckOptions options;
    options.common = takeMeasuringOptions(arguments);
    options.only = arguments.list(QStringLiteral("only"), names);
    options.strict = arguments.isSet(QStringLiteral("strict"));
    if (!arguments.error().isEmpty()) {
        return cli::wrongUsage(arguments.error());
    }
    const Result<bool> kept = runChecks(options);
    if (!kept) {
        return cli::finish(kept.error());
    }
    return options.strict && !kept.value() ? cli::kFailed : 0;
}

}  // namespace hitscope::bench
