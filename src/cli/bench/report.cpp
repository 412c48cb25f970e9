// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/report.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "cli/json_report.h"
#include "core/grouped.h"
#include "io/csv_writer.h"
#include "io/number_text.h"

namespace hitscope::bench {

namespace {

QString cell(const QStringList& row, qsizetype column) {
    return row.value(column);
}

std::vector<int> columnWidths(const Table& table) {
    std::vector<int> widths;
    for (qsizetype column = 0; column < table.columns.size(); ++column) {
        auto width = table.columns[column].size();
        for (const QStringList& row : table.rows) {
            width = std::max(width, cell(row, column).size());
        }
        widths.push_back(static_cast<int>(width));
    }
    return widths;
}

QString tableLine(const QStringList& cells, const std::vector<int>& widths) {
    QString line;
    for (std::size_t column = 0; column < widths.size(); ++column) {
        const QString text = cell(cells, static_cast<qsizetype>(column));
        line += column == 0 ? text.leftJustified(widths[column]) : text.rightJustified(widths[column] + 2);
    }
    while (line.endsWith(QLatin1Char(' '))) {
        line.chop(1);
    }
    return line + QLatin1Char('\n');
}

QString tableText(const Table& table) {
    const std::vector<int> widths = columnWidths(table);
    QString text = table.title + QLatin1Char('\n') + tableLine(table.columns, widths);
    for (const QStringList& row : table.rows) {
        text += tableLine(row, widths);
    }
    for (const QString& note : table.notes) {
        text += QStringLiteral("  ") + note + QLatin1Char('\n');
    }
    return text;
}

}  // namespace

QString toText(const Report& report) {
    QString text;
    for (const auto& [name, value] : report.header) {
        text += name + QStringLiteral(": ") + value + QLatin1Char('\n');
    }
    for (const Table& table : report.tables) {
        text += QLatin1Char('\n') + tableText(table);
    }
    if (!report.notes.isEmpty()) {
        text += QLatin1Char('\n') + report.notes.join(QLatin1Char('\n')) + QLatin1Char('\n');
    }
    return text;
}

namespace {

void add(cli::JsonReport& json, const std::string& key, const QJsonValue& value) {
    if (value.isString()) {
        json.text(key, value.toString());
    } else if (value.isBool()) {
        json.truth(key, value.toBool());
    } else if (value.isDouble()) {
        json.number(key, value.toDouble());
    } else if (value.isArray()) {  // on one line, as there are many
        std::string list;
        for (const QJsonValue& each : value.toArray()) {
            list += list.empty() ? "" : ", ";
            appendNumber(list, each.toDouble());
        }
        json.raw(key, '[' + list + ']');
    } else {
        json.nothing(key);
    }
}

void addTexts(cli::JsonReport& json, std::string_view key, const QStringList& texts) {
    json.beginArray(key);
    for (const QString& text : texts) {
        json.text({}, text);
    }
    json.endArray();
}

}  // namespace

QByteArray toJson(const Report& report) {
    cli::JsonReport json("bench " + report.benchmark.toStdString());
    json.beginObject("header");
    for (const auto& [name, value] : report.header) {
        json.text(name.toStdString(), value);
    }
    json.endObject();
    addTexts(json, "fields", report.fields);
    addTexts(json, "keys", report.keys);
    json.beginArray("records");
    for (const QJsonObject& record : report.records) {
        json.beginObject();
        for (const QString& field :
             report.fields + QStringList{QStringLiteral("unit"), QStringLiteral("runs")}) {
            if (record.contains(field)) {
                add(json, field.toStdString(), record[field]);
            }
        }
        json.endObject();
    }
    json.endArray();
    addTexts(json, "notes", report.notes);
    return QByteArray::fromStdString(json.take());
}

QJsonArray runsJson(const Samples& samples) {
    QJsonArray runs;
    for (const double run : samples.values()) {
        runs.append(run);
    }
    return runs;
}

QByteArray toCsv(const Report& report) {
    CsvWriter csv;
    csv.comment("benchmark: " + report.benchmark.toStdString());
    for (const auto& [name, value] : report.header) {
        csv.comment((name + QStringLiteral(": ") + value).toStdString());
    }
    for (const QString& note : report.notes) {
        csv.comment(note.toStdString());
    }
    for (const QString& field : report.fields) {
        csv.text(field.toStdString());
    }
    csv.endRow();
    for (const QJsonObject& record : report.records) {
        for (const QString& field : report.fields) {
            csv.text(record.value(field).toVariant().toString().toStdString());
        }
        csv.endRow();
    }
    return QByteArray::fromStdString(csv.take());
}

QString shortNumber(double value) {
    const double size = std::abs(value);
    if (size == 0.0 || !std::isfinite(size)) {
        return size == 0.0 ? QStringLiteral("0") : QStringLiteral("-");
    }
    const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 6);
    return QString::number(value, 'f', decimals);
}

QString shortTime(double seconds) {
    if (seconds < 1e-3) {
        return shortNumber(seconds * 1e6) + QStringLiteral(" µs");
    }
    return seconds < 1.0 ? shortNumber(seconds * 1e3) + QStringLiteral(" ms")
                         : shortNumber(seconds) + QStringLiteral(" s");
}

QString grouped(qulonglong value) {
    return QString::fromStdString(hitscope::grouped(value));
}

}  // namespace hitscope::bench
