// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/assimp_files.h"

#include <assimp/IOSystem.hpp>
#include <utility>

#include <assimp/MemoryIOWrapper.h>

#include <QFile>
#include <memory>

#include "io/file_scope.h"

namespace hitscope {
namespace {

class FolderFiles : public Assimp::IOSystem {
public:
    explicit FolderFiles(QString folder) : m_folder(std::move(folder)) {}

    bool Exists(const char* name) const override;
    [[nodiscard]] char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char* mode) override;
    void Close(Assimp::IOStream* stream) override;

private:
    QString m_folder;
};

}  // namespace

std::unique_ptr<Assimp::IOSystem> makeFolderFiles(const QString& folder) {
    return std::make_unique<FolderFiles>(folder);
}

bool FolderFiles::Exists(const char* name) const {
    return !resolveInside(m_folder, QString::fromUtf8(name)).isEmpty();
}

Assimp::IOStream* FolderFiles::Open(const char* name, const char* mode) {
    QFile file(resolveInside(m_folder, QString::fromUtf8(name)));
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
