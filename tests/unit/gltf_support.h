// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <string>

namespace hitscope::test {

inline constexpr int kByte = 5120;
inline constexpr int kUnsignedByte = 5121;
inline constexpr int kShort = 5122;
inline constexpr int kUnsignedShort = 5123;
inline constexpr int kUnsigned = 5125;
inline constexpr int kFloatNumbers = 5126;

/// A glTF file in the making: one node with a mesh of one primitive, and numbers in one buffer.
struct GltfFile {
    QJsonObject attributes;  ///< of the primitive
    QJsonObject primitive;   ///< its other members
    QJsonArray accessors;
    QJsonArray views;
    QJsonObject more;  ///< members of the document, which replace the usual ones
    std::string numbers;

    /// Gives its index.
    int view(const std::string& bytes, int stride = 0);
    /// Gives its index; `other` members replace the usual ones.
    int accessor(int view, int componentType, const char* type, int count, const QJsonObject& other = {});

    /// `uri`: where the numbers are; empty: in the file, as base64.
    [[nodiscard]] std::string text(const QString& uri = {}) const;
    [[nodiscard]] std::string glb() const;

private:
    [[nodiscard]] QByteArray json(const QJsonObject& buffer) const;
};

/// Three corners of a triangle, of 12 bytes each: (0, 0, 0), (100, 0, 0), (0, 100, 0).
std::string triangleCorners();

/// The triangle of those corners.
GltfFile triangleFile();

}  // namespace hitscope::test
