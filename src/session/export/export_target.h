// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/result.h"
#include "deform/hit.h"
#include "session/export/export_options.h"
#include "session/export/export_progress.h"
#include "session/target.h"

namespace hitscope {

class Session;

/// A target as it is on the screen at one moment: what another thread needs to write it. The window waits
/// while it is made, so it holds only what differs from the original; that thread calls complete().
struct TargetExport {
    TargetId id;
    std::string name;  ///< for people
    std::shared_ptr<const MeshData> original;
    std::shared_ptr<const RenderMesh> render;
    RigidTransform transform;
    /// One a file vertex, local frame, metres; empty: the original's, except those of `changed`.
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> changed;       ///< file vertices
    std::vector<glm::vec3> changedPositions;  ///< one for each of them
    /// One a render vertex, unit length; null: those of `turned`, or else the render mesh's.
    std::shared_ptr<const std::vector<glm::vec3>> normals;
    std::optional<TurnedNormals> turned;
    QString sourcePath;  ///< empty: none

    /// Makes all positions and normals out of what differs from the original.
    void complete();
};

/// Targets that are written into one file.
struct SceneExport {
    std::vector<TargetExport> targets;  ///< one at least; several become one mesh
    std::vector<Hit> hits;              ///< those that made what is shown
    ExportOptions options;
    std::function<void()> beforeStep = {};  ///< StagedFiles' own; for tests

    [[nodiscard]] bool isMerged() const { return targets.size() > 1; }
    /// In the coordinates of the scene, with a copy of all that it takes.
    [[nodiscard]] bool isPlaced() const { return isMerged() || options.inWorld; }
    [[nodiscard]] bool needsHits() const;  ///< how many hits moved each vertex
    [[nodiscard]] bool hasSteps() const { return traitsOf(options.format).hasSteps && options.steps > 0; }
};

/// What came of it.
struct ExportReport {
    QStringList notes;         ///< for the person: what the format does not hold
    bool wasReadBack = false;  ///< and it is what was meant
};

/// Copies of what hits change, as far as they do; the rest is shared. The targets' read-back is current.
[[nodiscard]] SceneExport copyForExport(const Session& session, std::span<const Target* const> targets,
                                        const ExportOptions& options);

/// Writes them to a file, in the files' own order. Of any thread. What is not read back as it was meant is an
/// error, and the file is there.
[[nodiscard]] Result<ExportReport> writeExport(SceneExport what, const QString& path,
                                               const ExportProgress::Told& told = {});

/// Both at once, for one target as it is on the screen.
[[nodiscard]] Result<ExportReport> exportTarget(const Session& session, const Target& target,
                                                const QString& path, const ExportOptions& options);

}  // namespace hitscope
