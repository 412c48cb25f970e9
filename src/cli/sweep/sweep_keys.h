// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <map>

namespace hitscope::cli {

/// Hashes of what goes into a sweep's jobs. Each file is read once.
class SweepKeys {
public:
    /// Of a file; empty: it cannot be read.
    [[nodiscard]] QByteArray contentOf(const QString& path);
    /// Of a scene: its format, its content, and that of the files that its shape comes from, which are the
    /// buffers of a glTF, and the meshes of a session with theirs. Materials and pictures change no result.
    /// The same wherever the scene's folder is. Empty: it cannot be read.
    [[nodiscard]] QByteArray sceneOf(const QString& path);

private:
    [[nodiscard]] QByteArray buffersOf(const QString& meshPath);
    [[nodiscard]] QByteArray meshesOf(const QString& sessionPath);

    std::map<QString, QByteArray> m_files;
    std::map<QString, QByteArray> m_scenes;
};

}  // namespace hitscope::cli
