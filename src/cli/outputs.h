// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include "core/result.h"
#include "usage/invocation.h"

namespace hitscope {
struct MeshData;
class Session;
}  // namespace hitscope

namespace hitscope::cli {

/// What is wrong with the files that a command line names, before anything is done: two that it writes are
/// one, one is read by it as well, two go to the standard output or come from the standard input, or a suffix
/// belongs to files of another kind. A session may be written to the file that it was read from. Empty:
/// nothing.
[[nodiscard]] QString wrongOutputs(const Invocation& given);

/// An error where a file is to be written into a folder that is not there, or onto a folder: before anything
/// is done. Nothing is said of verbs that make folders.
[[nodiscard]] Status checkFolders(const Invocation& given);

/// Keeps what the command line writes, for what follows.
void keepOutputs(const Invocation& given);
/// Likewise files that the folder will have, of names that were not known then; `as`: what names the folder.
void keepOutputs(const QString& as, const QStringList& paths);
/// An error where one of these is a file that a target was read from, or one that this refers to: a session
/// would refer to a mesh with dents, and apply its hits to it again.
[[nodiscard]] Status checkSources(const Session& session);
/// An error where one of these is a file that a mesh refers to: its materials, buffers or pictures.
[[nodiscard]] Status checkReferences(const QString& name, const QString& path, const MeshData& mesh);
/// Whether one of these checks ended with an error: nothing may be written then.
[[nodiscard]] bool areOutputsRefused();

/// Whether some file is written to the standard output, the report apart: nothing else is printed there then.
[[nodiscard]] bool isOutputTaken(const Invocation& given);

}  // namespace hitscope::cli
