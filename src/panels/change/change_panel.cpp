// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/change/change_panel.h"

#include <QPainter>
#include <QScopedValueRollback>
#include <algorithm>
#include <cmath>

#include "analysis/comparison_text.h"
#include "panels/help/help_text.h"
#include "session/shown_number.h"
#include "ui_change.h"

namespace hitscope {

namespace {

constexpr float kSliderScale = 10.0f;    // steps of the exaggeration's slider in 1
constexpr float kWipeScale = 1000.0f;    // steps of the wipe's slider across the picture
constexpr double kLargestValue = 1.0e6;  // that can be typed in
/// Milliseconds: a widget that paints itself has the whole window composed again.
constexpr int kBetweenSummaries = 200;

QColor colourAt(ColourMap map, double at) {
    const auto entry = static_cast<std::size_t>(std::lround(std::clamp(at, 0.0, 1.0) * 255.0));
    const auto& colour = colourTable(map)[entry];
    return {colour[0], colour[1], colour[2]};
}

QIcon iconOf(ColourMap map, const QSize& size) {
    QImage image(size, QImage::Format_RGB32);
    for (int x = 0; x < size.width(); ++x) {
        const QColor colour = colourAt(map, (x + 0.5) / size.width());
        for (int y = 0; y < size.height(); ++y) {
            image.setPixelColor(x, y, colour);
        }
    }
    return QIcon(QPixmap::fromImage(image));
}

/// "Displacement (m)".
QString titleOf(const ChangeTraits& traits) {
    return traits.unit.empty() ? QString::fromUtf8(traits.name)
                               : QStringLiteral("%1 (%2)").arg(QString::fromUtf8(traits.name),
                                                               QString::fromUtf8(traits.unit));
}

}  // namespace

ChangePanel::ChangePanel(ChangeValues& values, Comparison& comparison, const Session& session,
                         QWidget* parent)
    : QWidget(parent),
      m_values(values),
      m_comparison(comparison),
      m_session(session),
      m_ui(std::make_unique<Ui::Change>()) {
    m_ui->setupUi(this);
    m_ui->histogram->setEmptyText(tr("No vertex has changed"));
    fillBoxes();
    connectMap();
    connectBeforeAfter();
    connectComparison();
    m_summaryTimer.setSingleShot(true);
    m_summaryTimer.setInterval(kBetweenSummaries);
    connect(&values, &ChangeValues::summaryChanged, this, [this] {
        m_isSummaryNew = true;
        if (!m_summaryTimer.isActive()) {
            showSummary();
        }
    });
    connect(&m_summaryTimer, &QTimer::timeout, this, [this] {
        if (m_isSummaryNew) {
            showSummary();
        }
    });
    connect(&values, &ChangeValues::histogramChanged, this, &ChangePanel::showHistogram);
    setOptions({});
}

ChangePanel::~ChangePanel() = default;

void ChangePanel::fillBoxes() {
    for (const ChangeTraits& traits : allChangeQuantities()) {
        m_ui->quantity->addItem(QString::fromUtf8(traits.name));
        m_ui->quantity->setItemData(m_ui->quantity->count() - 1, QString::fromUtf8(traits.description),
                                    Qt::ToolTipRole);
    }
    const QSize icon = m_ui->map->iconSize();
    m_ui->map->addItem(iconOf(ColourMap::Viridis, icon), tr("Viridis"));
    m_ui->map->addItem(iconOf(ColourMap::Cividis, icon), tr("Cividis"));
    m_ui->map->addItem(iconOf(ColourMap::CoolWarm, icon), tr("Cool to warm"));
    for (NumberBox* box : {m_ui->low, m_ui->high}) {
        box->setRange(-kLargestValue, kLargestValue);
        box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }
}

void ChangePanel::connectMap() {
    connect(m_ui->on, &QCheckBox::toggled, this, &ChangePanel::editMap);
    connect(m_ui->isolines, &QCheckBox::toggled, this, &ChangePanel::editMap);
    connect(m_ui->quantity, &QComboBox::activated, this, [this](int quantity) {
        ChangeMapOptions map = m_map;
        map.quantity = static_cast<ChangeQuantity>(quantity);
        show(map);
        Q_EMIT mapEdited(m_map);
    });
    connect(m_ui->map, &QComboBox::activated, this, &ChangePanel::editMap);
    connect(m_ui->automatic, &QCheckBox::toggled, this, [this](bool automatic) {
        if (!m_showing && !automatic) {
            // A range is fixed where it is.
            m_map.style().fixed = shownRange(m_map, m_values.summary());
        }
        editMap();
    });
    const auto typed = [this] {
        if (!m_showing) {
            setFixedRange(m_ui->low->value(), m_ui->high->value());
        }
    };
    connect(m_ui->low, &NumberBox::edited, this, typed);
    connect(m_ui->high, &NumberBox::edited, this, typed);
    connect(m_ui->histogram, &HistogramPlot::rangeDragged, this, &ChangePanel::setFixedRange);
}

void ChangePanel::connectBeforeAfter() {
    const auto edit = [this](auto change) {
        if (!m_showing) {
            change(m_beforeAfter);
            showBeforeAfter();
            Q_EMIT beforeAfterEdited(m_beforeAfter);
        }
    };
    connect(m_ui->ghost, &QComboBox::activated, this, [edit](int mode) {
        edit([mode](BeforeAfterOptions& options) { options.ghost = static_cast<GhostMode>(mode); });
    });
    connect(m_ui->wipe, &QCheckBox::toggled, this,
            [edit](bool on) { edit([on](BeforeAfterOptions& options) { options.wipe = on; }); });
    connect(m_ui->wipeAt, &QSlider::valueChanged, this, [edit](int at) {
        edit([at](BeforeAfterOptions& options) { options.wipeAt = static_cast<float>(at) / kWipeScale; });
    });
    connect(m_ui->exaggerationSlider, &QSlider::valueChanged, this, [edit](int at) {
        edit([at](BeforeAfterOptions& options) {
            options.exaggeration = static_cast<float>(at) / kSliderScale;
        });
    });
    connect(m_ui->exaggeration, &QDoubleSpinBox::valueChanged, this, [edit](double factor) {
        edit([factor](BeforeAfterOptions& options) { options.exaggeration = static_cast<float>(factor); });
    });
}

void ChangePanel::setOptions(const DisplayOptions& display) {
    m_beforeAfter = display.beforeAfter;
    show(display.change);
    showBeforeAfter();
    const QScopedValueRollback showing(m_showing, true);
    m_ui->sideBySide->setChecked(display.sideBySide);
}

void ChangePanel::showBeforeAfter() {
    const QScopedValueRollback showing(m_showing, true);
    m_ui->ghost->setCurrentIndex(static_cast<int>(m_beforeAfter.ghost));
    m_ui->wipe->setChecked(m_beforeAfter.wipe);
    enableIf(*m_ui->wipeAt, m_beforeAfter.wipe, tr("Switch the wipe on first."));
    m_ui->wipeAt->setValue(static_cast<int>(std::lround(m_beforeAfter.wipeAt * kWipeScale)));
    m_ui->exaggerationSlider->setValue(
        static_cast<int>(std::lround(m_beforeAfter.exaggeration * kSliderScale)));
    m_ui->exaggeration->setValue(static_cast<double>(m_beforeAfter.exaggeration));
}

void ChangePanel::connectComparison() {
    listPipelines();
    connect(m_ui->other, &QComboBox::activated, this, [this](int index) {
        const QVariant kind = m_ui->other->itemData(index);
        Q_EMIT otherChosen(kind.isValid() ? std::optional(static_cast<PipelineKind>(kind.toInt()))
                                          : std::nullopt);
    });
    connect(m_ui->sideBySide, &QCheckBox::toggled, this, [this](bool on) {
        if (!m_showing) {
            Q_EMIT sideBySideEdited(on);
        }
    });
    connect(&m_session.readBack(), &ReadBack::unavailablePipelinesChanged, this, &ChangePanel::listPipelines);
    connect(&m_session.settings(), &SessionSettings::pipelineChanged, this, &ChangePanel::showReport);
    connect(&m_comparison, &Comparison::otherChanged, this, &ChangePanel::listPipelines);
    connect(&m_comparison, &Comparison::reportChanged, this, &ChangePanel::showReport);
    showReport();
}

void ChangePanel::listPipelines() {
    m_ui->other->clear();
    m_ui->other->addItem(tr("Off"));
    for (const PipelineTraits& traits : allPipelines()) {
        if (m_session.readBack().whyUnavailable(traits.kind).isEmpty()) {
            m_ui->other->addItem(QString::fromUtf8(traits.name), static_cast<int>(traits.kind));
        }
        if (m_comparison.other() == traits.kind) {
            m_ui->other->setCurrentIndex(m_ui->other->count() - 1);
        }
    }
}

void ChangePanel::showReport() {
    m_ui->report->setVisible(m_comparison.other().has_value());
    m_ui->report->setText(comparisonText(m_comparison));
}

void ChangePanel::show(const ChangeMapOptions& map) {
    const QScopedValueRollback showing(m_showing, true);
    m_map = map;
    const QuantityStyle& style = map.style();
    const ChangeTraits& traits = changeTraits(map.quantity);
    m_ui->on->setChecked(map.on);
    m_ui->quantity->setCurrentIndex(static_cast<int>(map.quantity));
    m_ui->map->setCurrentIndex(static_cast<int>(style.map));
    m_ui->isolines->setChecked(map.isolines);
    m_ui->automatic->setChecked(style.automatic);
    for (NumberBox* box : {m_ui->low, m_ui->high}) {
        enableIf(*box, !style.automatic, tr("The range is automatic."));
    }
    m_ui->histogram->setLabels(titleOf(traits), tr("vertices"));
    m_ui->histogram->setColours([palette = style.map](double at) { return colourAt(palette, at); });
    showRange();
    showNumbers();
}

void ChangePanel::showSummary() {
    m_isSummaryNew = false;
    m_summaryTimer.start();
    showRange();
    showNumbers();
}

void ChangePanel::showRange() {
    const QScopedValueRollback showing(m_showing, true);
    const ChangeRange range = shownRange(m_map, m_values.summary());
    for (NumberBox* box : {m_ui->low, m_ui->high}) {
        box->setStepsWithin(static_cast<double>(range.high) - static_cast<double>(range.low));
    }
    m_ui->low->showNumber(static_cast<double>(range.low));
    m_ui->high->showNumber(static_cast<double>(range.high));
    m_ui->histogram->setRange(
        HistogramPlot::Range{static_cast<double>(range.low), static_cast<double>(range.high)});
}

void ChangePanel::showNumbers() {
    const Summary summary = m_values.summary();
    if (summary.count == 0 || m_values.quantity() != m_map.quantity) {
        m_ui->numbers->setText(tr("No vertex has changed"));
        return;
    }
    const QString unit = QString::fromUtf8(changeTraits(m_map.quantity).unit);
    const double mean = summary.sum / static_cast<double>(summary.count);
    m_ui->numbers->setText(tr("%Ln {vertex|vertices}: %1 to %2, mean %3 %4", nullptr, trCount(summary.count))
                               .arg(shownNumber(summary.low, 'g', 4), shownNumber(summary.high, 'g', 4),
                                    shownNumber(mean, 'g', 4), unit));
    m_ui->numbers->setToolTip(
        tr("Root mean square: %1 %2").arg(shownNumber(summary.rootMeanSquare(), 'g', 5), unit));
}

void ChangePanel::showHistogram() {
    m_ui->histogram->setHistogram(m_values.histogram());
}

void ChangePanel::editMap() {
    if (m_showing) {
        return;
    }
    ChangeMapOptions map = m_map;
    map.on = m_ui->on->isChecked();
    map.isolines = m_ui->isolines->isChecked();
    map.style().map = static_cast<ColourMap>(m_ui->map->currentIndex());
    map.style().automatic = m_ui->automatic->isChecked();
    show(map);
    Q_EMIT mapEdited(m_map);
}

/// Ends that have changed places are put in order.
void ChangePanel::setFixedRange(double low, double high) {
    ChangeMapOptions map = m_map;
    map.style().automatic = false;
    map.style().fixed = {static_cast<float>(std::min(low, high)), static_cast<float>(std::max(low, high))};
    if (!(map.style().fixed.low < map.style().fixed.high)) {
        showRange();
        return;
    }
    show(map);
    Q_EMIT mapEdited(m_map);
}

void ChangePanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_values.setHistogramWanted(true);
    Q_EMIT shownOrHidden();
}

void ChangePanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    m_values.setHistogramWanted(false);
    Q_EMIT shownOrHidden();
}

}  // namespace hitscope
