// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "io/csv_writer.h"

namespace hitscope {

/// Rows of changed vertices, wherever they are written: numbers so that they are read back as the same.
class ChangesCsv {
public:
    /// A column for how far the normal turned, and one for hits.
    struct Columns {
        bool turned = true;
        bool hits = true;
        bool isNew = false;  ///< and one that tells vertices which the mesh's file does not have
    };
    ChangesCsv(CsvWriter& csv, Columns columns) : m_csv(csv), m_columns(columns) {}

    void header();
    /// vertex: from 0; turned: degrees. Number: float or double.
    template <class Vector>
    void row(std::uint32_t vertex, const Vector& original, const Vector& current, const Vector& displacement,
             double length, float turned, std::uint32_t hits, bool isNew = false) {
        m_csv.count(std::uint64_t{vertex} + 1);
        for (const Vector& vector : {original, current, displacement}) {
            m_csv.exact(vector.x).exact(vector.y).exact(vector.z);
        }
        m_csv.exact(length);
        if (m_columns.turned) {
            m_csv.exact(turned);
        }
        if (m_columns.hits) {
            m_csv.count(hits);
        }
        if (m_columns.isNew) {
            m_csv.count(isNew ? 1 : 0);
        }
        m_csv.endRow();
    }

private:
    CsvWriter& m_csv;
    Columns m_columns;
};

}  // namespace hitscope
