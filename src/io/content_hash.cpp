// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/content_hash.h"

#define XXH_INLINE_ALL  // no library to link
#include <xxhash.h>

#include <algorithm>

namespace hitscope {

void ContentHasher::add(std::string_view piece) {
    m_pieces.push_back(ofPiece(piece));
}

std::uint64_t ContentHasher::ofPiece(std::string_view piece) {
    return XXH3_64bits(piece.data(), piece.size());
}

std::uint64_t ContentHasher::ofPieces(const std::vector<std::uint64_t>& pieces) {
    return std::max<std::uint64_t>(XXH3_64bits(pieces.data(), pieces.size() * sizeof(std::uint64_t)), 1);
}

std::uint64_t contentHash(std::string_view content) {
    ContentHasher hasher;
    while (!content.empty()) {
        const std::string_view piece = content.substr(0, ContentHasher::kHashedPiece);
        hasher.add(piece);
        content.remove_prefix(piece.size());
    }
    return hasher.hash();
}

}  // namespace hitscope
