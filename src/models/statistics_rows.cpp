// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/statistics_rows.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <string_view>

#include "models/quantity_text.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

using Row = StatisticsRow;
using Sheet = StatisticsRow::Sheet;
using Value = std::optional<double>;

struct StatisticsRowTexts {
    Q_DECLARE_TR_FUNCTIONS(hitscope::StatisticsRow)
};

Value count(std::size_t number) {
    return static_cast<double>(number);
}

/// Least and greatest of nothing are no numbers.
Value ofSome(const Spread& spread, double value) {
    return spread.count > 0 ? Value(value) : std::nullopt;
}

std::size_t allVertices(const Sheet& sheet) {
    return sheet.all.topology.vertices;
}

template <int Axis>
Value centreOfMass(const Sheet& s) {
    const bool isSolid = s.all.topology.isSolid() && s.measures.signedVolume != 0.0;
    return isSolid ? Value(s.measures.centreOfMass()[Axis]) : std::nullopt;
}

template <int Axis>
Value boxSize(const Sheet& s) {
    return s.measures.box.size()[Axis];
}

template <int Axis>
Value boxMin(const Sheet& s) {
    return s.measures.box.empty() ? std::nullopt : Value(s.measures.box.min[Axis]);
}

template <int Axis>
Value boxMax(const Sheet& s) {
    return s.measures.box.empty() ? std::nullopt : Value(s.measures.box.max[Axis]);
}

template <class Number>
Value ofDisplacement(const Sheet& s, Number number) {
    return ofSome(s.all.displacement.length, number);
}

#define HITSCOPE_TEXT(text) QT_TRANSLATE_NOOP("hitscope::StatisticsRow", text)

constexpr auto kDisplacement = Row::Section::Displacement;
constexpr auto kSize = Row::Section::Size;
constexpr auto kSurface = Row::Section::Surface;
constexpr auto kEdges = Row::Section::Edges;
constexpr auto kFaces = Row::Section::Faces;
constexpr auto kTopology = Row::Section::Topology;
constexpr auto kCount = Row::Kind::Count;
constexpr auto kQuantity = Row::Kind::Quantity;
constexpr auto kYesNo = Row::Kind::YesNo;
constexpr auto kBoth = Row::Sides::Both;
constexpr auto kDeformed = Row::Sides::Deformed;
constexpr auto kSame = Row::Sides::Same;

constexpr const char* kBoxFrame = HITSCOPE_TEXT(
    "In the target's own frame; of all targets together, in the world. All vertices count, also "
    "those that no face uses.");
constexpr const char* kSolidMeaning = HITSCOPE_TEXT(
    "Of the enclosed solid, filled evenly. Only where the surface is watertight and its faces "
    "all look the same way.");

