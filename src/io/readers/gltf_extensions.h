// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QStringList>

namespace hitscope {

/// Which extensions a glTF file needs and uses: notes on what is not shown of it. BadGltf: it says that it
/// cannot be read without one that is not known here.
[[nodiscard]] QStringList checkGltfExtensions(const QJsonObject& root);

}  // namespace hitscope
