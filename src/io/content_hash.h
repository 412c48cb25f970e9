// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace hitscope {

/// Tells contents of files apart, quickly: as good as certain against accidents, none against an attacker.
/// It is XXH3 over the XXH3 of each piece of kHashedPiece bytes, so that pieces may be read one at a time.
class ContentHasher {
public:
    static constexpr std::size_t kHashedPiece = 1 << 20;

    /// The next piece, of kHashedPiece bytes; the last one may be shorter.
    void add(std::string_view piece);
    /// Of all pieces; never 0, which stands for "not known".
    [[nodiscard]] std::uint64_t hash() const { return ofPieces(m_pieces); }

    /// The two steps alone, for pieces that are read at once.
    [[nodiscard]] static std::uint64_t ofPiece(std::string_view piece);
    [[nodiscard]] static std::uint64_t ofPieces(const std::vector<std::uint64_t>& pieces);

private:
    std::vector<std::uint64_t> m_pieces;
};

[[nodiscard]] std::uint64_t contentHash(std::string_view content);

}  // namespace hitscope
