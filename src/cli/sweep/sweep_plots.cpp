// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <map>

#include "cli/sweep/sweep_results.h"

namespace hitscope::cli {

namespace {

constexpr double kPanelWidth = 220.0;  // pixels
constexpr double kPanelHeight = 150.0;
constexpr double kLeft = 62.0;  // of a panel: room for numbers
constexpr double kBottom = 34.0;
constexpr double kTop = 26.0;
constexpr std::array kColours{"#4477aa", "#ee6677", "#228833", "#ccbb44", "#66ccee", "#aa3377", "#777777"};

struct Metric {
    const char* name;
    double (*value)(const SweepResult&);
};
constexpr std::array<Metric, 2> kMetrics{
    {{"largest displacement, m", [](const SweepResult& result) { return result.largest; }},
     {"changed vertices",
      [](const SweepResult& result) { return static_cast<double>(result.changedVertices); }}}};

/// Which axis goes where; -1: none does.
struct Layout {
    qsizetype x = -1;
    qsizetype line = -1;
};

bool isNumbers(const SweepTable& table, qsizetype axis) {
    return std::all_of(table.plan.jobs.begin(), table.plan.jobs.end(), [axis](const SweepJob& job) {
        bool isNumber = false;
        static_cast<void>(job.values[axis].toDouble(&isNumber));
        return isNumber;
    });
}

/// Seeds are repetitions, which only stand in a row of their own where nothing else does.
Layout layoutOf(const SweepTable& table) {
    Layout layout;
    const QStringList& axes = table.plan.axes;
    for (const bool seedsToo : {false, true}) {
        for (qsizetype axis = 0; axis < axes.size() && layout.x < 0; ++axis) {
            if (isNumbers(table, axis) && (seedsToo || axes[axis] != QLatin1String("seed"))) {
                layout.x = axis;
            }
        }
    }
    for (qsizetype axis = 0; axis < axes.size() && layout.line < 0; ++axis) {
        if (axis != layout.x && axes[axis] != QLatin1String("seed")) {
            layout.line = axis;
        }
    }
    return layout;
}

struct Point {
    double x = 0.0;
    double y = 0.0;
};
/// By the value of the axis that tells lines apart.
using Lines = std::map<QString, std::vector<Point>>;

std::string number(double value) {
    return QString::number(value, 'f', 1).toStdString();
}
std::string label(double value) {
    return QString::number(value, 'g', 3).toStdString();
}
std::string escaped(const QString& text) {
    return text.toHtmlEscaped().toStdString();
}

std::string textAt(double x, double y, const char* anchor, const std::string& text) {
    return "  <text font-family=\"sans-serif\" font-size=\"11\" fill=\"#222\" x=\"" + number(x) + "\" y=\"" +
           number(y) + "\" text-anchor=\"" + anchor + "\">" + text + "</text>\n";
}

/// One diagram, at its place, over the x of all of its row, and up to the highest of its own points.
class Panel {
public:
    Panel(double left, double top, Point low, Point high)
        : m_left(left), m_top(top), m_low(low), m_high(high) {
        if (!(m_high.x > m_low.x)) {
            m_high.x = m_low.x + 1.0;
        }
        if (!(m_high.y > m_low.y)) {
            m_high.y = m_low.y + 1.0;
        }
    }

    [[nodiscard]] std::string frame(const std::string& title, const std::string& below) const {
        const double right = m_left + kPanelWidth;
        const double bottom = m_top + kPanelHeight;
        return "  <rect class=\"frame\" x=\"" + number(m_left) + "\" y=\"" + number(m_top) + "\" width=\"" +
               number(kPanelWidth) + "\" height=\"" + number(kPanelHeight) + "\"/>\n" +
               textAt(m_left, m_top - 6.0, "start", title) +
               textAt(m_left - 4.0, bottom, "end", label(m_low.y)) +
               textAt(m_left - 4.0, m_top + 8.0, "end", label(m_high.y)) +
               textAt(m_left, bottom + 12.0, "start", label(m_low.x)) +
               textAt(right, bottom + 12.0, "end", label(m_high.x)) +
               textAt(0.5 * (m_left + right), bottom + 24.0, "middle", below);
    }

    /// The points, and a line through the mean of those at each x.
    [[nodiscard]] std::string line(const std::vector<Point>& points, const char* colour) const {
        std::string svg;
        std::map<double, Point> sums;  // x: how many
        for (const Point& point : points) {
            const Point at = place(point);
            svg += "  <circle cx=\"" + number(at.x) + "\" cy=\"" + number(at.y) + "\" r=\"2\" fill=\"" +
                   colour + "\"/>\n";
            sums[point.x].x += 1.0;
            sums[point.x].y += point.y;
        }
        svg += "  <polyline fill=\"none\" stroke=\"" + std::string(colour) + "\" points=\"";
        for (const auto& [x, sum] : sums) {
            const Point at = place({x, sum.y / sum.x});
            svg += number(at.x) + ',' + number(at.y) + ' ';
        }
        return svg + "\"/>\n";
    }

private:
    [[nodiscard]] Point place(const Point& point) const {
        return {m_left + kPanelWidth * (point.x - m_low.x) / (m_high.x - m_low.x),
                m_top + kPanelHeight * (1.0 - (point.y - m_low.y) / (m_high.y - m_low.y))};
    }

