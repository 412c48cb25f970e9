// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/cutting_plane/cutting_plane_panel.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMessageBox>
#include <QScopedValueRollback>
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "io/staged_files.h"
#include "models/plain_text.h"
#include "models/quantity_text.h"
#include "panels/fields/save_name.h"
#include "panels/help/help_text.h"
#include "panels/icons/themed_icon.h"
#include "session/target.h"
#include "ui_cutting_plane.h"

namespace hitscope {

namespace {

constexpr int kPlotBeside = 520;        // pixels; from here on the plot is beside the controls
constexpr double kLargest = 1.0e6;      // metres
constexpr float kSameNormal = 5.0e-4f;  // what three decimals cannot tell apart
constexpr float kLeastNormal = 1.0e-3f;

/// So that it is seen in any theme which one is on.
void emphasize(QToolButton& button) {
    QPalette colours;
    if (button.isChecked()) {
        colours.setColor(QPalette::Button, colours.color(QPalette::Highlight));
        colours.setColor(QPalette::ButtonText, colours.color(QPalette::HighlightedText));
    }
    button.setPalette(colours);
}

glm::vec3 axis(int i) {
    glm::vec3 unit(0.0f);
    unit[i] = 1.0f;
    return unit;
}

QRectF around(const SectionView& view, const Bounds& bounds) {
    QRectF room;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec2 at = view({(corner & 1) != 0 ? bounds.max.x : bounds.min.x,
                                    (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                                    (corner & 4) != 0 ? bounds.max.z : bounds.min.z});
        if (corner == 0) {
            room = QRectF(at.x, at.y, 0.0, 0.0);
        }
        room.setCoords(std::min(room.left(), at.x), std::min(room.top(), at.y), std::max(room.right(), at.x),
                       std::max(room.bottom(), at.y));
    }
    return room;
}

}  // namespace

CuttingPlanePanel::CuttingPlanePanel(const Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_ui(std::make_unique<Ui::CuttingPlaneForm>()) {
    m_ui->setupUi(this);
    m_ui->copy->setIcon(themedIcon(QStringLiteral("copy")));
    m_ui->reset->setIcon(themedIcon(QStringLiteral("reset")));
    m_ui->csv->setIcon(themedIcon(QStringLiteral("export")));
    m_ui->deepest->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_ui->deepest->setMinimumHeight(2 * fontMetrics().lineSpacing());
    for (QDoubleSpinBox* box : {m_ui->normalX, m_ui->normalY, m_ui->normalZ}) {
        box->setRange(-1.0, 1.0);
        box->setDecimals(3);
        box->setSingleStep(0.1);
        box->setKeyboardTracking(false);
        box->setToolTip(tr("Direction of the normal; its length is ignored"));
        connect(box, &QDoubleSpinBox::valueChanged, this, &CuttingPlanePanel::editNormal);
    }
    m_ui->offset->setRange(-kLargest, kLargest);
    for (QToolButton* button : {m_ui->alongX, m_ui->alongY, m_ui->alongZ, m_ui->flip}) {
        connect(button, &QToolButton::toggled, this, [button] { emphasize(*button); });
    }
    connectPlane();
    connectReadOut();
    setCut({}, {});
    setSection(nullptr);
}

CuttingPlanePanel::~CuttingPlanePanel() = default;

void CuttingPlanePanel::edit(const std::function<void(CuttingPlane&)>& change) {
    if (!m_showing) {
        CuttingPlane cut = m_cut;
        change(cut);
        Q_EMIT edited(cut);
    }
}

void CuttingPlanePanel::connectPlane() {
    const auto toggle = [this](QAbstractButton& button, bool CuttingPlane::*option) {
        connect(&button, &QAbstractButton::toggled, this,
                [this, option](bool on) { edit([option, on](CuttingPlane& cut) { cut.*option = on; }); });
    };
    toggle(*m_ui->on, &CuttingPlane::on);
    toggle(*m_ui->flip, &CuttingPlane::flipped);
    toggle(*m_ui->originalLine, &CuttingPlane::originalLine);
    toggle(*m_ui->deformedLine, &CuttingPlane::deformedLine);
    toggle(*m_ui->fill, &CuttingPlane::fill);
    QToolButton* const buttons[] = {m_ui->alongX, m_ui->alongY, m_ui->alongZ};
    for (int i = 0; i < 3; ++i) {
        connect(buttons[i], &QToolButton::clicked, this, [this, i] {
            showNormal();  // a click on the one that is chosen does not let go of it
            Q_EMIT normalChosen(axis(i));
        });
    }
    connect(m_ui->fromView, &QToolButton::clicked, this, &CuttingPlanePanel::fromViewWanted);
    connect(m_ui->reset, &QToolButton::clicked, this, &CuttingPlanePanel::resetWanted);
    connect(m_ui->offset, &NumberBox::edited, this, [this](double offset) {
        edit([offset](CuttingPlane& cut) { cut.offset = static_cast<float>(offset); });
    });
    connect(m_ui->offsetSlider, &QSlider::valueChanged, this, [this](int at) {
        const OffsetRange range = offsetRange(m_bounds, m_cut.normal);
        const float part = static_cast<float>(at) / static_cast<float>(m_ui->offsetSlider->maximum());
        edit([&](CuttingPlane& cut) { cut.offset = range.low + part * (range.high - range.low); });
    });
    connect(m_ui->offsetSlider, &QSlider::sliderPressed, this, [this] { Q_EMIT moving(true); });
    connect(m_ui->offsetSlider, &QSlider::sliderReleased, this, [this] { Q_EMIT moving(false); });
}

void CuttingPlanePanel::connectReadOut() {
    connect(m_ui->copy, &QToolButton::clicked, this, [this] {
        if (m_section) {
            QGuiApplication::clipboard()->setText(sectionText(*m_section, m_scope));
        }
    });
    connect(m_ui->csv, &QToolButton::clicked, this, &CuttingPlanePanel::chooseCsv);
    connect(&m_session.targets(), &SessionTargets::selectedChanged, this, &CuttingPlanePanel::showSection);
}

void CuttingPlanePanel::setCut(const CuttingPlane& cut, const Bounds& bounds) {
    const QScopedValueRollback showing(m_showing, true);
    m_cut = cut;
    m_bounds = bounds;
    m_ui->on->setChecked(cut.on);
    m_ui->flip->setChecked(cut.flipped);
    m_ui->originalLine->setChecked(cut.originalLine);
    m_ui->deformedLine->setChecked(cut.deformedLine);
    m_ui->fill->setChecked(cut.fill);
    m_ui->plot->setShown(cut.originalLine, cut.deformedLine);
    showNormal();
    showOffset();
    if (!m_section) {
        showSection();
    }
}

void CuttingPlanePanel::showNormal() {
    const QScopedValueRollback showing(m_showing, true);
    QToolButton* const buttons[] = {m_ui->alongX, m_ui->alongY, m_ui->alongZ};
    for (int i = 0; i < 3; ++i) {
        buttons[i]->setChecked(m_cut.normal == axis(i));
    }
    // What has been typed stays as long as it means the same direction.
    const glm::vec3 typed(m_ui->normalX->value(), m_ui->normalY->value(), m_ui->normalZ->value());
    if (glm::length(typed) < kLeastNormal ||
        glm::distance(glm::normalize(typed), m_cut.normal) > kSameNormal) {
        m_ui->normalX->setValue(static_cast<double>(m_cut.normal.x));
        m_ui->normalY->setValue(static_cast<double>(m_cut.normal.y));
        m_ui->normalZ->setValue(static_cast<double>(m_cut.normal.z));
    }
}

void CuttingPlanePanel::showOffset() {
    const OffsetRange range = offsetRange(m_bounds, m_cut.normal);
    const float span = range.high - range.low;
    const float part = span > 0.0f ? (m_cut.offset - range.low) / span : 0.5f;
    m_ui->offset->setStepsWithin(static_cast<double>(span));
    m_ui->offset->showNumber(static_cast<double>(m_cut.offset));
    if (!m_ui->offsetSlider->isSliderDown()) {
        m_ui->offsetSlider->setValue(static_cast<int>(
            std::lround(std::clamp(part, 0.0f, 1.0f) * static_cast<float>(m_ui->offsetSlider->maximum()))));
    }
}

/// About the point of the plane that is nearest to the middle of the scene.
void CuttingPlanePanel::editNormal() {
    const glm::vec3 typed(m_ui->normalX->value(), m_ui->normalY->value(), m_ui->normalZ->value());
    if (glm::length(typed) < kLeastNormal) {
        return;
    }
    const glm::vec3 middle = planeFrame(m_cut, m_bounds).middle;
    edit([&](CuttingPlane& cut) {
        cut.normal = glm::normalize(typed);
        cut.offset = glm::dot(cut.normal, middle);
    });
}

void CuttingPlanePanel::setSection(std::shared_ptr<const SceneSection> section) {
    m_section = std::move(section);
    showSection();
}

/// The boxes that the targets of the section had before any hit, laid out flat.
QRectF CuttingPlanePanel::room() const {
    Bounds bounds;
    for (const TargetSection& section : m_section->targets) {
        const Target* target = m_scope.holds(section) ? m_session.targets().find(section.target) : nullptr;
        if (target != nullptr) {
            bounds.add(target->worldBounds());
        }
    }
    return bounds.empty() ? QRectF() : around(sectionView(m_section->cut.openSide()), bounds);
}

void CuttingPlanePanel::showSection() {
    const bool isAny = m_section && !m_section->targets.empty();
    const QString none = tr("The plane cuts no target, or is off.");
    enableIf(*m_ui->copy, isAny, none);
    enableIf(*m_ui->csv, isAny, none);
    if (!m_section) {
        m_ui->deepest->setText(m_cut.on ? tr("Computing the section…")
                                        : tr("Switch the plane on to see a section."));
        m_ui->plot->setSection(nullptr, {}, {});
        return;
    }
    m_scope = sectionScope(*m_section, m_session.targets().selected());
    m_ui->plot->setSection(m_section, m_scope, room());
    const auto deepest = deepestOf(*m_section, m_scope);
    const SectionView view = sectionView(m_section->cut.openSide());
    m_ui->deepest->setText(!isAny ? tr("The plane cuts no target.")
                           : deepest
                               ? tr("Greatest depth: %1 m\nat %2")
                                     .arg(quantityText(*deepest->depth), placeText(view, deepest->place))
                               : tr("Nothing has moved in this section."));
}

Status CuttingPlanePanel::saveCsv(const QString& path) const {
    const QByteArray csv = m_section ? sectionCsv(*m_section, m_scope) : QByteArray();
    return writeWhole(path, {csv.constData(), static_cast<std::size_t>(csv.size())});
}

void CuttingPlanePanel::chooseCsv() {
    const QString path = askSaveName(this, {.title = tr("Save Section as CSV"),
                                            .suggested = QStringLiteral("section.csv"),
                                            .filters = {tr("CSV (*.csv)")},
                                            .suffixes = {QStringLiteral("csv")}});
    if (path.isEmpty()) {
        return;
    }
    if (const Status status = saveCsv(path); !status) {
        QMessageBox::warning(this, tr("Save Section as CSV"),
                             asPlainText(QString::fromStdString(status.error().message())));
    }
}

void CuttingPlanePanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        for (QToolButton* button : {m_ui->alongX, m_ui->alongY, m_ui->alongZ, m_ui->flip}) {
            emphasize(*button);
        }
    }
}

/// Below one another where it is narrow: at the side of the window.
void CuttingPlanePanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const bool isNarrow = width() < kPlotBeside;
    m_ui->body->setDirection(isNarrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

}  // namespace hitscope
