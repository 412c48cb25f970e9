// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <string>
#include <variant>

namespace hitscope {

enum class PrimitiveKind : std::uint8_t { Cube, UvSphere, GeodesicSphere, Torus, Cylinder, Sheet, Turntable };

/// A shape that can be made in any fineness.
struct Primitive {
    PrimitiveKind kind = PrimitiveKind::Cube;
    int resolution = 32;  ///< within the kind's range, or it is brought there
    static constexpr float kLeastSize = 1.0e-6f;
    static constexpr float kMostSize = 1.0e9f;
    float size = 5.0f;  ///< metres: its largest extent, from kLeastSize to kMostSize

    bool operator==(const Primitive&) const = default;
};

/// Meshes of our own that are always the same.
enum class BuiltInMesh : std::uint8_t {
    Teapot,          ///< as the window opens on, and as on the turntable
    LowPolyCube,     ///< this and the next three: the paper's
    HighPolyCube,    ///< likewise
    LowPolySphere,   ///< likewise
    HighPolySphere,  ///< likewise
    TurntableStand,
    FineTorus,  ///< of 2,000,000 triangles
};

/// A file as it was when its mesh was read.
struct MeshFile {
    QString path;             ///< absolute
    std::uint64_t size = 0;   ///< bytes
    std::string sha256 = {};  ///< of its content, 64 hexadecimal digits, lower case; empty: not known

    bool operator==(const MeshFile&) const = default;
};

/// A picture that a mesh file names and that was found elsewhere.
struct LocatedTexture {
    std::string name;           ///< as the mesh file has it
    QString path;               ///< absolute
    QString relativePath = {};  ///< in a session file: from its folder, with '/'; empty: not known

    bool operator==(const LocatedTexture&) const = default;
};

/// What a target's mesh can be made from again. monostate: not known.
using TargetSource = std::variant<std::monostate, Primitive, BuiltInMesh, MeshFile>;

}  // namespace hitscope
