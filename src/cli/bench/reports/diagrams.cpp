// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/reports/diagrams.h"

#include <QJsonArray>
#include <QXmlStreamWriter>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "cli/bench/harness.h"

namespace hitscope::bench {

namespace {

constexpr double kWidth = 1000.0;  // of a diagram, its own units
constexpr double kRowHeight = 18.0;
constexpr double kLetter = 6.7;  // a wide one of a name
constexpr double kMostNames = 640.0;
constexpr double kLineHeight = 320.0;
constexpr int kColours = 6;

QString place(double value) {
    return QString::number(value, 'f', 1);
}

/// A logarithmic axis from one end of the drawing to the other.
class LogAxis {
public:
    LogAxis(double least, double most, double from, double to)
        : m_least(std::log10(least)), m_most(std::log10(most)), m_from(from), m_to(to) {
        constexpr double kRoom = 0.04;  // beyond the outermost, so that they are seen whole
        const double room = std::max(kRoom * (m_most - m_least), 0.02);
        m_least -= room;
        m_most += room;
    }

    [[nodiscard]] double at(double value) const {
        return m_from + (m_to - m_from) * (std::log10(value) - m_least) / (m_most - m_least);
    }

    /// Round values in its range: powers of ten, or 1, 2 and 5 of each, or nearer ones.
    [[nodiscard]] std::vector<double> ticks() const {
        std::vector<double> values;
        const std::vector<double> steps =
            m_most - m_least > 3.0 ? std::vector<double>{1.0}
            : m_most - m_least > 0.5
                ? std::vector<double>{1.0, 2.0, 5.0}
                : std::vector<double>{1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0};
        for (double decade = std::floor(m_least); decade <= m_most; decade += 1.0) {
            for (const double step : steps) {
                const double value = step * std::pow(10.0, decade);
                if (std::log10(value) >= m_least && std::log10(value) <= m_most) {
                    values.push_back(value);
                }
            }
        }
        return values;
    }

private:
    double m_least;
    double m_most;
    double m_from;
    double m_to;
};

void writeLine(QXmlStreamWriter& xml, double x1, double y1, double x2, double y2, const QString& kind) {
    xml.writeEmptyElement(QStringLiteral("line"));
    xml.writeAttribute(QStringLiteral("class"), kind);
    xml.writeAttribute(QStringLiteral("x1"), place(x1));
    xml.writeAttribute(QStringLiteral("y1"), place(y1));
    xml.writeAttribute(QStringLiteral("x2"), place(x2));
    xml.writeAttribute(QStringLiteral("y2"), place(y2));
}

void writeDot(QXmlStreamWriter& xml, double x, double y, const QString& kind) {
    xml.writeEmptyElement(QStringLiteral("circle"));
    xml.writeAttribute(QStringLiteral("class"), kind);
    xml.writeAttribute(QStringLiteral("cx"), place(x));
    xml.writeAttribute(QStringLiteral("cy"), place(y));
    xml.writeAttribute(QStringLiteral("r"), QStringLiteral("3.5"));
}

/// `anchor`: "start", "middle", "end".
void writeText(QXmlStreamWriter& xml, double x, double y, const QString& anchor, const QString& text,
               const QString& kind = {}) {
    xml.writeStartElement(QStringLiteral("text"));
    if (!kind.isEmpty()) {
        xml.writeAttribute(QStringLiteral("class"), kind);
    }
    xml.writeAttribute(QStringLiteral("x"), place(x));
    xml.writeAttribute(QStringLiteral("y"), place(y));
    xml.writeAttribute(QStringLiteral("text-anchor"), anchor);
    xml.writeCharacters(text);
    xml.writeEndElement();
}

void openDrawing(QXmlStreamWriter& xml, const QString& title, double height) {
    xml.writeTextElement(QStringLiteral("h2"), title);
    xml.writeStartElement(QStringLiteral("svg"));
    xml.writeAttribute(QStringLiteral("xmlns"), QStringLiteral("http://www.w3.org/2000/svg"));
    xml.writeAttribute(QStringLiteral("role"), QStringLiteral("img"));
    xml.writeAttribute(QStringLiteral("viewBox"), QStringLiteral("0 0 %1 %2").arg(kWidth).arg(height));
    xml.writeAttribute(QStringLiteral("width"), QString::number(kWidth));
    xml.writeTextElement(QStringLiteral("title"), title);
}

Samples samplesOf(const QJsonObject& record) {
    Samples samples;
    for (const QJsonValue& run : record[QStringLiteral("runs")].toArray()) {
        samples.add(run.toDouble());
    }
    return samples;
}

/// What tells a record from the others, but for one field.
QString nameWithout(const Report& report, const QJsonObject& record, const QString& field) {
    QStringList parts;
    for (const QString& key : report.keys) {
        const QJsonValue value = record[key];
        if (key != field && !value.isNull()) {
            parts << (value.isString() ? value.toString()
                      : value.isBool() ? (value.toBool() ? key : QString())
                                       : key + u' ' + value.toVariant().toString());
        }
    }
    parts.removeAll(QString());
    return parts.join(QStringLiteral(", "));
}

/// Of times where the report has no marks of its own; other units are no times.
std::vector<Mark> marksOf(const Report& report) {
    std::vector<Mark> marks = report.marks;
    for (const QJsonObject& record : report.records) {
        const Samples samples = samplesOf(record);
        if (report.marks.empty() && !samples.empty() && record[QStringLiteral("unit")].isUndefined()) {
            marks.push_back(
                {nameWithout(report, record, {}), samples.least(), samples.median(), samples.most()});
        }
    }
    marks.erase(
        std::remove_if(marks.begin(), marks.end(), [](const Mark& mark) { return !(mark.low > 0.0); }),
        marks.end());
    return marks;
}

QString valueLabel(const Report& report, double value) {
    return report.marks.empty() ? shortTime(value) : QString::number(value, 'g', 3);
}

/// Room for the names, up to two thirds of the drawing.
double namesWidth(const std::vector<Mark>& marks) {
    double width = 0.0;
    for (const Mark& mark : marks) {
        width = std::max(width, kLetter * static_cast<double>(mark.name.size()));
    }
    return std::min(width, kMostNames);
}

LogAxis axisOf(const std::vector<Mark>& marks) {
    double least = std::numeric_limits<double>::max();
    double most = 0.0;
    for (const Mark& mark : marks) {
        least = std::min({least, mark.low, mark.limit > 0.0 ? mark.limit : mark.low});
        most = std::max({most, mark.high, mark.limit});
    }
    return {least, most, namesWidth(marks) + 15.0, kWidth - 20.0};
}

void writeMarks(QXmlStreamWriter& xml, const Report& report) {
    const std::vector<Mark> marks = marksOf(report);
    if (marks.empty()) {
        return;
    }
    const LogAxis axis = axisOf(marks);
    const double bottom = kRowHeight * (static_cast<double>(marks.size()) + 0.5);
    openDrawing(
        xml,
        report.marksAxis.isEmpty() ? QStringLiteral("Time: median, least and longest") : report.marksAxis,
        bottom + 24.0);
    for (const double tick : axis.ticks()) {
        writeLine(xml, axis.at(tick), 4.0, axis.at(tick), bottom, QStringLiteral("grid"));
        writeText(xml, axis.at(tick), bottom + 16.0, QStringLiteral("middle"), valueLabel(report, tick),
                  QStringLiteral("faint"));
    }
    const double names = namesWidth(marks);
    double y = kRowHeight;
    for (const Mark& mark : marks) {
        writeText(xml, names, y + 4.0, QStringLiteral("end"), mark.name);
        writeLine(xml, axis.at(mark.low), y, axis.at(mark.high), y, QStringLiteral("line l0"));
        writeDot(xml, axis.at(mark.middle), y, QStringLiteral("f0"));
        if (mark.limit > 0.0) {
            writeLine(xml, axis.at(mark.limit), y - 6.0, axis.at(mark.limit), y + 6.0,
                      QStringLiteral("limit"));
        }
        y += kRowHeight;
    }
    xml.writeEndElement();
}

/// Medians over a field's values; by what else tells records apart.
using Lines = std::map<QString, std::map<double, double>>;

Lines linesOf(const Report& report) {
    Lines lines;
    for (const QJsonObject& record : report.records) {
        const Samples samples = samplesOf(record);
        if (samples.median() > 0.0) {
            lines[nameWithout(report, record, report.along)][record[report.along].toDouble()] =
                samples.median();
        }
    }
    std::erase_if(lines, [](const auto& line) { return line.second.size() < 2; });
    return lines;
}

/// Of a logarithmic axis, on which 0 stands a decade below the least value above it.
double shownX(double x, double least) {
    return x > 0.0 ? x : 0.1 * least;
}

void writeLines(QXmlStreamWriter& xml, const Report& report) {
    const Lines lines = report.along.isEmpty() ? Lines() : linesOf(report);
    if (lines.empty()) {
        return;
    }
    std::map<double, bool> xs;  // the keys alone
    double least = std::numeric_limits<double>::max();
    double most = 0.0;
    for (const auto& [name, points] : lines) {
        for (const auto& [x, y] : points) {
            xs[x] = true;
            least = std::min(least, y);
            most = std::max(most, y);
        }
    }
    const auto above = xs.upper_bound(0.0);
    const double leastX = above == xs.end() ? 1.0 : above->first;
    const LogAxis across(shownX(xs.begin()->first, leastX), shownX(xs.rbegin()->first, leastX), 80.0,
                         kWidth - 20.0);
    const LogAxis up(least, most, kLineHeight, 10.0);
    openDrawing(xml, QStringLiteral("Median time over %1").arg(report.along),
                kLineHeight + 40.0 + kRowHeight * static_cast<double>(lines.size()));
    for (const double tick : up.ticks()) {
        writeLine(xml, 80.0, up.at(tick), kWidth - 20.0, up.at(tick), QStringLiteral("grid"));
        writeText(xml, 74.0, up.at(tick) + 4.0, QStringLiteral("end"), shortTime(tick),
                  QStringLiteral("faint"));
    }
    for (const auto& [x, unused] : xs) {
        const double at = across.at(shownX(x, leastX));
        writeLine(xml, at, 10.0, at, kLineHeight, QStringLiteral("grid"));
        writeText(xml, at, kLineHeight + 16.0, QStringLiteral("middle"), grouped(static_cast<qulonglong>(x)),
                  QStringLiteral("faint"));
    }
    double legend = kLineHeight + 40.0;
    int colour = 0;
    for (const auto& [name, points] : lines) {
        const QString number = QString::number(colour % kColours);
        const QString stroke = QStringLiteral("line l") + number +
                               (colour / kColours % 2 == 1 ? QStringLiteral(" dashed") : QString());
        ++colour;
        QStringList corners;
        for (const auto& [x, y] : points) {
            corners << place(across.at(shownX(x, leastX))) + u',' + place(up.at(y));
            writeDot(xml, across.at(shownX(x, leastX)), up.at(y), u'f' + number);
        }
        xml.writeEmptyElement(QStringLiteral("polyline"));
        xml.writeAttribute(QStringLiteral("class"), stroke);
        xml.writeAttribute(QStringLiteral("points"), corners.join(u' '));
        writeLine(xml, 80.0, legend - 4.0, 110.0, legend - 4.0, stroke);
        writeText(xml, 118.0, legend, QStringLiteral("start"), name);
        legend += kRowHeight;
    }
    xml.writeEndElement();
}

}  // namespace

void writeDiagrams(QXmlStreamWriter& xml, const Report& report) {
    writeLines(xml, report);
    writeMarks(xml, report);
}

}  // namespace hitscope::bench