const Row kRows[] = {
    {kDisplacement, "changed_vertices", HITSCOPE_TEXT("Changed"), "",
     HITSCOPE_TEXT("Vertices of the file that are not where they were."), kCount, kDeformed,
     [](const Sheet& s) { return count(s.all.displacement.length.count); }},
    {kDisplacement, "changed_share", HITSCOPE_TEXT("Changed"), "%",
     HITSCOPE_TEXT("Changed vertices among all vertices of the file."), Row::Kind::Percent, kDeformed,
     [](const Sheet& s) {
         return allVertices(s) == 0 ? Value(0.0)
                                    : Value(100.0 * static_cast<double>(s.all.displacement.length.count) /
                                            static_cast<double>(allVertices(s)));
     }},
    {kDisplacement, "displacement_min", HITSCOPE_TEXT("Smallest"), "m",
     HITSCOPE_TEXT("Shortest way from the original to the current place, of the changed vertices."),
     kQuantity, kDeformed, [](const Sheet& s) { return ofDisplacement(s, s.all.displacement.length.least); }},
    {kDisplacement, "displacement_max", HITSCOPE_TEXT("Largest"), "m",
     HITSCOPE_TEXT("Longest way from the original to the current place."), kQuantity, kDeformed,
     [](const Sheet& s) { return ofDisplacement(s, s.all.displacement.length.greatest); }},
    {kDisplacement, "displacement_mean", HITSCOPE_TEXT("Mean"), "m",
     HITSCOPE_TEXT("Average of the changed vertices' displacements."), kQuantity, kDeformed,
     [](const Sheet& s) { return ofDisplacement(s, s.all.displacement.length.mean()); }},
    {kDisplacement, "displacement_median", HITSCOPE_TEXT("Median"), "m",
     HITSCOPE_TEXT("Half of the changed vertices moved less, half more."), kQuantity, kDeformed,
     [](const Sheet& s) { return ofDisplacement(s, s.all.displacement.median); }},
    {kDisplacement, "displacement_rms", HITSCOPE_TEXT("RMS"), "m",
     HITSCOPE_TEXT("Root of the mean square of the changed vertices' displacements."), kQuantity, kDeformed,
     [](const Sheet& s) { return ofDisplacement(s, s.all.displacement.rootMeanSquare); }},
    {kDisplacement, "displacement_deviation", HITSCOPE_TEXT("Std deviation"), "m",
     HITSCOPE_TEXT("Standard deviation of the changed vertices' displacements about their mean."), kQuantity,
     kDeformed, [](const Sheet& s) { return ofDisplacement(s, s.all.displacement.standardDeviation); }},

    {kSize, "box_size_x", HITSCOPE_TEXT("Size x"), "m", kBoxFrame, kQuantity, kBoth, boxSize<0>},
    {kSize, "box_size_y", HITSCOPE_TEXT("Size y"), "m", kBoxFrame, kQuantity, kBoth, boxSize<1>},
    {kSize, "box_size_z", HITSCOPE_TEXT("Size z"), "m", kBoxFrame, kQuantity, kBoth, boxSize<2>},
    {kSize, "box_diagonal", HITSCOPE_TEXT("Diagonal"), "m", kBoxFrame, kQuantity, kBoth,
     [](const Sheet& s) { return Value(glm::length(s.measures.box.size())); }},
    {kSize, "box_min_x", HITSCOPE_TEXT("Min x"), "m", kBoxFrame, kQuantity, kBoth, boxMin<0>},
    {kSize, "box_min_y", HITSCOPE_TEXT("Min y"), "m", kBoxFrame, kQuantity, kBoth, boxMin<1>},
    {kSize, "box_min_z", HITSCOPE_TEXT("Min z"), "m", kBoxFrame, kQuantity, kBoth, boxMin<2>},
    {kSize, "box_max_x", HITSCOPE_TEXT("Max x"), "m", kBoxFrame, kQuantity, kBoth, boxMax<0>},
    {kSize, "box_max_y", HITSCOPE_TEXT("Max y"), "m", kBoxFrame, kQuantity, kBoth, boxMax<1>},
    {kSize, "box_max_z", HITSCOPE_TEXT("Max z"), "m", kBoxFrame, kQuantity, kBoth, boxMax<2>},

    {kSurface, "surface_area", HITSCOPE_TEXT("Area"), "m²", HITSCOPE_TEXT("Sum of the faces' areas."),
     kQuantity, kBoth, [](const Sheet& s) { return Value(s.measures.faceArea.sum); }},
    {kSurface, "volume", HITSCOPE_TEXT("Volume"), "m³", kSolidMeaning, kQuantity, kBoth,
     [](const Sheet& s) { return s.all.topology.isSolid() ? Value(s.measures.volume()) : std::nullopt; }},
    {kSurface, "centre_of_mass_x", HITSCOPE_TEXT("Centre x"), "m", kSolidMeaning, kQuantity, kBoth,
     centreOfMass<0>},
    {kSurface, "centre_of_mass_y", HITSCOPE_TEXT("Centre y"), "m", kSolidMeaning, kQuantity, kBoth,
     centreOfMass<1>},
    {kSurface, "centre_of_mass_z", HITSCOPE_TEXT("Centre z"), "m", kSolidMeaning, kQuantity, kBoth,
     centreOfMass<2>},

    {kEdges, "edge_length_total", HITSCOPE_TEXT("Total"), "m",
     HITSCOPE_TEXT("Sum of the lengths of all edges, each once."), kQuantity, kBoth,
     [](const Sheet& s) { return Value(s.measures.edgeLength.sum); }},
    {kEdges, "edge_length_mean", HITSCOPE_TEXT("Mean"), "m", HITSCOPE_TEXT("Average length of an edge."),
     kQuantity, kBoth,
     [](const Sheet& s) { return ofSome(s.measures.edgeLength, s.measures.edgeLength.mean()); }},
    {kEdges, "edge_length_min", HITSCOPE_TEXT("Shortest"), "m", HITSCOPE_TEXT("Length of the shortest edge."),
     kQuantity, kBoth,
     [](const Sheet& s) { return ofSome(s.measures.edgeLength, s.measures.edgeLength.least); }},
    {kEdges, "edge_length_max", HITSCOPE_TEXT("Longest"), "m", HITSCOPE_TEXT("Length of the longest edge."),
     kQuantity, kBoth,
     [](const Sheet& s) { return ofSome(s.measures.edgeLength, s.measures.edgeLength.greatest); }},

    {kFaces, "face_area_min", HITSCOPE_TEXT("Smallest"), "m²", HITSCOPE_TEXT("Area of the smallest face."),
     kQuantity, kBoth, [](const Sheet& s) { return ofSome(s.measures.faceArea, s.measures.faceArea.least); }},
    {kFaces, "face_area_max", HITSCOPE_TEXT("Largest"), "m²", HITSCOPE_TEXT("Area of the largest face."),
     kQuantity, kBoth,
     [](const Sheet& s) { return ofSome(s.measures.faceArea, s.measures.faceArea.greatest); }},
    {kFaces, "aspect_min", HITSCOPE_TEXT("Best aspect"), "",
     HITSCOPE_TEXT(
         "Of the best shaped face: longest edge times perimeter over area, scaled so that a regular "
         "polygon has 1. Degenerate faces do not count."),
     kQuantity, kBoth, [](const Sheet& s) { return ofSome(s.measures.aspect, s.measures.aspect.least); }},
    {kFaces, "aspect_max", HITSCOPE_TEXT("Worst aspect"), "",
     HITSCOPE_TEXT("Of the worst shaped face: longest edge times perimeter over area, scaled so that a "
                   "regular polygon has 1. Degenerate faces do not count."),
     kQuantity, kBoth, [](const Sheet& s) { return ofSome(s.measures.aspect, s.measures.aspect.greatest); }},
    {kFaces, "degenerate_faces", HITSCOPE_TEXT("Degenerate"), "",
     HITSCOPE_TEXT("Faces without area, or no wider than a millionth of their length."), kCount, kBoth,
     [](const Sheet& s) { return count(s.measures.degenerateFaces); }},
    {kFaces, "flipped_faces", HITSCOPE_TEXT("Flipped"), "",
     HITSCOPE_TEXT("Faces that look the other way than they did in the original."), kCount, kBoth,
     [](const Sheet& s) { return count(s.measures.flippedFaces); }},

    {kTopology, "vertices", HITSCOPE_TEXT("Vertices"), "", HITSCOPE_TEXT("As the file has them."), kCount,
     kSame, [](const Sheet& s) { return count(s.all.topology.vertices); }},
    {kTopology, "unreferenced_vertices", HITSCOPE_TEXT("Unreferenced"), "",
     HITSCOPE_TEXT("Vertices that no face uses. They are not drawn; hits move them as all others."), kCount,
     kSame, [](const Sheet& s) { return count(s.all.topology.unreferencedVertices); }},
    {kTopology, "places", HITSCOPE_TEXT("Places"), "",
     HITSCOPE_TEXT("Vertices that faces use, those at the very same place counted once: files split vertices "
                   "along seams, but the surface hangs together there. What follows is of this surface."),
     kCount, kSame, [](const Sheet& s) { return count(s.all.topology.places); }},
    {kTopology, "edges", HITSCOPE_TEXT("Edges"), "",
     HITSCOPE_TEXT("Sides of faces, shared ones counted once."), kCount, kSame,
     [](const Sheet& s) { return count(s.all.topology.edges); }},
    {kTopology, "faces", HITSCOPE_TEXT("Faces"), "", HITSCOPE_TEXT("As the file has them."), kCount, kSame,
     [](const Sheet& s) { return count(s.all.topology.faces); }},
    {kTopology, "triangles", HITSCOPE_TEXT("Triangles"), "", HITSCOPE_TEXT("Faces with three corners."),
     kCount, kSame, [](const Sheet& s) { return count(s.all.topology.triangles); }},
    {kTopology, "quads", HITSCOPE_TEXT("Quads"), "", HITSCOPE_TEXT("Faces with four corners."), kCount, kSame,
     [](const Sheet& s) { return count(s.all.topology.quads); }},
    {kTopology, "larger_polygons", HITSCOPE_TEXT("Larger polygons"), "",
     HITSCOPE_TEXT("Faces with five corners or more."), kCount, kSame,
     [](const Sheet& s) { return count(s.all.topology.largerPolygons); }},
    {kTopology, "components", HITSCOPE_TEXT("Components"), "",
     HITSCOPE_TEXT("Parts of the surface that share no edge with one another."), kCount, kSame,
     [](const Sheet& s) { return count(s.all.topology.components); }},
    {kTopology, "boundary_edges", HITSCOPE_TEXT("Boundary edges"), "",
     HITSCOPE_TEXT("Edges that belong to one face only."), kCount, kSame,
     [](const Sheet& s) { return count(s.all.topology.boundaryEdges); }},
    {kTopology, "holes", HITSCOPE_TEXT("Holes"), "",
     HITSCOPE_TEXT("Closed lines of boundary edges; the rim of an open surface is one."), kCount, kSame,
     [](const Sheet& s) { return count(s.all.topology.holes); }},
    {kTopology, "non_manifold_edges", HITSCOPE_TEXT("Non-man. edges"), "",
     HITSCOPE_TEXT("Edges that three faces or more share."), kCount, kSame,
     [](const Sheet& s) { return count(s.all.topology.nonManifoldEdges); }},
    {kTopology, "non_manifold_vertices", HITSCOPE_TEXT("Non-man. verts"), "",
     HITSCOPE_TEXT("Places where parts of the surface meet in a point only. The ends of non-manifold edges "
                   "are not counted again."),
     kCount, kSame, [](const Sheet& s) { return count(s.all.topology.nonManifoldVertices); }},
    {kTopology, "opposed_edges", HITSCOPE_TEXT("Opposed edges"), "",
     HITSCOPE_TEXT("Edges whose two faces look to different sides: one of them is turned over."), kCount,
     kSame, [](const Sheet& s) { return count(s.all.topology.opposedEdges); }},
    {kTopology, "collapsed_faces", HITSCOPE_TEXT("Collapsed"), "",
     HITSCOPE_TEXT("Faces with fewer than three corners at different places, or that pass one place twice. "
                   "They are no part of the surface."),
     kCount, kSame, [](const Sheet& s) { return count(s.all.topology.collapsedFaces); }},
    {kTopology, "refused_faces", HITSCOPE_TEXT("Not half-edge"), "",
     HITSCOPE_TEXT("Faces that a half-edge structure (OpenMesh) cannot hold, of the vertices as the file has "
                   "them: they share an edge or a vertex with too many others, or are turned over."),
     kCount, kSame, [](const Sheet& s) { return count(s.all.refusedFaces); }},
    {kTopology, "euler_characteristic", HITSCOPE_TEXT("Euler number"), "",
     HITSCOPE_TEXT("Euler characteristic: different places less edges plus faces."), kCount, kSame,
     [](const Sheet& s) { return Value(static_cast<double>(s.all.topology.eulerCharacteristic)); }},
    {kTopology, "genus", HITSCOPE_TEXT("Genus"), "",
     HITSCOPE_TEXT("Handles, all components together: 0 for a sphere, 1 for a torus. Only of a manifold "
                   "surface with two sides."),
     kCount, kSame,
     [](const Sheet& s) {
         return s.all.topology.genus ? Value(static_cast<double>(*s.all.topology.genus)) : std::nullopt;
     }},
    {kTopology, "watertight", HITSCOPE_TEXT("Watertight"), "",
     HITSCOPE_TEXT("Manifold and without boundary: it has an inside."), kYesNo, kSame,
     [](const Sheet& s) { return Value(s.all.topology.watertight ? 1.0 : 0.0); }},
};

