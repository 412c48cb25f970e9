// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace hitscope {

struct JsonMember;

/// A value in a JSON text that has passed checkJson(). Holds its place alone: numbers are read from their own
/// characters, so that no bit of them gets lost, and a text of any size takes no memory.
class JsonValue {
public:
    enum class Kind : std::uint8_t { Object, Array, Text, Number, True, False, Null };

    /// `text` outlives this.
    JsonValue(std::string_view text, std::size_t at) : m_text(text), m_at(at) {}

    [[nodiscard]] Kind kind() const;
    [[nodiscard]] std::size_t offset() const { return m_at; }  ///< of its first character in the text
    [[nodiscard]] std::string_view characters() const;         ///< all of it, as it stands there
    [[nodiscard]] std::string text() const;                    ///< of a Text; UTF-8
    /// Of an Object, in the text's order; replaces what is in `members`. At most kMostMembers, or an error.
    [[nodiscard]] Status members(std::vector<JsonMember>& members) const;
    /// Of an Array: the first, and after `value` the next. Nothing: there is none.
    [[nodiscard]] std::optional<JsonValue> first() const;
    [[nodiscard]] std::optional<JsonValue> next() const;  ///< of a value in an Array

    static constexpr std::size_t kMostMembers = 200;

private:
    std::string_view m_text;
    std::size_t m_at;
};

struct JsonMember {
    std::string_view key;  ///< as it stands between its quotes
    JsonValue value;
};

/// That the whole text is one value of RFC 8259, in UTF-8, and at most kDeepestJson brackets deep; gives it.
/// The error's place is the line.
[[nodiscard]] Result<JsonValue> checkJson(std::string_view text);
inline constexpr int kDeepestJson = 64;

/// Whether a JsonMember's key is `name`.
[[nodiscard]] bool isKey(std::string_view key, std::string_view name);

/// The number of the line that has that byte, from 1.
[[nodiscard]] std::size_t lineAt(std::string_view text, std::size_t offset);

}  // namespace hitscope
