// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>

namespace Assimp {
class IOSystem;
}

namespace hitscope {

/// All the files that Assimp gets to see: `file`, wherever that is if it is a link, and regular ones in its
/// folder and below it, read whole. Nothing can be written, and nothing else be read, whatever a mesh file
/// names. `namesAreUris`: those are percent-encoded where they must be, as in glTF.
[[nodiscard]] std::unique_ptr<Assimp::IOSystem> makeFolderFiles(const QString& file, bool namesAreUris);

}  // namespace hitscope
