// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/help/help_text.h"

#include <QAction>
#include <QTextDocument>
#include <QToolButton>
#include <QVariant>

#include "models/plain_text.h"

namespace hitscope {

namespace {

constexpr const char* kWhyProperty = "hitscopeWhyDisabled";

QString nameOf(const QAction& action) {
    return withoutMarks(action.text().section(u'\t', 0, 0));
}

/// "Ctrl+G"; of those that the viewport handles, the one after the tabulator.
QString keyOf(const QAction& action) {
    const QString key = action.shortcut().toString(QKeySequence::NativeText);
    return key.isEmpty() ? action.text().section(u'\t', 1, 1) : key;
}

/// A tooltip of its own, not the name that Qt puts there.
QString ownToolTip(const QAction& action) {
    const QString text = action.toolTip();
    QString plain = text.section(u'\t', 0, 0);
    return plain.remove(QStringLiteral("…")) == nameOf(action) ? QString() : text;
}

/// Some tooltips have the reason in them already. Only `said` may be rich text.
QString joined(const QString& said, const QString& why) {
    const bool isSaid = why.isEmpty() || said.contains(why) || said.contains(why.toHtmlEscaped());
    if (isSaid || said.isEmpty()) {
        return isSaid ? said : asPlainText(why);
    }
    return Qt::mightBeRichText(said) ? said + QStringLiteral("<p>%1</p>").arg(why.toHtmlEscaped())
                                     : said + u'\n' + why;
}

}  // namespace

void enableIf(QAction& action, bool enabled, const QString& why) {
    action.setProperty(kWhyProperty, why);
    action.setEnabled(enabled);
}

void enableIf(QWidget& widget, bool enabled, const QString& why) {
    widget.setProperty(kWhyProperty, why);
    widget.setEnabled(enabled);
}

QString whyDisabled(const QAction& action) {
    return action.isEnabled() ? QString() : action.property(kWhyProperty).toString();
}

QString whyDisabled(const QWidget& widget) {
    for (const QWidget* at = &widget; at != nullptr && !at->isEnabled(); at = at->parentWidget()) {
        const QString why = at->property(kWhyProperty).toString();
        if (!why.isEmpty()) {
            return why;
        }
    }
    return {};
}

QString helpOf(const QAction& action) {
    const QString own = ownToolTip(action);
    QString said = own.isEmpty() ? nameOf(action) : own;
    const QString key = keyOf(action);
    if (!key.isEmpty() && !said.contains(u'(' + key + u')')) {
        said += QStringLiteral(" (%1)").arg(key);
    }
    return joined(said, whyDisabled(action));
}

QString helpOf(const QWidget& widget) {
    const auto* button = qobject_cast<const QToolButton*>(&widget);
    const QAction* action = button != nullptr ? button->defaultAction() : nullptr;
    return action != nullptr ? helpOf(*action) : joined(widget.toolTip(), whyDisabled(widget));
}

QString menuHelpOf(const QAction& action) {
    return joined(ownToolTip(action), whyDisabled(action));
}

}  // namespace hitscope
