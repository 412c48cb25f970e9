// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/csv_writer.h"

#include <QByteArray>
#include <array>
#include <charconv>
#include <utility>

#include "io/number_text.h"

namespace hitscope {

void CsvWriter::beginCell() {
    if (m_inRow) {
        m_text += ',';
    }
    m_inRow = true;
}

void CsvWriter::endLine() {
    m_text += m_lineEnd == LineEnd::CrLf ? "\r\n" : "\n";
}

CsvWriter& CsvWriter::text(std::string_view text) {
    if (text.find_first_of("\",\r\n") != std::string_view::npos) {
        return quoted(text);
    }
    beginCell();
    m_text += text;
    return *this;
}

CsvWriter& CsvWriter::quoted(std::string_view text) {
    beginCell();
    m_text += '"';
    for (const char c : text) {
        m_text += c;
        if (c == '"') {
            m_text += '"';
        }
    }
    m_text += '"';
    return *this;
}

CsvWriter& CsvWriter::count(std::uint64_t number) {
    beginCell();
    appendNumber(m_text, number);
    return *this;
}

CsvWriter& CsvWriter::exact(float number) {
    beginCell();
    appendNumber(m_text, number);
    return *this;
}

CsvWriter& CsvWriter::exact(double number) {
    beginCell();
    appendNumber(m_text, number);
    return *this;
}

CsvWriter& CsvWriter::general(double number, int digits) {
    return text(QByteArray::number(number, 'g', digits).toStdString());
}

CsvWriter& CsvWriter::general(const std::optional<double>& number, int digits) {
    return number ? general(*number, digits) : empty();
}

CsvWriter& CsvWriter::fixed(double number, int decimals) {
    return text(QByteArray::number(number, 'f', decimals).toStdString());
}

void CsvWriter::endRow() {
    endLine();
    m_inRow = false;
}

void CsvWriter::row(std::initializer_list<std::string_view> cells) {
    for (const std::string_view cell : cells) {
        text(cell);
    }
    endRow();
}

void CsvWriter::comment(std::string_view text) {
    m_text += "# ";
    m_text += text;
    endLine();
}

std::string CsvWriter::take() {
    m_inRow = false;
    return std::exchange(m_text, {});
}

}  // namespace hitscope
