// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/scatter_dialog.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSettings>
#include <QSpinBox>
#include <limits>
#include <numbers>

#include "analysis/changed_settings.h"
#include "models/focus_target.h"
#include "models/quantity_text.h"
#include "panels/fields/number_box.h"
#include "session/shown_number.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

enum : int { kWhole, kSelected };           // m_region
enum : int { kByNumber, kByDensity };       // m_amount
enum : int { kInward, kAlongView, kDown };  // m_direction
constexpr double kScatterPercent = 100.0;
constexpr double kWidestCone = 90.0;  // degrees
constexpr double kMostDensity = 1.0e12;

QString key(const char* name) {
    return QStringLiteral("scatter/") + QLatin1String(name);
}

}  // namespace

ScatterDialog::ScatterDialog(Session& session, Viewport& viewport, QWidget* parent)
    : PlanDialog(session, viewport, tr("Scatter Hits"), tr("&Scatter"), parent),
      m_region(new QComboBox(this)),
      m_amount(new QComboBox(this)),
      m_count(new QSpinBox(this)),
      m_density(new NumberBox(this)),
      m_size(new QDoubleSpinBox(this)),
      m_direction(new QComboBox(this)),
      m_cone(new QDoubleSpinBox(this)),
      m_seed(new QSpinBox(this)) {
    addFields();
    restore();
    showAmount();
    connect(m_amount, &QComboBox::currentIndexChanged, this, &ScatterDialog::showAmount);
    for (QComboBox* box : {m_region, m_amount, m_direction}) {
        connect(box, &QComboBox::currentIndexChanged, this, &ScatterDialog::replan);
    }
    connect(m_count, &QSpinBox::valueChanged, this, &ScatterDialog::replan);
    connect(m_seed, &QSpinBox::valueChanged, this, &ScatterDialog::replan);
    connect(m_density, &NumberBox::edited, this, &ScatterDialog::replan);
    connect(m_size, &QDoubleSpinBox::valueChanged, this, &ScatterDialog::replan);
    connect(m_cone, &QDoubleSpinBox::valueChanged, this, &ScatterDialog::replan);
    connect(&session.targets(), &SessionTargets::selectedChanged, this, &ScatterDialog::replan);
    connect(&viewport.navigation(), &Navigation::cameraChanged, this, [this] {
        if (m_direction->currentIndex() == kAlongView) {
            replan();
        }
    });
}

void ScatterDialog::addFields() {
    setObjectName(QStringLiteral("scatterDialog"));
    m_region->addItems({tr("The whole target"), tr("Its selected vertices")});
    m_amount->addItems({tr("Number"), tr("Hits per m²")});
    m_amount->setObjectName(QStringLiteral("amount"));
    m_count->setObjectName(QStringLiteral("count"));
    m_count->setRange(1, static_cast<int>(kMostScattered));
    m_count->setGroupSeparatorShown(true);
    m_density->setObjectName(QStringLiteral("density"));
    m_density->setRange(0.0, kMostDensity);
    m_size->setRange(0.0, 95.0);
    m_size->setDecimals(0);
    m_size->setSuffix(tr(" %"));
    m_size->setToolTip(tr("Sizes differ from that of the constants by up to so much"));
    m_direction->setObjectName(QStringLiteral("direction"));
    m_direction->addItems({tr("Into the surface"), tr("Along the view"), tr("Downwards")});
    m_direction->setToolTip(tr("Given directions strike only where the surface faces them"));
    m_cone->setRange(0.0, kWidestCone);
    m_cone->setDecimals(0);
    m_cone->setSuffix(tr("°"));
    m_cone->setToolTip(tr("Directions differ from that one by up to so much"));
    m_seed->setObjectName(QStringLiteral("seed"));
    m_seed->setRange(0, std::numeric_limits<int>::max());
    m_seed->setToolTip(tr("Another seed gives other places; the same one gives the same again"));
    for (QAbstractSpinBox* box :
         {static_cast<QAbstractSpinBox*>(m_count), static_cast<QAbstractSpinBox*>(m_size),
          static_cast<QAbstractSpinBox*>(m_cone), static_cast<QAbstractSpinBox*>(m_seed)}) {
        box->setKeyboardTracking(false);
    }
    fields().addRow(tr("&Over"), m_region);
    fields().addRow(tr("&Amount"), m_amount);
    fields().addRow(tr("&Number"), m_count);
    fields().addRow(tr("&Density"), m_density);
    fields().addRow(tr("Spread of si&ze"), m_size);
    fields().addRow(tr("D&irection"), m_direction);
    fields().addRow(tr("S&pread of direction"), m_cone);
    fields().addRow(tr("S&eed"), m_seed);
}

