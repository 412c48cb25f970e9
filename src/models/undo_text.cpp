// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/undo_text.h"

#include <QCoreApplication>

#include "models/quantity_text.h"

namespace hitscope {

namespace {

QString translated(const char* words) {
    return QCoreApplication::translate("hitscope::UndoText", words);
}

}  // namespace

QString undoText(const SessionUndo::Name& name) {
#define TEXT(words) QT_TRANSLATE_NOOP("hitscope::UndoText", words)
    const char* one = TEXT("Hit");
    const char* many = TEXT("%1 Hits");
    switch (name.kind) {
        case SessionUndo::Kind::Hit:
            break;
        case SessionUndo::Kind::Remove:
            one = TEXT("Remove Hit");
            many = TEXT("Remove %1 Hits");
            break;
        case SessionUndo::Kind::Clear:
            one = TEXT("Clear Hit");
            many = TEXT("Clear %1 Hits");
            break;
        case SessionUndo::Kind::Move:
            one = TEXT("Move Hit");
            many = TEXT("Move %1 Hits");
            break;
        case SessionUndo::Kind::Enable:
            one = TEXT("Enable Hit");
            many = TEXT("Enable %1 Hits");
            break;
        case SessionUndo::Kind::Disable:
            one = TEXT("Disable Hit");
            many = TEXT("Disable %1 Hits");
            break;
        case SessionUndo::Kind::EditHit:
            one = TEXT("Edit Hit");
            many = TEXT("Edit %1 Hits");
            break;
        case SessionUndo::Kind::HitConstants:
            one = TEXT("Constants of Hit");
            many = TEXT("Constants of %1 Hits");
            break;
        case SessionUndo::Kind::TargetTexture:
            one = TEXT("Locate Texture");
            many = TEXT("Locate %1 Textures");
            break;
        case SessionUndo::Kind::AddTarget:
            one = TEXT("Add Target");
            many = TEXT("Add %1 Targets");
            break;
        case SessionUndo::Kind::DuplicateTarget:
            one = TEXT("Duplicate Target");
            many = TEXT("Duplicate %1 Targets");
            break;
        case SessionUndo::Kind::RemoveTarget:
            one = TEXT("Remove Target");
            many = TEXT("Remove %1 Targets");
            break;
        case SessionUndo::Kind::MoveTarget:
            one = TEXT("Move Target");
            many = TEXT("Move %1 Targets");
            break;
        case SessionUndo::Kind::RotateTarget:
            one = TEXT("Rotate Target");
            many = TEXT("Rotate %1 Targets");
            break;
        case SessionUndo::Kind::RenameTarget:
            one = TEXT("Rename Target");
            many = TEXT("Rename %1 Targets");
            break;
        case SessionUndo::Kind::ShowTarget:
            one = TEXT("Show Target");
            many = TEXT("Show %1 Targets");
            break;
        case SessionUndo::Kind::HideTarget:
            one = TEXT("Hide Target");
            many = TEXT("Hide %1 Targets");
            break;
        case SessionUndo::Kind::ResetTarget:
            one = TEXT("Reset Target");
            many = TEXT("Reset %1 Targets");
            break;
        case SessionUndo::Kind::TargetPhysics:
            one = TEXT("Physics of Target");
            many = TEXT("Physics of %1 Targets");
            break;
        case SessionUndo::Kind::Constants:
            return translated(TEXT("Constants for Next Hit"));
        case SessionUndo::Kind::Lights:
            return translated(TEXT("Lights"));
        case SessionUndo::Kind::Projectile:
            return translated(TEXT("Projectile"));
        case SessionUndo::Kind::FlightMode:
            return translated(TEXT("Flight"));
        case SessionUndo::Kind::CoverTexture:
            return translated(TEXT("Texture on All Targets"));
        case SessionUndo::Kind::LoadScene:
            return translated(TEXT("Load Scene"));
        case SessionUndo::Kind::PlaceMesh:
            return translated(TEXT("Place Mesh"));
    }
#undef TEXT
    return name.count == 1 ? translated(one) : translated(many).arg(countText(name.count));
}

}  // namespace hitscope
