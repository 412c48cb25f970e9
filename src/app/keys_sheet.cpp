// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/keys_sheet.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPalette>
#include <span>

namespace hitscope {

namespace {

struct Line {
    const char* keys;
    const char* meaning;
};

constexpr const char* kContext = "hitscope::KeysSheet";
#define TEXT(words) QT_TRANSLATE_NOOP("hitscope::KeysSheet", words)

constexpr Line kMouse[] = {{TEXT("Click"), TEXT("Shoot at the point under the cursor")},
                           {TEXT("Double-click"), TEXT("Look at that point from now on (shoots nothing)")},
                           {TEXT("Drag"), TEXT("Orbit")},
                           {TEXT("Right-drag"), TEXT("Pan; also Shift+drag and middle-drag")},
                           {TEXT("Wheel"), TEXT("Zoom")}};
constexpr Line kViewport[] = {{TEXT("Space"), TEXT("Shoot at the crosshair; hold to repeat")},
                              {TEXT("Ctrl+B"), TEXT("Burst of shots")},
                              {TEXT("P"), TEXT("Pause, or let time go on")},
                              {TEXT("."), TEXT("One physics step")},
                              {TEXT(","), TEXT("Slow motion")},
                              {TEXT("W A S D"), TEXT("Fly; with Shift faster")},
                              {TEXT("E Q"), TEXT("Fly up and down")},
                              {TEXT("F"), TEXT("Frame the selected target, or all")},
                              {TEXT("Shift+F"), TEXT("Frame all")},
                              {TEXT("Esc"), TEXT("Select nothing")}};
constexpr Line kDisplay[] = {{TEXT("L"), TEXT("Wireframe: off, over, only")},
                             {TEXT("N"), TEXT("Normals: true, the paper's")},
                             {TEXT("T"), TEXT("Textures")},
                             {TEXT("C"), TEXT("Crosshair")},
                             {TEXT("G"), TEXT("Directional light")},
                             {TEXT("H"), TEXT("Point lights")},
                             {TEXT("J"), TEXT("Spotlight")},
                             {TEXT("F11"), TEXT("Full screen")}};
constexpr Line kFiles[] = {{TEXT("Ctrl+O"), TEXT("Open meshes; or drop them on the window")},
                           {TEXT("Ctrl+Shift+O"), TEXT("Add meshes to the scene")},
                           {TEXT("Ctrl+E"), TEXT("Export the deformed mesh")},
                           {TEXT("F12"), TEXT("Save the picture")},
                           {TEXT("Ctrl+Z"), TEXT("Undo the last change of hits or targets")},
                           {TEXT("Ctrl+Shift+Z"), TEXT("Redo")},
                           {TEXT("Ctrl+Shift+Del"), TEXT("Clear all hits")},
                           {TEXT("Ctrl+Q"), TEXT("Quit")}};
constexpr Line kHistory[] = {{TEXT("Space"), TEXT("Disable or enable the selected hits")},
                             {TEXT("Alt+Up Alt+Down"), TEXT("Move them; or drag them to another place")},
                             {TEXT("Del"), TEXT("Remove them")},
                             {TEXT("Ctrl+C"), TEXT("Copy them as CSV")}};
constexpr Line kScene[] = {{TEXT("F2"), TEXT("Rename the target; or double-click")},
                           {TEXT("Space"), TEXT("Hide or show the selected targets")},
                           {TEXT("Ctrl+D"), TEXT("Duplicate them; also in the viewport")},
                           {TEXT("Del"), TEXT("Remove them; also in the viewport")}};
#undef TEXT

QString text(const char* words) {
    return QCoreApplication::translate(kContext, words);
}

QLabel* section(const QString& title, std::span<const Line> lines, const QString& keyColour,
                QWidget* parent) {
    QString html = QStringLiteral("<b>%1</b><table cellspacing=\"4\">").arg(title);
    for (const Line& line : lines) {
        html += QStringLiteral(
                    "<tr><td bgcolor=\"%1\" style=\"padding:1px 6px\"><nobr>%2</nobr></td>"
                    "<td style=\"padding:1px 6px\">%3</td></tr>")
                    .arg(keyColour, text(line.keys).toHtmlEscaped(), text(line.meaning).toHtmlEscaped());
    }
    auto* label = new QLabel(html + QStringLiteral("</table>"), parent);
    label->setTextFormat(Qt::RichText);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    return label;
}

}  // namespace

void showKeysSheet(QWidget* parent) {
    auto* sheet = new QDialog(parent);
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    sheet->setObjectName(QStringLiteral("keysSheet"));
    sheet->setWindowTitle(text(QT_TRANSLATE_NOOP("hitscope::KeysSheet", "Keys and mouse")));
    const QString colour = sheet->palette().color(QPalette::Button).name();
    auto* layout = new QGridLayout(sheet);
    layout->setHorizontalSpacing(24);
    layout->setVerticalSpacing(16);
    layout->addWidget(section(text(QT_TRANSLATE_NOOP("hitscope::KeysSheet", "Mouse")), kMouse, colour, sheet),
                      0, 0);
    layout->addWidget(
        section(text(QT_TRANSLATE_NOOP("hitscope::KeysSheet", "Viewport")), kViewport, colour, sheet), 1, 0);
    layout->addWidget(
        section(text(QT_TRANSLATE_NOOP("hitscope::KeysSheet", "Display")), kDisplay, colour, sheet), 0, 1);
    layout->addWidget(
        section(text(QT_TRANSLATE_NOOP("hitscope::KeysSheet", "Files and hits")), kFiles, colour, sheet), 1,
        1);
    layout->addWidget(
        section(text(QT_TRANSLATE_NOOP("hitscope::KeysSheet", "Hit history")), kHistory, colour, sheet), 2,
        0);
    layout->addWidget(section(text(QT_TRANSLATE_NOOP("hitscope::KeysSheet", "Scene")), kScene, colour, sheet),
                      2, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, sheet);
    QObject::connect(buttons, &QDialogButtonBox::rejected, sheet, &QDialog::close);
    layout->addWidget(buttons, 3, 0, 1, 2);
    layout->setSizeConstraint(QLayout::SetFixedSize);
    sheet->show();
}

}  // namespace hitscope
