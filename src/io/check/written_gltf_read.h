// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace hitscope {

/// Thrown by readPrimitives(): what differs from a file of ours.
struct Difference {
    std::string what;
};

/// A primitive as it is in the file.
struct ReadPrimitive {
    std::vector<std::uint32_t> indices;
    std::vector<float> positions;            ///< 3 a vertex
    std::vector<float> fileVertices;         ///< empty: there are too many to be numbered
    std::vector<std::vector<float>> morphs;  ///< one a target, 3 a vertex
    std::vector<float> normals;              ///< 3 a vertex, or empty
    std::vector<float> turns;                ///< of them, by "Deformed"; 3 a vertex, or empty
    std::vector<float> texcoords;            ///< 2 a vertex, or empty
    int material = -1;
    int mode = -1;           ///< glTF's
    std::size_t object = 0;  ///< node that it is of
    std::size_t next = 0;    ///< index to be held against the mesh
};

/// Those of all nodes of a glTF or GLB file, in their order. told: with how much is read, [0, 1]; may be
/// empty. Throws GivenUp where the thread's GiveUpScope says so.
[[nodiscard]] std::vector<ReadPrimitive> readPrimitives(const QString& path,
                                                        const std::function<void(double)>& told);

}  // namespace hitscope
