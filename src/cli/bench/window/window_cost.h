// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QSize>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <vector>

#include "cli/bench/harness.h"
#include "cli/bench/window/window_run.h"

namespace hitscope::bench {

inline constexpr int kLeastSheet = 100;         ///< vertices
inline constexpr int kMostSheet = 20'000'000;   ///< vertices
inline constexpr int kMostScattered = 100'000;  ///< hits

/// Those numbers of vertices that make different sheets; what is left out is noted.
[[nodiscard]] std::vector<int> differentSheets(const std::vector<int>& vertices, QStringList& notes);

struct LatencyRow {
    QString measured;  ///< "undo key to picture"
    Samples seconds;
    Samples blocked;    ///< seconds that an event waited at most meanwhile, a value a sample
    Samples processor;  ///< seconds of all threads of the window, likewise
};
struct LatencyFigures {
    std::size_t vertices = 0;
    std::size_t moved = 0;  ///< vertices that a click moves
    QSize viewport;         ///< pixels
    std::vector<LatencyRow> rows;
    QJsonObject renderer;  ///< for windowReportHeader()
};
[[nodiscard]] const LatencyRow* findRow(const LatencyFigures& figures, const QString& measured);

struct LatencyWish {
    int vertices = 8000;  ///< of a bent sheet
    int scattered = 0;    ///< hits; 0: none
    Plan plan;
};
/// The window with such a mesh, used as a person uses it.
[[nodiscard]] Result<LatencyFigures> measureWindowLatency(const WindowRoom& room, const LatencyWish& wish);

struct MemoryRow {
    QString measured;       ///< "opened"
    QString about;          ///< for people
    double share = 0.0;     ///< PSS, bytes
    double resident = 0.0;  ///< RSS, bytes
    bool ofMesh = false;    ///< it grows with the mesh
};
struct MemoryFigures {
    std::size_t vertices = 0;
    std::size_t hits = 0;
    double meshBytes = 0.0;  ///< of its positions, and its triangles as 32 bit indices
    std::vector<MemoryRow> rows;
    QJsonObject renderer;  ///< for windowReportHeader()
};
[[nodiscard]] const MemoryRow* findRow(const MemoryFigures& figures, const QString& measured);

struct MemoryWish {
    int vertices = 2'000'000;  ///< of a bent sheet
    int hits = 500;            ///< of about 80 vertices
};
[[nodiscard]] Result<MemoryFigures> measureWindowMemory(const WindowRoom& room, const MemoryWish& wish);

}  // namespace hitscope::bench
