// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/result.h"
#include "mesh/mesh_data.h"
#include "mesh/refine/mesh_region.h"

namespace hitscope {

/// Called now and then with how much is done, [0, 1]; false gives the work up. May be empty.
using MeshGoOn = std::function<bool(double)>;

enum class RefineMethod : std::uint8_t {
    /// Each edge that is too long gets a vertex in its middle, pass by pass: a triangle with three such edges
    /// becomes four. The shape stays.
    Midpoint,
    /// The longest edge of all is cut in two until none is too long, with the triangles at it: few slivers,
    /// and the shape stays (Rivara; OpenMesh's LongestEdgeT).
    LongestEdge,
    /// Every triangle of the region becomes four until no edge is too long, and new vertices stand where a
    /// smooth surface through the old ones has them (Zorin, Schröder, Sweldens: Interpolating subdivision for
    /// meshes with arbitrary topology, 1996; OpenMesh's ModifiedButterflyT).
    Butterfly,
};

struct RefineOptions {
    RefineMethod method = RefineMethod::Midpoint;
    float edgeLength = 0.1f;  ///< metres, > 0: no edge in the region is longer afterwards
    /// Midpoint: quads become quads, and all edges of a strip of quads are cut where one of them is. Else
    /// polygons with an edge or a diagonal that is too long are cut into triangles first.
    bool keepQuads = false;
    MeshRegion region;

    bool operator==(const RefineOptions&) const = default;
};

/// More faces are not made: millions take gigabytes to draw.
inline constexpr std::size_t kMostRefinedFaces = 10'000'000;

/// A mesh with more vertices than it had.
struct RefinedMesh {
    MeshData mesh;
    std::size_t firstNew = 0;  ///< vertices from here on are new; those before are as they were, in every bit
    /// One a new vertex: the vertices that it stands between, two ends of an edge or four corners of a quad
    /// (kNoIndex: no more). They may be new themselves, but come before it.
    std::vector<std::array<std::uint32_t, 4>> parents;
};

/// Refines the faces of a region, and cuts those beside it where they share an edge, so that there is no
/// vertex on the side of a face: not between faces that have vertices of their own at the same places either.
/// Works on any mesh that has passed validate(): open, non-manifold, of polygons. The mesh's own vertices
/// keep numbers and positions; colours, normals and texture coordinates of new ones are between those of
/// their parents; materials, groups and smoothing of a face are its parts'. The same in every bit on any
/// number of processors. Errors: no usable edge length, more than mostFaces, given up.
[[nodiscard]] Result<RefinedMesh> refine(const MeshData& mesh, const RefineOptions& options,
                                         const MeshGoOn& goOn = {},
                                         std::size_t mostFaces = kMostRefinedFaces);

}  // namespace hitscope
