// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/give_up.h"
#include "document/fields.h"

namespace hitscope {

/// Appends values to a JSON text, in an order that is always the same. What FieldReader would check is
/// ignored here.
class FieldWriter {
public:
    /// Lines: a value each, indented; rows(), vectors and numbers of a list in one. Compact: no line ends.
    enum class Layout : std::uint8_t { Lines, Compact };
    FieldWriter(std::string& out, Layout layout) : m_out(out), m_layout(layout) {}

    template <class Value>
    void whole(std::string_view key, const Value& value) {  // at the top: an object in braces
        begin(key);
        open('{');
        Fields<Value>::visit(*this, value);
        close('}');
    }

    // What Fields call: see FieldReader.
    template <class Number>
    void number(std::string_view key, const Number& value, double /*lowest*/ = 0.0,
                double /*highest*/ = 0.0) {
        begin(key);
        put(value);
    }
    void flag(std::string_view key, bool value);
    template <class Enum>
    void word(std::string_view key, Enum value, std::span<const std::string_view> words) {
        begin(key);
        quote(words[static_cast<std::size_t>(value)]);
    }
    void text(std::string_view key, std::string_view value);
    void text(std::string_view key, const QString& value) {
        text(key, std::string_view(value.toStdString()));
    }
    template <glm::length_t L, class Number, glm::qualifier Q>
    void vector(std::string_view key, const glm::vec<L, Number, Q>& value, double /*lowest*/ = 0.0,
                double /*highest*/ = 0.0) {
        begin(key);
        for (glm::length_t i = 0; i < L; ++i) {
            m_out += i == 0 ? "[" : comma();
            put(value[i]);
        }
        m_out += ']';
    }
    void rotation(std::string_view key, const glm::quat& value);  ///< x, y, z, w
    template <class Value>
    void object(std::string_view key, const Value& value) {
        whole(key, value);
    }
    template <class Value>
    void list(std::string_view key, std::string_view /*one*/, const std::vector<Value>& values,
              std::size_t /*most*/) {
        items(key, values, false);
    }
    template <class Value>
    void rows(std::string_view key, std::string_view /*one*/, const std::vector<Value>& values,
              std::size_t /*most*/) {
        items(key, values, true);
    }
    template <class Value>
    void plain(std::string_view key, std::string_view /*one*/, const std::vector<Value>& values,
               std::size_t /*most*/) {
        begin(key);
        m_out += '[';
        bool isFirst = true;
        for (const Value& value : values) {
            m_out += isFirst ? "" : comma();
            isFirst = false;
            put(value);
        }
        m_out += ']';
    }
    template <class Value>
    void optional(std::string_view key, const std::optional<Value>& value) {
        if (value) {
            number(key, *value);
        }
    }
    template <class Value>
    void optionalObject(std::string_view key, const std::optional<Value>& value) {
        if (value) {
            object(key, *value);
        }
    }
    [[nodiscard]] static constexpr bool reads() { return false; }
    void require(std::string_view /*key*/) {}

    // For what is laid out by hand.
    void begin(std::string_view key);  ///< comma, line, name; an empty key: a value of a list
    void open(char bracket);
    void close(char bracket);
    void put(float value);
    void put(double value);
    void put(std::uint8_t value);
    void put(std::uint32_t value);
    void put(std::uint64_t value);
    void put(int value);
    void put(const std::string& value) { quote(value); }
    /// In one line until endRow().
    void beginRow();
    void endRow();

private:
    static constexpr std::size_t kItemsBetween = 1024;  ///< looks whether to go on

    void quote(std::string_view text);
    [[nodiscard]] const char* comma() const { return m_layout == Layout::Lines ? ", " : ","; }
    void newLine();

    template <class Value>
    void items(std::string_view key, const std::vector<Value>& values, bool inRows) {
        begin(key);
        open('[');
        std::size_t written = 0;
        for (const Value& value : values) {
            mayGiveUp(written++, kItemsBetween);
            begin({});
            if (inRows) {
                beginRow();
            }
            open('{');
            Fields<Value>::visit(*this, value);
            close('}');
            if (inRows) {
                endRow();
            }
        }
        close(']');
    }

    std::string& m_out;
    Layout m_layout;
    int m_depth = 0;
    int m_rows = 0;         ///< within how many rows this is
    bool m_isFirst = true;  ///< nothing stands in the innermost brackets
};

}  // namespace hitscope
