// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/hit_records.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "deform/dent_form_text.h"
#include "io/hit_records_fields.h"
#include "io/number_text.h"

namespace hitscope {

namespace hit_fields {

namespace {

constexpr std::size_t kLongestName = 4096;

/// The number of a hit that a field holds; null for those that are no float.
template <class AnyHit>
auto* floatOf(AnyHit& hit, Field field) {
    switch (field) {
        case Field::PointX:
            return &hit.point.x;
        case Field::PointY:
            return &hit.point.y;
        case Field::PointZ:
            return &hit.point.z;
        case Field::DirectionX:
            return &hit.direction.x;
        case Field::DirectionY:
            return &hit.direction.y;
        case Field::DirectionZ:
            return &hit.direction.z;
        case Field::NormalX:
            return &hit.normal.x;
        case Field::NormalY:
            return &hit.normal.y;
        case Field::NormalZ:
            return &hit.normal.z;
        case Field::Speed:
            return &hit.speed;
        case Field::Impulse:
            return &hit.impulse;
        case Field::MaxDistance:
            return &hit.constants.maxDistance;
        case Field::Power:
            return &hit.constants.power;
        case Field::MaxMagnitude:
            return &hit.constants.maxMagnitude;
        case Field::PressRadius:
            return &hit.form.radius;
        default:
            return static_cast<decltype(&hit.speed)>(nullptr);
    }
}

std::string floatText(float value) {
    std::string text;
    appendTwiceRoundedFloat(text, value);
    return text;
}

Error notA(const char* kind, Field field, std::string_view value) {
    std::string what(kFields[static_cast<std::size_t>(field)].name);
    if (value.empty()) {
        return {"“" + what + "” is missing.", "", ""};
    }
    what += " is “";
    what += value.substr(0, 40);
    what += "”, which is not ";
    what += kind;
    what += ".";
    return {std::move(what), "", ""};
}

/// All of the text, a finite number of this type and nothing else.
template <class Number>
std::optional<Number> numberIn(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
        return std::nullopt;
    }
    return value;
}

/// Overflow and infinity are refused; what is too small for a float is 0.
std::optional<float> floatIn(std::string_view text) {
    std::optional<float> value = numberIn<float>(text);
    const std::optional<double> wide = value ? std::nullopt : numberIn<double>(text);
    if (wide && std::abs(*wide) < 1.0) {
        value = static_cast<float>(*wide);
    }
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<bool> boolIn(std::string_view text) {
    if (text == "1" || text == "true") {
        return true;
    }
    return text == "0" || text == "false" ? std::optional(false) : std::nullopt;
}

}  // namespace

std::optional<Field> fieldNamed(std::string_view name) {
    const auto* const found =
        std::find_if(kFields.begin(), kFields.end(), [name](const FieldName& f) { return f.name == name; });
    return found == kFields.end() ? std::nullopt : std::optional(found->field);
}

std::string valueOf(const HitRecords& table, std::size_t index, Field field) {
    const Hit& hit = table.hits[index];
    if (const float* value = floatOf(hit, field)) {
        const bool isNormal = field >= Field::NormalX && field <= Field::NormalZ;
        const bool isUnknown = (isNormal && hit.normal == glm::vec3(0.0f)) ||
                               (field == Field::PressRadius && !hit.form.presses());
        return isUnknown ? std::string() : floatText(*value);
    }
    const bool isKnown = !table.effects.empty() && table.effects[index].has_value();
    const HitEffect* effect = isKnown ? &*table.effects[index] : nullptr;
    std::string text;
    switch (field) {
        case Field::Number:
            appendNumber(text, table.numbers.empty() ? index + 1 : table.numbers[index]);
            break;
        case Field::Time:
            appendNumber(text, hit.time);
            break;
        case Field::Target: {
            const auto name = table.targets.find(hit.target);
            return name == table.targets.end() ? std::string() : name->second;
        }
        case Field::Triangle:
            if (hit.triangle != kNoIndex) {
                appendNumber(text, hit.triangle);
            }
            break;
        case Field::Pipeline:
            return hit.pipeline < table.pipelines.size() ? table.pipelines[hit.pipeline] : std::string();
        case Field::Affected:
            if (effect != nullptr) {
                appendNumber(text, effect->affected);
            }
            break;
        case Field::Greatest:
            return effect != nullptr ? floatText(effect->greatest) : std::string();
        case Field::Enabled:
            return hit.enabled ? "1" : "0";
        case Field::Profile:
            return hit.form.isPaper() ? std::string() : std::string(keyOf(hit.form.profile));
        case Field::DentDirection:
            return hit.form.isPaper() ? std::string() : std::string(keyOf(hit.form.direction));
        case Field::Curve:
            return hit.form.profile == DentProfile::Curve ? curveText(hit.form.curve, ' ') : std::string();
        case Field::Group:
            return groupText(hit.group);
        default:
            break;
    }
    return text;
}

RecordReader::RecordReader(std::vector<std::string> pipelines) {
    m_table.pipelines = std::move(pipelines);
}

Status RecordReader::setTarget(Hit& hit, std::string_view name) {
    if (name.size() > kLongestName) {
        return Error{"The name of the target is too long.", "", ""};
    }
    const auto known = m_targets.find(name);
    if (known != m_targets.end()) {
        hit.target = known->second;
        return Done{};
    }
    hit.target = TargetId{static_cast<std::uint32_t>(m_targets.size() + 1)};
    m_targets.emplace(name, hit.target);
    m_table.targets.emplace(hit.target, name);
    return Done{};
}

Status RecordReader::setPipeline(Hit& hit, std::string_view key) {
    const auto found = std::find(m_table.pipelines.begin(), m_table.pipelines.end(), key);
    if (found == m_table.pipelines.end()) {
        return notA("a pipeline's key", Field::Pipeline, key);
    }
    hit.pipeline = static_cast<std::uint8_t>(found - m_table.pipelines.begin());
    return Done{};
}

Status RecordReader::setForm(DentForm& form, Field field, std::string_view value) {
    if (field == Field::Profile) {
        const auto profile = profileNamed(value);
        form.profile = profile.value_or(form.profile);
        return profile ? Status(Done{}) : Status(notA("a profile's key", field, value));
    }
    if (field == Field::DentDirection) {
        const auto direction = directionNamed(value);
        form.direction = direction.value_or(form.direction);
        return direction ? Status(Done{}) : Status(notA("projectile, surface or press", field, value));
    }
    const std::optional<CurveOrdinates> curve = curveFrom(value, ' ');
    form.curve = curve.value_or(form.curve);
    return curve ? Status(Done{}) : Status(notA("eight numbers from -1 to 1", field, value));
}

Status RecordReader::set(Hit& hit, Field field, std::string_view value) {
    if (value.empty()) {
        return kFields[static_cast<std::size_t>(field)].isRequired ? Status(notA("given", field, value))
                                                                   : Status(Done{});
    }
    if (float* number = floatOf(hit, field)) {
        const std::optional<float> read = floatIn(value);
        *number = read.value_or(0.0f);
        return read ? Status(Done{}) : Status(notA("a finite number", field, value));
    }
    switch (field) {
        case Field::Target:
            return setTarget(hit, value);
        case Field::Pipeline:
            return setPipeline(hit, value);
        case Field::Profile:
        case Field::DentDirection:
        case Field::Curve:
            return setForm(hit.form, field, value);
        case Field::Time: {
            const std::optional<double> time = numberIn<double>(value);
            hit.time = time.value_or(0.0);
            return time && std::isfinite(*time) ? Status(Done{})
                                                : Status(notA("a finite number", field, value));
        }
        case Field::Triangle: {
            const std::optional<std::uint32_t> triangle = numberIn<std::uint32_t>(value);
            hit.triangle = triangle.value_or(kNoIndex);
            return triangle ? Status(Done{}) : Status(notA("a triangle's number", field, value));
        }
        case Field::Group: {
            const std::optional<HitGroup> group = groupOf(value);
            hit.group = group.value_or(HitGroup());
            return group ? Status(Done{}) : Status(notA("a group such as “scatter 3”", field, value));
        }
        case Field::Enabled: {
            const std::optional<bool> enabled = boolIn(value);
            hit.enabled = enabled.value_or(true);
            return enabled ? Status(Done{}) : Status(notA("0 or 1", field, value));
        }
        default:  // what follows from the others: number, affected vertices, greatest displacement
            return numberIn<double>(value) ? Status(Done{}) : Status(notA("a number", field, value));
    }
}

Status RecordReader::add(const Hit& hit) {
    if (m_table.hits.size() == kMostRecordHits) {
        return Error{"The file has more than 1,000,000 hits.", "", "Split it."};
    }
    Result<Hit> checked = checkedHit(hit);
    if (!checked) {
        return checked.error();
    }
    m_table.hits.push_back(checked.value());
    return Done{};
}

Error atLine(std::size_t line, std::string what) {
    return {std::move(what), "line " + std::to_string(line), "Correct the line, or leave it out."};
}

}  // namespace hit_fields

Result<HitRecords> readHitRecords(std::string_view bytes, std::vector<std::string> pipelines) {
    if (bytes.size() > kMostRecordBytes) {
        return Error{"The file is larger than 256 MB.", "", "Split it."};
    }
    if (bytes.starts_with("\xef\xbb\xbf")) {
        bytes.remove_prefix(3);  // a byte order mark, as spreadsheets write it
    }
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    const bool isJson = first != std::string_view::npos && (bytes[first] == '{' || bytes[first] == '[');
    return isJson ? hit_fields::readJson(bytes, std::move(pipelines))
                  : hit_fields::readCsv(bytes, std::move(pipelines));
}

}  // namespace hitscope
