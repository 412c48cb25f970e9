// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh_references.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QUrl>
#include <QtEndian>
#include <algorithm>

#include "io/file_scope.h"

namespace hitscope {

namespace {

class References {
public:
    explicit References(const QString& meshPath) : m_folder(QFileInfo(meshPath).absolutePath()) {}

    void addLibraries(const std::string& line) {
        for (const QString& name : librariesOnLine(m_folder, fileNameText(line))) {
            addData(name);
        }
    }
    void addData(const QString& name) { add({name, resolveInside(m_folder, name)}); }
    void addPicture(const QString& name) {
        if (const QString direct = resolveInside(m_folder, name); !direct.isEmpty()) {
            add({name, direct, MeshReference::Kind::Picture});
        } else {
            add({name, resolveTexture(m_folder, name), MeshReference::Kind::PictureByName});
        }
    }

    [[nodiscard]] std::vector<MeshReference> found() const { return m_found; }

private:
    void add(const MeshReference& reference) {
        const bool isKnown =
            std::any_of(m_found.begin(), m_found.end(), [&reference](const MeshReference& known) {
                return known.path == reference.path && known.name == reference.name;
            });
        if (!reference.path.isEmpty() && !isKnown) {
            m_found.push_back(reference);
        }
    }

    QString m_folder;
    std::vector<MeshReference> m_found;
};

References referencesIn(const QString& meshPath, const MeshData& mesh) {
    References references(meshPath);
    for (const std::string& line : mesh.materialLibraries) {
        references.addLibraries(line);
    }
    for (const std::string& name : mesh.pictureFiles) {
        references.addPicture(fileNameText(name));
    }
    return references;
}

/// The JSON of a glTF, text or binary; empty: it is none.
QJsonObject gltfOf(const QString& meshPath) {
    constexpr qint64 kHeader = 20;  // of a binary file, before its JSON; the same in both versions
    constexpr qsizetype kLength = 12;
    const QString suffix = QFileInfo(meshPath).suffix().toLower();
    const bool isBinary = suffix == QLatin1String("glb");
    QFile file(meshPath);
    if ((!isBinary && suffix != QLatin1String("gltf")) || !file.open(QIODevice::ReadOnly)) {
        return {};
    }
    if (!isBinary) {
        return QJsonDocument::fromJson(file.readAll()).object();
    }
    const QByteArray header = file.read(kHeader);
    if (header.size() < kHeader) {
        return {};
    }
    const auto length = qFromLittleEndian<quint32>(header.constData() + kLength);
    return QJsonDocument::fromJson(file.read(std::min<qint64>(length, file.size()))).object();
}

/// The files that a list of a glTF names, as it is written and as it is meant; what is in the file itself has
/// "data:". Version 1 has objects in place of lists.
QStringList urisOf(const QJsonObject& gltf, const QString& list) {
    QStringList names;
    const QJsonValue things = gltf.value(list);
    const auto add = [&names](const QJsonValue& entry) {
        const QString uri = entry.toObject().value(QStringLiteral("uri")).toString();
        if (!uri.isEmpty() && !uri.startsWith(QLatin1String("data:"))) {
            names << uri << QUrl::fromPercentEncoding(uri.toUtf8());
        }
    };
    for (const QJsonValue& entry : things.toArray()) {
        add(entry);
    }
    for (const QJsonValue& entry : things.toObject()) {
        add(entry);
    }
    return names;
}

void addBuffers(References& references, const QJsonObject& gltf) {
    for (const QString& name : urisOf(gltf, QStringLiteral("buffers"))) {
        references.addData(name);
    }
}

}  // namespace

std::vector<MeshReference> referencesOf(const QString& meshPath, const MeshData& mesh) {
    return referencesIn(meshPath, mesh).found();
}

std::vector<MeshReference> buffersOf(const QString& meshPath) {
    References references(meshPath);
    addBuffers(references, gltfOf(meshPath));
    return references.found();
}

std::vector<MeshReference> allReferencesOf(const QString& meshPath, const MeshData& mesh) {
    References references = referencesIn(meshPath, mesh);
    const QJsonObject gltf = gltfOf(meshPath);
    addBuffers(references, gltf);
    for (const QString& name : urisOf(gltf, QStringLiteral("images"))) {
        references.addPicture(name);
    }
    return references.found();
}

}  // namespace hitscope
