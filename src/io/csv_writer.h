// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace hitscope {

/// Makes comma-separated values (RFC 4180), cell by cell. Text is UTF-8; numbers have a decimal point in
/// every locale. A row is ended by endRow(), whatever it has.
class CsvWriter {
public:
    enum class LineEnd : std::uint8_t { Lf, CrLf };
    explicit CsvWriter(LineEnd lineEnd = LineEnd::Lf) : m_lineEnd(lineEnd) {}

    /// In quotation marks where it needs them: with a comma, a quotation mark or a line's end in it.
    CsvWriter& text(std::string_view text);
    CsvWriter& quoted(std::string_view text);  ///< in quotation marks in any case
    CsvWriter& empty() { return text({}); }
    CsvWriter& count(std::uint64_t number);
    /// The fewest digits that read back as the same number.
    CsvWriter& exact(float number);
    CsvWriter& exact(double number);
    /// Of at most so many significant digits, as printf's %g.
    CsvWriter& general(double number, int digits);
    CsvWriter& general(const std::optional<double>& number, int digits);  ///< nothing: an empty cell
    CsvWriter& fixed(double number, int decimals);                        ///< as printf's %f
    void endRow();

    void row(std::initializer_list<std::string_view> cells);
    /// A line that begins with #, which readers of tables take for a comment; no part of RFC 4180.
    void comment(std::string_view text);

    [[nodiscard]] const std::string& written() const { return m_text; }
    /// What has been written; begins anew.
    [[nodiscard]] std::string take();

private:
    void beginCell();
    void endLine();

    std::string m_text;
    LineEnd m_lineEnd;
    bool m_inRow = false;
};

}  // namespace hitscope
