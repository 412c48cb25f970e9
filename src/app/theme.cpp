// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/theme.h"

#include <QApplication>
#include <QColor>
#include <QPainter>
#include <QProxyStyle>
#include <QStyleOption>

namespace hitscope {

namespace {

/// Fusion without the icons on dialog buttons, which fit neither theme, and with flat tool bars: their white
/// edge is meant for light windows only.
class PlainFusion : public QProxyStyle {
public:
    PlainFusion() : QProxyStyle(QStringLiteral("Fusion")) {}
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* returned) const override {
        return hint == SH_DialogButtonBox_ButtonsHaveIcons
                   ? 0
                   : QProxyStyle::styleHint(hint, option, widget, returned);
    }
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
        if (element != CE_ToolBar) {
            QProxyStyle::drawControl(element, option, painter, widget);
            return;
        }
        const QColor window = option->palette.color(QPalette::Window);
        painter->fillRect(option->rect, window);
        painter->setPen(window.darker(kEdge));
        painter->drawLine(option->rect.bottomLeft(), option->rect.bottomRight());
    }
    /// Fusion's outlines are darker than the window, and so not to be seen in a dark one; nor is what is
    /// pressed.
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        if (element == PE_PanelButtonTool && (option->state & State_On) != 0 && isDark(option->palette)) {
            markPressed(*option, *painter);
            return;
        }
        const bool isBox = element == PE_IndicatorCheckBox;
        if ((!isBox && element != PE_IndicatorRadioButton) || !isDark(option->palette)) {
            return;
        }
        QColor outline = option->palette.color(QPalette::Disabled, QPalette::WindowText);
        outline.setAlphaF((option->state & State_Enabled) != 0 ? 1.0f : kFaint);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(outline);
        painter->setBrush(Qt::NoBrush);
        const QRectF edge = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
        isBox ? painter->drawRoundedRect(edge, kCorner, kCorner) : painter->drawEllipse(edge);
        painter->restore();
    }

private:
    /// Fusion's pressed buttons are somewhat darker, which in a dark window looks like a disabled one.
    static void markPressed(const QStyleOption& option, QPainter& painter) {
        QColor fill = option.palette.color(QPalette::Highlight);
        fill.setAlphaF(kPressed);
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(option.palette.color(QPalette::Highlight));
        painter.setBrush(fill);
        painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), 2 * kCorner, 2 * kCorner);
        painter.restore();
    }

    static constexpr float kPressed = 0.3f;  // opacity
    static constexpr double kCorner = 1.5;   // pixels
    static constexpr float kFaint = 0.6f;
    static constexpr int kEdge = 125;  // per cent
};

struct Colours {
    QRgb window, base, alternate, button, text, disabled, highlight, highlightedText, link, toolTip;
    QRgb light, midlight, mid, dark, shadow;
};

constexpr Colours kLight{.window = 0xfff1f2f4,
                         .base = 0xffffffff,
                         .alternate = 0xfff3f5f7,
                         .button = 0xfff8f9fa,
                         .text = 0xff1d2126,
                         .disabled = 0xff9aa1a9,
                         .highlight = 0xff2f6fbf,
                         .highlightedText = 0xffffffff,
                         .link = 0xff2f6fbf,
                         .toolTip = 0xffffffff,
                         .light = 0xffffffff,
                         .midlight = 0xffe9ebee,
                         .mid = 0xffb9bec5,
                         .dark = 0xff9ca2aa,
                         .shadow = 0xff6d737b};

constexpr Colours kDark{.window = 0xff2a2d31,
                        .base = 0xff1f2124,
                        .alternate = 0xff272a2e,
                        .button = 0xff373b40,
                        .text = 0xffdfe2e6,
                        .disabled = 0xff7b8189,
                        .highlight = 0xff3d7ecf,
                        .highlightedText = 0xffffffff,
                        .link = 0xff7fb2ee,
                        .toolTip = 0xff3a3e44,
                        .light = 0xff4a4f56,
                        .midlight = 0xff40454b,
                        .mid = 0xff1b1d20,
                        .dark = 0xff191b1d,
                        .shadow = 0xff101112};

QPalette paletteOf(const Colours& colours) {
    QPalette palette;
    const auto set = [&palette](QPalette::ColorRole role, QRgb colour) {
        palette.setColor(role, QColor(colour));
    };
    set(QPalette::Window, colours.window);
    set(QPalette::Base, colours.base);
    set(QPalette::AlternateBase, colours.alternate);
    set(QPalette::Button, colours.button);
    set(QPalette::ToolTipBase, colours.toolTip);
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        set(role, colours.text);
        palette.setColor(QPalette::Disabled, role, QColor(colours.disabled));
    }
    set(QPalette::PlaceholderText, colours.disabled);
    set(QPalette::Highlight, colours.highlight);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(colours.mid));
    set(QPalette::HighlightedText, colours.highlightedText);
    palette.setColor(QPalette::Disabled, QPalette::HighlightedText, QColor(colours.disabled));
    set(QPalette::BrightText, 0xffff6b5e);
    set(QPalette::Link, colours.link);
    set(QPalette::LinkVisited, colours.link);
    set(QPalette::Light, colours.light);
    set(QPalette::Midlight, colours.midlight);
    set(QPalette::Mid, colours.mid);
    set(QPalette::Dark, colours.dark);
    set(QPalette::Shadow, colours.shadow);
    return palette;
}

}  // namespace

QStyle* makeStyle() {
    return new PlainFusion;
}

void applyTheme(ThemeChoice choice) {
    switch (choice) {
        case ThemeChoice::System:
            QApplication::setPalette(QPalette());
            break;
        case ThemeChoice::Light:
            QApplication::setPalette(paletteOf(kLight));
            break;
        case ThemeChoice::Dark:
            QApplication::setPalette(paletteOf(kDark));
            break;
    }
}

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::WindowText).lightness() > palette.color(QPalette::Window).lightness();
}

}  // namespace hitscope
