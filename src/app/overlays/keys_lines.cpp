// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/keys_lines.h"

#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSet>
#include <utility>

#include "models/plain_text.h"

namespace hitscope {

namespace {

constexpr const char* kKeysProperty = "hitscopeKeys";
constexpr const char* kMeaningProperty = "hitscopeKeysMeaning";

struct KeysTexts {
    Q_DECLARE_TR_FUNCTIONS(hitscope::Keys)
};

/// "Next Mode" of the menu "Wireframe" says little by itself.
QString meaningOf(const QString& text, const QString& submenu) {
    return submenu.isEmpty() ? text : submenu + QStringLiteral(": ") + text;
}

/// "Shift+F, Home": without those that are the same key on the number pad.
QString shortcutsOf(const QAction& action) {
    QStringList texts;
    for (const QKeySequence& keys : action.shortcuts()) {
        const bool pad =
            keys[0].keyboardModifiers().testFlag(Qt::KeypadModifier) || keys[0].key() == Qt::Key_Enter;
        if (texts.isEmpty() || !pad) {
            texts.append(keys.toString(QKeySequence::NativeText));
        }
    }
    return texts.join(QStringLiteral(", "));
}

void addLine(KeysSection& section, const QAction& action, const QString& submenu) {
    const QVariant keys = action.property(kKeysProperty);
    if (keys.isValid()) {
        if (!keys.toString().isEmpty()) {
            section.lines.push_back({keys.toString(), action.property(kMeaningProperty).toString()});
        }
        return;
    }
    const QStringList text = withoutMarks(action.text()).split(u'\t');
    const QString shortcut = shortcutsOf(action);
    const QString key = shortcut.isEmpty() ? text.value(1) : shortcut;
    if (!key.isEmpty()) {
        section.lines.push_back({key, meaningOf(text.value(0), submenu)});
    }
}

void addMenu(KeysSection& section, const QMenu& menu, const QString& submenu) {
    for (const QAction* action : menu.actions()) {
        if (const QMenu* inner = action->menu()) {
            addMenu(section, *inner, withoutMarks(inner->title()));
        } else {
            addLine(section, *action, submenu);
        }
    }
}

/// Keys that work in the dock's widgets only.
KeysSection dockKeys(const QDockWidget& dock) {
    KeysSection section{dock.windowTitle(), {}};
    QSet<const QAction*> seen;
    for (const QWidget* widget : dock.findChildren<QWidget*>()) {
        for (const QAction* action : widget->actions()) {
            if (action->shortcutContext() != Qt::WindowShortcut && !seen.contains(action)) {
                seen.insert(action);
                addLine(section, *action, {});
            }
        }
    }
    return section;
}

QString dragName(const DragBinding& binding) {
    const QString button = binding.button == Qt::LeftButton    ? KeysTexts::tr("Left-drag")
                           : binding.button == Qt::RightButton ? KeysTexts::tr("Right-drag")
                                                               : KeysTexts::tr("Middle-drag");
    switch (binding.key) {
        case Qt::ShiftModifier:
            return KeysTexts::tr("Shift+%1").arg(button);
        case Qt::ControlModifier:
            return KeysTexts::tr("Ctrl+%1").arg(button);
        case Qt::AltModifier:
            return KeysTexts::tr("Alt+%1").arg(button);
        default:
            return button;
    }
}

QString orbitMeaning(OrbitMode mode) {
    switch (mode) {
        case OrbitMode::Point:
            return KeysTexts::tr("Orbit about the point under the cursor; beside targets: about them");
        case OrbitMode::Turntable:
            return KeysTexts::tr("Orbit about the view centre");
        case OrbitMode::Fly:
            break;
    }
    return KeysTexts::tr("Look around");
}

QString motionMeaning(CameraMotion motion, OrbitMode mode) {
    return motion == CameraMotion::Orbit ? orbitMeaning(mode)
           : motion == CameraMotion::Pan ? KeysTexts::tr("Pan")
                                         : KeysTexts::tr("Zoom");
}

}  // namespace

KeysSection mouseKeys(NavigationPreset preset, OrbitMode mode) {
    KeysSection section{KeysTexts::tr("Mouse"), {}};
    section.lines.push_back({KeysTexts::tr("Click"), KeysTexts::tr("Shoot at the point under the cursor")});
    section.lines.push_back(
        {KeysTexts::tr("Ctrl+click"),
         KeysTexts::tr("Select the target there, as a click with Move; elsewhere: none")});
    section.lines.push_back(
        {KeysTexts::tr("Ctrl+Shift+click"), KeysTexts::tr("Select the target there too, or no longer")});
    section.lines.push_back({KeysTexts::tr("Middle-click"), KeysTexts::tr("Look at that point from now on")});
    for (const DragBinding& binding : dragBindings(preset)) {
        section.lines.push_back({dragName(binding), motionMeaning(binding.motion, mode)});
    }
    section.lines.push_back({KeysTexts::tr("Right-click"),
                             KeysTexts::tr("Menu of what is there: pick, select, measure, remove")});
    section.lines.push_back(
        {KeysTexts::tr("Alt+click"), KeysTexts::tr("Pick the vertex there; so does a click with Inspect")});
    section.lines.push_back({KeysTexts::tr("Wheel"), KeysTexts::tr("Zoom; on a trackpad: pinch")});
    section.lines.push_back({KeysTexts::tr("Shift+wheel"), KeysTexts::tr("Field of view")});
    section.lines.push_back({KeysTexts::tr("Two fingers"), KeysTexts::tr("Orbit; Shift: pan; Ctrl: zoom")});
    return section;
}

KeysSection heldKeys() {
    return {KeysTexts::tr("Viewport"),
            {{KeysTexts::tr("Space"), KeysTexts::tr("Shoot at the crosshair; hold to repeat")},
             {KeysTexts::tr("W A S D"), KeysTexts::tr("Fly; Shift: faster")},
             {KeysTexts::tr("E Q"), KeysTexts::tr("Fly up and down")},
             {KeysTexts::tr("[ ]"), KeysTexts::tr("Brush: size; Shift: strength; so does Ctrl+wheel")},
             {KeysTexts::tr("Esc"), KeysTexts::tr("Clear the selection; give a drag or a brush stroke up")}}};
}

std::vector<KeysSection> actionKeys(const QMainWindow& window) {
    std::vector<KeysSection> sections;
    const auto keep = [&sections](KeysSection section) {
        if (!section.lines.empty()) {
            sections.push_back(std::move(section));
        }
    };
    for (const QAction* action : window.menuBar()->actions()) {
        if (const QMenu* menu = action->menu()) {
            KeysSection section{withoutMarks(menu->title()), {}};
            addMenu(section, *menu, {});
            keep(std::move(section));
        }
    }
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>()) {
        keep(dockKeys(*dock));
    }
    return sections;
}

void listKeysAs(QAction& action, const QString& keys, const QString& meaning) {
    action.setProperty(kKeysProperty, keys);
    action.setProperty(kMeaningProperty, meaning);
}

void leaveOutOfKeys(QAction& action) {
    action.setProperty(kKeysProperty, QString(QLatin1String("")));
}

}  // namespace hitscope
