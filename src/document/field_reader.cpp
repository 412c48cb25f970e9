// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/field_reader.h"

#include <algorithm>

#include "document/session_document.h"
#include "io/number_text.h"

namespace hitscope {

namespace {

constexpr float kUnitTolerance = 1.0e-3f;

std::string numberText(double value) {
    std::string text;
    appendNumber(text, value);
    return text;
}

}  // namespace

FieldReader::FieldReader(std::string_view text, const JsonValue& value, FieldReader* parent,
                         std::string_view name, std::size_t index)
    : m_text(text), m_value(value), m_parent(parent), m_name(name), m_index(index) {
    if (!ok()) {
        return;
    }
    if (value.kind() != JsonValue::Kind::Object) {
        failAt({}, value, "has to be an object in braces.");
        return;
    }
    if (const Status read = value.members(m_members); !read) {
        m_members.clear();
        failAt({}, value, "has too many values.");
        return;
    }
    for (std::size_t i = 1; i < m_members.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (m_members[i].key == m_members[j].key) {
                failAt(m_members[i].key.substr(0, 40), m_members[i].value, "is there twice.");
                return;
            }
        }
    }
}

std::optional<JsonValue> FieldReader::find(std::string_view key) {
    if (!ok()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < m_members.size(); ++i) {
        const std::size_t at = m_next + i < m_members.size() ? m_next + i : m_next + i - m_members.size();
        if (isKey(m_members[at].key, key)) {
            m_next = at;
            m_asked.set(at);
            return m_members[at].value;
        }
    }
    return std::nullopt;
}

/// "hit 3, point", from the outside in.
std::string FieldReader::placeOf(std::string_view key) const {
    std::string place = m_parent != nullptr ? m_parent->placeOf(m_name) : std::string();
    if (m_index > 0) {
        place += ' ' + std::to_string(m_index);
    }
    if (!key.empty()) {
        place += (place.empty() ? "" : ", ") + std::string(key);
    }
    return place;
}

/// "line 7, hit 3, point"
std::string FieldReader::lineAndPlace(std::string_view key, const JsonValue& value) const {
    const std::string place = placeOf(key);
    const std::string line = "line " + std::to_string(lineAt(m_text, value.offset()));
    return place.empty() ? line : line + ", " + place;
}

void FieldReader::passOver() {
    constexpr std::size_t kMostKept = 20;
    constexpr std::size_t kLongestKey = 40;
    if (!ok() || m_asked.count() == m_members.size()) {
        return;
    }
    std::vector<PassedOver>& all = root().m_passedOver;
    for (std::size_t i = 0; i < m_members.size(); ++i) {
        if (m_asked.test(i)) {
            continue;
        }
        const std::string_view key = m_members[i].key.substr(0, kLongestKey);
        const auto known = std::find_if(all.begin(), all.end(), [&](const PassedOver& other) {
            return other.within == m_name && other.key == key;
        });
        if (known != all.end()) {
            ++known->count;
        } else if (all.size() < kMostKept) {
            all.push_back({m_name, key, lineAndPlace(key, m_members[i].value)});
        }
    }
}

std::vector<std::string> FieldReader::takePassedOver() {
    passOver();
    std::vector<std::string> places;
    for (const PassedOver& value : m_passedOver) {
        places.push_back(value.count == 1 ? value.first
                                          : value.first + " (" + std::to_string(value.count) + " times)");
    }
    m_passedOver.clear();
    return places;
}

void FieldReader::failAt(std::string_view key, const JsonValue& from, std::string what) {
    FieldReader& outermost = root();
    if (outermost.m_error) {
        return;
    }
    outermost.m_error = Error{"It " + std::move(what), lineAndPlace(key, from),
                              "Compare it with a session that Hitscope saved."};
}

void FieldReader::fail(std::string_view key, std::string what) {
    const std::optional<JsonValue> found = key.empty() ? std::nullopt : find(key);
    failAt(key, found.value_or(m_value), std::move(what));
}

void FieldReader::require(std::string_view key) {
    if (ok() && !has(key)) {
        failAt(key, m_value, "is missing.");
    }
}

