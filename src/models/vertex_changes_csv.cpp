// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/vertex_changes_csv.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "io/staged_files.h"
#include "io/writers/changes_csv.h"

namespace hitscope {

namespace {

constexpr std::size_t kChunk = 4096;  // rows

constexpr ChangesCsv::Columns kAll{};

void addRows(CsvWriter& csv, const VertexChangesTable& table, std::size_t first, std::size_t last) {
    ChangesCsv rows(csv, kAll);
    for (std::size_t row = first; row < last; ++row) {
        const std::uint32_t vertex = table.rows[row];
        const VertexChangesTable::Row& values = table.values[row];
        const glm::vec3& original = table.original->positions[vertex];
        rows.row(vertex, original, values.current, values.current - original,
                 glm::distance(glm::dvec3(values.current), glm::dvec3(original)), glm::degrees(values.turned),
                 values.hits);
    }
}

}  // namespace

QByteArray csv(const VertexChangesTable& table) {
    CsvWriter writer;
    ChangesCsv(writer, kAll).header();
    addRows(writer, table, 0, table.rows.size());
    return QByteArray::fromStdString(writer.take());
}

Status saveCsv(const VertexChangesTable& table, const QString& path) {
    return writeWhole(path, [&table](const PutPiece& put) {
        CsvWriter writer;
        ChangesCsv(writer, kAll).header();
        bool written = put(writer.take());
        for (std::size_t first = 0; written && first < table.rows.size(); first += kChunk) {
            addRows(writer, table, first, std::min(first + kChunk, table.rows.size()));
            written = put(writer.take());
        }
    });
}

}  // namespace hitscope
