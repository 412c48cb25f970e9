// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut_texts_support.h"
#include "session/shown_number.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTableView>
#include <QTextDocument>
#include <QToolButton>
#include <QTreeView>
#include <cmath>

namespace hitscope {

namespace {

constexpr int kRounding = 1;  // pixels

QString about(const QWidget& widget, const QString& text, int has, int needs) {
    QString name;
    for (const QWidget* part = &widget; part != nullptr && name.isEmpty(); part = part->parentWidget()) {
        name = part->objectName();
    }
    return QStringLiteral("%1 %2: “%3” has %4 of %5 pixels")
        .arg(QLatin1String(widget.metaObject()->className()), name, text)
        .arg(has)
        .arg(needs);
}

int widthOf(const QWidget& widget, const QString& text) {
    return widget.fontMetrics().size(Qt::TextShowMnemonic, text).width();
}

void addLabel(const QLabel& label, QStringList& cut) {
    if (label.text().isEmpty()) {
        return;
    }
    const QMargins inside = label.contentsMargins();
    const int margin = 2 * label.margin();
    const int width = label.width() - inside.left() - inside.right() - margin;
    const int height = label.height() - inside.top() - inside.bottom() - margin;
    QSize needs;
    if (Qt::mightBeRichText(label.text())) {
        QTextDocument document;
        document.setDefaultFont(label.font());
        document.setDocumentMargin(0.0);
        document.setHtml(label.text());
        if (label.wordWrap()) {
            document.setTextWidth(width);
        }
        needs = {static_cast<int>(std::floor(document.idealWidth())),
                 static_cast<int>(std::floor(document.size().height()))};
    } else {
        const int flags = Qt::TextShowMnemonic | (label.wordWrap() ? Qt::TextWordWrap : 0);
        needs = label.fontMetrics().boundingRect(QRect(0, 0, width, 100'000), flags, label.text()).size();
    }
    if (needs.width() > width + kRounding) {
        cut.append(about(label, label.text(), width, needs.width()));
    } else if (needs.height() > height + 2 * kRounding) {
        cut.append(about(label, label.text() + QStringLiteral(" (height)"), height, needs.height()));
    }
}

void addButton(const QAbstractButton& button, QStringList& cut) {
    if (button.text().isEmpty()) {
        return;
    }
    int needs = widthOf(button, button.text());
    if (const auto* tool = qobject_cast<const QToolButton*>(&button)) {
        if (tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull()) {
            return;
        }
        needs += tool->icon().isNull() ? 0 : tool->iconSize().width();
    } else {
        needs = button.minimumSizeHint().width();
    }
    if (needs > button.width() + kRounding) {
        cut.append(about(button, button.text(), button.width(), needs));
    }
}

/// A scroll area is covered by its own viewport.
bool isOnScreen(const QWidget& widget) {
    if (!widget.isVisible()) {
        return false;
    }
    const auto* area = qobject_cast<const QAbstractScrollArea*>(&widget);
    return !(area != nullptr ? area->viewport() : &widget)->visibleRegion().isEmpty();
}

void addComboBox(const QComboBox& box, QStringList& cut) {
    QStyleOptionComboBox option;
    option.initFrom(&box);
    option.editable = box.isEditable();
    const QRect field =
        box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box);
    const int needs = widthOf(box, box.currentText());
    if (needs > field.width() + kRounding) {
        cut.append(about(box, box.currentText(), field.width(), needs));
    }
}

void addLineEdit(const QLineEdit& edit, QStringList& cut) {
    constexpr int kInside = 4;  // QLineEdit's own margins
    const int width = edit.width() - edit.textMargins().left() - edit.textMargins().right() - kInside;
    const QString text = edit.text().isEmpty() ? edit.placeholderText() : edit.text();
    if (widthOf(edit, text) > width + kRounding) {
        cut.append(about(edit, text, width, widthOf(edit, text)));
    }
}

void addTabs(const QTabBar& tabs, QStringList& cut) {
    for (int i = 0; i < tabs.count(); ++i) {
        if (!tabs.isTabVisible(i)) {
            continue;
        }
        const QRect place = tabs.tabRect(i);
        const bool stands = tabs.shape() == QTabBar::RoundedEast || tabs.shape() == QTabBar::RoundedWest;
        const int room = stands ? place.height() : place.width();
        const int needs = widthOf(tabs, tabs.tabText(i));
        const bool isElided = tabs.elideMode() != Qt::ElideNone && needs > room;
        if (isElided) {
            cut.append(about(tabs, tabs.tabText(i), room, needs));
        }
    }
}

void addHeader(const QHeaderView& header, QStringList& cut) {
    const bool isRow = header.orientation() == Qt::Horizontal;
    const QAbstractItemModel* model = header.model();
    for (int section = 0; isRow && model != nullptr && section < header.count(); ++section) {
        if (header.isSectionHidden(section)) {
            continue;
        }
        const QString text = model->headerData(section, Qt::Horizontal).toString();
        const int needs = widthOf(header, text);
        if (needs > header.sectionSize(section)) {
            cut.append(about(header, text, header.sectionSize(section), needs));
        }
    }
}

/// Rows on the screen only.
void addItems(const QAbstractItemView& view, QStringList& cut) {
    const QAbstractItemModel* model = view.model();
    if (model == nullptr) {
        return;
    }
    QModelIndex row = view.indexAt({2, 2});
    const auto* tree = qobject_cast<const QTreeView*>(&view);
    for (int i = 0; i < 60 && row.isValid(); ++i) {
        for (int column = 0; column < model->columnCount(row.parent()); ++column) {
            const QModelIndex index = row.siblingAtColumn(column);
            const QRect place = view.visualRect(index);
            const QString text = index.data().toString();
            if (place.width() <= 0 || text.isEmpty() ||
                (tree != nullptr && tree->isFirstColumnSpanned(row.row(), row.parent()))) {
                continue;
            }
            const QFontMetrics metrics(
                index.data(Qt::FontRole).isValid() ? index.data(Qt::FontRole).value<QFont>() : view.font());
            const int margin = view.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &view) + 1;
            const int needs = metrics.horizontalAdvance(text) + 2 * margin;
            if (needs > place.width()) {
                cut.append(about(view, text, place.width(), needs));
            }
        }
        row = tree != nullptr ? tree->indexBelow(row) : row.siblingAtRow(row.row() + 1);
    }
}

}  // namespace

QStringList cutTexts(const QWidget& top) {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);  // of texts that have just changed
    QStringList cut;
    QList<const QWidget*> widgets{&top};
    for (const QWidget* widget : top.findChildren<QWidget*>()) {
        widgets.append(widget);
    }
    for (const QWidget* widget : widgets) {
        if (!isOnScreen(*widget)) {
            continue;
        }
        if (const auto* label = qobject_cast<const QLabel*>(widget)) {
            addLabel(*label, cut);
        } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
            addButton(*button, cut);
        } else if (const auto* box = qobject_cast<const QComboBox*>(widget)) {
            addComboBox(*box, cut);
        } else if (const auto* edit = qobject_cast<const QLineEdit*>(widget)) {
            addLineEdit(*edit, cut);
        } else if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) {
            addTabs(*tabs, cut);
        } else if (const auto* header = qobject_cast<const QHeaderView*>(widget)) {
            addHeader(*header, cut);
        } else if (const auto* view = qobject_cast<const QAbstractItemView*>(widget)) {
            addItems(*view, cut);
        }
    }
    cut.removeDuplicates();
    return cut;
}

/// Appends part of the text itself, so that words stay of usual length. Placeholders and marks of rich text
/// are left alone.
QString LongerWords::translate(const char*, const char* text, const char*, int number) const {
    QString source = QString::fromUtf8(text);
    if (number >= 0) {
        source = inEnglish(source, number);
        source.replace(QStringLiteral("%n"), QString::number(number));
    }
    constexpr double kLonger = 0.4;
    QString words = source;
    words.remove(u'&').remove(u'\t').remove(u'\n');
    if (source.contains(u'<') || source.contains(u'*') || source.contains(u'/') || words.size() < 3 ||
        source.contains(u'\t')) {
        return source;
    }
    QString more;
    for (const QChar letter : words) {
        if (static_cast<double>(more.size() + 1) >= kLonger * static_cast<double>(words.size())) {
            break;
        }
        more += letter.isLetter() ? letter.toLower() : u'n';
    }
    const bool hasDots = source.endsWith(u'…');
    if (hasDots) {
        source.chop(1);
    }
    const QString joint = words.size() > 8 ? QStringLiteral(" ") : QString();
    return source + joint + more + (hasDots ? QStringLiteral("…") : QString());
}

}  // namespace hitscope
