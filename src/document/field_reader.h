// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <bitset>
#include <charconv>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "document/fields.h"
#include "document/json_text.h"

namespace hitscope {

/// Takes the values of a JSON object into members of ours. A value that is not there leaves the member as it
/// is, and one that nobody asks for is passed over, and named: files of other versions have less or more. The
/// first thing that is wrong is kept as the error, and from then on nothing is read.
class FieldReader {
public:
    /// `value` is of checked JSON; both outlive this.
    FieldReader(std::string_view text, const JsonValue& value) : FieldReader(text, value, nullptr, {}, 0) {}

    [[nodiscard]] bool ok() const { return !m_error && (m_parent == nullptr || m_parent->ok()); }
    [[nodiscard]] Status status() const { return m_error ? Status(*m_error) : Status(Done{}); }
    [[nodiscard]] static constexpr bool reads() { return true; }
    /// Once all has been asked for: places of values that nobody asked for, "line 3, hit 1, powr". Of those
    /// with one key in things of one kind, the first and how many there are.
    [[nodiscard]] std::vector<std::string> takePassedOver();
    [[nodiscard]] bool has(std::string_view key) { return find(key).has_value(); }

    /// Says that something is wrong with a value, or, with an empty key, with all of this.
    void fail(std::string_view key, std::string what);
    void require(std::string_view key);

    /// A number in [lowest, highest], which are rounded to its type; integers are written as such.
    template <class Number>
    void number(std::string_view key, Number& value, double lowest = -kUnbound, double highest = kUnbound) {
        if (const std::optional<JsonValue> found = find(key)) {
            take(key, *found, value, lowest, highest);
        }
    }
    void flag(std::string_view key, bool& value);
    /// One of the words, by the enumeration's numbers.
    template <class Enum>
    void word(std::string_view key, Enum& value, std::span<const std::string_view> words) {
        if (const std::optional<std::size_t> index = wordOf(key, words)) {
            value = static_cast<Enum>(*index);
        }
    }
    void text(std::string_view key, std::string& value);
    void text(std::string_view key, QString& value);
    template <glm::length_t L, class Number, glm::qualifier Q>
    void vector(std::string_view key, glm::vec<L, Number, Q>& value, double lowest = -kUnbound,
                double highest = kUnbound) {
        std::optional<JsonValue> part = listOf(key, L);
        for (glm::length_t i = 0; part && i < L; ++i, part = part->next()) {
            take(key, *part, value[i], lowest, highest);
        }
    }
    void rotation(std::string_view key, glm::quat& value);  ///< x, y, z, w; unit
    /// What the object does not say is as in a new one.
    template <class Value>
    void object(std::string_view key, Value& value) {
        if (const std::optional<JsonValue> found = find(key)) {
            value = {};
            FieldReader within(m_text, *found, this, key, 0);
            Fields<Value>::visit(within, value);
            within.passOver();
        }
    }
    /// Likewise, and what the object does not say stays as it was.
    template <class Value>
    void within(std::string_view key, Value& value) {
        if (const std::optional<JsonValue> found = find(key)) {
            FieldReader inner(m_text, *found, this, key, 0);
            Fields<Value>::visit(inner, value);
            inner.passOver();
        }
    }
    /// Objects; `one` is what people call one of them. The list replaces what is there.
    template <class Value>
    void list(std::string_view key, std::string_view one, std::vector<Value>& values, std::size_t most) {
        std::optional<JsonValue> item = listOf(key, std::nullopt);
        if (ok() && has(key)) {
            values.clear();
        }
        for (; ok() && item; item = item->next()) {
            if (isFull(key, values.size(), most)) {
                return;
            }
            values.emplace_back();
            FieldReader within(m_text, *item, this, one, values.size());
            Fields<Value>::visit(within, values.back());
            within.passOver();
        }
    }
    template <class Value>
    void rows(std::string_view key, std::string_view one, std::vector<Value>& values, std::size_t most) {
        list(key, one, values, most);
    }
    /// Numbers or texts.
    template <class Value>
    void plain(std::string_view key, std::string_view /*one*/, std::vector<Value>& values, std::size_t most) {
        std::optional<JsonValue> item = listOf(key, std::nullopt);
        if (ok() && has(key)) {
            values.clear();
        }
        for (; ok() && item; item = item->next()) {
            if (isFull(key, values.size(), most)) {
                return;
            }
            values.emplace_back();
            if constexpr (std::is_same_v<Value, std::string>) {
                takeText(key, *item, values.back());
            } else {
                take(key, *item, values.back(), -kUnbound, kUnbound);
            }
        }
    }
    /// A number, or nothing where there is none.
    template <class Value>
    void optional(std::string_view key, std::optional<Value>& value) {
        if (has(key)) {
            value.emplace();
            number(key, *value);
        }
    }
    template <class Value>
    void optionalObject(std::string_view key, std::optional<Value>& value) {
        if (has(key)) {
            object(key, value.emplace());
        }
    }
    [[nodiscard]] bool isNumber(std::string_view key) {
        const std::optional<JsonValue> found = find(key);
        return found && found->kind() == JsonValue::Kind::Number;
    }

private:
    static constexpr double kUnbound = std::numeric_limits<double>::infinity();

