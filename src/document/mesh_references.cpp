// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh_references.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QUrl>
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

/// The files that a list of a glTF names, as it is written and as it is meant; what is in the file itself has
/// "data:".
QStringList urisOf(const QJsonObject& gltf, const QString& list) {
    QStringList names;
    for (const QJsonValue& entry : gltf.value(list).toArray()) {
        const QString uri = entry.toObject().value(QStringLiteral("uri")).toString();
        if (!uri.isEmpty() && !uri.startsWith(QLatin1String("data:"))) {
            names << uri << QUrl::fromPercentEncoding(uri.toUtf8());
        }
    }
    return names;
}

}  // namespace

std::vector<MeshReference> referencesOf(const QString& meshPath, const MeshData& mesh) {
    return referencesIn(meshPath, mesh).found();
}

std::vector<MeshReference> allReferencesOf(const QString& meshPath, const MeshData& mesh) {
    References references = referencesIn(meshPath, mesh);
    QFile file(meshPath);
    if (QFileInfo(meshPath).suffix().toLower() == QLatin1String("gltf") && file.open(QIODevice::ReadOnly)) {
        const QJsonObject gltf = QJsonDocument::fromJson(file.readAll()).object();
        for (const QString& name : urisOf(gltf, QStringLiteral("buffers"))) {
            references.addData(name);
        }
        for (const QString& name : urisOf(gltf, QStringLiteral("images"))) {
            references.addPicture(name);
        }
    }
    return references.found();
}

}  // namespace hitscope
