// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/checked_lines.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "deform/fingerprint.h"
#include "document/document_words.h"

namespace hitscope {

namespace {

constexpr std::size_t kDigits = 16;

}  // namespace

std::uint64_t lineChecksum(std::uint64_t number, std::string_view json) {
    Fingerprint print;
    print.add(number);
    for (const char c : json) {
        print.add(static_cast<std::uint8_t>(c));
    }
    return print.value();
}

void CheckedLines::keep(std::string_view json) {
    m_at += kDigits + 1 + json.size() + 1;
    ++m_number;
}

Result<std::string_view> CheckedLines::next() const {
    const std::string_view rest = m_text.substr(m_at);
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) {
        return problem("It ends in the middle of a line.");
    }
    std::uint64_t sum = 0;
    const std::string_view digits = rest.substr(0, std::min(end, kDigits));
    if (end <= kDigits || rest[kDigits] != ' ' || !document_words::isHex(digits, kDigits)) {
        return problem("A line has no checksum.");
    }
    std::from_chars(digits.data(), digits.data() + kDigits, sum, 16);
    const std::string_view json = rest.substr(kDigits + 1, end - kDigits - 1);
    if (lineChecksum(m_number, json) != sum) {
        return problem("A line is damaged, or not in its place.");
    }
    return json;
}

Error CheckedLines::problem(const char* what) const {
    return {what, "line " + std::to_string(m_number + 1), "What stands before it can still be used."};
}

}  // namespace hitscope
