// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/section_drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/section_view.h"
#include "view/change_options.h"

namespace hitscope::cli {

namespace {

constexpr double kWidth = 160.0;  // millimetres
constexpr double kMargin = 8.0;
constexpr double kLeast = 1.0e-9;  // metres across, of a section that is a point

/// From metres in the plane to millimetres on paper.
class Paper {
public:
    Paper(const SceneSection& section, const SectionView& view) : m_view(view) {
        for (const TargetSection& target : section.targets) {
            for (const auto* curves : {&target.original, &target.deformed}) {
                for (const SectionCurve& curve : *curves) {
                    for (const glm::vec3& point : curve.points) {
                        m_low = glm::min(m_low, at(point));
                        m_high = glm::max(m_high, at(point));
                    }
                }
            }
        }
        if (!(m_low.x <= m_high.x)) {
            m_low = m_high = glm::dvec2(0.0);
        }
        const glm::dvec2 size = glm::max(m_high - m_low, glm::dvec2(kLeast));
        m_scale = (kWidth - 2.0 * kMargin) / std::max(size.x, size.y);
        m_height = size.y * m_scale + 3.0 * kMargin;
    }
    [[nodiscard]] double height() const { return m_height; }
    [[nodiscard]] double scale() const { return m_scale; }
    [[nodiscard]] glm::dvec2 place(const glm::vec3& point) const {
        const glm::dvec2 flat = at(point) - m_low;
        return {kMargin + flat.x * m_scale, m_height - 2.0 * kMargin - flat.y * m_scale};
    }

private:
    /// As it is shown: an axis may grow to the left, or downwards.
    [[nodiscard]] glm::dvec2 at(const glm::vec3& point) const {
        const glm::dvec2 flat = m_view(point);
        return {m_view.right.mirrored ? -flat.x : flat.x, m_view.up.mirrored ? -flat.y : flat.y};
    }

    const SectionView& m_view;
    glm::dvec2 m_low{std::numeric_limits<double>::infinity()};
    glm::dvec2 m_high{-std::numeric_limits<double>::infinity()};
    double m_scale = 1.0;
    double m_height = 0.0;
};

std::string decimals(double value, int digits = 3) {
    return QString::number(value, 'f', digits).toStdString();
}

void addCurves(std::string& svg, const Paper& paper, const std::vector<SectionCurve>& curves,
               const char* style) {
    for (const SectionCurve& curve : curves) {
        svg += std::string("  <") + (curve.closed ? "polygon" : "polyline") + " class=\"" + style +
               "\" points=\"";
        for (const glm::vec3& point : curve.points) {
            const glm::dvec2 at = paper.place(point);
            svg += decimals(at.x) + ',' + decimals(at.y) + ' ';
        }
        svg += "\"/>\n";
    }
}

void addBar(std::string& svg, const Paper& paper) {
    constexpr int kParts = 4;
    const double length = niceStep(0.0, (kWidth - 2.0 * kMargin) / paper.scale(), kParts);
    const double y = paper.height() - kMargin;
    svg += "  <path class=\"bar\" d=\"M" + decimals(kMargin) + ' ' + decimals(y) + "h" +
           decimals(length * paper.scale()) +
           "\"/>\n  <text font-family=\"sans-serif\" font-size=\"4\" fill=\"#222\" x=\"" + decimals(kMargin) +
           "\" y=\"" + decimals(y + 5.0) + "\">" + QString::number(length, 'g', 3).toStdString() +
           " m</text>\n";
}

}  // namespace

std::string sectionSvg(const SceneSection& section) {
    const SectionView view = sectionView(section.cut.openSide());
    const Paper paper(section, view);
    const std::string height = decimals(paper.height());
    std::string svg =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
        decimals(kWidth, 0) + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + decimals(kWidth, 0) + ' ' +
        height +
        "\">\n  <style>.original{fill:none;stroke:#888;stroke-width:.3;stroke-dasharray:1.5 1}"
        ".deformed{fill:none;stroke:#c0392b;stroke-width:.4}.bar{stroke:#222;stroke-width:.4}"
        "</style>\n";
    for (const TargetSection& target : section.targets) {
        addCurves(svg, paper, target.original, "original");
        addCurves(svg, paper, target.deformed, "deformed");
    }
    addBar(svg, paper);
    return svg + "</svg>\n";
}

}  // namespace hitscope::cli
