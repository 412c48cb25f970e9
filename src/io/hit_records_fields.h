// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "io/hit_records.h"

namespace hitscope::hit_fields {

/// A column of the table, and a key of its JSON: what it holds is the same text in both.
enum class Field : std::uint8_t {
    Number,
    Time,
    Target,
    PointX,
    PointY,
    PointZ,
    DirectionX,
    DirectionY,
    DirectionZ,
    NormalX,
    NormalY,
    NormalZ,
    Triangle,
    Speed,
    Impulse,
    MaxDistance,
    Power,
    MaxMagnitude,
    Pipeline,
    Affected,
    Greatest,
    Enabled,
    Profile,
    DentDirection,
    Curve,
    PressRadius,
    Group
};
struct FieldName {
    Field field = Field::Number;
    std::string_view name;
    bool isRequired = false;
};
inline constexpr std::array<FieldName, 27> kFields{{
    {Field::Number, "number"},
    {Field::Time, "time_s"},
    {Field::Target, "target", true},
    {Field::PointX, "point_x_m", true},
    {Field::PointY, "point_y_m", true},
    {Field::PointZ, "point_z_m", true},
    {Field::DirectionX, "direction_x", true},
    {Field::DirectionY, "direction_y", true},
    {Field::DirectionZ, "direction_z", true},
    {Field::NormalX, "normal_x"},
    {Field::NormalY, "normal_y"},
    {Field::NormalZ, "normal_z"},
    {Field::Triangle, "triangle"},
    {Field::Speed, "speed_m_per_s"},
    {Field::Impulse, "impulse_n_s"},
    {Field::MaxDistance, "max_distance_m"},
    {Field::Power, "power_m2"},
    {Field::MaxMagnitude, "max_magnitude_m"},
    {Field::Pipeline, "pipeline"},
    {Field::Affected, "affected_vertices"},
    {Field::Greatest, "greatest_displacement_m"},
    {Field::Enabled, "enabled"},
    {Field::Profile, "profile"},
    {Field::DentDirection, "dent_direction"},
    {Field::Curve, "curve"},
    {Field::PressRadius, "press_radius_m"},
    {Field::Group, "group"},
}};

[[nodiscard]] constexpr bool isText(Field field) {
    return field == Field::Target || field == Field::Pipeline || field == Field::Profile ||
           field == Field::DentDirection || field == Field::Curve || field == Field::Group;
}
/// Nothing: no such name.
[[nodiscard]] std::optional<Field> fieldNamed(std::string_view name);
/// Of hit `index`; empty: not known. Texts are not quoted.
[[nodiscard]] std::string valueOf(const HitRecords& table, std::size_t index, Field field);

/// Builds a table hit by hit out of texts.
class RecordReader {
public:
    explicit RecordReader(std::vector<std::string> pipelines);
    /// An empty value leaves what is not required as it is.
    [[nodiscard]] Status set(Hit& hit, Field field, std::string_view value);
    /// Every field of it has been set.
    [[nodiscard]] Status add(const Hit& hit);
    [[nodiscard]] HitRecords take() { return std::move(m_table); }

private:
    [[nodiscard]] Status setTarget(Hit& hit, std::string_view name);
    [[nodiscard]] static Status setForm(DentForm& form, Field field, std::string_view value);
    [[nodiscard]] Status setPipeline(Hit& hit, std::string_view key);

    HitRecords m_table;
    std::map<std::string, TargetId, std::less<>> m_targets;
};

/// `what` at a line, counted from 1.
[[nodiscard]] Error atLine(std::size_t line, std::string what);

[[nodiscard]] Result<HitRecords> readCsv(std::string_view text, std::vector<std::string> pipelines);
[[nodiscard]] Result<HitRecords> readJson(std::string_view text, std::vector<std::string> pipelines);

}  // namespace hitscope::hit_fields
