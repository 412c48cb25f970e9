// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "core/image.h"
#include "core/result.h"
#include "document/session_document.h"
#include "session/session_undo.h"

namespace hitscope {

class Session;

/// Where a session's mesh files may be.
struct MeshPlaces {
    QString folder;                    ///< the session file's: relative paths start here; empty: not known
    std::map<QString, QString> found;  ///< by the path in the document: what a person chose in its place
    QStringList others;                ///< folders where files of the same name are looked for, last
};

/// A mesh that is not what it was.
struct MeshTrouble {
    enum class Kind : std::uint8_t {
        Missing,   ///< no file, or none that can be read as a mesh: its targets and hits are left out
        Changed,   ///< another content than when the session was saved; opened all the same
        NotKnown,  ///< the session does not say what it was made from: left out
    };
    Kind kind = Kind::Missing;
    QString path;  ///< in the document: a key of MeshPlaces::found
    std::vector<TargetId> targets;
    std::size_t hits = 0;  ///< on them
    Error error;           ///< in words for the person; what() of Changed says what will happen
};

/// A document with all that takes time to make.
struct PreparedSession {
    SessionDocument document;
    SceneState scene;
    std::shared_ptr<const Image> coverTexture;  ///< null: none
    std::vector<MeshTrouble> troubles;          ///< to be told before it is restored
    QStringList notes;  ///< of the import, and of what the document has that is not known

    [[nodiscard]] bool isWhole() const;  ///< nothing is left out
};

/// How it goes, and whether it is still wanted. Called from the thread that prepares.
struct PrepareControl {
    std::function<void(double fraction, const QString& doing)> progress = {};
    const std::atomic<bool>* cancelled = nullptr;
    [[nodiscard]] bool isCancelled() const { return cancelled != nullptr && *cancelled; }
};

/// Makes the targets of a document from their sources: imports, builds, hashes. On any thread, and for as
/// long as the meshes take; fails where it was cancelled or memory ran out, and not for meshes that are
/// missing or changed: these are among the troubles. A mesh that several targets share is made once.
[[nodiscard]] Result<PreparedSession> prepareSession(SessionDocument document, const MeshPlaces& places,
                                                     const PrepareControl& control = {});

/// The files that the meshes of its targets are made from, as they are now: each target's, in their order, as
/// prepareSession() finds it. Those that are not there are left out. Reads all of them; on any thread.
[[nodiscard]] std::vector<MeshFile> meshFilesOf(SessionDocument document, const MeshPlaces& places);

/// Makes a session what the document says; nothing can be undone after it. On the session's thread. Cameras
/// and display are the window's to take. Targets get ids that the session never had, in `prepared` too: what
/// is still on its way for others is not taken for theirs.
void restoreSession(Session& session, PreparedSession& prepared);

/// The targets whose positions are now known, and are not those that the document has.
[[nodiscard]] std::vector<TargetId> differingTargets(const Session& session, const SessionDocument& document);

}  // namespace hitscope
