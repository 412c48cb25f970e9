// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/group_name.h"

#include <QCoreApplication>

#include "models/quantity_text.h"

namespace hitscope {

QString groupName(const HitGroup& group) {
    const auto name = [&group](const char* words) {
        return QCoreApplication::translate("hitscope::GroupName", words).arg(countText(group.number));
    };
    switch (group.kind) {
        case HitGroupKind::Chosen:
            return name(QT_TRANSLATE_NOOP("hitscope::GroupName", "Group %1"));
        case HitGroupKind::Mirror:
            return name(QT_TRANSLATE_NOOP("hitscope::GroupName", "Mirror %1"));
        case HitGroupKind::Scatter:
            return name(QT_TRANSLATE_NOOP("hitscope::GroupName", "Scatter %1"));
        case HitGroupKind::Stroke:
            return name(QT_TRANSLATE_NOOP("hitscope::GroupName", "Brush stroke %1"));
        case HitGroupKind::None:
            break;
    }
    return {};
}

}  // namespace hitscope
