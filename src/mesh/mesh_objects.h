// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/mesh_data.h"

namespace hitscope {

/// How many objects a mesh has: see MeshObjects. Looks at groups only.
[[nodiscard]] std::size_t objectCount(const MeshData& mesh);

/// The objects of a mesh, by its groups of FaceGroup::Kind::Object: each has the faces from its name on, up
/// to the next name. One that is named again at once goes on; faces before the first name are an object of
/// their own; one without faces does not count.
class MeshObjects {
public:
    /// `mesh` outlives this.
    explicit MeshObjects(const MeshData& mesh);

    [[nodiscard]] std::size_t count() const { return m_objects.size(); }
    /// What the file calls it; empty: it has no name. object < count().
    [[nodiscard]] const std::string& name(std::size_t object) const { return m_objects[object].name; }
    /// Of the mesh's vertices those it has, ascending: its faces', and those of lines and points, which go
    /// with the first object that has a face at their first vertex. The first object has also what is left.
    [[nodiscard]] const std::vector<std::uint32_t>& vertices(std::size_t object) const {
        return m_objects[object].vertices;
    }
    /// A mesh of that object alone, with the materials and pictures it uses; coordinates, and the order of
    /// vertices and faces, are the same.
    [[nodiscard]] MeshData only(std::size_t object) const;

private:
    struct Object {
        std::string name;
        std::uint32_t firstFace = 0;
        std::uint32_t endFace = 0;
        std::vector<std::uint32_t> vertices;
        std::vector<std::uint32_t> lines;  ///< by index
        std::vector<std::uint32_t> points;
    };
    void findVertices();

    const MeshData& m_mesh;
    std::vector<Object> m_objects;
};

}  // namespace hitscope
