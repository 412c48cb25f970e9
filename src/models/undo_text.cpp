// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/undo_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>

#include "models/quantity_text.h"

namespace hitscope {

namespace {

QString translated(const char* words) {
    return QCoreApplication::translate("hitscope::UndoText", words);
}

/// What a step is called, about one and about several.
struct Words {
    SessionUndo::Kind kind;
    const char* one;
    const char* many;  ///< null: nothing is counted
};

#define TEXT(words) QT_TRANSLATE_NOOP("hitscope::UndoText", words)
constexpr Words kWords[] = {
    {SessionUndo::Kind::Hit, TEXT("Hit"), TEXT("%1 Hits")},
    {SessionUndo::Kind::Remove, TEXT("Remove Hit"), TEXT("Remove %1 Hits")},
    {SessionUndo::Kind::Clear, TEXT("Clear Hit"), TEXT("Clear %1 Hits")},
    {SessionUndo::Kind::Move, TEXT("Move Hit"), TEXT("Move %1 Hits")},
    {SessionUndo::Kind::Enable, TEXT("Enable Hit"), TEXT("Enable %1 Hits")},
    {SessionUndo::Kind::Disable, TEXT("Disable Hit"), TEXT("Disable %1 Hits")},
    {SessionUndo::Kind::EditHit, TEXT("Edit Hit"), TEXT("Edit %1 Hits")},
    {SessionUndo::Kind::HitConstants, TEXT("Constants of Hit"), TEXT("Constants of %1 Hits")},
    {SessionUndo::Kind::Mirror, TEXT("Mirror Hit"), TEXT("Mirror %1 Hits")},
    {SessionUndo::Kind::Scatter, TEXT("Scatter Hit"), TEXT("Scatter %1 Hits")},
    {SessionUndo::Kind::Stroke, TEXT("Brush Hit"), TEXT("Brush Stroke of %1 Hits")},
    {SessionUndo::Kind::Group, TEXT("Group Hit"), TEXT("Group %1 Hits")},
    {SessionUndo::Kind::Ungroup, TEXT("Ungroup Hit"), TEXT("Ungroup %1 Hits")},
    {SessionUndo::Kind::TargetTexture, TEXT("Locate Texture"), TEXT("Locate %1 Textures")},
    {SessionUndo::Kind::ReloadMesh, TEXT("Reload Mesh"), TEXT("Reload Meshes of %1 Targets")},
    {SessionUndo::Kind::RefineMesh, TEXT("Refine Mesh"), TEXT("Refine Meshes of %1 Targets")},
    {SessionUndo::Kind::SimplifyMesh, TEXT("Simplify Mesh"), TEXT("Simplify Meshes of %1 Targets")},
    {SessionUndo::Kind::SmoothMesh, TEXT("Smooth Mesh"), TEXT("Smooth Meshes of %1 Targets")},
    {SessionUndo::Kind::ApplyHits, TEXT("Apply Hits"), TEXT("Apply Hits of %1 Targets")},
    {SessionUndo::Kind::SeparateObjects, TEXT("Separate Objects"), nullptr},
    {SessionUndo::Kind::AddTarget, TEXT("Add Target"), TEXT("Add %1 Targets")},
    {SessionUndo::Kind::DuplicateTarget, TEXT("Duplicate Target"), TEXT("Duplicate %1 Targets")},
    {SessionUndo::Kind::RemoveTarget, TEXT("Remove Target"), TEXT("Remove %1 Targets")},
    {SessionUndo::Kind::MoveTarget, TEXT("Move Target"), TEXT("Move %1 Targets")},
    {SessionUndo::Kind::RotateTarget, TEXT("Rotate Target"), TEXT("Rotate %1 Targets")},
    {SessionUndo::Kind::RenameTarget, TEXT("Rename Target"), TEXT("Rename %1 Targets")},
    {SessionUndo::Kind::ShowTarget, TEXT("Show Target"), TEXT("Show %1 Targets")},
    {SessionUndo::Kind::HideTarget, TEXT("Hide Target"), TEXT("Hide %1 Targets")},
    {SessionUndo::Kind::ResetTarget, TEXT("Reset Target"), TEXT("Reset %1 Targets")},
    {SessionUndo::Kind::TargetPhysics, TEXT("Physics of Target"), TEXT("Physics of %1 Targets")},
    {SessionUndo::Kind::Constants, TEXT("Constants for Next Hit"), nullptr},
    {SessionUndo::Kind::Lights, TEXT("Lights"), nullptr},
    {SessionUndo::Kind::Projectile, TEXT("Projectile"), nullptr},
    {SessionUndo::Kind::FlightMode, TEXT("Flight"), nullptr},
    {SessionUndo::Kind::CoverTexture, TEXT("Texture on All Targets"), nullptr},
    {SessionUndo::Kind::CuttingPlane, TEXT("Cutting Plane"), nullptr},
    {SessionUndo::Kind::LoadScene, TEXT("Load Scene"), nullptr},
    {SessionUndo::Kind::PlaceMesh, TEXT("Place Mesh"), nullptr},
};
#undef TEXT

}  // namespace

QString undoText(const SessionUndo::Name& name) {
    const auto* words = std::find_if(std::begin(kWords), std::end(kWords),
                                     [&name](const Words& row) { return row.kind == name.kind; });
    return words->many == nullptr || name.count == 1 ? translated(words->one)
                                                     : translated(words->many).arg(countText(name.count));
}

}  // namespace hitscope
