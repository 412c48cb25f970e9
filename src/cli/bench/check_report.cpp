// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/check_report.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace hitscope::bench {

namespace {

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

/// `kept`: what the column of that name says.
void addUnmeasured(Report& report, const Check& check, const Error& why, const QString& kept) {
    const QString name = QString::fromStdString(check.name);
    report.tables.front().rows.push_back({name, {}, QStringLiteral("-"), bound(check.atMost), kept});
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
bool addRows(Report& report, const Check& check, const std::vector<CheckRow>& rows) {
    double worst = 0.0;
    for (const CheckRow& row : rows) {
        worst = std::max(worst, row.ratio.value);
    }
    for (const CheckRow& row : rows) {
        addRow(report, check, row, rows.size() > 1 && row.ratio.value >= worst);
    }
    return worst <= check.atMost;
}

/// Nothing: all pipelines run here that the promise cannot do without.
std::optional<Error> whyNotHere(const Check& check, const BenchRoom& room) {
    for (const PipelineKind kind : check.needs) {
        if (const Result<std::unique_ptr<DeformationPipeline>> made = room.makePipeline(kind); !made) {
            return made.error();
        }
    }
    return std::nullopt;
}

/// Whether the promise is kept. Nobody can expect one of a pipeline that does not run here; any other that
/// could not be measured may be broken.
bool reportCheck(const Check& check, const BenchRoom& room, const Plan& plan, Report& report) {
    report.tables.front().notes << QStringLiteral("%1: %2").arg(QString::fromStdString(check.name),
                                                                QString::fromStdString(check.about));
    const QString excused = QStringLiteral("does not run here");
    if (const std::optional<Error> why = whyNotHere(check, room)) {
        addUnmeasured(report, check, *why, excused);
        return true;
    }
    const Result<std::vector<CheckRow>> rows = check.measure(room, plan);
    room.say({});
    if (!rows) {
        addUnmeasured(report, check, rows.error(), QStringLiteral("not measured"));
        return false;
    }
    if (rows.value().empty()) {
        addUnmeasured(report, check, {"Nothing of it runs here.", "", ""}, excused);
        return true;
    }
    return addRows(report, check, rows.value());
}

}  // namespace

Result<bool> reportChecks(std::span<const Check> checks, const BenchRoom& room, const Plan& plan,
                          Report& report) {
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
    for (const Check& check : checks) {
        allKept = reportCheck(check, room, plan, report) && allKept;
        if (Status status = noGlErrors(); !status) {
            return status.error();
        }
    }
    return allKept;
}

}  // namespace hitscope::bench