    FieldReader(std::string_view text, const JsonValue& value, FieldReader* parent, std::string_view name,
                std::size_t index);

    std::optional<JsonValue> find(std::string_view key);
    std::optional<std::size_t> wordOf(std::string_view key, std::span<const std::string_view> words);
    /// The first of a list, which has `count` values if that is said.
    std::optional<JsonValue> listOf(std::string_view key, std::optional<std::size_t> count);
    bool isFull(std::string_view key, std::size_t size, std::size_t most);
    void takeText(std::string_view key, const JsonValue& from, std::string& value);
    void failOutOfRange(std::string_view key, const JsonValue& from, double lowest, double highest);
    void failAt(std::string_view key, const JsonValue& from, std::string what);
    [[nodiscard]] std::string placeOf(std::string_view key) const;
    [[nodiscard]] std::string lineAndPlace(std::string_view key, const JsonValue& value) const;
    /// Tells the root of the values that nobody has asked for.
    void passOver();
    FieldReader& root() { return m_parent != nullptr ? m_parent->root() : *this; }

    template <class Number>
    void take(std::string_view key, const JsonValue& from, Number& value, double lowest, double highest) {
        if (!ok()) {
            return;
        }
        const std::string_view digits = from.characters();
        Number read{};
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), read);
        if (from.kind() != JsonValue::Kind::Number) {
            failAt(key, from, "has to be a number.");
        } else if (error != std::errc()) {
            failOutOfRange(key, from, lowest, highest);
        } else if (end != digits.data() + digits.size()) {
            failAt(key, from, "has to be a whole number.");
        } else if (!isWithin(read, lowest, highest)) {
            failOutOfRange(key, from, lowest, highest);
        } else {
            value = read;
        }
    }
    template <class Number>
    static bool isWithin(Number value, double lowest, double highest) {
        if constexpr (std::is_floating_point_v<Number>) {
            return std::isfinite(value) && value >= static_cast<Number>(lowest) &&
                   value <= static_cast<Number>(highest);
        } else {
            return static_cast<double>(value) >= lowest && static_cast<double>(value) <= highest;
        }
    }

    /// A key that is not known, in things of one kind.
    struct PassedOver {
        std::string_view within;
        std::string_view key;
        std::string first;  ///< its place
        std::size_t count = 1;
    };

    std::string_view m_text;
    JsonValue m_value;
    FieldReader* m_parent;
    std::string_view m_name;  ///< in the parent
    std::size_t m_index;      ///< in a list, from 1; 0: in none
    std::vector<JsonMember> m_members;
    std::size_t m_next = 0;                        ///< of the members: the one that is likely asked for next
    std::bitset<JsonValue::kMostMembers> m_asked;  ///< for which members
    std::vector<PassedOver> m_passedOver;          ///< of all, in the root
    std::optional<Error> m_error;
};

}  // namespace hitscope
