// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>

#include "deform/deformed_mesh.h"
#include "deform/hit.h"

namespace hitscope {

/// 64 bits that tell two results apart: FNV-1a (offset basis 14695981039346656037, prime 1099511628211) over
/// bytes, every number with its lowest byte first on any machine, floats and doubles by their IEEE 754 bits.
class Fingerprint {
public:
    void add(std::uint8_t number) { addBytes(number, 1); }
    void add(std::uint32_t number) { addBytes(number, 4); }
    void add(std::uint64_t number) { addBytes(number, 8); }
    void add(float number);
    void add(double number);
    void add(const glm::vec3& v);  ///< x, y, z
    [[nodiscard]] std::uint64_t value() const { return m_value; }

private:
    void addBytes(std::uint64_t number, int count);

    std::uint64_t m_value = 14695981039346656037u;
};

/// As people read it: 16 hexadecimal digits, lower case.
[[nodiscard]] std::string fingerprintText(std::uint64_t fingerprint);

/// Of hits, whatever pipeline or renderer applied them. The number of hits (64 bits), and of each hit in
/// order: the place of its target in `targets` from 0 (32 bits; their number where it is none of them),
/// point, direction, normal (3 floats each), max_distance, power, max_magnitude (floats), time (a double),
/// speed, impulse (floats), triangle (32 bits), enabled (a byte, 0 or 1); of a hit whose form is not the
/// paper's also profile and direction (a byte each, their places in kDentProfileKeys and kDentDirectionKeys
/// from 0), the radius that presses (a float; else 0) and the ordinates of the curve (8 floats; the usual
/// ones of another profile). The sign of a zero does not count: readers of JSON lose it. Hit::pipeline,
/// Hit::flight and Hit::group do not count either; they deform nothing.
[[nodiscard]] std::uint64_t hitsFingerprint(std::span<const Hit> hits, std::span<const TargetId> targets);

/// Of positions as the active pipeline made them, to the last bit, the sign of zeros among it. The number of
/// targets (64 bits), and of each target in order: the number of its file's vertices (64 bits) and, in the
/// file's order, x, y and z of each (3 floats; metres, local frame).
[[nodiscard]] std::uint64_t positionsFingerprint(std::span<const DeformedMesh* const> targets);
/// Of one target, whose positions these are. Long work that may be given up.
[[nodiscard]] std::uint64_t positionsFingerprint(std::span<const glm::vec3> positions);

}  // namespace hitscope
