// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/assimp_files.h"

#include <assimp/IOSystem.hpp>
#include <utility>

#include <assimp/MemoryIOWrapper.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QUrl>
#include <memory>

#include "io/file_scope.h"

namespace hitscope {
namespace {

class FolderFiles : public Assimp::IOSystem {
public:
    FolderFiles(QString file, const FolderFilesOptions& options)
        : m_file(std::move(file)), m_folder(QFileInfo(m_file).absolutePath()), m_options(options) {}

    bool Exists(const char* name) const override;
    [[nodiscard]] char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

private:
    /// Empty: it is none of them.
    [[nodiscard]] QString find(const char* name) const;
    /// Empty: it is not in memory.
    [[nodiscard]] std::string_view inMemory(const char* name) const;

    QString m_file;
    QString m_folder;
    FolderFilesOptions m_options;
};

}  // namespace

std::unique_ptr<Assimp::IOSystem> makeFolderFiles(const QString& file, const FolderFilesOptions& options) {
    return std::make_unique<FolderFiles>(file, options);
}

QString FolderFiles::find(const char* name) const {
    const QString wanted = QString::fromUtf8(name);
    if (wanted == m_file) {
        return m_file;
    }
    QString direct = resolveInside(m_folder, wanted);
    if (!direct.isEmpty() || !m_options.namesAreUris || !wanted.startsWith(m_folder)) {
        return direct;
    }
    // Assimp puts the folder before the name; it may have a percent sign of its own.
    const QByteArray uri = wanted.mid(m_folder.size()).toUtf8();
    return resolveInside(m_folder, m_folder + QUrl::fromPercentEncoding(uri));
}

std::string_view FolderFiles::inMemory(const char* name) const {
    const QString wanted = QString::fromUtf8(name);
    if (wanted == m_file) {
        return m_options.document;
    }
    const bool isOther = wanted == QDir(m_folder).filePath(QString::fromLatin1(m_options.otherName));
    return isOther ? m_options.other : std::string_view();
}

bool FolderFiles::Exists(const char* name) const {
    return !inMemory(name).empty() || !find(name).isEmpty();
}

Assimp::IOStream* FolderFiles::Open(const char* name, const char* mode) {
    if (const std::string_view bytes = inMemory(name); !bytes.empty()) {
        return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    }
    QFile file(find(name));
    if (file.fileName().isEmpty() || !mode || mode[0] != 'r' || !file.open(QIODevice::ReadOnly)) {
        return nullptr;
    }
    const auto size = static_cast<std::size_t>(file.size());
    auto bytes = std::make_unique<std::uint8_t[]>(size);
    if (file.read(reinterpret_cast<char*>(bytes.get()), file.size()) != file.size()) {
        return nullptr;
    }
    constexpr bool kOwnsBytes = true;
    return new Assimp::MemoryIOStream(bytes.release(), size, kOwnsBytes);
}

void FolderFiles::Close(Assimp::IOStream* stream) {
    delete stream;
}

}  // namespace hitscope
