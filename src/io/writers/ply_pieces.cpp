// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/ply_pieces.h"

#include <cmath>
#include <limits>

#include "io/number_text.h"
#include "io/readers/ply_values.h"

namespace hitscope {
namespace {

constexpr qint64 kPart = 1 << 20;          // bytes read at once
constexpr std::size_t kAhead = 512;        // so many are there before a value is read
constexpr std::size_t kLongest = 1 << 26;  // bytes that one value takes at most, with the blanks before it

}  // namespace

PlyPieces::PlyPieces(QFile& file, PlyEncoding encoding, qint64 start) : m_file(file), m_encoding(encoding) {
    m_isAtEnd = !m_file.seek(start);
}

void PlyPieces::readMore() {
    m_buffer.erase(0, m_at);
    m_at = 0;
    const QByteArray part = m_file.read(kPart);
    m_isAtEnd = part.isEmpty();
    m_buffer.append(part.constData(), static_cast<std::size_t>(part.size()));
}

std::uint64_t PlyPieces::bytesLeft() const {
    return static_cast<std::uint64_t>(std::max<qint64>(m_file.size() - m_file.pos(), 0)) + window().size();
}

PlyPiece PlyPieces::next(PlyType type) {
    if (window().size() < kAhead && !m_isAtEnd) {
        readMore();
    }
    for (;;) {
        const std::string_view from = window();
        const bool isAscii = m_encoding == PlyEncoding::Ascii;
        try {
            double value = 0.0;
            std::size_t left = 0;
            if (isAscii) {
                PlyAsciiSource source(from);
                value = source.value(type);
                left = source.bytesLeft();
            } else {
                PlyBinarySource source(from, m_encoding == PlyEncoding::BigEndian);
                value = source.value(type);
                left = source.bytesLeft();
            }
            if (left > 0 || !isAscii || m_isAtEnd) {  // else the number may go on
                const std::size_t size = from.size() - left;
                m_at += size;
                return {value, from.substr(0, size)};
            }
        } catch (const PlyDataEnd&) {
            if (m_isAtEnd || from.size() > kLongest) {
                throw;
            }
        }
        readMore();
    }
}

std::string_view PlyPieces::nextRest() {
    if (window().empty() && !m_isAtEnd) {
        readMore();
    }
    const std::string_view rest = window();
    m_at = m_buffer.size();
    return rest;
}

template <class Number>
void PlyValues::appendAs(std::string& text, double value) const {
    Number number{};
    if constexpr (std::is_integral_v<Number>) {
        using Limits = std::numeric_limits<Number>;
        const double held = std::clamp(std::round(value), static_cast<double>(Limits::min()),
                                       static_cast<double>(Limits::max()));
        number = std::isnan(held) ? Number{0} : static_cast<Number>(held);
    } else {
        number = static_cast<Number>(value);
    }
    if (isAscii()) {
        if (!text.empty() && text.back() != '\n') {
            text += ' ';
        }
        if constexpr (std::is_same_v<Number, float>) {
            appendTwiceRoundedFloat(text, number);
        } else {
            appendNumber(text, number);
        }
        return;
    }
    char bytes[sizeof(Number)];
    std::memcpy(bytes, &number, sizeof number);
    if ((m_encoding == PlyEncoding::LittleEndian) != (std::endian::native == std::endian::little)) {
        std::reverse(bytes, bytes + sizeof bytes);
    }
    text.append(bytes, sizeof bytes);
}

void PlyValues::append(std::string& text, PlyType type, double value) const {
    switch (type) {
        case PlyType::Int8:
            return appendAs<std::int8_t>(text, value);
        case PlyType::Uint8:
            return appendAs<std::uint8_t>(text, value);
        case PlyType::Int16:
            return appendAs<std::int16_t>(text, value);
        case PlyType::Uint16:
            return appendAs<std::uint16_t>(text, value);
        case PlyType::Int32:
            return appendAs<std::int32_t>(text, value);
        case PlyType::Uint32:
            return appendAs<std::uint32_t>(text, value);
        case PlyType::Float32:
            return appendAs<float>(text, value);
        case PlyType::Float64:
            return appendAs<double>(text, value);
    }
}

void PlyValues::endRecord(std::string& text) const {
    if (isAscii()) {
        text += '\n';
    }
}

}  // namespace hitscope
