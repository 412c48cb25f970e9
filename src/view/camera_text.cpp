// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/camera_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <optional>
#include <vector>

namespace hitscope {

namespace {

constexpr std::string_view kExample = "camera pivot 0 1.5 0 yaw 34.4 pitch 20 distance 12 fov 50 perspective";
constexpr double kDegree = glm::pi<double>() / 180.0;
// Meshes are of any size and anywhere, and so is the camera that looks at one: only what is no float is
// refused.
constexpr double kLargestFloat = 3.4028235e38;  // metres; rounds to the largest float
constexpr double kSmallestFloat = 1.17549436e-38;

/// A word and the numbers that follow it.
struct Field {
    std::string_view name;
    std::size_t count;
    double lowest;
    double highest;
};
enum FieldIndex : std::size_t { kPivot, kYaw, kPitch, kDistance, kFov, kFieldCount };
constexpr std::array<Field, kFieldCount> kFields{{{"pivot", 3, -kLargestFloat, kLargestFloat},
                                                  {"yaw", 1, -360.0, 360.0},
                                                  {"pitch", 1, -90.0, 90.0},
                                                  {"distance", 1, kSmallestFloat, kLargestFloat},
                                                  {"fov", 1, 5.0, 120.0}}};
constexpr std::string_view kPerspective = "perspective";
constexpr std::string_view kOrthographic = "orthographic";

using Values = std::array<std::optional<std::array<double, 3>>, kFieldCount>;

Error wrong(std::string what) {
    return {std::move(what), "", "A camera reads: " + std::string(kExample)};
}

std::vector<std::string_view> wordsOf(std::string_view text) {
    constexpr std::string_view kSpace = " \t\r\n";
    std::vector<std::string_view> words;
    for (std::size_t at = text.find_first_not_of(kSpace); at != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(kSpace, at), text.size());
        words.push_back(text.substr(at, end - at));
        at = text.find_first_not_of(kSpace, end);
    }
    return words;
}

std::optional<double> numberOf(std::string_view word) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = error == std::errc() && end == word.data() + word.size();
    return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string text(double value, int digits) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::general, digits);
    return {buffer.data(), end.ptr};
}

/// In units of `unit`, with as many digits as it takes to read the same number again; nine tell all floats
/// apart.
std::string text(float value, double unit) {
    constexpr int kFewestDigits = 6;  // with fewer, large numbers would be written as powers of ten
    constexpr int kMostDigits = 9;
    for (int digits = kFewestDigits; digits < kMostDigits; ++digits) {
        std::string shorter = text(static_cast<double>(value) / unit, digits);
        if (static_cast<float>(*numberOf(shorter) * unit) == value) {
            return shorter;
        }
    }
    return text(static_cast<double>(value) / unit, kMostDigits);
}

/// Takes a field's numbers from words[at], behind its name; moves `at` past them.
Status readField(const Field& field, const std::vector<std::string_view>& words, std::size_t& at,
                 std::optional<std::array<double, 3>>& values) {
    if (values) {
        return wrong("\"" + std::string(field.name) + "\" is there twice.");
    }
    values.emplace();
    for (std::size_t i = 0; i < field.count; ++i, ++at) {
        const std::optional<double> value = at < words.size() ? numberOf(words[at]) : std::nullopt;
        if (!value) {
            return wrong("\"" + std::string(field.name) + "\" needs " +
                         (field.count == 1 ? "a number." : std::to_string(field.count) + " numbers."));
        }
        if (*value < field.lowest || *value > field.highest) {
            return wrong("\"" + std::string(field.name) + "\" has to be from " + text(field.lowest, 6) +
                         " to " + text(field.highest, 6) + ".");
        }
        (*values)[i] = *value;
    }
    return Done{};
}

Camera cameraOf(const Values& values, Projection projection, const Camera& base) {
    const auto number = [&values](FieldIndex field) { return (*values[field])[0]; };
    const auto radians = [&number](FieldIndex field) { return static_cast<float>(number(field) * kDegree); };
    const std::array<double, 3>& pivot = *values[kPivot];
    Camera camera = base;
    camera.setProjection(projection);
    camera.setFieldOfView(radians(kFov));
    camera.restore({static_cast<float>(pivot[0]), static_cast<float>(pivot[1]), static_cast<float>(pivot[2])},
                   radians(kYaw), radians(kPitch), static_cast<float>(number(kDistance)));
    return camera;
}

}  // namespace

std::string cameraText(const Camera& camera) {
    const auto metres = [](float value) { return text(value, 1.0); };
    const auto degrees = [](float value) { return text(value, kDegree); };
    const glm::vec3 pivot = camera.pivot();
    return "camera pivot " + metres(pivot.x) + ' ' + metres(pivot.y) + ' ' + metres(pivot.z) + " yaw " +
           degrees(camera.yaw()) + " pitch " + degrees(camera.pitch()) + " distance " +
           metres(camera.distance()) + " fov " + degrees(camera.fieldOfView()) + ' ' +
           std::string(camera.isOrthographic() ? kOrthographic : kPerspective);
}

Result<Camera> parseCamera(std::string_view line, const Camera& base) {
    const std::vector<std::string_view> words = wordsOf(line);
    if (words.empty() || words.front() != "camera") {
        return wrong("This is no camera.");
    }
    Values values;
    std::optional<Projection> projection;
    for (std::size_t at = 1; at < words.size();) {
        const std::string_view word = words[at++];
        if (word == kPerspective || word == kOrthographic) {
            if (projection) {
                return wrong("The projection is there twice.");
            }
            projection = word == kOrthographic ? Projection::Orthographic : Projection::Perspective;
            continue;
        }
        std::size_t field = 0;
        while (field < kFieldCount && kFields[field].name != word) {
            ++field;
        }
        if (field == kFieldCount) {
            return wrong("\"" + std::string(word.substr(0, 40)) + "\" is no word of a camera.");
        }
        if (Status read = readField(kFields[field], words, at, values[field]); !read) {
            return read.error();
        }
    }
    for (std::size_t field = 0; field < kFieldCount; ++field) {
        if (!values[field]) {
            return wrong("\"" + std::string(kFields[field].name) + "\" is missing.");
        }
    }
    if (!projection) {
        return wrong("\"perspective\" or \"orthographic\" is missing.");
    }
    return cameraOf(values, *projection, base);
}

}  // namespace hitscope
