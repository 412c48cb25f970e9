// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/shot_series_dialog.h"

#include <QPushButton>
#include <QSettings>
#include <limits>

#include "analysis/changed_settings.h"
#include "panels/help/help_text.h"
#include "ui_shot_series.h"

namespace hitscope {

namespace {

constexpr double kPercent = 100.0;

}  // namespace

ShotSeriesDialog::ShotSeriesDialog(QWidget* parent)
    : QDialog(parent), m_ui(std::make_unique<Ui::ShotSeries>()) {
    m_ui->setupUi(this);
    m_flightHelp = m_ui->instant->toolTip();
    m_ui->pattern->addItems({tr("Burst"), tr("Line across the view"), tr("Circle in the view")});
    m_ui->count->setMaximum(ShotSeries::kMostShots);
    m_ui->interval->setMaximum(ShotSeries::kLongestInterval);
    m_ui->angle->setMaximum(ShotSeries::kWidest);
    m_ui->seed->setMaximum(std::numeric_limits<int>::max());
    auto* shoot = m_ui->buttons->addButton(tr("S&hoot"), QDialogButtonBox::ActionRole);
    auto* save = m_ui->buttons->addButton(tr("Save &Script…"), QDialogButtonBox::ActionRole);
    shoot->setObjectName(QStringLiteral("shoot"));
    shoot->setDefault(true);
    save->setAutoDefault(false);
    save->setToolTip(tr("Save these shots to a file, to shoot them again from the same places"));
    connect(shoot, &QPushButton::clicked, this, [this] {
        keep();
        Q_EMIT shotsWanted(series());
    });
    connect(save, &QPushButton::clicked, this, [this] { Q_EMIT saveWanted(series()); });
    connect(m_ui->buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(m_ui->pattern, &QComboBox::currentIndexChanged, this, &ShotSeriesDialog::choose);
    showSeries(loadShotSeries(QSettings(), m_shown));
}

ShotSeriesDialog::~ShotSeriesDialog() = default;

void ShotSeriesDialog::setPattern(ShotSeries::Pattern pattern) {
    m_ui->pattern->setCurrentIndex(static_cast<int>(pattern));
}

void ShotSeriesDialog::setShotsFly(bool fly) {
    m_ui->instant->setEnabled(fly);
    m_ui->instant->setToolTip(fly ? m_flightHelp
                                  : tr("The flight in the tool bar is Instant: no shot flies."));
}

ShotSeries ShotSeriesDialog::series() const {
    ShotSeries series;
    series.pattern = m_shown;
    series.count = m_ui->count->value();
    series.interval = m_ui->interval->value();
    series.angle = m_ui->angle->value();
    series.seed = static_cast<std::uint32_t>(m_ui->seed->value());
    series.from = QPointF(m_ui->fromX->value(), m_ui->fromY->value()) / kPercent;
    series.to = QPointF(m_ui->toX->value(), m_ui->toY->value()) / kPercent;
    series.isInstant = m_ui->instant->isChecked();
    return series;
}

void ShotSeriesDialog::choose(int index) {
    keep();
    showSeries(loadShotSeries(QSettings(), static_cast<ShotSeries::Pattern>(index)));
}

void ShotSeriesDialog::showSeries(const ShotSeries& series) {
    m_shown = series.pattern;
    m_ui->count->setValue(series.count);
    m_ui->interval->setValue(series.interval);
    m_ui->angle->setValue(series.angle);
    m_ui->seed->setValue(static_cast<int>(series.seed));
    m_ui->fromX->setValue(series.from.x() * kPercent);
    m_ui->fromY->setValue(series.from.y() * kPercent);
    m_ui->toX->setValue(series.to.x() * kPercent);
    m_ui->toY->setValue(series.to.y() * kPercent);
    m_ui->instant->setChecked(series.isInstant);
    const bool isLine = m_shown == ShotSeries::Pattern::Line;
    const bool isBurst = m_shown == ShotSeries::Pattern::Burst;
    for (QWidget* field : {static_cast<QWidget*>(m_ui->fromX), static_cast<QWidget*>(m_ui->fromY),
                           static_cast<QWidget*>(m_ui->toX), static_cast<QWidget*>(m_ui->toY)}) {
        enableIf(*field, isLine, tr("Only a sweep goes from one place to another."));
    }
    enableIf(*m_ui->angle, !isLine, tr("A sweep has no angle."));
    enableIf(*m_ui->seed, isBurst, tr("Only bursts are random."));
}

void ShotSeriesDialog::keep() {
    saveShotSeries(*ChangedSettings(), series());
}

void ShotSeriesDialog::hideEvent(QHideEvent* event) {
    keep();
    QDialog::hideEvent(event);
}

}  // namespace hitscope
