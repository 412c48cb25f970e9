// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/vertex_changes_csv.h"

#include <algorithm>
#include <charconv>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "io/staged_files.h"

namespace hitscope {

namespace {

constexpr char kHeader[] =
    "vertex,original_x,original_y,original_z,current_x,current_y,current_z,displacement_x,displacement_y,"
    "displacement_z,displacement,normal_turned_degrees,hits\n";
constexpr std::size_t kChunk = 4096;  // rows

template <class Number>
void append(QByteArray& text, Number number) {
    char digits[32];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
    text.append(digits, end - digits);
}

void append(QByteArray& text, const glm::vec3& vector) {
    for (int i = 0; i < 3; ++i) {
        append(text, vector[i]);
        text.append(',');
    }
}

void appendRows(QByteArray& text, const VertexChangesTable& table, std::size_t first, std::size_t last) {
    for (std::size_t row = first; row < last; ++row) {
        const std::uint32_t vertex = table.rows[row];
        const VertexChangesTable::Row& values = table.values[row];
        const glm::vec3& original = table.original->positions[vertex];
        append(text, std::uint64_t{vertex} + 1);
        text.append(',');
        append(text, original);
        append(text, values.current);
        append(text, values.current - original);
        append(text, glm::distance(glm::dvec3(values.current), glm::dvec3(original)));
        text.append(',');
        append(text, glm::degrees(values.turned));
        text.append(',');
        append(text, values.hits);
        text.append('\n');
    }
}

}  // namespace

QByteArray csv(const VertexChangesTable& table) {
    QByteArray text(kHeader);
    appendRows(text, table, 0, table.rows.size());
    return text;
}

Status saveCsv(const VertexChangesTable& table, const QString& path) {
    return writeWhole(path, [&table](const PutPiece& put) {
        bool written = put(kHeader);
        for (std::size_t first = 0; written && first < table.rows.size(); first += kChunk) {
            QByteArray text;
            appendRows(text, table, first, std::min(first + kChunk, table.rows.size()));
            written = put({text.constData(), static_cast<std::size_t>(text.size())});
        }
    });
}

}  // namespace hitscope