void ScatterDialog::showAmount() {
    const bool isDensity = m_amount->currentIndex() == kByDensity;
    fields().setRowVisible(m_count, !isDensity);
    fields().setRowVisible(m_density, isDensity);
}

void ScatterDialog::restore() {
    const QSettings settings;
    m_amount->setCurrentIndex(settings.value(key("byDensity"), false).toBool() ? kByDensity : kByNumber);
    m_count->setValue(settings.value(key("count"), 100).toInt());
    m_density->setValue(settings.value(key("density"), 10.0).toDouble());
    m_size->setValue(settings.value(key("sizeSpread"), 0.0).toDouble());
    m_direction->setCurrentIndex(std::clamp(settings.value(key("direction"), 0).toInt(), 0, int{kDown}));
    m_cone->setValue(settings.value(key("cone"), 0.0).toDouble());
    m_seed->setValue(settings.value(key("seed"), 1).toInt());
}

void ScatterDialog::hideEvent(QHideEvent* event) {
    const ChangedSettings settings;
    settings->setValue(key("byDensity"), m_amount->currentIndex() == kByDensity);
    settings->setValue(key("count"), m_count->value());
    settings->setValue(key("density"), m_density->value());
    settings->setValue(key("sizeSpread"), m_size->value());
    settings->setValue(key("direction"), m_direction->currentIndex());
    settings->setValue(key("cone"), m_cone->value());
    settings->setValue(key("seed"), m_seed->value());
    PlanDialog::hideEvent(event);
}

ScatterPlan ScatterDialog::plan() const {
    ScatterPlan plan;
    plan.byDensity = m_amount->currentIndex() == kByDensity;
    plan.count = static_cast<std::uint32_t>(m_count->value());
    plan.density = m_density->value();
    plan.seed = static_cast<std::uint64_t>(m_seed->value());
    plan.sizeSpread = m_size->value() / kScatterPercent;
    plan.isInward = m_direction->currentIndex() == kInward;
    plan.cone = m_cone->value() * std::numbers::pi / 180.0;
    const glm::vec3 world = m_direction->currentIndex() == kAlongView ? viewport().camera().forward()
                                                                      : glm::vec3(0.0f, -1.0f, 0.0f);
    const Target* target = focusTarget(session());
    plan.direction = target != nullptr ? target->transform.directionToLocal(world) : world;
    return plan;
}

void ScatterDialog::replan() {
    const Target* target = focusTarget(session());
    if (isVisible()) {
        planner().plan(target != nullptr ? target->id : TargetId{}, plan(),
                       m_region->currentIndex() == kSelected);
    }
}

QString ScatterDialog::summary(const HitPlanner::Plan& plan) const {
    const Target* target = focusTarget(session());
    const QString text = tr("%Ln {hit|hits} over %1 m² of %2.", nullptr, trCount(plan.hits.size()))
                             .arg(quantityText(plan.area), target != nullptr ? target->name : QString());
    return plan.areDents ? text : text + u' ' + tr("They are shown as marks: too many for dents.");
}

}  // namespace hitscope
