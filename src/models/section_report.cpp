// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/section_report.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "io/csv_writer.h"
#include "models/quantity_text.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr double kMoved = 1.0e-6;  // metres, below which nothing counts as dented

struct SectionTexts {
    Q_DECLARE_TR_FUNCTIONS(hitscope::SectionReport)
};

std::size_t segmentsOf(const SectionCurve& curve) {
    return curve.closed ? curve.points.size()
                        : curve.points.size() - std::min<std::size_t>(curve.points.size(), 1);
}

double lengthOf(const std::vector<SectionCurve>& curves) {
    double length = 0.0;
    for (const SectionCurve& curve : curves) {
        for (std::size_t i = 0; i < segmentsOf(curve); ++i) {
            length += static_cast<double>(
                glm::distance(curve.points[i], curve.points[(i + 1) % curve.points.size()]));
        }
    }
    return length;
}

/// Where on the segment from a to b, [0, 1], the place nearest to `at` is.
double alongOf(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& at) {
    const glm::dvec2 way = b - a;
    const double length2 = glm::dot(way, way);
    return length2 > 0.0 ? std::clamp(glm::dot(at - a, way) / length2, 0.0, 1.0) : 0.0;
}

/// What has been found nearest so far.
struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    std::optional<SectionReading> reading;
};

void readCurve(Nearest& best, const TargetSection& section, std::size_t curve, const SectionView& view,
               const glm::dvec2& at) {
    const std::vector<glm::vec3>& points = section.deformed[curve].points;
    for (std::size_t i = 0; i < segmentsOf(section.deformed[curve]); ++i) {
        const std::size_t next = (i + 1) % points.size();
        const glm::dvec2 a = view(points[i]);
        const glm::dvec2 b = view(points[next]);
        const double along = alongOf(a, b, at);
        const double distance = glm::distance(glm::mix(a, b, along), at);
        if (distance < best.distance) {
            const auto part = static_cast<float>(along);
            SectionReading reading{section.target, glm::mix(points[i], points[next], part), {}, {}};
            if (section.depths.greatest) {
                const std::vector<glm::vec3>& nearest = section.depths.nearest[curve];
                const std::vector<float>& depths = section.depths.depths[curve];
                reading.nearest = glm::mix(nearest[i], nearest[next], part);
                reading.depth =
                    glm::mix(static_cast<double>(depths[i]), static_cast<double>(depths[next]), along);
            }
            best = {distance, reading};
        }
    }
}

QString coordinateText(const SectionView::Axis& axis, const QString& word, double value) {
    const QString name = axis.name != 0 ? QString(QLatin1Char(axis.name)) : word;
    constexpr double kSmall = 0.1;  // metres: three decimals are too few
    constexpr double kNone = 1.0e-7;
    const double size = std::abs(value);
    return name + u' ' +
           (size < kSmall && size > kNone ? shownNumber(value, 'g', 3)
                                          : shownNumber(size > kNone ? value : 0.0, 'f', 3));
}

void addCsv(CsvWriter& csv, const char* state, const TargetSection& section, const SectionView& view,
            const std::vector<SectionCurve>& curves, const SectionDepths& depths) {
    constexpr int kDigits = 9;
    const std::string name = section.name.toStdString();
    for (std::size_t line = 0; line < curves.size(); ++line) {
        for (std::size_t i = 0; i < curves[line].points.size(); ++i) {
            const glm::vec3& point = curves[line].points[i];
            csv.text(state).quoted(name).count(line).count(curves[line].closed ? 1 : 0);
            for (int axis = 0; axis < 3; ++axis) {
                csv.general(static_cast<double>(point[axis]), kDigits);
            }
            const glm::dvec2 flat = view(point);
            csv.general(flat.x, kDigits).general(flat.y, kDigits);
            csv.general(
                depths.greatest ? std::optional(static_cast<double>(depths.depths[line][i])) : std::nullopt,
                kDigits);
            csv.endRow();
        }
    }
}

}  // namespace

