// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/key_routing.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QSpinBox>
#include <QToolBar>

#include "panels/fields/number_box.h"

namespace hitscope {

namespace {

/// The box itself or its editor; null: neither.
QAbstractSpinBox* spinBoxOf(QWidget& widget) {
    if (auto* box = qobject_cast<QAbstractSpinBox*>(&widget)) {
        return box;
    }
    return qobject_cast<QLineEdit*>(&widget) != nullptr
               ? qobject_cast<QAbstractSpinBox*>(widget.parentWidget())
               : nullptr;
}

QLineEdit* editorOf(const QAbstractSpinBox& box) {
    return box.findChild<QLineEdit*>(QString(), Qt::FindDirectChildrenOnly);
}

bool takesText(const QWidget& widget) {
    return qobject_cast<const QLineEdit*>(&widget) != nullptr || widget.inherits("QTextEdit") ||
           widget.inherits("QPlainTextEdit") || widget.testAttribute(Qt::WA_InputMethodEnabled);
}

/// Something has been typed that is not in force yet.
bool isTyping(const QAbstractSpinBox& box) {
    const QLineEdit* editor = editorOf(box);
    return editor != nullptr && editor->isModified();
}

void setTyped(const QAbstractSpinBox& box, bool typed) {
    if (QLineEdit* editor = editorOf(box)) {
        editor->setModified(typed);
    }
}

void dropTyped(QAbstractSpinBox& box) {
    if (auto* number = qobject_cast<QDoubleSpinBox*>(&box)) {
        number->setValue(number->value());
    } else if (auto* whole = qobject_cast<QSpinBox*>(&box)) {
        whole->setValue(whole->value());
    }
    setTyped(box, false);
}

bool isPlain(const QKeyEvent& event) {
    return (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
}

/// Typed where Qt would drop it, as between thousands: of 0,5 there would be 05.
bool isCommaForPoint(const QAbstractSpinBox& box, const QKeyEvent& event) {
    return event.text() == QStringLiteral(",") && qobject_cast<const QDoubleSpinBox*>(&box) != nullptr &&
           qobject_cast<const NumberBox*>(&box) == nullptr &&
           box.locale().decimalPoint() == QStringLiteral(".");
}

bool isReturn(const QKeyEvent& event) {
    return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

/// What a spin box does with a number: digits, sign and point, the cursor, steps, the clipboard.
bool belongsToNumber(const QKeyEvent& event) {
    switch (event.key()) {
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
        case Qt::Key_Home:
        case Qt::Key_End:
        case Qt::Key_Tab:
        case Qt::Key_Backtab:
            return true;
        case Qt::Key_Backspace:
        case Qt::Key_Delete:
            return isPlain(event);
        default:
            break;
    }
    for (const QKeySequence::StandardKey key :
         {QKeySequence::Copy, QKeySequence::Cut, QKeySequence::Paste, QKeySequence::SelectAll}) {
        if (event.matches(key)) {
            return true;
        }
    }
    const QString text = event.text();
    return isPlain(event) && text.size() == 1 &&
           (text[0].isDigit() || QStringLiteral("+-.,").contains(text[0]));
}

/// What a text would take.
bool isWritten(const QKeyEvent& event) {
    const QString text = event.text();
    return isPlain(event) && text.size() == 1 && text[0].isPrint();
}

/// Of a list.
bool goesToEnd(const QKeyEvent& event) {
    return (event.key() == Qt::Key_Home || event.key() == Qt::Key_End) && isPlain(event);
}

bool isEscape(const QKeyEvent& event) {
    return event.key() == Qt::Key_Escape && isPlain(event);
}

/// What the picture does while it is held.
bool fliesCamera(const QKeyEvent& event) {
    switch (event.key()) {
        case Qt::Key_W:
        case Qt::Key_A:
        case Qt::Key_S:
        case Qt::Key_D:
        case Qt::Key_E:
        case Qt::Key_Q:
            return isPlain(event);
        default:
            return false;
    }
}

}  // namespace

KeyRouting::KeyRouting(QMainWindow& window, QWidget& picture)
    : QObject(&window), m_window(window), m_picture(picture) {
    qApp->installEventFilter(this);
}

bool KeyRouting::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    const bool isKey = type == QEvent::ShortcutOverride || type == QEvent::KeyPress;
    if ((!isKey && type != QEvent::FocusIn && type != QEvent::MouseButtonPress) || !watched->isWidgetType()) {
        return false;
    }
    auto& widget = static_cast<QWidget&>(*watched);
    if (&widget == &m_picture || QApplication::activePopupWidget() != nullptr) {
        return false;
    }
    // Nobody on the way up wanted it.
    if (type == QEvent::KeyPress && isTop(widget) && !m_picture.hasFocus() &&
        isEscape(static_cast<const QKeyEvent&>(*event))) {
        handOver(static_cast<QKeyEvent&>(*event));
        return true;
    }
    if (!isInPanel(widget)) {
        return false;
    }
    if (type == QEvent::ShortcutOverride) {
        return override(widget, static_cast<QKeyEvent&>(*event));
    }
    if (type == QEvent::KeyPress) {
        return press(widget, static_cast<QKeyEvent&>(*event));
    }
    if (QAbstractSpinBox* box = spinBoxOf(widget)) {
        if (type == QEvent::FocusIn) {
            setTyped(*box, false);  // what was typed before is in force
            const Qt::FocusReason reason = static_cast<const QFocusEvent&>(*event).reason();
            const bool isByKey = reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason;
            m_edited = isByKey ? box : nullptr;
        } else if (&widget != box) {
            m_edited = box;  // not its buttons
        }
    }
    return false;
}

/// The window, or a dock that floats.
bool KeyRouting::isTop(const QWidget& widget) const {
    return &widget == &m_window || (qobject_cast<const QDockWidget*>(&widget) != nullptr &&
                                    widget.parentWidget() == &m_window && widget.isWindow());
}

/// In a dock or a tool bar of the window, and not the editor of a cell, which ends with the cell.
bool KeyRouting::isInPanel(const QWidget& widget) const {
    const bool isView = qobject_cast<const QAbstractItemView*>(&widget) != nullptr;
    for (const QWidget* parent = widget.parentWidget(); parent != nullptr; parent = parent->parentWidget()) {
        if (!isView && qobject_cast<const QAbstractItemView*>(parent) != nullptr) {
            return false;
        }
        if (qobject_cast<const QDockWidget*>(parent) != nullptr ||
            qobject_cast<const QToolBar*>(parent) != nullptr) {
            return parent->parentWidget() == &m_window;
        }
    }
    return false;
}

bool KeyRouting::override(QWidget& widget, QKeyEvent& event) const {
    if (const QAbstractSpinBox* box = spinBoxOf(widget)) {
        if (isTyping(*box) || belongsToNumber(event) || (box == m_edited && isWritten(event))) {
            return false;
        }
        event.ignore();
        return true;
    }
    if (goesToEnd(event) && (qobject_cast<const QComboBox*>(&widget) != nullptr ||
                             qobject_cast<const QAbstractItemView*>(&widget) != nullptr)) {
        event.accept();
        return true;
    }
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) {
        const bool isUndo = event.matches(QKeySequence::Undo) && !line->isUndoAvailable();
        const bool isRedo = event.matches(QKeySequence::Redo) && !line->isRedoAvailable();
        if (isUndo || isRedo) {
            event.ignore();
            return true;
        }
    }
    return false;
}

bool KeyRouting::press(QWidget& widget, QKeyEvent& event) {
    if (QAbstractSpinBox* box = spinBoxOf(widget)) {
        return pressInSpinBox(*box, event);
    }
    if (takesText(widget) || !fliesCamera(event)) {
        return false;
    }
    handOver(event);
    return true;
}

bool KeyRouting::pressInSpinBox(QAbstractSpinBox& box, QKeyEvent& event) {
    if (isReturn(event)) {
        box.interpretText();
        m_picture.setFocus();  // with which the editing is finished
        return true;
    }
    if (isEscape(event) && isTyping(box)) {
        dropTyped(box);
        m_picture.setFocus();
        return true;
    }
    if (isCommaForPoint(box, event)) {
        QKeyEvent point(event.type(), Qt::Key_Period, event.modifiers(), QStringLiteral("."));
        QCoreApplication::sendEvent(&box, &point);
        return true;
    }
    if (event.matches(QKeySequence::SelectAll)) {
        m_edited = &box;
    }
    const bool isSpace = event.key() == Qt::Key_Space && isPlain(event);
    const bool isRefused = &box == m_edited && isWritten(event);
    if (isTyping(box) || isRefused || !(isSpace || isEscape(event) || fliesCamera(event))) {
        return false;
    }
    handOver(event);
    return true;
}

void KeyRouting::handOver(QKeyEvent& event) {
    m_picture.setFocus();
    QCoreApplication::sendEvent(&m_picture, &event);
}

}  // namespace hitscope
