// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <span>

#include "analysis/measured_target.h"
#include "session/shown_number.h"

namespace hitscope {

/// One line of the mesh statistics, apart from how it is shown.
struct StatisticsRow {
    enum class Section : std::uint8_t { Displacement, Size, Surface, Edges, Faces, Topology };
    enum class Kind : std::uint8_t { Count, Quantity, Percent, YesNo };
    /// Original and deformed side by side; only one value, of the deformed; or one that no hit changes.
    enum class Sides : std::uint8_t { Both, Deformed, Same };
    /// The two sides of a measurement, so that a row needs one function for both.
    struct Sheet {
        const MeshMeasurement& all;
        const SurfaceMeasures& measures;
    };

    Section section = Section::Displacement;
    const char* key;      ///< "edge_length_mean", for files; never translated
    const char* name;     ///< to be translated in the context hitscope::StatisticsRow
    const char* unit;     ///< "m", "m²", …; empty: a plain number
    const char* meaning;  ///< what is counted or measured, one or two sentences; likewise
    Kind kind = Kind::Quantity;
    Sides sides = Sides::Both;
    /// Nothing: there is no such number, and whyNot() says why.
    std::optional<double> (*value)(const Sheet&);
};

/// All of them, section by section.
[[nodiscard]] std::span<const StatisticsRow> statisticsRows();
/// With the unit that the section's lengths are in: "Displacement (m)".
[[nodiscard]] QString sectionName(StatisticsRow::Section section);
/// With its unit, unless the section has named it: "Area (m²)", "Largest".
[[nodiscard]] QString propertyName(const StatisticsRow& row);

/// The row of that key; it exists.
[[nodiscard]] const StatisticsRow& statisticsRow(const char* key);

enum class StatisticsSide : std::uint8_t { Original, Deformed, Change };
/// Nothing: the row has no such value.
[[nodiscard]] std::optional<double> statisticsValue(const StatisticsRow& row, const MeshMeasurement& all,
                                                    StatisticsSide side);
/// "1,234", "0.30000", "12.5", "yes"; for Change with its sign. Empty where there is no value and need not be
/// one; a word or two ("open") where there could be one: whyNot() has the sentence. `locale`: of numbers.
[[nodiscard]] QString statisticsText(const StatisticsRow& row, const MeshMeasurement& all,
                                     StatisticsSide side, const QLocale& locale = shownLocale());
/// Why a row that could have a value has none: "Not watertight: 24 boundary edges." Empty: it has one.
[[nodiscard]] QString whyNot(const StatisticsRow& row, const MeshMeasurement& all);

}  // namespace hitscope
