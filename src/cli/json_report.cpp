// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/json_report.h"

#include <cmath>

#include "io/number_text.h"

namespace hitscope::cli {

std::string jsonText(const QString& text) {
    std::string made = "\"";
    for (const char c : text.toStdString()) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            made += '\\';
            made += c;
        } else if (code < 0x20) {
            constexpr const char* kDigits = "0123456789abcdef";
            made += "\\u00";
            made += kDigits[code >> 4u];
            made += kDigits[code & 15u];
        } else {
            made += c;
        }
    }
    return made + '"';
}

JsonReport::JsonReport(std::string_view verb) {
    m_text = "{";
    m_isEmpty.push_back(true);
    text("report", QString::fromUtf8(verb.data(), static_cast<qsizetype>(verb.size())));
}

void JsonReport::begin(std::string_view key) {
    m_text += m_isEmpty.back() ? "\n" : ",\n";
    m_isEmpty.back() = false;
    m_text.append(2 * m_isEmpty.size(), ' ');
    if (!key.empty()) {
        m_text += '"';
        m_text += key;
        m_text += "\": ";
    }
}

void JsonReport::open(std::string_view key, char bracket) {
    begin(key);
    m_text += bracket;
    m_isEmpty.push_back(true);
}

void JsonReport::close(char bracket) {
    const bool isEmpty = m_isEmpty.back();
    m_isEmpty.pop_back();
    if (!isEmpty) {
        m_text += '\n';
        m_text.append(2 * m_isEmpty.size(), ' ');
    }
    m_text += bracket;
}

template <class Number>
void JsonReport::append(Number value) {
    if (std::isfinite(value)) {
        if constexpr (std::is_same_v<Number, float>) {
            appendTwiceRoundedFloat(m_text, value);
        } else {
            appendNumber(m_text, value);
        }
    } else {
        m_text += "null";
    }
}

JsonReport& JsonReport::beginObject(std::string_view key) {
    open(key, '{');
    return *this;
}

JsonReport& JsonReport::endObject() {
    close('}');
    return *this;
}

JsonReport& JsonReport::beginArray(std::string_view key) {
    open(key, '[');
    return *this;
}

JsonReport& JsonReport::endArray() {
    close(']');
    return *this;
}

JsonReport& JsonReport::raw(std::string_view key, std::string_view json) {
    begin(key);
    m_text += json;
    return *this;
}

JsonReport& JsonReport::text(std::string_view key, const QString& value) {
    return raw(key, jsonText(value));
}

JsonReport& JsonReport::count(std::string_view key, std::uint64_t value) {
    return raw(key, std::to_string(value));
}

JsonReport& JsonReport::number(std::string_view key, float value) {
    begin(key);
    append(value);
    return *this;
}

JsonReport& JsonReport::number(std::string_view key, double value) {
    begin(key);
    append(value);
    return *this;
}

JsonReport& JsonReport::number(std::string_view key, const std::optional<double>& value) {
    return value ? number(key, *value) : nothing(key);
}

JsonReport& JsonReport::truth(std::string_view key, bool value) {
    return raw(key, value ? "true" : "false");
}

JsonReport& JsonReport::nothing(std::string_view key) {
    return raw(key, "null");
}

JsonReport& JsonReport::vector(std::string_view key, const glm::vec3& value) {
    return append(key, value);
}

JsonReport& JsonReport::vector(std::string_view key, const glm::dvec3& value) {
    return append(key, value);
}

template <class Vector>
JsonReport& JsonReport::append(std::string_view key, const Vector& value) {
    begin(key);
    m_text += '[';
    for (int axis = 0; axis < 3; ++axis) {
        m_text += axis > 0 ? ", " : "";
        append(value[axis]);
    }
    m_text += ']';
    return *this;
}

std::string JsonReport::take() {
    close('}');
    m_text += '\n';
    return std::move(m_text);
}

}  // namespace hitscope::cli
