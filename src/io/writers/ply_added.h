// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "io/writers/file_positions.h"
#include "io/writers/ply_pieces.h"

namespace hitscope {

/// The properties that an export adds to each vertex.
class PlyAdded {
public:
    /// All outlive this. `taken`: names that the vertices have already; those of ours get a number then.
    PlyAdded(const MeshExport& what, const PlyOptions& options, const std::vector<PlyProperty>& taken = {})
        : m_what(what), m_positions(what), m_options(options) {
        const auto add = [this, &taken](const char* name, PlyType type) {
            std::string free = name;
            for (int n = 2; isTaken(free, taken); ++n) {
                free = name + std::string("_") + std::to_string(n);
            }
            m_isRenamed = m_isRenamed || free != name;
            m_properties.push_back({free, type, false, PlyType::Uint8});
        };
        if (options.displacement) {
            add("dx", PlyType::Float32);
            add("dy", PlyType::Float32);
            add("dz", PlyType::Float32);
        }
        if (options.length) {
            add("displacement", PlyType::Float32);
        }
        if (hasHits()) {
            add("hits", PlyType::Uint32);
        }
        if (!what.mesh->isAsRead()) {
            add("new", PlyType::Uint8);            // 1: no vertex of the source
            add("source_vertex", PlyType::Int32);  // its number there, from 0; -1: none
        }
    }

    [[nodiscard]] const std::vector<PlyProperty>& properties() const { return m_properties; }
    [[nodiscard]] bool isRenamed() const { return m_isRenamed; }
    void append(std::string& text, const PlyValues& values, std::size_t vertex) const {
        const glm::dvec3 moved = m_positions.displacement(vertex);
        for (int i = 0; m_options.displacement && i < 3; ++i) {
            values.append(text, PlyType::Float32, moved[i]);
        }
        if (m_options.length) {
            values.append(text, PlyType::Float32, glm::length(moved));
        }
        if (hasHits()) {
            values.append(text, PlyType::Uint32, m_what.hits[vertex]);
        }
        if (const MeshData& mesh = *m_what.mesh; !mesh.isAsRead()) {
            values.append(text, PlyType::Uint8, mesh.isNew(vertex) ? 1.0 : 0.0);
            values.append(text, PlyType::Int32,
                          mesh.isNew(vertex) ? -1.0 : static_cast<double>(mesh.sourceVertices[vertex]));
        }
    }

private:
    [[nodiscard]] bool hasHits() const { return m_options.hits && !m_what.hits.empty(); }
    static bool isTaken(const std::string& name, const std::vector<PlyProperty>& taken) {
        for (const PlyProperty& property : taken) {
            if (property.name == name) {
                return true;
            }
        }
        return false;
    }

    const MeshExport& m_what;
    FilePositions m_positions;
    const PlyOptions& m_options;
    std::vector<PlyProperty> m_properties;
    bool m_isRenamed = false;
};

/// "property float dx"
[[nodiscard]] inline std::string plyLine(const PlyProperty& property) {
    static constexpr const char* kNames[] = {"char", "uchar", "short", "ushort",
                                             "int",  "uint",  "float", "double"};
    return std::string("property ") + kNames[static_cast<std::size_t>(property.type)] + ' ' + property.name;
}

}  // namespace hitscope
