// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/keys_overlay.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>
#include <QPainter>
#include <QScrollArea>
#include <QStatusBar>
#include <algorithm>
#include <iterator>
#include <utility>

namespace hitscope {

namespace {

constexpr int kColumnWidth = 300;  // logical pixels at least
constexpr int kMostColumns = 5;
constexpr int kMargin = 16;        // logical pixels
constexpr float kOpacity = 0.92f;  // words have to stay readable over any picture

/// Title, gap and lines.
std::size_t heightOf(const KeysSection& section) {
    constexpr std::size_t kTitleAndGap = 2;
    return section.lines.size() + kTitleAndGap;
}

QString htmlOf(const KeysSection& section, const QString& keyColour) {
    QString html = QStringLiteral("<b>%1</b><table cellspacing=\"2\">").arg(section.title.toHtmlEscaped());
    for (const KeysLine& line : section.lines) {
        html += QStringLiteral(
                    "<tr><td bgcolor=\"%1\" style=\"padding:0px 5px\"><nobr>%2</nobr></td>"
                    "<td style=\"padding:0px 5px\">%3</td></tr>")
                    .arg(keyColour, line.keys.toHtmlEscaped(), line.meaning.toHtmlEscaped());
    }
    return html + QStringLiteral("</table>");
}

/// The sections in order, in at most `columns` columns of about the same height: the lowest limit that
/// suffices.
std::vector<std::vector<const KeysSection*>> arrange(const std::vector<KeysSection>& sections,
                                                     std::size_t columns) {
    std::size_t all = 0;
    std::size_t tallest = 0;
    for (const KeysSection& section : sections) {
        all += heightOf(section);
        tallest = std::max(tallest, heightOf(section));
    }
    for (std::size_t limit = std::max(tallest, all / columns);; ++limit) {
        std::vector<std::vector<const KeysSection*>> arranged(1);
        std::size_t height = 0;
        for (const KeysSection& section : sections) {
            if (height + heightOf(section) > limit) {
                arranged.emplace_back();
                height = 0;
            }
            arranged.back().push_back(&section);
            height += heightOf(section);
        }
        if (arranged.size() <= columns) {
            return arranged;
        }
    }
}

}  // namespace

KeysOverlay::KeysOverlay(QMainWindow& window)
    : QFrame(&window), m_window(window), m_area(new QScrollArea(this)) {
    setObjectName(QStringLiteral("keysOverlay"));
    setFocusPolicy(Qt::StrongFocus);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    m_area->setFrameShape(QFrame::NoFrame);
    m_area->setWidgetResizable(true);
    m_area->setFocusPolicy(Qt::NoFocus);
    m_area->viewport()->setAutoFillBackground(false);
    layout->addWidget(m_area);
    window.installEventFilter(this);
    hide();
}

void KeysOverlay::toggle(std::vector<KeysSection> first) {
    if (isVisible()) {
        closeSheet();
        return;
    }
    m_sections = std::move(first);
    std::vector<KeysSection> own = actionKeys(m_window);
    std::move(own.begin(), own.end(), std::back_inserter(m_sections));
    m_before = m_window.focusWidget();
    place();
    show();
    raise();
    setFocus();
}

void KeysOverlay::closeSheet() {
    hide();
    if (m_before && m_window.isAncestorOf(m_before)) {
        m_before->setFocus();
    }
    m_before.clear();
}

void KeysOverlay::place() {
    QRect room = m_window.rect();
    room.setTop(m_window.menuBar()->isVisible() ? m_window.menuBar()->geometry().bottom() + 1 : 0);
    if (m_window.statusBar()->isVisible()) {
        room.setBottom(m_window.statusBar()->geometry().top() - 1);
    }
    setGeometry(room);
    fill();
}

void KeysOverlay::fill() {
    const auto columns =
        static_cast<std::size_t>(std::clamp((width() - 2 * kMargin) / kColumnWidth, 1, kMostColumns));
    const QString colour = palette().color(QPalette::Button).name();
    auto* sheet = new QWidget;
    auto* row = new QHBoxLayout(sheet);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kMargin);
    for (const auto& sections : arrange(m_sections, columns)) {
        auto* column = new QVBoxLayout;
        column->setSpacing(kMargin / 2);
        for (const KeysSection* section : sections) {
            auto* label = new QLabel(htmlOf(*section, colour), sheet);
            label->setTextFormat(Qt::RichText);
            label->setWordWrap(true);
            column->addWidget(label);
        }
        column->addStretch();
        row->addLayout(column, 1);
    }
    m_area->setWidget(sheet);
    sheet->setAutoFillBackground(false);  // which setWidget() turned on
}

bool KeysOverlay::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_window && event->type() == QEvent::Resize && isVisible()) {
        place();
    }
    return QFrame::eventFilter(watched, event);
}

bool KeysOverlay::event(QEvent* event) {
    // Escape is this sheet's while it is open, whatever else it is the shortcut of.
    if (event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        event->accept();
        return true;
    }
    return QFrame::event(event);
}

void KeysOverlay::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape || event->key() == Qt::Key_F1) {
        closeSheet();
    } else {
        QFrame::keyPressEvent(event);
    }
}

void KeysOverlay::mousePressEvent(QMouseEvent*) {
    closeSheet();
}

void KeysOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    QColor colour = palette().color(QPalette::Window);
    colour.setAlphaF(kOpacity);
    painter.fillRect(rect(), colour);
}

}  // namespace hitscope
