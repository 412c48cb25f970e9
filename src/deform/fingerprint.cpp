// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/fingerprint.h"

#include <algorithm>
#include <bit>

#include "core/give_up.h"

namespace hitscope {

namespace {

constexpr std::uint64_t kPrime = 1099511628211u;
constexpr int kByteBits = 8;

template <class Number>
Number unsignedZero(Number number) {
    return number == Number(0) ? Number(0) : number;
}

glm::vec3 unsignedZero(const glm::vec3& v) {
    return {unsignedZero(v.x), unsignedZero(v.y), unsignedZero(v.z)};
}

void addForm(Fingerprint& print, const DentForm& form) {
    print.add(static_cast<std::uint8_t>(form.profile));
    print.add(static_cast<std::uint8_t>(form.direction));
    print.add(unsignedZero(form.radius));
    for (const float ordinate : form.curve) {
        print.add(unsignedZero(ordinate));
    }
}

void addPositions(Fingerprint& print, std::span<const glm::vec3> positions) {
    print.add(std::uint64_t{positions.size()});
    for (std::size_t v = 0; v < positions.size(); ++v) {
        mayGiveUp(v);
        print.add(positions[v]);
    }
}

}  // namespace

void Fingerprint::addBytes(std::uint64_t number, int count) {
    for (int i = 0; i < count; ++i) {
        m_value = (m_value ^ (number & 0xffu)) * kPrime;
        number >>= kByteBits;
    }
}

void Fingerprint::add(float number) {
    add(std::bit_cast<std::uint32_t>(number));
}

void Fingerprint::add(double number) {
    add(std::bit_cast<std::uint64_t>(number));
}

void Fingerprint::add(const glm::vec3& v) {
    add(v.x);
    add(v.y);
    add(v.z);
}

std::string fingerprintText(std::uint64_t fingerprint) {
    constexpr int kDigits = 16;
    constexpr int kDigitBits = 4;
    std::string text(kDigits, '0');
    for (auto digit = text.rbegin(); digit != text.rend(); ++digit) {
        *digit = "0123456789abcdef"[fingerprint & 0xfu];
        fingerprint >>= kDigitBits;
    }
    return text;
}

std::uint64_t hitsFingerprint(std::span<const Hit> hits, std::span<const TargetId> targets) {
    Fingerprint print;
    print.add(std::uint64_t{hits.size()});
    for (const Hit& hit : hits) {
        const auto target = std::find(targets.begin(), targets.end(), hit.target);
        print.add(static_cast<std::uint32_t>(target - targets.begin()));
        print.add(unsignedZero(hit.point));
        print.add(unsignedZero(hit.direction));
        print.add(unsignedZero(hit.normal));
        print.add(unsignedZero(hit.constants.maxDistance));
        print.add(unsignedZero(hit.constants.power));
        print.add(unsignedZero(hit.constants.maxMagnitude));
        print.add(unsignedZero(hit.time));
        print.add(unsignedZero(hit.speed));
        print.add(unsignedZero(hit.impulse));
        print.add(hit.triangle);
        print.add(static_cast<std::uint8_t>(hit.enabled ? 1 : 0));
        if (!hit.form.isPaper()) {
            addForm(print, hit.form);
        }
    }
    return print.value();
}

std::uint64_t positionsFingerprint(std::span<const DeformedMesh* const> targets) {
    Fingerprint print;
    print.add(std::uint64_t{targets.size()});
    for (const DeformedMesh* target : targets) {
        addPositions(print, target->positions());
    }
    return print.value();
}

std::uint64_t positionsFingerprint(std::span<const glm::vec3> positions) {
    Fingerprint print;
    print.add(std::uint64_t{1});
    addPositions(print, positions);
    return print.value();
}

}  // namespace hitscope
