// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <string>
#include <string_view>

#include "io/readers/ply_header.h"

namespace hitscope {

/// A value of a PLY file and the bytes it stands in; in text with the blanks before it.
struct PlyPiece {
    double value = 0.0;
    std::string_view raw;  ///< until the next one is asked for
};

/// The data of a PLY file, value after value, of which a bounded part is in memory.
class PlyPieces {
public:
    /// `file` is open and outlives this; reading begins at `start`.
    PlyPieces(QFile& file, PlyEncoding encoding, qint64 start);

    /// Throws PlyDataEnd (readers/ply_values.h) where there is none.
    PlyPiece next(PlyType type);
    /// What is left, in parts; empty at the end.
    std::string_view nextRest();
    /// Bytes of the file behind what was given.
    [[nodiscard]] std::uint64_t bytesLeft() const;

private:
    void readMore();
    [[nodiscard]] std::string_view window() const { return std::string_view(m_buffer).substr(m_at); }
    [[nodiscard]] bool isAtEnd() const { return m_isAtEnd; }

    QFile& m_file;
    PlyEncoding m_encoding;
    std::string m_buffer;
    std::size_t m_at = 0;
    bool m_isAtEnd = false;
};

/// How values are written in an encoding; appends.
class PlyValues {
public:
    explicit PlyValues(PlyEncoding encoding) : m_encoding(encoding) {}

    [[nodiscard]] bool isAscii() const { return m_encoding == PlyEncoding::Ascii; }
    [[nodiscard]] PlyEncoding encoding() const { return m_encoding; }
    /// Whole types get the nearest number that they hold. In text a blank comes first, but for a line's
    /// first.
    void append(std::string& text, PlyType type, double value) const;
    void endRecord(std::string& text) const;

private:
    template <class Number>
    void appendAs(std::string& text, double value) const;

    PlyEncoding m_encoding;
};

}  // namespace hitscope
