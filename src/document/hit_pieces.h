// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "deform/hit.h"

namespace hitscope {

/// A long list of hits that is edited anywhere at the cost of a piece of it, however long it is.
class HitPieces {
public:
    explicit HitPieces(std::vector<Hit> hits);

    [[nodiscard]] std::size_t size() const { return m_size; }
    /// Hits [at, at + remove) become `insert`. at + remove <= size().
    void splice(std::size_t at, std::size_t remove, std::span<const Hit> insert);
    [[nodiscard]] std::vector<Hit> take();  ///< all of them; leaves none

private:
    using Piece = std::vector<Hit>;

    std::vector<Piece> m_pieces;  ///< none is empty, and few are longer than kLongest
    std::size_t m_size = 0;
};

}  // namespace hitscope
