// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the cells of the hit history.
#include <cmath>
#include <limits>

#include "analysis/hit_files.h"
#include "models/dent_form_names.h"
#include "models/group_name.h"
#include "models/hit_history_model.h"
#include "models/quantity_text.h"
#include "session/frame_costs.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr double kSmallDepth = 0.01;  // metres: below, three decimals would say too little
constexpr double kSmallSpeed = 0.1;   // metres a second, newton seconds: likewise two

bool isCount(int column) {
    return column == HitHistoryModel::NumberColumn || column == HitHistoryModel::AffectedColumn ||
           column == HitHistoryModel::TriangleColumn;
}

}  // namespace

std::optional<double> HitHistoryModel::number(const Hit& hit, std::size_t row, int column) const {
    const auto asDouble = [](float value) { return static_cast<double>(value); };
    const bool isEffect = column == AffectedColumn || column == GreatestColumn;
    const auto effect =
        isEffect && m_effects != nullptr ? m_effects->effect(row) : std::optional<HitEffect>();
    const bool isCost = column == CpuCostColumn || column == GpuCostColumn;
    const auto cost = isCost ? m_session.frameCosts().hitCost(row) : std::optional<HitCost>();
    switch (column) {
        case NumberColumn:
            return static_cast<double>(row + 1);
        case TimeColumn:
            return hit.time;
        case SpeedColumn:
            return asDouble(hit.speed);
        case ImpulseColumn:
            return asDouble(hit.impulse);
        case AffectedColumn:
            return effect ? std::optional(static_cast<double>(effect->affected)) : std::nullopt;
        case GreatestColumn:
            return effect ? std::optional(asDouble(effect->greatest)) : std::nullopt;
        case CpuCostColumn:
            return cost ? std::optional(cost->cpu * kMilliseconds) : std::nullopt;
        case GpuCostColumn:
            return cost && cost->gpu ? std::optional(*cost->gpu * kMilliseconds) : std::nullopt;
        case MaxDistanceColumn:
            return asDouble(hit.constants.maxDistance);
        case PowerColumn:
            return asDouble(hit.constants.power);
        case MaxMagnitudeColumn:
            return asDouble(hit.constants.maxMagnitude);
        case TriangleColumn:
            return hit.triangle != kNoIndex ? std::optional(static_cast<double>(hit.triangle)) : std::nullopt;
        default:
            return std::nullopt;
    }
}

std::optional<glm::vec3> HitHistoryModel::vector(const Hit& hit, int column) const {
    switch (column) {
        case PointColumn:
            return hit.point;
        case DirectionColumn:
            return hit.direction;
        case NormalColumn:
            return hit.normal != glm::vec3(0.0f) ? std::optional(hit.normal) : std::nullopt;
        case WorldPointColumn: {
            const Target* target = m_session.targets().find(hit.target);
            return target != nullptr ? std::optional(target->transform.toWorld(hit.point)) : std::nullopt;
        }
        default:
            return std::nullopt;
    }
}

QVariant HitHistoryModel::rawValue(const Hit& hit, std::size_t row, int column) const {
    if (const std::optional<glm::vec3> v = vector(hit, column)) {
        return QVariantList{static_cast<double>(v->x), static_cast<double>(v->y), static_cast<double>(v->z)};
    }
    if (column == TargetColumn) {
        return static_cast<qulonglong>(hit.target.value);
    }
    const std::optional<double> value = number(hit, row, column);
    if (!value) {
        return {};
    }
    return isCount(column) ? QVariant(static_cast<qulonglong>(*value)) : QVariant(*value);
}

void HitHistoryModel::sortParts(std::size_t row, int column, double (&parts)[3]) const {
    const Hit& hit = m_session.hits().history().hits()[row];
    constexpr double kUnknown = -std::numeric_limits<double>::infinity();
    if (const std::optional<glm::vec3> v = vector(hit, column)) {
        for (int i = 0; i < 3; ++i) {
            parts[i] = static_cast<double>((*v)[i]);
        }
    } else if (column == PipelineColumn) {
        parts[0] = pipelineOf(hit) ? static_cast<double>(hit.pipeline) : kUnknown;
    } else if (column == GroupColumn) {
        parts[0] = hit.group ? static_cast<double>(hit.group.kind) : kUnknown;
        parts[1] = hit.group ? static_cast<double>(hit.group.number) : kUnknown;
    } else {
        parts[0] = number(hit, row, column).value_or(kUnknown);
    }
}

QString HitHistoryModel::text(const Hit& hit, std::size_t row, int column) const {
    if (const std::optional<glm::vec3> v = vector(hit, column)) {
        return vectorText(*v);
    }
    if (column == TargetColumn) {
        return targetName(hit);
    }
    if (column == PipelineColumn) {
        const std::optional<PipelineKind> kind = pipelineOf(hit);
        return QString::fromUtf8(kind ? pipelineTraits(*kind).name : std::string_view());
    }
    if (column == GroupColumn) {
        return groupName(hit.group);
    }
    const std::optional<double> value = number(hit, row, column);
    if (!value) {
        return {};
    }
    switch (column) {
        case TimeColumn:
            return shownNumber(*value, 'f', 2);
        case SpeedColumn:
        case ImpulseColumn:
            return *value != 0.0 && std::abs(*value) < kSmallSpeed ? quantityText(*value)
                                                                   : shownNumber(*value, 'f', 2);
        case GreatestColumn:
            return std::abs(*value) < kSmallDepth ? quantityText(*value) : shownNumber(*value, 'f', 3);
        case CpuCostColumn:
        case GpuCostColumn:
            return shownNumber(*value, 'f', 3);
        case MaxDistanceColumn:
        case PowerColumn:
        case MaxMagnitudeColumn:
            return shownFloat(static_cast<float>(*value));
        default:
            return countText(static_cast<std::size_t>(*value));
    }
}

QString HitHistoryModel::toolTip(const Hit& hit, std::size_t row) const {
    QString tip = tr("Max distance %1 m, power %2 m², max magnitude %3 m")
                      .arg(shownFloat(hit.constants.maxDistance), shownFloat(hit.constants.power),
                           shownFloat(hit.constants.maxMagnitude));
    if (!hit.form.isPaper()) {
        tip += u'\n' + tr("Form of the dent: %1").arg(nameOf(hit.form));
    }
    const HitState state = stateOf(row);
    if (state == Disabled) {
        tip.prepend(tr("Disabled: the mesh is as if this hit had not been made.") + u'\n');
    } else if (state == Later) {
        tip.prepend(tr("Later: the targets are shown as they were before this hit.") + u'\n');
    } else if (state == Dropped) {
        const CapacityReport& report = m_session.readBack().capacity();
        const std::string_view pipeline = pipelineTraits(m_session.settings().pipeline()).name;
        const QString why = report.perTarget
                                ? tr("Dropped: the pipeline “%1” keeps the last %2 hits on each target.")
                                : tr("Dropped: the pipeline “%1” keeps the last %2 hits of the scene.");
        tip.prepend(why.arg(QString::fromUtf8(pipeline), countText(report.capacity.value_or(report.used))) +
                    u'\n');
    }
    return tip;
}

QString HitHistoryModel::targetName(const Hit& hit) const {
    const Target* target = m_session.targets().find(hit.target);
    return target != nullptr ? target->name : QString();
}

}  // namespace hitscope