#undef HITSCOPE_TEXT

/// In a word or two, for a narrow column, and as a sentence.
struct Reason {
    QString word;
    QString sentence;
};

Reason reasonFor(const Row& row, const SurfaceStatistics& topology) {
    const bool isGenus = std::string_view(row.key) == "genus";
    if (topology.faces == topology.collapsedFaces) {
        return {QStringLiteral("–"), StatisticsRowTexts::tr("There are no faces.")};
    }
    const bool isOpen = !isGenus && topology.boundaryEdges > 0;
    if (!topology.isManifold()) {
        return {
            isOpen ? StatisticsRowTexts::tr("open") : StatisticsRowTexts::tr("n/a"),
            (isGenus ? StatisticsRowTexts::tr("Not defined: the surface is not manifold (%1, %2).")
                     : StatisticsRowTexts::tr("Not watertight: the surface is not manifold (%1, %2)."))
                .arg(StatisticsRowTexts::tr("%Ln {edge|edges}", nullptr, trCount(topology.nonManifoldEdges)),
                     StatisticsRowTexts::tr("%Ln {vertex|vertices}", nullptr,
                                            trCount(topology.nonManifoldVertices)))};
    }
    if (isGenus) {
        return {StatisticsRowTexts::tr("one-sided"),
                StatisticsRowTexts::tr("Not defined: the surface is not orientable.")};
    }
    if (isOpen) {
        return {StatisticsRowTexts::tr("open"),
                StatisticsRowTexts::tr("Not watertight: %Ln boundary {edge|edges}.", nullptr,
                                       trCount(topology.boundaryEdges))};
    }
    if (topology.opposedEdges > 0) {
        return {StatisticsRowTexts::tr("n/a"),
                StatisticsRowTexts::tr("The orientation of the faces is inconsistent: %Ln {edge joins|edges "
                                       "join} faces of opposite orientation.",
                                       nullptr, trCount(topology.opposedEdges))};
    }
    return {QStringLiteral("–"), StatisticsRowTexts::tr("The volume is zero.")};
}

