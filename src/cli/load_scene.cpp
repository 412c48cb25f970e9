// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/load_scene.h"

#include <QFileInfo>
#include <QTextStream>
#include <utility>

#include "io/import.h"

namespace hitscope::cli {

Status loadScene(Session& session, const QString& meshPath, QTextStream& out) {
    if (meshPath.isEmpty()) {
        loadPaperRow(session, kDefaultPaperRow);
        return Done{};
    }
    Result<ImportedMesh> imported = importMesh(meshPath);
    if (!imported) {
        return imported.error();
    }
    for (const QString& note : imported.value().notes) {
        out << "note: " << note << "\n";
    }
    loadMesh(session, std::move(imported.value().mesh), QFileInfo(meshPath).absoluteFilePath());
    return Done{};
}

}  // namespace hitscope::cli
