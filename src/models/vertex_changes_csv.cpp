// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/vertex_changes_csv.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "io/csv_writer.h"
#include "io/staged_files.h"

namespace hitscope {

namespace {

constexpr std::size_t kChunk = 4096;  // rows

void addHeader(CsvWriter& csv) {
    csv.row({"vertex", "original_x", "original_y", "original_z", "current_x", "current_y", "current_z",
             "displacement_x", "displacement_y", "displacement_z", "displacement", "normal_turned_degrees",
             "hits"});
}

void addVector(CsvWriter& csv, const glm::vec3& vector) {
    csv.exact(vector.x).exact(vector.y).exact(vector.z);
}

void addRows(CsvWriter& csv, const VertexChangesTable& table, std::size_t first, std::size_t last) {
    for (std::size_t row = first; row < last; ++row) {
        const std::uint32_t vertex = table.rows[row];
        const VertexChangesTable::Row& values = table.values[row];
        const glm::vec3& original = table.original->positions[vertex];
        csv.count(std::uint64_t{vertex} + 1);
        addVector(csv, original);
        addVector(csv, values.current);
        addVector(csv, values.current - original);
        csv.exact(glm::distance(glm::dvec3(values.current), glm::dvec3(original)));
        csv.exact(glm::degrees(values.turned)).count(values.hits);
        csv.endRow();
    }
}

}  // namespace

QByteArray csv(const VertexChangesTable& table) {
    CsvWriter writer;
    addHeader(writer);
    addRows(writer, table, 0, table.rows.size());
    return QByteArray::fromStdString(writer.take());
}

Status saveCsv(const VertexChangesTable& table, const QString& path) {
    return writeWhole(path, [&table](const PutPiece& put) {
        CsvWriter writer;
        addHeader(writer);
        bool written = put(writer.take());
        for (std::size_t first = 0; written && first < table.rows.size(); first += kChunk) {
            addRows(writer, table, first, std::min(first + kChunk, table.rows.size()));
            written = put(writer.take());
        }
    });
}

}  // namespace hitscope
