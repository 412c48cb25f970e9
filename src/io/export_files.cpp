// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/export_files.h"

#include <sys/stat.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <optional>

#include "io/export_names.h"
#include "io/file_scope.h"
#include "io/mtl_lines.h"
#include "io/save_image.h"

namespace hitscope {
namespace {

bool hasContent(const QString& path, const QByteArray& content) {
    QFile file(path);
    return QFileInfo(path).isFile() && file.open(QIODevice::ReadOnly) && file.size() == content.size() &&
           file.readAll() == content;
}

/// Where a file goes that the mesh's file calls `name`: the same way from the folder, if it leads down.
QString placeBelow(const QString& name) {
    QString local = name;
    local.replace(QLatin1Char('\\'), QLatin1Char('/'));
    const QString clean = QDir::cleanPath(local);
    const bool leadsDown = !QDir::isAbsolutePath(clean) && !clean.startsWith(QLatin1String("..")) &&
                           !clean.contains(QLatin1Char(':'));
    return leadsDown ? clean : QFileInfo(clean).fileName();
}

unsigned modeOf(const QString& path) {
    struct stat info {};
    return ::stat(QFile::encodeName(path).constData(), &info) == 0 ? info.st_mode & 0777 : 0600;
}

}  // namespace

bool ExportPlace::isOwnFolder() const {
    const QString source = QFileInfo(sourceFolder).canonicalFilePath();
    return !sourceFolder.isEmpty() && !source.isEmpty() && source == QFileInfo(folder).canonicalFilePath();
}

/// `name`, or with a number before its suffix, so that nothing else has it.
template <class IsSame>
QString MaterialFiles::freeName(const QString& name, const IsSame& isSame) const {
    const QDir folder(m_place.folder);
    const QFileInfo info(name);
    const QString before = info.path() == QLatin1String(".") ? QString() : info.path() + QLatin1Char('/');
    const QString suffix = info.suffix().isEmpty() ? QString() : QLatin1Char('.') + info.suffix();
    QString free = name;
    for (int n = 1;; ++n) {
        const QString path = folder.filePath(free);
        const QFileInfo there(path);
        const bool isTaken = there.exists() || there.isSymLink() || m_staged.holds(path);
        if (!isTaken || isSame(path)) {
            return free;
        }
        free = before + QStringLiteral("%1-%2%3").arg(info.completeBaseName()).arg(n).arg(suffix);
    }
}

QString MaterialFiles::freePath(const QString& name, const QByteArray& content) const {
    return QDir(m_place.folder).filePath(freeName(name, [&content](const QString& path) {
        return hasContent(path, content);
    }));
}

Result<std::string> MaterialFiles::placePicture(const std::string& name, bool inItsFolder) {
    const bool isPicture =
        std::find(m_mesh.pictureFiles.begin(), m_mesh.pictureFiles.end(), name) != m_mesh.pictureFiles.end();
    const QString given = fileNameText(name);
    const QString source = isPicture && !m_place.sourceFolder.isEmpty()
                               ? resolveTexture(m_place.sourceFolder, given)
                               : QString();
    if (source.isEmpty() || m_place.isOwnFolder()) {
        return name;
    }
    const QString wanted = inItsFolder ? placeBelow(given) : QFileInfo(source).fileName();
    const QString free = freeName(wanted, [this, &source](const QString& path) {
        const auto placed = m_placed.find(path);
        return placed != m_placed.end() ? placed->second == source : haveSameContent(path, source);
    });
    const QString path = QDir(m_place.folder).filePath(free);
    if (!m_placed.contains(path) && !QFileInfo::exists(path)) {
        if (const Status copied = m_staged.addCopy(source, path, kMaxTextureBytes); !copied) {
            return copied.error();
        }
    }
    m_placed.emplace(path, source);
    return free == wanted && inItsFolder ? name : free.toStdString();
}

Result<std::string> MaterialFiles::placeImage(int image) {
    const auto known = m_placedImages.find(image);
    if (known != m_placedImages.end()) {
        return known->second;
    }
    const QByteArray png = encodePng(m_mesh.images[static_cast<std::size_t>(image)]);
    const QString path =
        freePath(QStringLiteral("%1_texture%2.png").arg(m_place.baseName).arg(image + 1), png);
    if (!QFileInfo::exists(path)) {
        const std::string_view bytes(png.constData(), static_cast<std::size_t>(png.size()));
        if (const Status added = m_staged.add(path, bytes, StagedFiles::Existing::Keep); !added) {
            return added.error();
        }
    }
    return m_placedImages.emplace(image, QFileInfo(path).fileName().toStdString()).first->second;
}

Result<std::string> MaterialFiles::placeTexture(const std::string& name, int image) {
    const bool isThere = !name.empty() && !m_place.sourceFolder.isEmpty() &&
                         !resolveTexture(m_place.sourceFolder, fileNameText(name)).isEmpty();
    return image >= 0 && !isThere ? placeImage(image) : placePicture(name, false);
}

Result<std::vector<PlacedTextures>> MaterialFiles::placeTextures() {
    std::vector<PlacedTextures> placed;
    for (const Material& material : m_mesh.materials) {
        Result<std::string> diffuse = placeTexture(material.diffuseTexture, material.diffuseImage);
        if (!diffuse) {
            return diffuse.error();
        }
        Result<std::string> normals = placeTexture(material.normalMap.texture, material.normalMap.image);
        if (!normals) {
            return normals.error();
        }
        const MetalRoughness& metal = material.metalRoughness;
        Result<std::string> metalRoughness = placeTexture(metal.texture, metal.image);
        if (!metalRoughness) {
            return metalRoughness.error();
        }
        placed.push_back(
            {std::move(diffuse.value()), std::move(normals.value()), std::move(metalRoughness.value())});
    }
    return placed;
}

/// Whether that name leads to a file from the export's folder.
bool MaterialFiles::isAtPlace(std::string_view name) const {
    return !resolveTexture(m_place.folder, fileNameText(std::string(name))).isEmpty();
}

QByteArray MaterialFiles::withNewNames(const QByteArray& library, const QString& name) const {
    const char end = mtlLineEnd({library.constData(), static_cast<std::size_t>(library.size())});
    QList<QByteArray> lines = library.split(end);
    for (QByteArray& line : lines) {
        const std::optional<MtlMap> map = mtlMapOf({line.constData(), static_cast<std::size_t>(line.size())});
        const std::string texture =
            map ? textureOfLibrary(m_place.sourceFolder, name, std::string(map->name)) : std::string();
        auto renamed = map ? m_renamed.find(texture) : m_renamed.end();
        if (map && renamed == m_renamed.end()) {  // of a kind that is not drawn, known by its text
            renamed = m_renamed.find(fileNameText(texture).toStdString());
        }
        std::string now = renamed != m_renamed.end() ? renamed->second : std::string();
        if (map && now.empty() && texture != map->name && isAtPlace(map->name)) {
            now = texture;  // it lies beside the library; the other would be taken for it
        }
        if (!now.empty()) {
            line.replace(map->name.data() - line.constData(), static_cast<qsizetype>(map->name.size()),
                         QByteArray::fromStdString(now));
        }
    }
    return lines.join(end);
}

/// Empty: there is nothing to refer to.
Result<std::string> MaterialFiles::placeLibrary(const QString& name) {
    const QString source = resolveInside(m_place.sourceFolder, name);
    QFile file(source);
    if (source.isEmpty() || QFileInfo(source).size() > kMaxLibraryBytes || !file.open(QIODevice::ReadOnly)) {
        return std::string();
    }
    const QByteArray own = file.read(kMaxLibraryBytes);
    if (!definesMaterials({own.constData(), static_cast<std::size_t>(own.size())})) {
        return std::string();
    }
    const QString wanted = placeBelow(name);
    const auto known = m_placedLibraries.find({wanted, source});
    if (known != m_placedLibraries.end()) {
        return known->second;
    }
    const QByteArray content = withNewNames(own, name);
    const QString path = freePath(wanted, content);
    if (!QFileInfo::exists(path) && !m_staged.holds(path)) {
        const std::string_view bytes(content.constData(), static_cast<std::size_t>(content.size()));
        if (const Status added = m_staged.add(path, bytes, StagedFiles::Existing::Keep, modeOf(source));
            !added) {
            return added.error();
        }
    }
    const std::string placed = QDir(m_place.folder).relativeFilePath(path).toStdString();
    return m_placedLibraries.emplace(std::pair(wanted, source), placed).first->second;
}

Status MaterialFiles::placeLocated() {
    const auto place = [this](const std::string& name, int image) -> Status {
        const bool isThere = m_place.sourceFolder.isEmpty() ||
                             !resolveTexture(m_place.sourceFolder, fileNameText(name)).isEmpty();
        if (name.empty() || image < 0 || isThere || m_renamed.contains(name)) {
            return Done{};
        }
        const Result<std::string> placed = placeImage(image);
        if (!placed) {
            return placed.error();
        }
        m_renamed.emplace(name, placed.value());
        return Done{};
    };
    for (const Material& material : m_mesh.materials) {
        if (Status placed = place(material.diffuseTexture, material.diffuseImage); !placed) {
            return placed;
        }
        if (Status placed = place(material.normalMap.texture, material.normalMap.image); !placed) {
            return placed;
        }
        if (Status placed = place(material.metalRoughness.texture, material.metalRoughness.image); !placed) {
            return placed;
        }
    }
    return Done{};
}

Status MaterialFiles::placePictures() {
    if (!m_mesh.materialLibraries.empty()) {
        if (Status placed = placeLocated(); !placed) {
            return placed;
        }
    }
    if (m_place.isOwnFolder() && m_renamed.empty()) {
        return Done{};
    }
    for (const std::string& picture : m_mesh.pictureFiles) {
        const Result<std::string> placed = placePicture(picture, true);
        if (!placed) {
            return placed.error();
        }
        if (placed.value() != picture) {
            m_renamed.emplace(picture, placed.value());
        }
    }
    return Done{};
}

Result<std::vector<std::string>> MaterialFiles::placeLibraries() {
    std::vector<std::string> names;
    if (const Status placed = placePictures(); !placed) {
        return placed.error();
    }
    if (m_place.isOwnFolder() && m_renamed.empty()) {
        for (const std::string& line : m_mesh.materialLibraries) {
            names.push_back(nameOnLine(line));
        }
        return names;
    }
    for (const std::string& line : m_mesh.materialLibraries) {
        for (const QString& name : librariesOnLine(m_place.sourceFolder, fileNameText(line))) {
            const Result<std::string> placed = placeLibrary(name);
            if (!placed) {
                return placed.error();
            }
            const std::string& library = placed.value();
            if (!library.empty() && std::find(names.begin(), names.end(), library) == names.end()) {
                names.push_back(library);
            }
        }
    }
    return names;
}

Result<std::map<std::size_t, std::string>> MaterialFiles::placeLibraryLines() {
    std::map<std::size_t, std::string> lines;
    if (const Status placed = placePictures(); !placed) {
        return placed.error();
    }
    if (m_place.isOwnFolder() && m_renamed.empty()) {
        return lines;
    }
    for (std::size_t i = 0; i < m_mesh.materialLibraries.size(); ++i) {
        const QString line = fileNameText(m_mesh.materialLibraries[i]);
        std::string now;
        bool isNew = false;
        for (const QString& name : librariesOnLine(m_place.sourceFolder, line)) {
            const Result<std::string> placed = placeLibrary(name);
            if (!placed) {
                return placed.error();
            }
            const std::string own = name.toStdString();
            now += (now.empty() ? "" : " ") + (placed.value().empty() ? own : placed.value());
            isNew = isNew || (!placed.value().empty() && placed.value() != placeBelow(name).toStdString());
        }
        if (isNew) {
            lines.emplace(i, now);
        }
    }
    return lines;
}

}  // namespace hitscope
