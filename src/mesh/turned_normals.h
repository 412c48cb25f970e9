// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "mesh/render_mesh.h"

namespace hitscope {

/// One normal a render vertex: the render mesh's own, but for those that were changed. They are kept in
/// pieces, so that the first dent of a large mesh takes time and memory for what it changes. Copies share the
/// pieces until one of them changes one; each may be read and changed by a thread of its own.
class TurnedNormals {
public:
    explicit TurnedNormals(std::shared_ptr<const RenderMesh> mesh) : m_mesh(std::move(mesh)) {}

    [[nodiscard]] std::size_t size() const { return m_mesh->vertices.size(); }
    [[nodiscard]] const glm::vec3& operator[](std::size_t vertex) const {
        const std::size_t piece = vertex / kPiece;
        return piece < m_pieces.size() && m_pieces[piece] ? (*m_pieces[piece])[vertex % kPiece]
                                                          : m_mesh->vertices[vertex].normal;
    }
    /// set() may be called for the vertex from now on, by several threads for different ones, until this is
    /// copied or reset.
    void makeOwn(std::size_t vertex);
    void set(std::size_t vertex, const glm::vec3& normal) {
        (*m_pieces[vertex / kPiece])[vertex % kPiece] = normal;
    }
    void reset() { m_pieces.clear(); }

    /// Of vertices [first, first + count).
    [[nodiscard]] std::vector<glm::vec3> some(std::size_t first, std::size_t count) const;
    [[nodiscard]] std::vector<glm::vec3> all() const { return some(0, size()); }

private:
    static constexpr std::size_t kPiece = 256;  // normals: 3 KiB
    using Piece = std::array<glm::vec3, kPiece>;

    std::shared_ptr<const RenderMesh> m_mesh;
    std::vector<std::shared_ptr<Piece>> m_pieces;  ///< null: as the render mesh has them; empty: all are
};

}  // namespace hitscope
