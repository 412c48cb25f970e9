// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <string_view>

namespace hitscope {

/// Text that grows and is used again, without zeros written to it first: for what is written by pointers.
class TextBuffer {
public:
    /// Where the text ends, with room for so many bytes more; until the next call.
    [[nodiscard]] char* room(std::size_t bytes) {
        if (bytes > m_capacity - m_size) {
            grow(bytes);
        }
        return m_bytes.get() + m_size;
    }
    /// After writing behind room().
    void endAt(const char* end) { m_size = static_cast<std::size_t>(end - m_bytes.get()); }
    void append(std::string_view text) {
        std::copy(text.begin(), text.end(), room(text.size()));
        m_size += text.size();
    }
    void clear() { m_size = 0; }
    [[nodiscard]] std::string_view text() const { return {m_bytes.get(), m_size}; }

private:
    void grow(std::size_t bytes) {
        constexpr std::size_t kFirst = 4096;
        const std::size_t capacity = std::max({kFirst, m_size + bytes, 2 * m_capacity});
        auto larger = std::make_unique_for_overwrite<char[]>(capacity);
        if (m_size > 0) {
            std::memcpy(larger.get(), m_bytes.get(), m_size);
        }
        m_bytes = std::move(larger);
        m_capacity = capacity;
    }

    std::unique_ptr<char[]> m_bytes;
    std::size_t m_size = 0;
    std::size_t m_capacity = 0;
};

}  // namespace hitscope
