// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <map>
#include <memory>
#include <vector>

#include "core/result.h"
#include "document/mesh_references.h"
#include "document/open_document.h"
#include "document/session_document.h"

namespace hitscope {

/// A file that is to lie in a folder.
struct CollectedFile {
    QString source;
    QString place;  ///< from the folder, with '/'; it leads down

    bool operator==(const CollectedFile&) const = default;
};

/// A session with all that it refers to, in one folder.
struct Collection {
    SessionDocument document;          ///< of files in that folder, named from there
    std::vector<CollectedFile> files;  ///< each place once
    QStringList notes;                 ///< what cannot be collected, in words
};

/// What the meshes name, by the paths in the document.
using ReferencesByMesh = std::map<QString, std::vector<MeshReference>>;

/// Where each file goes: a mesh into a folder of its own below "meshes", which meshes of one folder share,
/// with what it names at the places where it looks for them; located textures into "textures". Looks at no
/// file.
[[nodiscard]] Collection planCollection(SessionDocument document, const ReferencesByMesh& references);

/// Meshes as they were read, by the paths in the document.
using MeshesByPath = std::map<QString, std::shared_ptr<const MeshData>>;

/// Writes a session, its meshes and what these name into `folder`, which is made where it is not there; all
/// or nothing, and in place of no file. `name` is the session file's. Returns the notes. Fails where a mesh
/// is gone or is not what it was when it was read. On any thread.
[[nodiscard]] Result<QStringList> collectSession(SessionDocument document, const MeshesByPath& meshes,
                                                 const QString& folder, const QString& name,
                                                 const PrepareControl& control = {});

}  // namespace hitscope
