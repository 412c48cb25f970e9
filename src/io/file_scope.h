// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <string>

namespace hitscope {

inline constexpr qint64 kMaxTextureBytes = 512ll << 20;  ///< of one picture's file
inline constexpr qint64 kMaxLibraryBytes = 64 << 20;     ///< of one MTL file

/// A file's name as a mesh or MTL file has it, of any bytes: read as UTF-8, or, where it is none, as Latin-1,
/// which older programs wrote.
[[nodiscard]] QString fileNameText(const std::string& bytes);

/// The canonical path of `name` (relative to `folder`, or absolute) if it is a regular, readable file inside
/// `folder` once every link and ".." is followed; empty otherwise. Backslashes count as separators. A mesh
/// file names other files, and must not be able to name any file of the person's.
[[nodiscard]] QString resolveInside(const QString& folder, const QString& name);

/// The same for the URI of a glTF file, whose blanks and letters beyond ASCII are written as "%20": as it is
/// written, for those who do not know that; decoded otherwise.
[[nodiscard]] QString resolveUri(const QString& folder, const QString& uri);

/// The same for a texture: files from other machines name "C:\textures\wood.png", and the file of that name
/// in `folder` is meant.
[[nodiscard]] QString resolveTexture(const QString& folder, const QString& name);

/// The name of a texture that a glTF file names by a URI: decoded if only so a file is found.
[[nodiscard]] QString textureOfUri(const QString& folder, const QString& uri);

/// The name of a texture that the MTL file `library` names, from the mesh's folder: as it is written, or from
/// that file's own folder where only this leads to a file.
[[nodiscard]] std::string textureOfLibrary(const QString& folder, const QString& library,
                                           const std::string& name);

/// The file names of an MTL line, which may hold one name with blanks in it, or several names.
[[nodiscard]] QStringList librariesOnLine(const QString& folder, const QString& line);

}  // namespace hitscope