SectionScope sectionScope(const SceneSection& section, TargetId selected) {
    const bool isCut =
        std::any_of(section.targets.begin(), section.targets.end(),
                    [selected](const TargetSection& target) { return target.target == selected; });
    return {isCut ? selected : TargetId{}};
}

std::optional<SectionReading> readSection(const SceneSection& section, const SectionScope& scope,
                                          const glm::dvec2& at) {
    const SectionView view = sectionView(section.cut.openSide());
    Nearest best;
    for (const TargetSection& target : section.targets) {
        for (std::size_t curve = 0; scope.holds(target) && curve < target.deformed.size(); ++curve) {
            readCurve(best, target, curve, view, at);
        }
    }
    return best.reading;
}

std::optional<SectionReading> deepestOf(const SceneSection& section, const SectionScope& scope) {
    const TargetSection* deepest = nullptr;
    for (const TargetSection& target : section.targets) {
        const auto depth = static_cast<double>(target.depths.greatest.value_or(0.0f));
        if (scope.holds(target) && depth > kMoved &&
            (deepest == nullptr || *target.depths.greatest > *deepest->depths.greatest)) {
            deepest = &target;
        }
    }
    if (deepest == nullptr) {
        return std::nullopt;
    }
    const SectionDepths& depths = deepest->depths;
    return SectionReading{deepest->target, deepest->deformed[depths.curve].points[depths.point],
                          depths.nearest[depths.curve][depths.point], static_cast<double>(*depths.greatest)};
}

QString placeText(const SectionView& view, const glm::vec3& place) {
    const glm::dvec2 flat = view(place);
    return coordinateText(view.right, SectionTexts::tr("across"), flat.x) + numberSeparator() +
           coordinateText(view.up, SectionTexts::tr("up"), flat.y);
}

QString sectionText(const SceneSection& section, const SectionScope& scope) {
    QStringList lines;
    const auto add = [&lines](const QString& name, const QString& value, const QString& unit = {}) {
        lines.append(name + u'\t' + value + u'\t' + unit);
    };
    const auto metres = [](double value) { return QString::number(value, 'g', 6); };
    add(SectionTexts::tr("Normal"), copiedVectorText(section.cut.normal));
    add(SectionTexts::tr("Offset"), metres(static_cast<double>(section.cut.offset)), QStringLiteral("m"));
    for (const TargetSection& target : section.targets) {
        if (scope.holds(target)) {
            add(SectionTexts::tr("Target"), target.name);
            add(SectionTexts::tr("Length, original"), metres(lengthOf(target.original)), QStringLiteral("m"));
            add(SectionTexts::tr("Length, deformed"), metres(lengthOf(target.deformed)), QStringLiteral("m"));
            if (target.depths.greatest) {
                add(SectionTexts::tr("Greatest depth"), metres(static_cast<double>(*target.depths.greatest)),
                    QStringLiteral("m"));
            } else {
                add(SectionTexts::tr("Greatest depth"),
                    target.original.empty() ? SectionTexts::tr("none, the plane does not cut the original")
                                            : SectionTexts::tr("none, the plane cuts only the original"));
            }
        }
    }
    if (const auto deepest = deepestOf(section, scope)) {
        add(SectionTexts::tr("Deepest at"), copiedVectorText(deepest->place), QStringLiteral("m"));
    }
    return lines.join(u'\n');
}

QByteArray sectionCsv(const SceneSection& section, const SectionScope& scope) {
    CsvWriter csv;
    csv.row({"state", "target", "line", "closed", "x_m", "y_m", "z_m", "right_m", "up_m", "depth_m"});
    const SectionView view = sectionView(section.cut.openSide());
    for (const TargetSection& target : section.targets) {
        if (scope.holds(target)) {
            addCsv(csv, "original", target, view, target.original, {});
            addCsv(csv, "deformed", target, view, target.deformed, target.depths);
        }
    }
    return QByteArray::fromStdString(csv.take());
}

}  // namespace hitscope
