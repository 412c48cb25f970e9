// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/dent_measurement/dent_measurement_panel.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QMessageBox>
#include <QToolTip>
#include <algorithm>
#include <numbers>

#include "io/staged_files.h"
#include "models/plain_text.h"
#include "models/quantity_text.h"
#include "models/vertex_facts.h"
#include "panels/fields/save_name.h"
#include "panels/help/help_text.h"
#include "panels/icons/themed_icon.h"
#include "panels/plot/plot_theme.h"
#include "ui_dent_measurement.h"

namespace hitscope {

namespace {

constexpr int kProfileBeside = 420;  // pixels; from here on the profile is beside the figures

constexpr double kDegree = std::numbers::pi / 180.0;

/// The highest point of the lines at `along`: the outer surface, where a profile crosses it more than once.
std::optional<double> heightAt(const DentMeasurement::Profile& lines, double along) {
    std::optional<double> highest;
    for (const std::vector<ProfilePoint>& line : lines) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            const ProfilePoint& a = line[i - 1];
            const ProfilePoint& b = line[i];
            if (std::min(a.along, b.along) > along || std::max(a.along, b.along) < along) {
                continue;
            }
            const double width = b.along - a.along;
            const double height = width == 0.0 ? std::max(a.height, b.height)
                                               : a.height + (along - a.along) / width * (b.height - a.height);
            highest = std::max(highest.value_or(height), height);
        }
    }
    return highest;
}

}  // namespace