bool mayBeMissing(const Row& row) {
    const std::string_view key(row.key);
    return key == "volume" || key == "genus" || key.starts_with("centre_of_mass");
}

/// A change in fewer digits, as it is read against the numbers beside it: eight characters with its sign,
/// which is what the column holds.
QString changeText(const QLocale& locale, double value) {
    constexpr int kDigits = 3;
    constexpr int kDecimals = 5;
    constexpr int kLeast = -4;
    constexpr int kMost = 6;
    const double size = std::abs(value);
    const int magnitude =
        size > 0.0 && std::isfinite(size) ? static_cast<int>(std::floor(std::log10(size))) : 0;
    if (magnitude < kLeast || magnitude > kMost) {
        return shownNumber(locale, value, 'e', 1);
    }
    return size > 0.0 ? shownNumber(locale, value, 'f', std::clamp(kDigits - 1 - magnitude, 0, kDecimals))
                      : QStringLiteral("0");
}

QString numberText(const QLocale& locale, const Row& row, double value) {
    switch (row.kind) {
        case Row::Kind::Count:
            return (value < 0.0 ? QStringLiteral("-") : QString()) +
                   locale.toString(static_cast<qulonglong>(std::abs(value)));
        case Row::Kind::Percent:
            return shownNumber(locale, value, 'f', 2);
        case Row::Kind::YesNo:
            return value != 0.0 ? StatisticsRowTexts::tr("yes") : StatisticsRowTexts::tr("no");
        case Row::Kind::Quantity:
            return quantityText(locale, value);
    }
    return {};
}

}  // namespace

