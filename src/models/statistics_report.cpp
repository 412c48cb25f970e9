// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/statistics_report.h"

#include <QCoreApplication>
#include <QStringList>
#include <array>

#include "io/csv_writer.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

struct StatisticsTexts {
    Q_DECLARE_TR_FUNCTIONS(hitscope::StatisticsReport)
};

using Cells = std::array<QString, 4>;

Cells headings() {
    return {StatisticsTexts::tr("Property"), StatisticsTexts::tr("Original"), StatisticsTexts::tr("Deformed"),
            StatisticsTexts::tr("Change")};
}

Cells cellsOf(const StatisticsRow& row, const MeshMeasurement& measurement) {
    const auto text = [&](StatisticsSide side) {
        return statisticsText(row, measurement, side, copiedLocale());
    };
    return {propertyName(row), text(StatisticsSide::Original), text(StatisticsSide::Deformed),
            text(StatisticsSide::Change)};
}

QString padded(const Cells& cells, const std::array<qsizetype, 4>& widths) {
    QString line = cells[0].leftJustified(static_cast<int>(widths[0]));
    for (std::size_t i = 1; i < cells.size(); ++i) {
        line += QStringLiteral("  ") + cells[i].rightJustified(static_cast<int>(widths[i]));
    }
    while (line.endsWith(u' ')) {
        line.chop(1);
    }
    return line + u'\n';
}

}  // namespace

QString statisticsAsText(const QString& title, const MeshMeasurement& measurement) {
    std::array<qsizetype, 4> widths{};
    const auto widen = [&widths](const Cells& cells) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            widths[i] = std::max(widths[i], cells[i].size());
        }
    };
    widen(headings());
    for (const StatisticsRow& row : statisticsRows()) {
        widen(cellsOf(row, measurement));
    }
    QString text = title + u'\n' + padded(headings(), widths);
    const StatisticsRow* last = nullptr;
    for (const StatisticsRow& row : statisticsRows()) {
        if (last == nullptr || row.section != last->section) {
            text += u'\n' + sectionName(row.section) + u'\n';
        }
        text += padded(cellsOf(row, measurement), widths);
        last = &row;
    }
    return text;
}

QString statisticsAsMarkdown(const QString& title, const MeshMeasurement& measurement) {
    QString text = QStringLiteral("## ") + title + u'\n';
    const auto line = [&text](const Cells& cells) {
        QStringList escaped;
        for (QString cell : cells) {
            escaped << cell.replace(u'|', QLatin1String("\\|"));
        }
        text += QStringLiteral("| ") + escaped.join(QStringLiteral(" | ")) + QStringLiteral(" |\n");
    };
    const StatisticsRow* last = nullptr;
    for (const StatisticsRow& row : statisticsRows()) {
        if (last == nullptr || row.section != last->section) {
            text += QStringLiteral("\n### ") + sectionName(row.section) + QStringLiteral("\n\n");
            line(headings());
            text += QStringLiteral("| :--- | ---: | ---: | ---: |\n");
        }
        line(cellsOf(row, measurement));
        last = &row;
    }
    return text;
}

QString statisticsAsCsv(const MeshMeasurement& measurement) {
    constexpr int kDigits = 17;
    CsvWriter csv(CsvWriter::LineEnd::CrLf);
    csv.row({"section", "key", "property", "unit", "original", "deformed", "change", "note"});
    for (const StatisticsRow& row : statisticsRows()) {
        csv.text(sectionName(row.section).toStdString()).text(row.key);
        csv.text(QCoreApplication::translate("hitscope::StatisticsRow", row.name).toStdString());
        csv.text(row.unit);
        for (const StatisticsSide side :
             {StatisticsSide::Original, StatisticsSide::Deformed, StatisticsSide::Change}) {
            csv.general(statisticsValue(row, measurement, side), kDigits);
        }
        csv.text(whyNot(row, measurement).toStdString());
        csv.endRow();
    }
    return QString::fromStdString(csv.take());
}

}  // namespace hitscope
