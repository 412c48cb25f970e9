// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_window/latency_exports.h"

#include <optional>

#include "app/actions/export_actions.h"
#include "bench_window/passing_folder.h"

namespace hitscope::bench {

namespace {

constexpr double kNanosecond = 1.0e-9;  // seconds

std::optional<Row> exportOnce(DrivenWindow& window, ExportActions& exports, const QString& path) {
    std::optional<bool> isWritten;
    QObject listener;
    QObject::connect(&exports, &ExportActions::ended, &listener,
                     [&isWritten](const QString&, bool written) { isWritten = written; });
    window.settle();
    window.setRefines(true);  // another picture is begun
    const double spent = processorTime();
    const std::int64_t begin = nowInNanoseconds();
    window.watch().restart();
    exports.begin(path, std::nullopt);
    window.wait(QStringLiteral("the exported file"), [&isWritten] { return isWritten.has_value(); });
    Row row{QStringLiteral("export, %1").arg(path.section(u'.', -1).toUpper())};
    row.add(kNanosecond * static_cast<double>(nowInNanoseconds() - begin), window.watch().longest(),
            processorTime() - spent);
    window.setRefines(false);
    return isWritten.value_or(false) ? std::optional(row) : std::nullopt;
}

}  // namespace

std::vector<Row> exportLatency(DrivenWindow& window) {
    std::vector<Row> rows;
    const PassingFolder folder;
    auto* const exports = window.window().findChild<ExportActions*>();
    if (exports == nullptr || !folder.isValid()) {
        return rows;
    }
    for (const QString& name : {QStringLiteral("mesh.obj"), QStringLiteral("mesh.glb")}) {
        if (std::optional<Row> row = exportOnce(window, *exports, folder.filePath(name))) {
            rows.push_back(std::move(*row));
        }
    }
    return rows;
}

}  // namespace hitscope::bench