DentMeasurementPanel::DentMeasurementPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_ui(std::make_unique<Ui::DentMeasurementForm>()), m_measurement(session) {
    m_ui->setupUi(this);
    m_measurement.setActive(false);
    for (QLabel* figure : {m_ui->depth, m_ui->rim, m_ui->area, m_ui->volume, m_ui->distance}) {
        figure->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    m_ui->copy->setIcon(themedIcon(QStringLiteral("copy")));
    m_ui->csv->setIcon(themedIcon(QStringLiteral("export")));
    QCustomPlot* plot = m_ui->plot;
    plot->setBufferDevicePixelRatio(plot->devicePixelRatioF());
    plot->xAxis->setLabel(tr("along (m)"));
    plot->yAxis->setLabel(tr("height (m)"));
    plot->xAxis->setLabelPadding(1);
    plot->yAxis->setLabelPadding(1);
    plot->yAxis->ticker()->setTickCount(3);
    plot->setMouseTracking(true);
    m_pointer = new QCPItemStraightLine(plot);
    m_pointer->setVisible(false);
    connect(plot, &QCustomPlot::mouseMove, this,
            [this](QMouseEvent* event) { readProfile(event->position()); });
    connect(m_ui->angleSlider, &QSlider::valueChanged, m_ui->angle, &QSpinBox::setValue);
    connect(m_ui->angle, &QSpinBox::valueChanged, m_ui->angleSlider, &QSlider::setValue);
    connect(m_ui->angle, &QSpinBox::valueChanged, this,
            [this](int degrees) { m_measurement.setAngle(degrees * kDegree); });
    m_ui->apart->setChecked(m_measurement.tellsApart());
    connect(m_ui->apart, &QCheckBox::toggled, &m_measurement, &DentMeasurement::setTellsApart);
    connect(m_ui->copy, &QToolButton::clicked, this, &DentMeasurementPanel::copy);
    connect(m_ui->csv, &QToolButton::clicked, this, &DentMeasurementPanel::chooseCsv);
    connect(&m_measurement, &DentMeasurement::reportChanged, this, &DentMeasurementPanel::showReport);
    connect(&m_measurement, &DentMeasurement::distanceChanged, this, &DentMeasurementPanel::showDistance);
    applyPalette();
    showReport();
    showDistance();
}

DentMeasurementPanel::~DentMeasurementPanel() = default;

void DentMeasurementPanel::showReport() {
    const DentMeasurement::Report& report = m_measurement.report();
    const std::optional<DentMeasures>& dent = report.dent;
    const QString merged = report.merged.isEmpty() ? QString() : u'\n' + report.merged;
    m_ui->subject->setText(dent ? tr("%1, vertices moved: %2").arg(report.target, countText(dent->vertices)) +
                                      merged
                                : report.why);
    const auto show = [&dent](QLabel& label, double DentMeasures::*figure, const QString& unit) {
        label.setText(dent ? quantityText((*dent).*figure) + u' ' + unit : QStringLiteral("–"));
    };
    show(*m_ui->depth, &DentMeasures::depth, tr("m"));
    show(*m_ui->rim, &DentMeasures::rimDiameter, tr("m"));
    show(*m_ui->area, &DentMeasures::affectedArea, tr("m²"));
    show(*m_ui->volume, &DentMeasures::displacedVolume, tr("m³"));
    enableIf(*m_ui->csv, dent.has_value(), tr("No dent is measured."));
    drawProfile();
}

void DentMeasurementPanel::showDistance() {
    const std::optional<DentMeasurement::Distance> distance = m_measurement.distance();
    m_ui->distance->setText(
        distance
            ? tr("%1 m, deformed %2 m").arg(quantityText(distance->before), quantityText(distance->after))
            : tr("pick two vertices"));
    m_ui->distance->setToolTip(
        distance ? tr("Vertices %1 and %2")
                       .arg(vertexNumberText(distance->from.vertex), vertexNumberText(distance->to.vertex))
                 : QString());
}

void DentMeasurementPanel::drawProfile() {
    QCustomPlot* plot = m_ui->plot;
    for (QCPCurve* curve : m_curves) {
        plot->removePlottable(curve);
    }
    m_curves.clear();
    m_pointer->setVisible(false);
    const auto add = [&](const DentMeasurement::Profile& lines, const QPen& pen) {
        for (const std::vector<ProfilePoint>& line : lines) {
            auto* curve = new QCPCurve(plot->xAxis, plot->yAxis);
            curve->setPen(pen);
            for (const ProfilePoint& point : line) {
                curve->addData(point.along, point.height);
            }
            m_curves.push_back(curve);
        }
    };
    QColor original = palette().color(QPalette::WindowText);
    original.setAlphaF(0.6f);
    add(m_measurement.report().before, QPen(original, 1, Qt::DashLine));
    add(m_measurement.report().after, QPen(palette().color(QPalette::Highlight), 1.5));
    plot->rescaleAxes();
    plot->yAxis->scaleRange(1.2);
    plot->replot(QCustomPlot::rpQueuedReplot);
}

void DentMeasurementPanel::applyPalette() {
    applyPlotTheme(*m_ui->plot, *this);
    m_pointer->setPen(QPen(palette().color(QPalette::WindowText), 1));
    drawProfile();
}

std::optional<double> DentMeasurementPanel::depthAt(double along) const {
    const std::optional<double> before = heightAt(m_measurement.report().before, along);
    const std::optional<double> after = heightAt(m_measurement.report().after, along);
    return before && after ? std::optional(*before - *after) : std::nullopt;
}

void DentMeasurementPanel::readProfile(const QPointF& position) {
    QCustomPlot* plot = m_ui->plot;
    const double along = plot->xAxis->pixelToCoord(position.x());
    const std::optional<double> depth = depthAt(along);
    m_pointer->setVisible(depth.has_value());
    m_pointer->point1->setCoords(along, 0.0);
    m_pointer->point2->setCoords(along, 1.0);
    plot->replot(QCustomPlot::rpQueuedReplot);
    QToolTip::showText(
        plot->mapToGlobal(position.toPoint()),
        depth ? tr("%1 m along, %2 m deep").arg(quantityText(along), quantityText(*depth)) : QString(), plot);
}

void DentMeasurementPanel::copy() {
    QGuiApplication::clipboard()->setText(m_measurement.text());
}

Status DentMeasurementPanel::saveCsv(const QString& path) const {
    const QByteArray csv = m_measurement.profileCsv();
    return writeWhole(path, {csv.constData(), static_cast<std::size_t>(csv.size())});
}

void DentMeasurementPanel::chooseCsv() {
    const QString path = askSaveName(this, {.title = tr("Save Profile as CSV"),
                                            .suggested = QStringLiteral("profile.csv"),
                                            .filters = {tr("CSV (*.csv)")},
                                            .suffixes = {QStringLiteral("csv")}});
    if (path.isEmpty()) {
        return;
    }
    if (const Status status = saveCsv(path); !status) {
        QMessageBox::warning(this, tr("Save Profile as CSV"),
                             asPlainText(QString::fromStdString(status.error().message())));
    }
}

void DentMeasurementPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if ((event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) &&
        m_pointer != nullptr) {
        applyPalette();
    }
}

/// Below one another where it is narrow: at the side of the window.
void DentMeasurementPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_ui->body->setDirection(width() < kProfileBeside ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void DentMeasurementPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_measurement.setActive(true);
}

void DentMeasurementPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    m_measurement.setActive(false);
}

}  // namespace hitscope