void FieldReader::flag(std::string_view key, bool& value) {
    const std::optional<JsonValue> found = find(key);
    if (!found) {
        return;
    }
    const JsonValue::Kind kind = found->kind();
    if (kind == JsonValue::Kind::True || kind == JsonValue::Kind::False) {
        value = kind == JsonValue::Kind::True;
    } else {
        failAt(key, *found, "has to be true or false.");
    }
}

std::optional<std::size_t> FieldReader::wordOf(std::string_view key,
                                               std::span<const std::string_view> words) {
    const std::optional<JsonValue> found = find(key);
    if (!found) {
        return std::nullopt;
    }
    if (found->kind() == JsonValue::Kind::Text) {
        const auto word = std::find(words.begin(), words.end(), found->text());
        if (word != words.end()) {
            return static_cast<std::size_t>(word - words.begin());
        }
    }
    std::string known;
    for (const std::string_view word : words) {
        known += (known.empty() ? "\"" : ", \"") + std::string(word) + '"';
    }
    failAt(key, *found, "has to be one of " + known + ".");
    return std::nullopt;
}

void FieldReader::takeText(std::string_view key, const JsonValue& from, std::string& value) {
    if (from.kind() != JsonValue::Kind::Text) {
        failAt(key, from, "has to be a text.");
        return;
    }
    std::string text = from.text();
    if (text.size() > SessionDocument::kMostText) {
        failAt(key, from, "is too long.");
        return;
    }
    std::erase(text, '\0');  // a mesh file may have one in an object's name
    value = std::move(text);
}

void FieldReader::text(std::string_view key, std::string& value) {
    if (const std::optional<JsonValue> found = find(key)) {
        takeText(key, *found, value);
    }
}

void FieldReader::text(std::string_view key, QString& value) {
    std::string utf8;
    if (has(key)) {
        text(key, utf8);
        value = QString::fromStdString(utf8);
    }
}

std::optional<JsonValue> FieldReader::listOf(std::string_view key, std::optional<std::size_t> count) {
    const std::optional<JsonValue> found = find(key);
    if (!found) {
        return std::nullopt;
    }
    bool isFitting = found->kind() == JsonValue::Kind::Array;
    if (isFitting && count) {
        std::size_t size = 0;
        for (auto part = found->first(); part && size <= *count; part = part->next()) {
            ++size;
        }
        isFitting = size == *count;
    }
    if (!isFitting) {
        failAt(key, *found,
               count ? "has to be a list of " + std::to_string(*count) + " numbers."
                     : "has to be a list in brackets.");
        return std::nullopt;
    }
    return found->first();
}

bool FieldReader::isFull(std::string_view key, std::size_t size, std::size_t most) {
    if (size == most) {
        fail(key, "has more than " + std::to_string(most) + " entries.");
    }
    return size == most;
}

void FieldReader::rotation(std::string_view key, glm::quat& value) {
    constexpr std::size_t kParts = 4;
    std::optional<JsonValue> part = listOf(key, kParts);
    if (!part) {
        return;
    }
    float* const parts[kParts] = {&value.x, &value.y, &value.z, &value.w};
    for (std::size_t i = 0; part && i < kParts; ++i, part = part->next()) {
        take(key, *part, *parts[i], -kUnbound, kUnbound);
    }
    if (ok() && !(std::abs(glm::length(value) - 1.0f) < kUnitTolerance)) {
        fail(key, "is no rotation: the four numbers are a quaternion of length 1.");
    }
}

void FieldReader::failOutOfRange(std::string_view key, const JsonValue& from, double lowest, double highest) {
    const std::string given = std::string(from.characters().substr(0, 40));
    if (std::isfinite(lowest) && std::isfinite(highest)) {
        failAt(key, from,
               "is " + given + ", and has to be from " + numberText(lowest) + " to " + numberText(highest) +
                   ".");
    } else if (std::isfinite(lowest)) {
        failAt(key, from, "is " + given + ", and has to be " + numberText(lowest) + " or more.");
    } else {
        failAt(key, from, "is " + given + ", which is too large or too small.");
    }
}

}  // namespace hitscope
