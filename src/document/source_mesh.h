// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "document/open_document.h"
#include "io/imported_mesh.h"
#include "session/target_plan.h"

namespace hitscope {

/// The file that a target's mesh is to be read from: the first that has the content that is wanted, else the
/// first that is there. Nothing: none is, or the mesh comes from no file.
[[nodiscard]] std::optional<MeshFile> findMesh(const SavedTarget& target, const MeshPlaces& places);

/// Makes meshes of saved targets from their sources, each once. On any thread.
class SourceMeshes {
public:
    /// All outlive this; what is wrong is added to `troubles`, what an import says to `notes`.
    SourceMeshes(const MeshPlaces& places, const PrepareControl& control, std::vector<MeshTrouble>& troubles,
                 QStringList& notes)
        : m_places(places), m_control(control), m_troubles(troubles), m_notes(notes) {}

    /// With the mesh's own name and place; null: it cannot be made, which is among the troubles.
    const TargetPlan* planOf(const SavedTarget& target);

private:
    std::optional<TargetPlan> make(const SavedTarget& target);
    std::optional<TargetPlan> import(const SavedTarget& target, const MeshFile& file);
    /// What was done to the mesh is done to it again.
    std::optional<MeshData> stepped(const SavedTarget& target, MeshData mesh, MeshSteps& steps);
    void note(const SavedTarget& target, MeshTrouble::Kind kind, const Error& error);
    /// Gives the mesh its pictures that were found elsewhere; returns where they are now.
    std::vector<LocatedTexture> addTextures(const SavedTarget& target, MeshData& mesh);
    [[nodiscard]] QString placeOf(const LocatedTexture& texture) const;

    [[nodiscard]] Result<ImportedMesh> importFile(const QString& path) const;

    const MeshPlaces& m_places;
    const PrepareControl& m_control;
    std::vector<MeshTrouble>& m_troubles;
    QStringList& m_notes;
    struct Made {
        std::optional<TargetPlan> plan;
        std::size_t firstTrouble = 0;  ///< of those that it met
        std::size_t endOfTroubles = 0;
    };
    std::map<std::string, Made> m_made;  ///< by what it was made from
};

}  // namespace hitscope
