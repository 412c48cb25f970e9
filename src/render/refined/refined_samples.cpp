// SPDX-License-Identifier: GPL-3.0-or-later
// What the samples of a refined picture differ by.
#include <cmath>
#include <cstdint>
#include <glm/gtc/constants.hpp>

#include "render/refined/refined_picture.h"

namespace hitscope {
namespace {

constexpr float kGoldenAngle = 2.3999632f;

/// The number's digits to that base, behind the point in turned order (van der Corput).
float turned(int number, int base) {
    float result = 0.0f;
    float digit = 1.0f;
    for (; number > 0; number /= base) {
        digit /= static_cast<float>(base);
        result += digit * static_cast<float>(number % base);
    }
    return result;
}

/// The second of Sobol's sequences, [0, 1); with the first, turned(number, 2), each part of the square gets
/// its share.
float sobol(int number) {
    std::uint32_t result = 0;
    std::uint32_t direction = 1u << 31;
    for (; number > 0; number /= 2, direction ^= direction >> 1) {
        result ^= number % 2 != 0 ? direction : 0;
    }
    return static_cast<float>(static_cast<double>(result) / 4294967296.0);
}

float fraction(double value) {
    return static_cast<float>(value - std::floor(value));
}

}  // namespace

RefinedPicture::Sample RefinedPicture::sampleAt(int index) {
    constexpr double kPlastic = 0.7548776662466927;
    constexpr float kMiddle = 0.5f - 0.5f / static_cast<float>(kUsualSamples);  // the mean of the usual ones
    constexpr double kGolden = 0.6180339887498949;
    Sample sample;
    sample.jitter = glm::vec2(turned(index, 2), sobol(index)) - kMiddle;
    const float out = std::sqrt(turned(index + 1, 2));
    const float angle = glm::two_pi<float>() * turned(index + 1, 3);
    sample.light = {out * std::cos(angle), out * std::sin(angle)};
    sample.turn = {fraction(kGolden * index), fraction(kPlastic * index)};
    return sample;
}

RefinedPicture::LightPlace RefinedPicture::nextLight(bool software) const {
    constexpr int kSharing = 2;
    static_assert(kJudged + (kUsualSamples - kJudged) / kSharing == LightPlace::kKept);
    if (!m_settles) {
        return {sampleAt(m_samples / (software ? kSharing : 1)).light, LightPlace::kKept};
    }
    // The first ones tell where shadows are soft, and so stand for the light's rim, a quarter of its disc.
    constexpr float kRim = 0.93f;
    constexpr float kInner = 0.866f;
    if (m_samples < kJudged) {
        const float angle = glm::two_pi<float>() * (static_cast<float>(m_samples) + 0.5f) / kJudged;
        return {kRim * glm::vec2(std::cos(angle), std::sin(angle)), m_samples};
    }
    const int place = (m_samples - kJudged) / kSharing + 1;
    const float angle = kGoldenAngle * static_cast<float>(place);
    return {kInner * std::sqrt(turned(place, 2)) * glm::vec2(std::cos(angle), std::sin(angle)),
            kJudged + place - 1};
}

}  // namespace hitscope
