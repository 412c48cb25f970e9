// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/field_writer.h"

#include "io/number_text.h"

namespace hitscope {

namespace {

constexpr std::size_t kIndent = 2;

/// For others to read as a number with a fraction: some lose the sign of the whole number -0.
template <class Number>
bool isNegativeZero(Number value) {
    return value == Number(0) && std::signbit(value);
}

}  // namespace

void FieldWriter::newLine() {
    if (m_layout == Layout::Lines && m_rows == 0) {
        m_out += '\n';
        m_out.append(kIndent * static_cast<std::size_t>(m_depth), ' ');
    }
}

void FieldWriter::begin(std::string_view key) {
    if (!m_isFirst) {
        m_out += m_rows > 0 ? comma() : ",";
    }
    m_isFirst = false;
    if (m_depth > 0) {
        newLine();
    }
    if (!key.empty()) {
        quote(key);
        m_out += m_layout == Layout::Lines ? ": " : ":";
    }
}

void FieldWriter::open(char bracket) {
    m_out += bracket;
    ++m_depth;
    m_isFirst = true;
}

void FieldWriter::close(char bracket) {
    --m_depth;
    if (!m_isFirst) {
        newLine();
    }
    m_out += bracket;
    m_isFirst = false;
}

void FieldWriter::beginRow() {
    ++m_rows;
}

void FieldWriter::endRow() {
    --m_rows;
}

void FieldWriter::flag(std::string_view key, bool value) {
    begin(key);
    m_out += value ? "true" : "false";
}

void FieldWriter::text(std::string_view key, std::string_view value) {
    begin(key);
    quote(value);
}

void FieldWriter::rotation(std::string_view key, const glm::quat& value) {
    begin(key);
    const float parts[] = {value.x, value.y, value.z, value.w};
    for (std::size_t i = 0; i < std::size(parts); ++i) {
        m_out += i == 0 ? "[" : comma();
        put(parts[i]);
    }
    m_out += ']';
}

void FieldWriter::put(float value) {
    if (isNegativeZero(value)) {
        m_out += "-0.0";
    } else {
        appendTwiceRoundedFloat(m_out, value);
    }
}

void FieldWriter::put(double value) {
    if (isNegativeZero(value)) {
        m_out += "-0.0";
    } else {
        appendNumber(m_out, value);
    }
}

void FieldWriter::put(std::uint8_t value) {
    appendNumber(m_out, std::uint32_t{value});
}
void FieldWriter::put(std::uint32_t value) {
    appendNumber(m_out, value);
}
void FieldWriter::put(std::uint64_t value) {
    appendNumber(m_out, value);
}
void FieldWriter::put(int value) {
    appendNumber(m_out, value);
}

void FieldWriter::quote(std::string_view text) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    m_out += '"';
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            m_out += '\\';
            m_out += c;
        } else if (code < 0x20) {
            m_out += "\\u00";
            m_out += kDigits[code >> 4];
            m_out += kDigits[code & 15];
        } else {
            m_out += c;
        }
    }
    m_out += '"';
}

}  // namespace hitscope
