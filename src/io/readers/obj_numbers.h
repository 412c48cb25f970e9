// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "io/readers/text_cursor.h"

namespace hitscope {

/// Thrown inside the OBJ reader alone, and turned into an Error with the line's number.
struct BadLine {
    std::string what;
};

/// The number at the cursor; `of` says in the error whose it is.
inline double coordinate(TextCursor& line, const char* of) {
    line.skipBlanks();
    const std::optional<double> value = line.number();
    if (!value) {
        const std::string_view word = line.word();
        throw BadLine{word.empty() ? std::string("The ") + of + " has too few numbers."
                                   : quoted(word) + " is not a number."};
    }
    return *value;
}

/// Numbers after the ones that are needed, until the end of the line, a comment or something else.
template <std::size_t Most>
std::size_t optionalNumbers(TextCursor& line, std::array<double, Most>& values) {
    std::size_t count = 0;
    while (count < Most) {
        line.skipBlanks();
        const std::optional<double> value = line.number();
        if (!value) {
            break;
        }
        values[count++] = *value;
    }
    return count;
}

}  // namespace hitscope
