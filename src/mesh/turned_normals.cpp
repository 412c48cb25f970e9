// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/turned_normals.h"

#include <algorithm>

namespace hitscope {

void TurnedNormals::makeOwn(std::size_t vertex) {
    const std::size_t number = vertex / kPiece;
    m_pieces.resize((size() + kPiece - 1) / kPiece);
    std::shared_ptr<Piece>& piece = m_pieces[number];
    if (!piece) {
        piece = std::make_shared<Piece>();
        const std::size_t first = number * kPiece;
        for (std::size_t i = 0; i < std::min(kPiece, size() - first); ++i) {
            (*piece)[i] = m_mesh->vertices[first + i].normal;
        }
    } else if (piece.use_count() > 1) {
        piece = std::make_shared<Piece>(*piece);
    } else {
        // Another thread may have read them last: use_count() alone does not order its reads before our
        // writes. One more owner that goes does, as its decrement acquires what the other's released. (The
        // thread sanitizer does not know fences.)
        std::shared_ptr<Piece>(piece).reset();
    }
}

std::vector<glm::vec3> TurnedNormals::some(std::size_t first, std::size_t count) const {
    std::vector<glm::vec3> normals;
    normals.reserve(count);
    for (std::size_t vertex = first; vertex < first + count; ++vertex) {
        normals.push_back((*this)[vertex]);
    }
    return normals;
}

}  // namespace hitscope
