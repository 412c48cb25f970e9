// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/undo_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>

#include "models/quantity_text.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

QString translated(const char* words, int count = -1) {
    return QCoreApplication::translate("hitscope::UndoText", words, nullptr, count);
}

/// What a step is called, about one and about several.
struct Words {
    SessionUndo::Kind kind;
    const char* one;
    const char* many;  ///< null: nothing is counted
    UndoPart part = UndoPart::None;
};

#define TEXT(words) QT_TRANSLATE_NOOP("hitscope::UndoText", words)
constexpr Words kWords[] = {
    {SessionUndo::Kind::Hit, TEXT("Hit"), TEXT("%Ln Hits")},
    {SessionUndo::Kind::Remove, TEXT("Remove Hit"), TEXT("Remove %Ln Hits")},
    {SessionUndo::Kind::Clear, TEXT("Clear Hit"), TEXT("Clear %Ln Hits")},
    {SessionUndo::Kind::Move, TEXT("Reorder Hit"), TEXT("Reorder %Ln Hits")},
    {SessionUndo::Kind::Enable, TEXT("Enable Hit"), TEXT("Enable %Ln Hits")},
    {SessionUndo::Kind::Disable, TEXT("Disable Hit"), TEXT("Disable %Ln Hits")},
    {SessionUndo::Kind::EditHit, TEXT("Edit Hit"), TEXT("Edit %Ln Hits")},
    {SessionUndo::Kind::EditHit, TEXT("Max Distance of Hit"), TEXT("Max Distance of %Ln Hits"),
     UndoPart::MaxDistance},
    {SessionUndo::Kind::EditHit, TEXT("Power of Hit"), TEXT("Power of %Ln Hits"), UndoPart::Power},
    {SessionUndo::Kind::EditHit, TEXT("Max Magnitude of Hit"), TEXT("Max Magnitude of %Ln Hits"),
     UndoPart::MaxMagnitude},
    {SessionUndo::Kind::EditHit, TEXT("Press Radius of Hit"), TEXT("Press Radius of %Ln Hits"),
     UndoPart::PressRadius},
    {SessionUndo::Kind::EditHit, TEXT("Fall-off of Hit"), TEXT("Fall-off of %Ln Hits"), UndoPart::Falloff},
    {SessionUndo::Kind::EditHit, TEXT("Direction of Hit"), TEXT("Direction of %Ln Hits"),
     UndoPart::Direction},
    {SessionUndo::Kind::EditHit, TEXT("Point of Hit"), TEXT("Point of %Ln Hits"), UndoPart::Point},
    {SessionUndo::Kind::HitConstants, TEXT("Constants of Hit"), TEXT("Constants of %Ln Hits")},
    {SessionUndo::Kind::Mirror, TEXT("Mirror Hit"), TEXT("Mirror %Ln Hits")},
    {SessionUndo::Kind::Scatter, TEXT("Scatter Hit"), TEXT("Scatter %Ln Hits")},
    {SessionUndo::Kind::Stroke, TEXT("Brush Hit"), TEXT("Brush Stroke of %Ln Hits")},
    {SessionUndo::Kind::Group, TEXT("Group Hit"), TEXT("Group %Ln Hits")},
    {SessionUndo::Kind::Ungroup, TEXT("Ungroup Hit"), TEXT("Ungroup %Ln Hits")},
    {SessionUndo::Kind::TargetTexture, TEXT("Locate Texture"), TEXT("Locate %Ln Textures")},
    {SessionUndo::Kind::ReloadMesh, TEXT("Reload Mesh"), TEXT("Reload Meshes of %Ln Targets")},
    {SessionUndo::Kind::RefineMesh, TEXT("Refine Mesh"), TEXT("Refine Meshes of %Ln Targets")},
    {SessionUndo::Kind::SimplifyMesh, TEXT("Simplify Mesh"), TEXT("Simplify Meshes of %Ln Targets")},
    {SessionUndo::Kind::SmoothMesh, TEXT("Smooth Mesh"), TEXT("Smooth Meshes of %Ln Targets")},
    {SessionUndo::Kind::ApplyHits, TEXT("Apply Hits"), TEXT("Apply Hits of %Ln Targets")},
    {SessionUndo::Kind::ScaleTarget, TEXT("Scale Target"), TEXT("Scale %Ln Targets")},
    {SessionUndo::Kind::SeparateObjects, TEXT("Separate Objects"), nullptr},
    {SessionUndo::Kind::AddTarget, TEXT("Add Target"), TEXT("Add %Ln Targets")},
    {SessionUndo::Kind::DuplicateTarget, TEXT("Duplicate Target"), TEXT("Duplicate %Ln Targets")},
    {SessionUndo::Kind::PutOnTurntable, TEXT("Put on a Turntable"), nullptr},
    {SessionUndo::Kind::RemoveTarget, TEXT("Remove Target"), TEXT("Remove %Ln Targets")},
    {SessionUndo::Kind::MoveTarget, TEXT("Move Target"), TEXT("Move %Ln Targets")},
    {SessionUndo::Kind::RotateTarget, TEXT("Rotate Target"), TEXT("Rotate %Ln Targets")},
    {SessionUndo::Kind::RenameTarget, TEXT("Rename Target"), TEXT("Rename %Ln Targets")},
    {SessionUndo::Kind::ShowTarget, TEXT("Show Target"), TEXT("Show %Ln Targets")},
    {SessionUndo::Kind::HideTarget, TEXT("Hide Target"), TEXT("Hide %Ln Targets")},
    {SessionUndo::Kind::ResetTarget, TEXT("Reset Target"), TEXT("Reset %Ln Targets")},
    {SessionUndo::Kind::TargetPhysics, TEXT("Physics of Target"), TEXT("Physics of %Ln Targets")},
    {SessionUndo::Kind::Constants, TEXT("Constants for Next Hit"), nullptr},
    {SessionUndo::Kind::Constants, TEXT("Max Distance for Next Hit"), nullptr, UndoPart::MaxDistance},
    {SessionUndo::Kind::Constants, TEXT("Power for Next Hit"), nullptr, UndoPart::Power},
    {SessionUndo::Kind::Constants, TEXT("Max Magnitude for Next Hit"), nullptr, UndoPart::MaxMagnitude},
    {SessionUndo::Kind::Constants, TEXT("Fall-off for Next Hit"), nullptr, UndoPart::Falloff},
    {SessionUndo::Kind::Constants, TEXT("Direction for Next Hit"), nullptr, UndoPart::Direction},
    {SessionUndo::Kind::Lights, TEXT("Lights"), nullptr},
    {SessionUndo::Kind::Projectile, TEXT("Projectile"), nullptr},
    {SessionUndo::Kind::FlightMode, TEXT("Flight"), nullptr},
    {SessionUndo::Kind::CoverTexture, TEXT("Texture on All Targets"), nullptr},
    {SessionUndo::Kind::CuttingPlane, TEXT("Cutting Plane"), nullptr},
    {SessionUndo::Kind::CuttingPlane, TEXT("Cutting Plane On"), nullptr, UndoPart::CutOn},
    {SessionUndo::Kind::CuttingPlane, TEXT("Cutting Plane Off"), nullptr, UndoPart::CutOff},
    {SessionUndo::Kind::CuttingPlane, TEXT("Offset of Cutting Plane"), nullptr, UndoPart::CutOffset},
    {SessionUndo::Kind::CuttingPlane, TEXT("Axis of Cutting Plane"), nullptr, UndoPart::CutAxis},
    {SessionUndo::Kind::CuttingPlane, TEXT("Flip Cutting Plane"), nullptr, UndoPart::CutFlip},
    {SessionUndo::Kind::CuttingPlane, TEXT("Fill of Cutting Plane"), nullptr, UndoPart::CutFill},
    {SessionUndo::Kind::CuttingPlane, TEXT("Lines of Cutting Plane"), nullptr, UndoPart::CutLines},
    {SessionUndo::Kind::LoadScene, TEXT("Load Scene"), nullptr},
    {SessionUndo::Kind::PlaceMesh, TEXT("Place Mesh"), nullptr},
};
#undef TEXT

}  // namespace

QString undoText(const SessionUndo::Name& name) {
    const auto find = [&name](UndoPart part) {
        return std::find_if(std::begin(kWords), std::end(kWords),
                            [&](const Words& row) { return row.kind == name.kind && row.part == part; });
    };
    const auto* words = find(name.part);
    words = words != std::end(kWords) ? words : find(UndoPart::None);
    if (words->many != nullptr && name.count != 1) {
        return translated(words->many, trCount(name.count));
    }
    const QString one = translated(words->one);
    return name.hit == 0 ? one : QStringLiteral("%1 %2").arg(one, countText(name.hit));
}

QString undoText(const SessionUndo& steps, std::size_t step) {
    const QString text = undoText(steps.name(step));
    const QString target = steps.target(step);
    return target.isEmpty() ? text : translated("%1 “%2”").arg(text, target);
}

}  // namespace hitscope
