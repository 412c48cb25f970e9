// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>
#include <string>
#include <string_view>

namespace hitscope {

/// The name of the buffer that decodeGltf() adds.
inline constexpr const char* kDecodedGltfBuffer = "hitscope:decoded";

/// Makes floats, one after the other, of those numbers of a file of version 2 that Assimp would take for that
/// and that are not: positions, normals, tangents and texture coordinates of small integers, and all whose
/// sparse replacements it would put between interleaved ones. `binary`: the buffer in the file itself;
/// `folder`: where others are. Changes their accessors in `root`, and gives the buffer that these refer to;
/// empty: there are none. BadGltf: the numbers are none that their attribute may have, or are not there.
[[nodiscard]] std::string decodeGltf(QJsonObject& root, std::string_view binary, const QString& folder);

}  // namespace hitscope
