// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/hit_pieces.h"

#include <algorithm>
#include <utility>

namespace hitscope {

namespace {

constexpr std::size_t kLongest = 1024;

}  // namespace

HitPieces::HitPieces(std::vector<Hit> hits) {
    splice(0, 0, hits);
}

void HitPieces::splice(std::size_t at, std::size_t remove, std::span<const Hit> insert) {
    m_size = m_size - remove + insert.size();
    std::size_t piece = 0;
    while (piece < m_pieces.size() && at >= m_pieces[piece].size()) {
        at -= m_pieces[piece++].size();
    }
    if (piece == m_pieces.size() && piece > 0) {  // at the very end: that of the last one
        at += m_pieces[--piece].size();
    }
    // What stays of the pieces concerned, with the new hits between, becomes pieces again.
    Piece changed;
    std::size_t last = piece;
    if (piece < m_pieces.size()) {
        Piece& first = m_pieces[piece];
        changed.assign(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(at));
    }
    changed.insert(changed.end(), insert.begin(), insert.end());
    for (std::size_t skip = at + remove; last < m_pieces.size(); ++last) {
        const Piece& rest = m_pieces[last];
        if (skip <= rest.size()) {
            changed.insert(changed.end(), rest.begin() + static_cast<std::ptrdiff_t>(skip), rest.end());
            ++last;
            break;
        }
        skip -= rest.size();
    }
    std::vector<Piece> pieces;
    for (std::size_t begin = 0; begin < changed.size(); begin += kLongest) {
        const auto from = changed.begin() + static_cast<std::ptrdiff_t>(begin);
        const std::size_t count = std::min(kLongest, changed.size() - begin);
        pieces.emplace_back(from, from + static_cast<std::ptrdiff_t>(count));
    }
    const auto where = m_pieces.erase(m_pieces.begin() + static_cast<std::ptrdiff_t>(piece),
                                      m_pieces.begin() + static_cast<std::ptrdiff_t>(last));
    m_pieces.insert(where, std::make_move_iterator(pieces.begin()), std::make_move_iterator(pieces.end()));
}

std::vector<Hit> HitPieces::take() {
    std::vector<Hit> hits;
    hits.reserve(std::exchange(m_size, 0));
    for (const Piece& piece : std::exchange(m_pieces, {})) {
        hits.insert(hits.end(), piece.begin(), piece.end());
    }
    return hits;
}

}  // namespace hitscope
