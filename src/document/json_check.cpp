// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/json_escapes.h"
#include "document/json_text.h"

namespace hitscope {

namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// Goes through a text once and stops where it is no JSON.
class Checker {
public:
    explicit Checker(std::string_view text) : m_text(text) {}

    Result<JsonValue> check() {
        m_at = m_text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
        skipSpace();
        const std::size_t begin = m_at;
        if (value(0)) {
            skipSpace();
            if (m_at == m_text.size()) {
                return JsonValue(m_text, begin);
            }
            fail("Something follows its end.");
        }
        return Error{m_problem, "line " + std::to_string(lineAt(m_text, m_at)),
                     "It is damaged, or was written by another program."};
    }

private:
    bool fail(std::string problem) {
        m_problem = m_at < m_text.size() ? std::move(problem) : "It ends in the middle.";
        return false;
    }
    [[nodiscard]] char here() const { return m_at < m_text.size() ? m_text[m_at] : '\0'; }
    void skipSpace() {
        while (m_at < m_text.size() && isJsonSpace(m_text[m_at])) {
            ++m_at;
        }
    }
    bool word(std::string_view word) {
        if (m_text.substr(m_at, word.size()) != word) {
            m_at = m_text.size() - m_at < word.size() ? m_text.size() : m_at;
            return fail("A value is neither number, text, list nor object.");
        }
        m_at += word.size();
        return true;
    }

    // NOLINTNEXTLINE(misc-no-recursion): no deeper than kDeepestJson
    bool value(int depth) {
        switch (here()) {
            case '{':
            case '[':
                return depth < kDeepestJson ? container(depth)
                                            : fail("There are more than " + std::to_string(kDeepestJson) +
                                                   " brackets within each other.");
            case '"':
                return text();
            case 't':
                return word("true");
            case 'f':
                return word("false");
            case 'n':
                return word("null");
            default:
                return number();
        }
    }

    // NOLINTNEXTLINE(misc-no-recursion): likewise
    bool container(int depth) {
        const bool isObject = here() == '{';
        const char end = isObject ? '}' : ']';
        ++m_at;
        skipSpace();
        if (here() == end) {
            ++m_at;
            return true;
        }
        for (;;) {
            if (isObject && !key()) {
                return false;
            }
            if (!value(depth + 1)) {
                return false;
            }
            skipSpace();
            if (here() == end) {
                ++m_at;
                return true;
            }
            if (here() != ',') {
                return fail(isObject ? "A comma or a closing brace is missing."
                                     : "A comma or a closing bracket is missing.");
            }
            ++m_at;
            skipSpace();
        }
    }

    bool key() {
        if (here() != '"') {
            return fail("The name of a value is missing.");
        }
        if (!text()) {
            return false;
        }
        skipSpace();
        if (here() != ':') {
            return fail("A colon is missing.");
        }
        ++m_at;
        skipSpace();
        return true;
    }

    bool text() {
        for (++m_at; m_at < m_text.size();) {
            const char c = m_text[m_at];
            if (c == '"') {
                ++m_at;
                return true;
            }
            if (c == '\\') {
                if (!escape()) {
                    return false;
                }
            } else if (static_cast<unsigned char>(c) < 0x20u) {
                return fail("A text has a control character, or does not end.");
            } else if (static_cast<unsigned char>(c) < 0x80u) {
                ++m_at;
            } else if (const std::size_t length = lengthOfUtf8(m_text.substr(m_at)); length > 0) {
                m_at += length;
            } else {
                return fail("A text is not UTF-8.");
            }
        }
        return fail("");
    }

    bool escape() {
        constexpr std::string_view kSimple = "\"\\/bfnrt";
        const char c = m_at + 1 < m_text.size() ? m_text[m_at + 1] : '\0';
        if (c == 'u') {
            const std::optional<Escaped> escaped = escapedAt(m_text.substr(m_at));
            if (!escaped) {
                return fail("A text has \\u without a character.");
            }
            m_at += escaped->length;
            return true;
        }
        if (c == '\0' || kSimple.find(c) == std::string_view::npos) {
            return fail("A text has a backslash that means nothing.");
        }
        m_at += 2;
        return true;
    }

    bool digits() {
        if (!isDigit(here())) {
            return fail("A value is neither number, text, list nor object.");
        }
        while (isDigit(here())) {
            ++m_at;
        }
        return true;
    }

    bool number() {
        if (here() == '-') {
            ++m_at;
        }
        const bool isZero = here() == '0';
        const std::size_t begin = m_at;
        if (!digits()) {
            return false;
        }
        if (isZero && m_at > begin + 1) {
            m_at = begin;
            return fail("A number begins with a zero too many.");
        }
        if (here() == '.') {
            ++m_at;
            if (!digits()) {
                return false;
            }
        }
        if (here() == 'e' || here() == 'E') {
            ++m_at;
            if (here() == '+' || here() == '-') {
                ++m_at;
            }
            return digits();
        }
        return true;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    std::string m_problem;
};

}  // namespace

Result<JsonValue> checkJson(std::string_view text) {
    return Checker(text).check();
}

}  // namespace hitscope
