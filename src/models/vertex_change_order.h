// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mesh/mesh_data.h"
#include "models/vertex_changes_csv.h"

namespace hitscope {

/// A vertex as it is now. Metres, local frame; radians.
struct VertexState {
    std::uint32_t vertex = 0;
    glm::vec3 current{0.0f};
    float turned = 0.0f;     ///< of its normal
    std::uint32_t hits = 0;  ///< that moved it
};

/// Which changed vertices to show and in what order.
struct VertexQuery {
    enum class Key : std::uint8_t { Number, Original, Current, Displacement, Length, Turned, Hits };
    Key key = Key::Number;  ///< vectors by x, then y, then z; equal ones by number
    bool descending = false;
    float leastLength = 0.0f;  ///< metres: of the displacement
    /// Only these, ascending; null: all.
    std::shared_ptr<const std::vector<std::uint32_t>> only;

    bool operator==(const VertexQuery&) const = default;
};

/// The changed vertices of one target, sorted and filtered. Knows no session, so that it can be worked with
/// on any thread, one at a time; it is told what moved, and what it then costs is that, the copying of the
/// rows and, for another query, sorting them.
class VertexChangeOrder {
public:
    explicit VertexChangeOrder(std::shared_ptr<const MeshData> original);

    /// Those back at their original are no changed vertices any more.
    void take(std::span<const VertexState> moved);
    /// File vertices.
    [[nodiscard]] std::vector<std::uint32_t> rows(const VertexQuery& query);
    /// These vertices, as far as told.
    [[nodiscard]] VertexChangesTable table(std::vector<std::uint32_t> vertices) const;

private:
    [[nodiscard]] bool isShown(std::uint32_t vertex) const;
    [[nodiscard]] float keyOf(std::uint32_t vertex, int component) const;
    [[nodiscard]] bool isBefore(std::uint32_t a, std::uint32_t b) const;
    void sortAll();
    void mergeMoved();

    /// Of a vertex that was told of.
    struct Told {
        glm::vec3 current{0.0f};
        float length = 0.0f;
        float turned = 0.0f;
        std::uint32_t hits = 0;
        bool isMoved = false;  ///< in m_moved
    };
    [[nodiscard]] const Told& told(std::uint32_t vertex) const { return m_told[m_placeOf[vertex]]; }

    std::shared_ptr<const MeshData> m_original;
    std::vector<std::uint32_t> m_placeOf;  ///< vertex -> its place in m_told, or kNoIndex; empty: none was
    std::vector<Told> m_told;
    std::vector<std::uint32_t> m_listed;  ///< whose these are
    std::vector<std::uint32_t> m_moved;   ///< since m_rows was made
    VertexQuery m_query;
    std::optional<std::vector<std::uint32_t>> m_rows;  ///< the answer to m_query before m_moved
};

}  // namespace hitscope
