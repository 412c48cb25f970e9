// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <string>
#include <string_view>

#include "io/imported_mesh.h"

namespace hitscope::test {

/// Writes a file and gives its path.
QString writeFile(const QString& folder, const QString& name, std::string_view content);

/// The whole file.
std::string readFile(const QString& path);

/// Names what differs between two meshes, name and materialLibraries apart; empty: they are equal in every
/// bit.
QStringList differences(const MeshData& a, const MeshData& b);

/// A PNG of 2 x 1 pixels: red, then half transparent green.
QByteArray smallPng();

/// Appends numbers to bytes as they lie in a little-endian file.
template <class Number>
void put(std::string& bytes, Number number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}
template <class Number, class... More>
void put(std::string& bytes, Number number, More... more) {
    put(bytes, number);
    put(bytes, more...);
}

/// The message of a failed result, or "no error".
template <class T>
QString messageOf(const Result<T>& result) {
    return result ? QStringLiteral("no error") : QString::fromStdString(result.error().message());
}

}  // namespace hitscope::test
