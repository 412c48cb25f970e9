// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/brush_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>

#include "viewport/brush_tool.h"

namespace hitscope {

namespace {

constexpr double kBrushPercent = 100.0;
constexpr double kMillimetres = 1000.0;
enum : int { kOfSize, kInMillimetres };  // m_unit

QDoubleSpinBox* percentBox(QWidget* parent) {
    auto* box = new QDoubleSpinBox(parent);
    box->setDecimals(0);
    box->setRange(BrushSettings::kLeast * kBrushPercent, BrushSettings::kMost * kBrushPercent);
    box->setSingleStep(5.0);
    box->setSuffix(BrushDialog::tr(" %"));
    box->setKeyboardTracking(false);
    return box;
}

}  // namespace

BrushDialog::BrushDialog(BrushTool& brush, QWidget* parent)
    : QDialog(parent),
      m_brush(brush),
      m_size(percentBox(this)),
      m_strength(percentBox(this)),
      m_unit(new QComboBox(this)),
      m_spacing(percentBox(this)),
      m_millimetres(new QDoubleSpinBox(this)),
      m_direction(new QComboBox(this)) {
    setObjectName(QStringLiteral("brushDialog"));
    setWindowTitle(tr("Brush"));
    m_size->setObjectName(QStringLiteral("size"));
    m_size->setToolTip(tr("Of the max distance in force; [ and ] change it too"));
    m_strength->setToolTip(
        tr("Of the power and the max magnitude in force; Shift+[ and Shift+] change it too"));
    m_unit->setObjectName(QStringLiteral("unit"));
    m_millimetres->setObjectName(QStringLiteral("millimetres"));
    m_unit->addItems({tr("Relative to the size"), tr("In millimetres")});
    m_spacing->setToolTip(tr("Between two hits of a stroke, of the reach of one"));
    m_millimetres->setDecimals(3);
    m_millimetres->setRange(0.001, 1.0e9);
    m_millimetres->setValue(10.0);
    m_millimetres->setSuffix(tr(" mm"));
    m_millimetres->setKeyboardTracking(false);
    m_direction->addItems({tr("Into the surface"), tr("Along the view")});
    auto* fields = new QFormLayout(this);
    fields->addRow(tr("&Size"), m_size);
    fields->addRow(tr("S&trength"), m_strength);
    fields->addRow(tr("S&pacing"), m_unit);
    fields->addRow(QString(), m_spacing);
    fields->addRow(QString(), m_millimetres);
    fields->addRow(tr("&Direction"), m_direction);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    fields->addRow(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    for (QDoubleSpinBox* box : {m_size, m_strength, m_spacing, m_millimetres}) {
        connect(box, &QDoubleSpinBox::valueChanged, this, &BrushDialog::apply);
    }
    connect(m_unit, &QComboBox::currentIndexChanged, this, &BrushDialog::apply);
    connect(m_direction, &QComboBox::currentIndexChanged, this, &BrushDialog::apply);
    connect(&brush, &BrushTool::settingsChanged, this, &BrushDialog::showSettings);
    showSettings();
}

void BrushDialog::showSettings() {
    m_isShowing = true;
    const BrushSettings& settings = m_brush.settings();
    const bool isFixed = settings.spacingMetres > 0.0;
    m_size->setValue(settings.size * kBrushPercent);
    m_strength->setValue(settings.strength * kBrushPercent);
    m_unit->setCurrentIndex(isFixed ? kInMillimetres : kOfSize);
    m_spacing->setValue(settings.spacing * kBrushPercent);
    if (isFixed) {
        m_millimetres->setValue(settings.spacingMetres * kMillimetres);
    }
    auto* fields = qobject_cast<QFormLayout*>(layout());
    fields->setRowVisible(m_spacing, !isFixed);
    fields->setRowVisible(m_millimetres, isFixed);
    m_direction->setCurrentIndex(settings.isInward ? 0 : 1);
    m_isShowing = false;
}

void BrushDialog::apply() {
    if (m_isShowing) {
        return;
    }
    BrushSettings settings;
    settings.size = m_size->value() / kBrushPercent;
    settings.strength = m_strength->value() / kBrushPercent;
    settings.spacing = m_spacing->value() / kBrushPercent;
    settings.spacingMetres =
        m_unit->currentIndex() == kInMillimetres ? m_millimetres->value() / kMillimetres : 0.0;
    settings.isInward = m_direction->currentIndex() == 0;
    m_brush.setSettings(settings);
}

}  // namespace hitscope
