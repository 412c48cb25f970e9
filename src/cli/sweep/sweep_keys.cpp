// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep_keys.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

#include "cli/opened_scene.h"
#include "document/mesh_references.h"
#include "document/open_document.h"
#include "document/session_file.h"

namespace hitscope::cli {

QByteArray SweepKeys::contentOf(const QString& path) {
    QByteArray& hash = m_files[path];
    QFile file(path);
    QCryptographicHash made(QCryptographicHash::Sha256);
    if (hash.isEmpty() && file.open(QIODevice::ReadOnly) && made.addData(&file)) {
        hash = made.result().toHex();
    }
    return hash;
}

QByteArray SweepKeys::sceneOf(const QString& path) {
    QByteArray& scene = m_scenes[path];
    const QByteArray content = scene.isEmpty() ? contentOf(path) : QByteArray();
    if (!content.isEmpty()) {
        // The same bytes are another mesh, or none, in another format.
        scene = QFileInfo(path).suffix().toLower().toUtf8() + '=' + content +
                (namesSession(path) ? meshesOf(path) : buffersOf(path));
    }
    return scene;
}

QByteArray SweepKeys::buffersOf(const QString& meshPath) {
    QByteArray hashes;
    for (const MeshReference& buffer : hitscope::buffersOf(meshPath)) {
        hashes += ',' + contentOf(buffer.path);
    }
    return hashes;
}

QByteArray SweepKeys::meshesOf(const QString& sessionPath) {
    Result<SessionDocument> document = readSessionFile(sessionPath);
    if (!document) {
        return {};  // its job says what is wrong
    }
    MeshPlaces places;
    places.folder = QFileInfo(sessionPath).absolutePath();
    QByteArray hashes;
    for (const MeshFile& mesh : meshFilesOf(std::move(document).value(), places)) {
        hashes += '\n' + QByteArray::fromStdString(mesh.sha256) + buffersOf(mesh.path);
    }
    return hashes;
}

}  // namespace hitscope::cli
