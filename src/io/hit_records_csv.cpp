// SPDX-License-Identifier: GPL-3.0-or-later
// Hits as comma-separated values (RFC 4180).
#include <algorithm>
#include <utility>

#include "io/csv_writer.h"
#include "io/hit_records_fields.h"

namespace hitscope {

namespace {

using namespace hit_fields;

/// Takes a file apart into rows of fields.
class CsvRows {
public:
    explicit CsvRows(std::string_view text) : m_text(text) {}

    [[nodiscard]] bool atEnd() const { return m_at == m_text.size(); }
    [[nodiscard]] std::size_t line() const { return m_rowLine; }  ///< where the row begins

    /// The next row; an error for quotes that do not pair.
    [[nodiscard]] Status next(std::vector<std::string>& fields) {
        fields.clear();
        m_rowLine = m_line;
        for (;;) {
            std::string& field = fields.emplace_back();
            const Status status = m_at < m_text.size() && m_text[m_at] == '"' ? quoted(field) : plain(field);
            if (!status) {
                return status;
            }
            if (m_at < m_text.size() && m_text[m_at] == ',') {
                ++m_at;
                continue;
            }
            endLine();
            return Done{};
        }
    }

private:
    [[nodiscard]] Status plain(std::string& field) {
        const std::size_t end = std::min(m_text.find_first_of(",\r\n\"", m_at), m_text.size());
        field = m_text.substr(m_at, end - m_at);
        m_at = end;
        if (m_at < m_text.size() && m_text[m_at] == '"') {
            return atLine(m_line, "A quotation mark stands in the middle of a field.");
        }
        return Done{};
    }
    [[nodiscard]] Status quoted(std::string& field) {
        for (++m_at; m_at < m_text.size(); ++m_at) {
            if (m_text[m_at] == '"') {
                if (m_at + 1 == m_text.size() || m_text[m_at + 1] != '"') {
                    ++m_at;
                    return isFieldEnd() ? Status(Done{})
                                        : Status(atLine(m_line, "Text follows a quoted field."));
                }
                ++m_at;
            } else if (m_text[m_at] == '\n') {
                ++m_line;
            }
            field += m_text[m_at];
        }
        return atLine(m_rowLine, "A quotation mark is not closed.");
    }
    [[nodiscard]] bool isFieldEnd() const {
        return m_at == m_text.size() ||
               std::string_view(",\r\n").find(m_text[m_at]) != std::string_view::npos;
    }
    void endLine() {
        if (m_at < m_text.size() && m_text[m_at] == '\r') {
            ++m_at;
        }
        if (m_at < m_text.size() && m_text[m_at] == '\n') {
            ++m_at;
        }
        ++m_line;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    std::size_t m_line = 1;
    std::size_t m_rowLine = 1;
};

Result<std::vector<Field>> columnsIn(const std::vector<std::string>& names, std::size_t line) {
    std::vector<Field> columns;
    for (const std::string& name : names) {
        const std::optional<Field> field = fieldNamed(name);
        if (!field) {
            return atLine(line, "“" + name.substr(0, 40) + "” is no column of a table of hits.");
        }
        if (std::find(columns.begin(), columns.end(), *field) != columns.end()) {
            return atLine(line, "The column “" + name + "” is there twice.");
        }
        columns.push_back(*field);
    }
    for (const FieldName& needed : kFields) {
        if (needed.isRequired && std::find(columns.begin(), columns.end(), needed.field) == columns.end()) {
            return atLine(line, "The column “" + std::string(needed.name) + "” is missing.");
        }
    }
    return columns;
}

Status readRow(RecordReader& reader, const std::vector<Field>& columns,
               const std::vector<std::string>& fields) {
    if (fields.size() != columns.size()) {
        return Error{"The line has " + std::to_string(fields.size()) + " fields, the header " +
                         std::to_string(columns.size()) + ".",
                     "", ""};
    }
    Hit hit;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (Status status = reader.set(hit, columns[i], fields[i]); !status) {
            return status;
        }
    }
    return reader.add(hit);
}

}  // namespace

std::string toCsv(const HitRecords& table) {
    CsvWriter csv;
    for (const FieldName& column : kFields) {
        csv.text(column.name);
    }
    csv.endRow();
    for (std::size_t i = 0; i < table.hits.size(); ++i) {
        for (const FieldName& column : kFields) {
            csv.text(valueOf(table, i, column.field));
        }
        csv.endRow();
    }
    return csv.take();
}

Result<HitRecords> hit_fields::readCsv(std::string_view text, std::vector<std::string> pipelines) {
    CsvRows rows(text);
    std::vector<std::string> fields;
    if (Status status = rows.next(fields); !status) {
        return status.error();
    }
    const Result<std::vector<Field>> columns = columnsIn(fields, rows.line());
    if (!columns) {
        return columns.error();
    }
    RecordReader reader(std::move(pipelines));
    while (!rows.atEnd()) {
        if (Status status = rows.next(fields); !status) {
            return status.error();
        }
        if (fields.size() == 1 && fields.front().empty()) {
            continue;  // an empty line
        }
        if (Status status = readRow(reader, columns.value(), fields); !status) {
            return atLine(rows.line(), status.error().what);
        }
    }
    return reader.take();
}

}  // namespace hitscope