std::span<const StatisticsRow> statisticsRows() {
    return kRows;
}

const StatisticsRow& statisticsRow(const char* key) {
    return *std::find_if(std::begin(kRows), std::end(kRows),
                         [key](const Row& row) { return std::string_view(row.key) == key; });
}

QString propertyName(const StatisticsRow& row) {
    const bool isSaid = row.section == kDisplacement || row.section == kSize || row.section == kEdges;
    const QString unit = QString::fromUtf8(row.unit);
    return unit.isEmpty() || (isSaid && unit == QLatin1String("m"))
               ? StatisticsRowTexts::tr(row.name)
               : QStringLiteral("%1 (%2)").arg(StatisticsRowTexts::tr(row.name), unit);
}

QString sectionName(StatisticsRow::Section section) {
    switch (section) {
        case Row::Section::Displacement:
            return StatisticsRowTexts::tr("Displacement (m)");
        case Row::Section::Size:
            return StatisticsRowTexts::tr("Bounding box (m)");
        case Row::Section::Surface:
            return StatisticsRowTexts::tr("Surface and volume");
        case Row::Section::Edges:
            return StatisticsRowTexts::tr("Edge lengths (m)");
        case Row::Section::Faces:
            return StatisticsRowTexts::tr("Faces");
        case Row::Section::Topology:
            return StatisticsRowTexts::tr("Topology");
    }
    return {};
}

