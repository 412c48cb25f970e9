// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <assimp/IOSystem.hpp>

namespace hitscope {

/// All the files that Assimp gets to see: regular ones in one folder and below it, read whole. Nothing can be
/// written, and nothing outside be read, whatever a mesh file names.
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

}  // namespace hitscope
