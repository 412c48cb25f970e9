// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "io/readers/ply_header.h"
#include "io/readers/text_cursor.h"

namespace hitscope {

/// Thrown by the sources below when the data end or are no numbers; the PLY reader turns it into an Error.
struct PlyDataEnd : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Whether data follow those that were read: blanks and zeros only fill a file up.
inline bool holdsMore(std::string_view rest) {
    return std::any_of(rest.begin(), rest.end(),
                       [](char c) { return c != '\0' && c != '\n' && !TextCursor::isBlank(c); });
}

/// Numbers of an ascii PLY's data, one after the other.
class PlyAsciiSource {
public:
    explicit PlyAsciiSource(std::string_view data) : m_cursor(data) {}

    double value(PlyType) {
        m_cursor.skipBlanks(true);
        const std::optional<double> number = m_cursor.number();
        if (!number) {
            if (m_cursor.atEnd()) {
                throw PlyDataEnd("The file ends");
            }
            throw PlyDataEnd(quoted(m_cursor.word()) + " is not a number");
        }
        return *number;
    }
    void skip(PlyType type, std::uint64_t count) {
        for (; count > 0; --count) {
            value(type);
        }
    }
    [[nodiscard]] std::string_view rest() const { return m_cursor.rest(); }
    [[nodiscard]] std::uint64_t bytesLeft() const { return rest().size(); }
    /// Values of a type that the data left can hold at most.
    [[nodiscard]] std::uint64_t room(PlyType) const { return bytesLeft() / 2 + 1; }

private:
    TextCursor m_cursor;
};

/// The same of a binary one; `swapped`: its bytes are in the other order than this machine's.
class PlyBinarySource {
public:
    PlyBinarySource(std::string_view data, bool swapped) : m_data(data), m_swapped(swapped) {}

    double value(PlyType type) {
        switch (type) {
            case PlyType::Int8:
                return take<std::int8_t>();
            case PlyType::Uint8:
                return take<std::uint8_t>();
            case PlyType::Int16:
                return take<std::int16_t>();
            case PlyType::Uint16:
                return take<std::uint16_t>();
            case PlyType::Int32:
                return take<std::int32_t>();
            case PlyType::Uint32:
                return take<std::uint32_t>();
            case PlyType::Float32:
                return static_cast<double>(take<float>());
            case PlyType::Float64:
                break;
        }
        return take<double>();
    }
    void skip(PlyType type, std::uint64_t count) {
        if (count > room(type)) {
            throw PlyDataEnd("The file ends");
        }
        m_data.remove_prefix(count * sizeOf(type));
    }
    [[nodiscard]] std::string_view rest() const { return m_data; }
    [[nodiscard]] std::uint64_t bytesLeft() const { return m_data.size(); }
    [[nodiscard]] std::uint64_t room(PlyType type) const { return m_data.size() / sizeOf(type); }

private:
    template <class T>
    T take() {
        if (m_data.size() < sizeof(T)) {
            throw PlyDataEnd("The file ends");
        }
        std::array<char, sizeof(T)> bytes;
        std::memcpy(bytes.data(), m_data.data(), sizeof(T));
        m_data.remove_prefix(sizeof(T));
        if (m_swapped) {
            std::reverse(bytes.begin(), bytes.end());
        }
        return std::bit_cast<T>(bytes);
    }

    std::string_view m_data;
    bool m_swapped;
};

}  // namespace hitscope