std::optional<double> statisticsValue(const StatisticsRow& row, const MeshMeasurement& all,
                                      StatisticsSide side) {
    if (side == StatisticsSide::Original) {
        return row.sides == Row::Sides::Deformed ? std::nullopt : row.value({all, all.original});
    }
    if (side == StatisticsSide::Deformed) {
        return row.value({all, all.deformed});
    }
    if (row.sides != Row::Sides::Both) {
        return {};
    }
    const Value before = row.value({all, all.original});
    const Value after = row.value({all, all.deformed});
    return before && after ? Value(*after - *before) : std::nullopt;
}

QString statisticsText(const StatisticsRow& row, const MeshMeasurement& all, StatisticsSide side,
                       const QLocale& locale) {
    const Value value = statisticsValue(row, all, side);
    if (value) {
        const bool isChange = side == StatisticsSide::Change && row.kind == Row::Kind::Quantity;
        const QString text = isChange ? changeText(locale, *value) : numberText(locale, row, *value);
        const bool isIncrease = side == StatisticsSide::Change && *value > 0.0;
        return isIncrease ? u'+' + text : text;
    }
    return mayBeMissing(row) && side != StatisticsSide::Change ? reasonFor(row, all.topology).word
                                                               : QString();
}

QString whyNot(const StatisticsRow& row, const MeshMeasurement& all) {
    const bool isThere = statisticsValue(row, all, StatisticsSide::Deformed).has_value();
    return mayBeMissing(row) && !isThere ? reasonFor(row, all.topology).sentence : QString();
}

}  // namespace hitscope
