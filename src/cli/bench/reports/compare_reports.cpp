// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/reports/compare_reports.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <optional>
#include <vector>

#include "cli/bench/harness.h"
#include "cli/bench/reports/ratio_interval.h"

namespace hitscope::bench {

namespace {

struct ReadRow {
    QString name;  ///< its keys' values
    QString unit;
    std::vector<double> runs;  ///< above 0, one at least
};

struct ReadReport {
    QString benchmark;  ///< "frame"
    QJsonObject header;
    std::vector<ReadRow> rows;
};

Error wrong(const ReportFile& file, const std::string& what) {
    return Error{what, file.path.toStdString(),
                 "Give a report that hitscope-cli bench has written with --report."};
}

QString nameOf(const QJsonObject& record, const QJsonArray& keys) {
    QStringList parts;
    for (const QJsonValue& key : keys) {
        const QJsonValue value = record[key.toString()];
        if (value.isBool()) {
            if (value.toBool()) {
                parts << key.toString();
            }
        } else if (value.isString()) {
            parts << value.toString();
        } else if (value.isDouble()) {
            parts << key.toString() + u' ' + QString::number(value.toDouble(), 'g', 12);
        }
    }
    return parts.join(QStringLiteral(", "));
}

Result<std::vector<double>> runsOf(const ReportFile& file, const QString& row, const QJsonArray& values) {
    std::vector<double> runs;
    for (const QJsonValue& value : values) {
        if (!(value.toDouble() > 0.0)) {
            return wrong(file, "A run of the row \"" + row.toStdString() + "\" is no number above 0.");
        }
        runs.push_back(value.toDouble());
    }
    return runs;
}

Result<ReadReport> readReport(const ReportFile& file) {
    QJsonParseError problem;
    const QJsonDocument document = QJsonDocument::fromJson(file.json, &problem);
    if (problem.error != QJsonParseError::NoError) {
        return wrong(file, "This is not JSON, from byte " + std::to_string(problem.offset) +
                               " on: " + problem.errorString().toStdString() + ".");
    }
    const QJsonObject object = document.object();
    const QString name = object[QStringLiteral("report")].toString();
    if (!name.startsWith(QStringLiteral("bench ")) || !object[QStringLiteral("keys")].isArray() ||
        !object[QStringLiteral("records")].isArray()) {
        return wrong(file, "This is not the report of a benchmark.");
    }
    ReadReport report{name.mid(6), object[QStringLiteral("header")].toObject(), {}};
    const QJsonArray keys = object[QStringLiteral("keys")].toArray();
    for (const QJsonValue& value : object[QStringLiteral("records")].toArray()) {
        const QJsonObject record = value.toObject();
        const QString row = nameOf(record, keys);
        Result<std::vector<double>> runs = runsOf(file, row, record[QStringLiteral("runs")].toArray());
        if (!runs) {
            return runs.error();
        }
        if (runs.value().empty()) {
            continue;
        }
        if (std::any_of(report.rows.begin(), report.rows.end(),
                        [&row](const ReadRow& other) { return other.name == row; })) {
            return wrong(file, "Two rows are \"" + row.toStdString() + "\".");
        }
        report.rows.push_back({row, record[QStringLiteral("unit")].toString(), std::move(runs).value()});
    }
    if (report.rows.empty()) {
        return wrong(file, "Its rows have no runs.");
    }
    return report;
}

double medianOfRuns(const std::vector<double>& runs) {
    Samples samples;
    for (const double run : runs) {
        samples.add(run);
    }
    return samples.median();
}

QString valueText(double value, const QString& unit) {
    return unit.isEmpty() ? shortTime(value) : shortNumber(value) + u' ' + unit;
}

QString decimals(double ratio) {
    return QString::number(ratio, 'f', 3);
}

/// What can be said of a row for certain.
QString verdictOf(const RatioInterval& interval, double tolerance) {
    if (!interval.low) {
        return QStringLiteral("too few runs");
    }
    if (*interval.low > 1.0 + tolerance) {
        return QStringLiteral("slower");
    }
    if (*interval.low > 1.0) {
        return QStringLiteral("slower, in tolerance");
    }
    return *interval.high < 1.0 ? QStringLiteral("faster") : QStringLiteral("no difference seen");
}

void addRow(ReportComparison& made, const ReadRow& a, const ReadRow& b, const ComparisonRules& rules) {
    const RatioInterval interval = ratioInterval(a.runs, b.runs, rules.confidence);
    const QString verdict = verdictOf(interval, rules.tolerance);
    made.slowerRows += verdict == QLatin1String("slower") ? 1 : 0;
    const double medianA = medianOfRuns(a.runs);
    const double medianB = medianOfRuns(b.runs);
    const auto orNull = [](const std::optional<double>& value) {
        return value ? QJsonValue(*value) : QJsonValue();
    };
    made.report.tables.front().rows.push_back(
        {a.name, valueText(medianA, a.unit), valueText(medianB, b.unit), decimals(interval.ratio),
         interval.low ? decimals(*interval.low) + u'-' + decimals(*interval.high) : QStringLiteral("-"),
         QStringLiteral("%1, %2").arg(a.runs.size()).arg(b.runs.size()), verdict});
    made.report.records.push_back({{QStringLiteral("row"), a.name},
                                   {QStringLiteral("a_median"), medianA},
                                   {QStringLiteral("b_median"), medianB},
                                   {QStringLiteral("a_runs"), static_cast<qint64>(a.runs.size())},
                                   {QStringLiteral("b_runs"), static_cast<qint64>(b.runs.size())},
                                   {QStringLiteral("ratio"), interval.ratio},
                                   {QStringLiteral("ratio_low"), orNull(interval.low)},
                                   {QStringLiteral("ratio_high"), orNull(interval.high)},
                                   {QStringLiteral("verdict"), verdict}});
    made.report.marks.push_back({a.name, interval.low.value_or(interval.ratio), interval.ratio,
                                 interval.high.value_or(interval.ratio), 1.0 + rules.tolerance});
}

/// Files and what was measured in them; a note where they are not of the same machine.
void addHeader(Report& report, const ReportFile& a, const ReportFile& b, const ReadReport& readA,
               const ReadReport& readB) {
    report.header = {{QStringLiteral("compared"), QStringLiteral("bench ") + readA.benchmark},
                     {QStringLiteral("A"), a.path},
                     {QStringLiteral("B"), b.path}};
    for (const char* key : {"program", "date", "processor", "renderer", "OpenGL", "picture"}) {
        const QString name = QLatin1String(key);
        const QString inA = readA.header[name].toString();
        const QString inB = readB.header[name].toString();
        if (inA == inB) {
            report.header.emplace_back(name, inA);
            continue;
        }
        report.header.emplace_back(QStringLiteral("A, ") + name, inA);
        report.header.emplace_back(QStringLiteral("B, ") + name, inB);
        if (name != QLatin1String("program") && name != QLatin1String("date")) {
            report.notes << QStringLiteral("They differ in the %1: ratios are of that as well.").arg(name);
        }
    }
}

void noteRowsOfOne(Report& report, const ReadReport& of, const ReadReport& other, const QString& which) {
    for (const ReadRow& row : of.rows) {
        if (std::none_of(other.rows.begin(), other.rows.end(),
                         [&row](const ReadRow& each) { return each.name == row.name; })) {
            report.notes << QStringLiteral("Only %1 has the row: %2").arg(which, row.name);
        }
    }
}

void describe(Report& report, const ComparisonRules& rules) {
    report.benchmark = QStringLiteral("compare");
    report.keys = {QStringLiteral("row")};
    report.fields = {QStringLiteral("row"),       QStringLiteral("a_median"),   QStringLiteral("b_median"),
                     QStringLiteral("a_runs"),    QStringLiteral("b_runs"),     QStringLiteral("ratio"),
                     QStringLiteral("ratio_low"), QStringLiteral("ratio_high"), QStringLiteral("verdict")};
    report.marksAxis = QStringLiteral("B over A; the bar: %1 % confidence").arg(100.0 * rules.confidence);
    Table table;
    table.title = QStringLiteral("B over A");
    table.columns = {QStringLiteral("row"),
                     QStringLiteral("A"),
                     QStringLiteral("B"),
                     QStringLiteral("B / A"),
                     QStringLiteral("%1 % interval").arg(100.0 * rules.confidence),
                     QStringLiteral("runs"),
                     QString()};
    report.tables.push_back(table);
    report.notes
        << QStringLiteral(
               "Slower: the whole interval lies above %1. It is of the runs of each report; what the "
               "machine did otherwise from one report to the other is not in it. Of rows that are "
               "alike, %2 in 100 still look different.")
               .arg(1.0 + rules.tolerance)
               .arg(100.0 * (1.0 - rules.confidence), 0, 'g', 3);
}

}  // namespace

Result<ReportComparison> compareReports(const ReportFile& a, const ReportFile& b,
                                        const ComparisonRules& rules) {
    const Result<ReadReport> readA = readReport(a);
    if (!readA) {
        return readA.error();
    }
    const Result<ReadReport> readB = readReport(b);
    if (!readB) {
        return readB.error();
    }
    if (readA.value().benchmark != readB.value().benchmark) {
        return Error{"It is of bench " + readB.value().benchmark.toStdString() + ", and " +
                         a.path.toStdString() + " of bench " + readA.value().benchmark.toStdString() + ".",
                     b.path.toStdString(), "Compare two of the same benchmark."};
    }
    ReportComparison made;
    describe(made.report, rules);
    addHeader(made.report, a, b, readA.value(), readB.value());
    for (const ReadRow& row : readA.value().rows) {
        for (const ReadRow& other : readB.value().rows) {
            if (row.name == other.name) {
                addRow(made, row, other, rules);
            }
        }
    }
    if (made.report.records.empty()) {
        return Error{"It has no row in common with " + a.path.toStdString() + ".", b.path.toStdString(),
                     "Measure both with the same options."};
    }
    noteRowsOfOne(made.report, readA.value(), readB.value(), QStringLiteral("A"));
    noteRowsOfOne(made.report, readB.value(), readA.value(), QStringLiteral("B"));
    return made;
}

}  // namespace hitscope::bench
