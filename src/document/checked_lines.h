// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/result.h"

namespace hitscope {

/// Of a journal's line with that number, from 0: what its first 16 digits say.
[[nodiscard]] std::uint64_t lineChecksum(std::uint64_t number, std::string_view json);

/// Takes the lines of a journal one by one, as long as they are good.
class CheckedLines {
public:
    explicit CheckedLines(std::string_view text) : m_text(text) {}  ///< outlives this

    [[nodiscard]] std::size_t goodBytes() const { return m_at; }
    [[nodiscard]] bool isAtEnd() const { return m_at == m_text.size(); }
    /// The JSON of the next line.
    [[nodiscard]] Result<std::string_view> next() const;
    void keep(std::string_view json);  ///< what next() gave is good

private:
    [[nodiscard]] Error problem(const char* what) const;

    std::string_view m_text;
    std::size_t m_at = 0;
    std::uint64_t m_number = 0;
};

}  // namespace hitscope
