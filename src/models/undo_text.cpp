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

QString undoText(const HistoryUndo::Name& name) {
#define TEXT(words) QT_TRANSLATE_NOOP("hitscope::UndoText", words)
    const char* one = TEXT("Hit");
    const char* many = TEXT("%1 Hits");
    switch (name.kind) {
        case HistoryUndo::Kind::Hit:
            break;
        case HistoryUndo::Kind::Remove:
            one = TEXT("Remove Hit");
            many = TEXT("Remove %1 Hits");
            break;
        case HistoryUndo::Kind::Clear:
            one = TEXT("Clear Hit");
            many = TEXT("Clear %1 Hits");
            break;
        case HistoryUndo::Kind::Move:
            one = TEXT("Move Hit");
            many = TEXT("Move %1 Hits");
            break;
        case HistoryUndo::Kind::Enable:
            one = TEXT("Enable Hit");
            many = TEXT("Enable %1 Hits");
            break;
        case HistoryUndo::Kind::Disable:
            one = TEXT("Disable Hit");
            many = TEXT("Disable %1 Hits");
            break;
        case HistoryUndo::Kind::Constants:
            return translated(TEXT("Constants"));
    }
#undef TEXT
    return name.hits == 1 ? translated(one) : translated(many).arg(countText(name.hits));
}

}  // namespace hitscope