    double m_left;
    double m_top;
    Point m_low;
    Point m_high;
};

Lines linesOf(const SweepTable& table, const Layout& layout, const QString& scene, const Metric& metric) {
    Lines lines;
    for (std::size_t i = 0; i < table.plan.jobs.size(); ++i) {
        const SweepJob& job = table.plan.jobs[i];
        if (table.results[i] && job.scene == scene) {
            const double x = layout.x < 0 ? static_cast<double>(i + 1) : job.values[layout.x].toDouble();
            lines[layout.line < 0 ? QString() : job.values[layout.line]].push_back(
                {x, metric.value(*table.results[i])});
        }
    }
    return lines;
}

const char* colourOf(const SweepTable& table, const Layout& layout, const QString& value) {
    QStringList values;
    for (const SweepJob& job : table.plan.jobs) {
        if (layout.line >= 0 && !values.contains(job.values[layout.line])) {
            values << job.values[layout.line];
        }
    }
    const qsizetype place = std::max<qsizetype>(values.indexOf(value), 0);
    return kColours[static_cast<std::size_t>(place) % kColours.size()];
}

std::string legend(const SweepTable& table, const Layout& layout, double y) {
    std::string svg;
    double x = kLeft;
    QStringList said;
    for (const SweepJob& job : table.plan.jobs) {
        if (layout.line < 0 || said.contains(job.values[layout.line])) {
            continue;
        }
        said << job.values[layout.line];
        const QString text = table.plan.axes[layout.line] + u' ' + said.constLast();
        svg += "  <circle cx=\"" + number(x) + "\" cy=\"" + number(y - 4.0) + "\" r=\"4\" fill=\"" +
               colourOf(table, layout, said.constLast()) + "\"/>\n" +
               textAt(x + 8.0, y, "start", escaped(text));
        x += 24.0 + 7.0 * static_cast<double>(text.size());
    }
    return svg;
}

std::string rowOf(const SweepTable& table, const Layout& layout, const QStringList& scenes,
                  std::size_t metric) {
    std::vector<Lines> columns;
    std::vector<double> highest;  // one a column: scenes may differ in size by orders of magnitude
    Point low{1.0e300, 0.0};
    double right = -1.0e300;
    for (const QString& scene : scenes) {
        columns.push_back(linesOf(table, layout, scene, kMetrics[metric]));
        highest.push_back(0.0);
        for (const auto& [value, points] : columns.back()) {
            for (const Point& point : points) {
                low.x = std::min(low.x, point.x);
                right = std::max(right, point.x);
                highest.back() = std::max(highest.back(), point.y);
            }
        }
    }
    std::string svg;
    const double top = kTop + static_cast<double>(metric) * (kPanelHeight + kBottom + kTop);
    const QString below = layout.x < 0 ? QStringLiteral("job") : table.plan.axes[layout.x];
    for (std::size_t column = 0; column < columns.size(); ++column) {
        const Panel panel(kLeft + static_cast<double>(column) * (kPanelWidth + kLeft), top, low,
                          {right, highest[column]});
        const QString& scene = scenes[static_cast<qsizetype>(column)];
        const QString title = scene.isEmpty() ? QStringLiteral("the paper's scene") : scene.section(u'/', -1);
        svg += panel.frame(escaped(title) + ": " + kMetrics[metric].name, escaped(below));
        for (const auto& [value, points] : columns[column]) {
            svg += panel.line(points, colourOf(table, layout, value));
        }
    }
    return svg;
}

}  // namespace

std::string toSvg(const SweepTable& table) {
    QStringList scenes;
    for (const SweepJob& job : table.plan.jobs) {
        if (!scenes.contains(job.scene)) {
            scenes << job.scene;
        }
    }
    const Layout layout = layoutOf(table);
    const double width = kLeft + static_cast<double>(scenes.size()) * (kPanelWidth + kLeft);
    const double rows = static_cast<double>(kMetrics.size()) * (kPanelHeight + kBottom + kTop);
    const double height = kTop + rows + kBottom;
    std::string svg =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
        number(width) + "\" height=\"" + number(height) +
        "\">\n  <style>.frame{fill:none;stroke:#999}</style>\n"
        "  <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    for (std::size_t metric = 0; metric < kMetrics.size(); ++metric) {
        svg += rowOf(table, layout, scenes, metric);
    }
    return svg + legend(table, layout, height - 12.0) + "</svg>\n";
}

}  // namespace hitscope::cli
