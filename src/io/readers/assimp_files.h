// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>
#include <string_view>

namespace Assimp {
class IOSystem;
}

namespace hitscope {

/// The texts must live as long as the files are read.
struct FolderFilesOptions {
    bool namesAreUris = false;   ///< percent-encoded where they must be, as in glTF
    std::string_view document;   ///< what is in the file for Assimp; empty: what is there
    const char* otherName = "";  ///< of a file in its folder that is only in memory
    std::string_view other;      ///< what is in that; empty: there is no such file
};

/// All the files that Assimp gets to see: `file`, wherever that is if it is a link, and regular ones in its
/// folder and below it, read whole. Nothing can be written, and nothing else be read, whatever a mesh file
/// names.
[[nodiscard]] std::unique_ptr<Assimp::IOSystem> makeFolderFiles(const QString& file,
                                                                const FolderFilesOptions& options);

}  // namespace hitscope
