// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface/surface_measures.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace hitscope {

void Spread::add(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
    sum += value;
    ++count;
}

void Spread::add(const Spread& other) {
    least = std::min(least, other.least);
    greatest = std::max(greatest, other.greatest);
    sum += other.sum;
    count += other.count;
}

void Box::add(const glm::dvec3& point) {
    min = glm::min(min, point);
    max = glm::max(max, point);
}

void Box::add(const Box& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
}

void SurfaceMeasures::add(const SurfaceMeasures& other) {
    box.add(other.box);
    edgeLength.add(other.edgeLength);
    faceArea.add(other.faceArea);
    aspect.add(other.aspect);
    degenerateFaces += other.degenerateFaces;
    flippedFaces += other.flippedFaces;
    signedVolume += other.signedVolume;
    volumeMoment += other.volumeMoment;
}

SurfaceMeasures SurfaceMeasures::inFile(const Placement& placement) const {
    const double length = 1.0 / placement.scale;
    const double volumes = length * length * length;
    SurfaceMeasures made = *this;
    if (!box.empty()) {
        made.box = {placement.toFile(box.min), placement.toFile(box.max)};
    }
    made.edgeLength = edgeLength.times(length);
    made.faceArea = faceArea.times(length * length);
    made.signedVolume = signedVolume * volumes;
    made.volumeMoment = volumeMoment * (volumes * length) + made.signedVolume * placement.centre;
    return made;
}

std::span<const std::uint32_t> Displacements::within(double least, double most) const {
    const auto first = std::lower_bound(lengths.begin(), lengths.end(), least,
                                        [](float length, double limit) { return double{length} < limit; });
    const auto last = std::upper_bound(first, lengths.end(), most,
                                       [](double limit, float length) { return limit < double{length}; });
    return std::span(vertices).subspan(static_cast<std::size_t>(first - lengths.begin()),
                                       static_cast<std::size_t>(last - first));
}

namespace {

/// The length of that rank, 0 for the least, of all lists together.
float atRank(std::span<const Displacements* const> lists, std::size_t rank) {
    std::vector<float> all;
    if (lists.size() == 1) {
        return lists[0]->lengths[rank];
    }
    for (const Displacements* list : lists) {
        all.insert(all.end(), list->lengths.begin(), list->lengths.end());
    }
    const auto place = all.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(all.begin(), place, all.end());
    return *place;
}

}  // namespace

Displacements::Summary summarise(std::span<const Displacements* const> lists) {
    Displacements::Summary summary;
    double squares = 0.0;
    for (const Displacements* list : lists) {
        for (const float length : list->lengths) {
            summary.length.add(double{length});
            squares += double{length} * double{length};
        }
    }
    const std::size_t count = summary.length.count;
    if (count == 0) {
        return summary;
    }
    summary.median = 0.5 * (double{atRank(lists, (count - 1) / 2)} + double{atRank(lists, count / 2)});
    summary.rootMeanSquare = std::sqrt(squares / static_cast<double>(count));
    // About the mean and not from the squares, which would cancel where all moved about alike.
    double about = 0.0;
    const double mean = summary.length.mean();
    for (const Displacements* list : lists) {
        for (const float length : list->lengths) {
            about += (double{length} - mean) * (double{length} - mean);
        }
    }
    summary.standardDeviation = std::sqrt(about / static_cast<double>(count));
    return summary;
}

Histogram histogramOf(std::span<const Displacements* const> lists, double most, std::size_t bins) {
    if (!(most > 0.0)) {
        return {};
    }
    Histogram histogram(0.0, most, bins);
    for (const Displacements* list : lists) {
        for (const float length : list->lengths) {
            histogram.add(double{length});
        }
    }
    return histogram;
}

}  // namespace hitscope
