// SPDX-License-Identifier: GPL-3.0-or-later
// Over checked text.
#include "document/json_text.h"

#include <algorithm>

#include "document/json_escapes.h"

namespace hitscope {

namespace {

std::size_t pastSpace(std::string_view text, std::size_t at) {
    while (at < text.size() && isJsonSpace(text[at])) {
        ++at;
    }
    return at;
}

/// Behind the text whose opening quote is at `at`.
std::size_t pastText(std::string_view text, std::size_t at) {
    for (++at; text[at] != '"'; ++at) {
        at += text[at] == '\\' ? 1 : 0;
    }
    return at + 1;
}

std::size_t pastValue(std::string_view text, std::size_t at) {
    const char first = text[at];
    if (first == '"') {
        return pastText(text, at);
    }
    if (first != '{' && first != '[') {
        constexpr std::string_view kEnds = " \n\r\t,]}";
        return std::min(text.find_first_of(kEnds, at), text.size());
    }
    int depth = 0;
    do {
        const char c = text[at];
        if (c == '"') {
            at = pastText(text, at);
            continue;
        }
        depth += c == '{' || c == '[' ? 1 : 0;
        depth -= c == '}' || c == ']' ? 1 : 0;
        ++at;
    } while (depth > 0);
    return at;
}

std::string unescaped(std::string_view characters) {
    constexpr std::string_view kNames = "bfnrt";
    constexpr std::string_view kMeant = "\b\f\n\r\t";
    std::string text;
    for (std::size_t at = 0; at < characters.size();) {
        if (characters[at] != '\\') {
            text += characters[at++];
            continue;
        }
        const char c = characters[at + 1];
        if (c == 'u') {
            const Escaped escaped = *escapedAt(characters.substr(at));
            appendUtf8(text, escaped.code);
            at += escaped.length;
            continue;
        }
        const std::size_t name = kNames.find(c);
        text += name == std::string_view::npos ? c : kMeant[name];
        at += 2;
    }
    return text;
}

}  // namespace

JsonValue::Kind JsonValue::kind() const {
    switch (m_text[m_at]) {
        case '{':
            return Kind::Object;
        case '[':
            return Kind::Array;
        case '"':
            return Kind::Text;
        case 't':
            return Kind::True;
        case 'f':
            return Kind::False;
        case 'n':
            return Kind::Null;
        default:
            return Kind::Number;
    }
}

std::string_view JsonValue::characters() const {
    return m_text.substr(m_at, pastValue(m_text, m_at) - m_at);
}

std::string JsonValue::text() const {
    const std::string_view quoted = characters();
    return unescaped(quoted.substr(1, quoted.size() - 2));
}

Status JsonValue::members(std::vector<JsonMember>& members) const {
    constexpr std::size_t kUsual = 16;
    members.clear();
    members.reserve(kUsual);
    std::size_t at = pastSpace(m_text, m_at + 1);
    while (m_text[at] != '}') {
        const std::size_t keyEnd = pastText(m_text, at);
        const std::string_view key = m_text.substr(at + 1, keyEnd - at - 2);
        const std::size_t value = pastSpace(m_text, pastSpace(m_text, keyEnd) + 1);
        if (members.size() == kMostMembers) {
            return Error{"An object has more than " + std::to_string(kMostMembers) + " values.", "", ""};
        }
        members.push_back({key, JsonValue(m_text, value)});
        at = pastSpace(m_text, pastValue(m_text, value));
        at = m_text[at] == ',' ? pastSpace(m_text, at + 1) : at;
    }
    return Done{};
}

std::optional<JsonValue> JsonValue::first() const {
    const std::size_t at = pastSpace(m_text, m_at + 1);
    return m_text[at] == ']' ? std::nullopt : std::optional(JsonValue(m_text, at));
}

std::optional<JsonValue> JsonValue::next() const {
    const std::size_t at = pastSpace(m_text, pastValue(m_text, m_at));
    return m_text[at] == ']' ? std::nullopt : std::optional(JsonValue(m_text, pastSpace(m_text, at + 1)));
}

bool isKey(std::string_view key, std::string_view name) {
    return key == name ||
           (key.size() > name.size() && key.find('\\') != std::string_view::npos && unescaped(key) == name);
}

std::size_t lineAt(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

}  // namespace hitscope
