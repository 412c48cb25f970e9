// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/hit_filter.h"

#include <QLocale>
#include <algorithm>
#include <set>
#include <string_view>

#include "models/group_name.h"
#include "models/hit_history_model.h"

namespace hitscope {

namespace {

/// As a number is typed: without what stands between groups of digits.
QString withoutSeparators(QString text) {
    return text.remove(QLocale().groupSeparator());
}

}  // namespace

bool isFilteredBy(int first, int last) {
    const auto isAmong = [first, last](int column) { return column >= first && column <= last; };
    return isAmong(HitHistoryModel::NumberColumn) || isAmong(HitHistoryModel::TargetColumn) ||
           isAmong(HitHistoryModel::PipelineColumn) || isAmong(HitHistoryModel::GroupColumn);
}

std::vector<std::uint32_t> acceptedHits(const Session& session, const HitFilter& filter, std::uint32_t first,
                                        std::uint32_t end) {
    const std::span<const Hit> hits = session.hits().history().hits();
    // What the text is in, once for each name and not for each hit.
    std::set<TargetId> targets;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        if (target->name.contains(filter.text, Qt::CaseInsensitive)) {
            targets.insert(target->id);
        }
    }
    const auto isIn = [&filter](std::string_view name) {
        return QString::fromUtf8(name).contains(filter.text, Qt::CaseInsensitive);
    };
    std::set<std::uint8_t> pipelines;
    for (const PipelineTraits& traits : allPipelines()) {
        if (isIn(traits.name)) {
            pipelines.insert(static_cast<std::uint8_t>(traits.kind));
        }
    }
    // Hits of one group stand together.
    HitGroup group;
    bool isInGroup = false;
    const QString number = withoutSeparators(filter.text);
    std::vector<std::uint32_t> rows;
    for (std::uint32_t row = first; row < std::min<std::size_t>(end, hits.size()); ++row) {
        const Hit& hit = hits[row];
        if ((filter.isEnabled && !hit.enabled) || (filter.target && hit.target != filter.target)) {
            continue;
        }
        if (hit.group != group) {
            group = hit.group;
            isInGroup = group && !number.isEmpty() &&
                        withoutSeparators(groupName(group)).contains(number, Qt::CaseInsensitive);
        }
        const bool isNumber = !number.isEmpty() && QString::number(row + 1).contains(number);
        if (filter.text.isEmpty() || isNumber || isInGroup || targets.contains(hit.target) ||
            pipelines.contains(hit.pipeline)) {
            rows.push_back(row);
        }
    }
    return rows;
}

}  // namespace hitscope
