// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/read_mesh.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QFile>
#include <QFileInfo>

#include "io/content_hash.h"
#include "io/readers/assimp_reader.h"
#include "io/readers/mtl_reader.h"
#include "io/readers/obj_reader.h"
#include "io/readers/off_reader.h"
#include "io/readers/ply_reader.h"
#include "io/readers/stl_reader.h"
#include "io/readers/textures.h"

namespace hitscope {
namespace {

/// A file's content, mapped; the file must be a regular one.
class FileContent {
public:
    Status open(const QString& path) {
        // Not blocking: a pipe that took the file's place since it was checked must not hold us for ever.
        const int descriptor = ::open(QFile::encodeName(path).constData(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
        struct stat info {};
        if (descriptor < 0 || ::fstat(descriptor, &info) != 0 || !S_ISREG(info.st_mode)) {
            if (descriptor >= 0) {
                ::close(descriptor);
            }
            return Error{
                "The file cannot be opened.", {}, "Check that it is still there and that you may read it."};
        }
        m_file.open(descriptor, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle);
        if (m_file.size() == 0) {
            return Error{"The file is empty.", {}, "Save or download it again."};
        }
        const uchar* const data = m_file.map(0, m_file.size());
        if (!data) {
            return Error{"The file cannot be read: " + m_file.errorString().toStdString() + ".", {}, {}};
        }
        m_bytes = {reinterpret_cast<const char*>(data), static_cast<std::size_t>(m_file.size())};
        return Done{};
    }
    [[nodiscard]] std::string_view bytes() const { return m_bytes; }

private:
    QFile m_file;
    std::string_view m_bytes;
};

/// An export that copies the source must know that it still is what was read.
Result<ImportedMesh> withHash(Result<ImportedMesh> imported, std::string_view content) {
    if (imported) {
        imported.value().mesh.sourceHash = contentHash(content);
    }
    return imported;
}

Result<ImportedMesh> parseFile(const QString& path, const ProgressSink& progress) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    FileContent content;
    if (const Status opened = content.open(path); !opened) {
        return opened.error();
    }
    if (suffix == QStringLiteral("obj")) {
        if (content.bytes().starts_with("\xFF\xFE") || content.bytes().starts_with("\xFE\xFF")) {
            return Error{"It is text in UTF-16, in which no OBJ file is written.",
                         {},
                         "Open it in a text editor and save it as UTF-8."};
        }
        return withHash(parseObj(content.bytes(), progress), content.bytes());
    }
    if (suffix == QStringLiteral("ply")) {
        return withHash(parsePly(content.bytes(), progress), content.bytes());
    }
    if (suffix == QStringLiteral("stl")) {
        return parseStl(content.bytes(), progress);
    }
    if (suffix == QStringLiteral("off")) {
        return parseOff(content.bytes(), progress);
    }
    return readWithAssimp(path, content.bytes(), progress);
}

Status checkSurface(const MeshData& mesh, const QString& suffix) {
    const std::string format = suffix.toUpper().toStdString();
    if (mesh.positions.empty()) {
        return Error{"There are no vertices in it; is this really a file of the format " + format + "?",
                     {},
                     "Check that the file's suffix tells its format."};
    }
    if (mesh.faceCount() == 0) {
        return Error{"It has " + std::to_string(mesh.vertexCount()) +
                         (mesh.vertexCount() == 1 ? " vertex" : " vertices") +
                         " but no faces; Hitscope needs a surface.",
                     {},
                     "Make a surface of the points in another program, for instance MeshLab, and save that."};
    }
    return validate(mesh);
}

/// "bunny.obj, line 12"
Error withPlace(Error error, const QString& path) {
    const std::string file = path.toStdString();
    error.where = error.where.empty() ? file : file + ", " + error.where;
    return error;
}

}  // namespace

Result<ImportedMesh> readMesh(const QString& path, const ProgressSink& progress) {
    Result<ImportedMesh> imported = parseFile(path, progress);
    if (!imported) {
        return withPlace(imported.error(), path);
    }
    const QFileInfo info(path);
    if (const Status usable = checkSurface(imported.value().mesh, info.suffix()); !usable) {
        return withPlace(usable.error(), path);
    }
    const QString name = info.completeBaseName();  // which ".obj" has none of
    imported.value().mesh.name = (name.isEmpty() ? info.fileName() : name).toStdString();
    if (progress) {
        progress(1.0, "Reading materials and textures");
    }
    QStringList otherMaps;
    if (info.suffix().toLower() == QStringLiteral("obj")) {
        otherMaps = readMaterialLibraries(imported.value(), info.absolutePath());
    }
    readTextures(imported.value(), info.absolutePath(), otherMaps);
    if (const Status valid = validate(imported.value().mesh); !valid) {
        return withPlace(valid.error(), path);
    }
    return imported;
}

}  // namespace hitscope
