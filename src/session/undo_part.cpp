// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/undo_part.h"

#include <algorithm>
#include <optional>

namespace hitscope {

namespace {

/// The only part that differs.
class OnlyPart {
public:
    void note(UndoPart part, bool differs) {
        if (differs) {
            m_part = m_isAny ? UndoPart::None : part;
            m_isAny = true;
        }
    }
    [[nodiscard]] UndoPart part() const { return m_part; }

private:
    UndoPart m_part = UndoPart::None;
    bool m_isAny = false;
};

void note(OnlyPart& only, const DeformationConstants& before, const DeformationConstants& after) {
    only.note(UndoPart::MaxDistance, before.maxDistance != after.maxDistance);
    only.note(UndoPart::Power, before.power != after.power);
    only.note(UndoPart::MaxMagnitude, before.maxMagnitude != after.maxMagnitude);
}

/// Another direction of dents has a radius, or a profile, of its own.
void note(OnlyPart& only, const DentForm& before, const DentForm& after) {
    if (before.direction == after.direction) {
        only.note(UndoPart::PressRadius, before.radius != after.radius);
        only.note(UndoPart::Falloff, before.profile != after.profile || before.curve != after.curve);
    }
}

UndoPart changedPart(const Hit& before, const Hit& after) {
    OnlyPart only;
    note(only, before.constants, after.constants);
    note(only, before.form, after.form);
    only.note(UndoPart::Direction,
              before.direction != after.direction || before.form.direction != after.form.direction);
    only.note(UndoPart::Point, before.point != after.point);
    return only.part();
}

}  // namespace

UndoPart changedPart(std::span<const HistoryEdit> edits) {
    std::optional<UndoPart> part;
    for (const HistoryEdit& edit : edits) {
        const std::size_t hits = std::min(edit.before.size(), edit.after.size());
        for (std::size_t i = 0; i < hits; ++i) {
            if (edit.before[i] == edit.after[i]) {
                continue;
            }
            const UndoPart here = changedPart(edit.before[i], edit.after[i]);
            if (part.value_or(here) != here || here == UndoPart::None) {
                return UndoPart::None;
            }
            part = here;
        }
    }
    return part.value_or(UndoPart::None);
}

UndoPart changedPart(const ConstantsSetting& before, const ConstantsSetting& after) {
    OnlyPart only;
    note(only, before.constants, after.constants);
    note(only, before.form, after.form);
    only.note(UndoPart::Direction, before.form.direction != after.form.direction);
    only.note(UndoPart::None, before.relative != after.relative);
    return only.part();
}

UndoPart changedPart(const CuttingPlane& before, const CuttingPlane& after) {
    if (before.on != after.on) {
        return after.on ? UndoPart::CutOn : UndoPart::CutOff;
    }
    if (before.normal != after.normal) {
        return UndoPart::CutAxis;
    }
    OnlyPart only;
    only.note(UndoPart::CutOffset, before.offset != after.offset);
    only.note(UndoPart::CutFlip, before.flipped != after.flipped);
    only.note(UndoPart::CutFill, before.fill != after.fill);
    only.note(UndoPart::CutLines,
              before.originalLine != after.originalLine || before.deformedLine != after.deformedLine);
    return only.part();
}

}  // namespace hitscope
