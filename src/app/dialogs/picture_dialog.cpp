// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/picture_dialog.h"
#include "panels/help/help_text.h"
#include "scene/picture.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QSpinBox>

namespace hitscope {

namespace {

constexpr int kLargestSide = 65'536;  // pixels; what the driver can draw is said when it cannot
constexpr int kMostPictures = 10'000;
constexpr int kUsualPictures = 120;
constexpr int kUsualSamples = 32;
constexpr QSize kPresets[] = {{1280, 720}, {1920, 1080}, {2560, 1440}, {3840, 2160}, {7680, 4320}};

QSpinBox* makeNumber(const QString& name, int most, int value, QWidget* parent) {
    auto* box = new QSpinBox(parent);
    box->setObjectName(name);
    box->setRange(1, most);
    box->setValue(value);
    return box;
}

}  // namespace

PictureDialog::PictureDialog(Kind kind, const QSize& shown, std::size_t hits, QWidget* parent)
    : QDialog(parent), m_shown(shown) {
    const bool one = kind == Kind::Picture;
    setObjectName(QStringLiteral("pictureDialog"));
    setWindowTitle(one ? tr("Save Picture") : tr("Save Picture Sequence"));
    auto* form = new QFormLayout(this);
    if (!one) {
        form->addRow(tr("Pictures:"), makeSequence(hits));
    }
    form->addRow(tr("Size:"), makeSize());
    form->addRow(tr("Samples:"), makeSamples());
    m_transparent = new QCheckBox(tr("&Transparent background"), this);
    m_transparent->setObjectName(QStringLiteral("transparent"));
    m_floor = new QCheckBox(tr("&Floor"), this);
    m_floor->setChecked(true);
    form->addRow({}, m_transparent);
    form->addRow({}, m_floor);
    m_labels = new QCheckBox(tr("Colour &bar and labels"), this);
    m_labels->setObjectName(QStringLiteral("labels"));
    m_labels->setToolTip(tr("What the viewport writes over the picture where it shows change"));
    m_labels->setChecked(true);
    form->addRow({}, m_labels);
    m_selectionMarks = new QCheckBox(tr("Include selection &marks"), this);
    m_selectionMarks->setObjectName(QStringLiteral("selectionMarks"));
    m_selectionMarks->setToolTip(
        tr("Dots on the selected vertices, the ring of the selected hit, the tint of the selected target"));
    form->addRow({}, m_selectionMarks);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->addButton(one ? tr("&Save As…") : tr("Choose &Folder…"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form->addRow(buttons);
    form->setSizeConstraint(QLayout::SetFixedSize);
}

QWidget* PictureDialog::makeSize() {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    m_preset = new QComboBox(row);
    m_preset->addItem(tr("Same as the viewport"), m_shown);
    for (const QSize& size : kPresets) {
        m_preset->addItem(tr("%1 × %2").arg(size.width()).arg(size.height()), size);
    }
    m_preset->addItem(tr("Another"));
    m_width = makeNumber(QStringLiteral("pictureWidth"), kLargestSide, m_shown.width(), row);
    m_height = makeNumber(QStringLiteral("pictureHeight"), kLargestSide, m_shown.height(), row);
    layout->addWidget(m_preset);
    layout->addWidget(m_width);
    layout->addWidget(new QLabel(tr("×"), row));
    layout->addWidget(m_height);
    layout->addWidget(new QLabel(tr("pixels"), row));
    connect(m_preset, &QComboBox::activated, this, &PictureDialog::followPreset);
    connect(m_width, &QSpinBox::valueChanged, this, &PictureDialog::followNumbers);
    connect(m_height, &QSpinBox::valueChanged, this, &PictureDialog::followNumbers);
    return row;
}

QSpinBox* PictureDialog::makeSamples() {
    m_samples = makeNumber(QStringLiteral("samples"), kMostSamples, kUsualSamples, this);
    m_samples->setToolTip(
        tr("How many pictures each one is the mean of: more give smoother edges, shadows and ambient "
           "occlusion, and take as many times longer. With 1 it is drawn once, without them."));
    return m_samples;
}

QWidget* PictureDialog::makeSequence(std::size_t hits) {
    auto* column = new QWidget(this);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* turn = new QWidget(column);
    auto* turnLayout = new QHBoxLayout(turn);
    turnLayout->setContentsMargins(0, 0, 0, 0);
    auto* turntable = new QRadioButton(tr("&Once around, in"), turn);
    turntable->setObjectName(QStringLiteral("turntable"));
    turntable->setChecked(true);
    m_turntable = makeNumber(QStringLiteral("turntablePictures"), kMostPictures, kUsualPictures, turn);
    m_turntable->setSuffix(tr(" pictures"));
    turnLayout->addWidget(turntable);
    turnLayout->addWidget(m_turntable);
    turnLayout->addStretch();
    m_replay = new QRadioButton(tr("The &hits one by one (%n)", nullptr, static_cast<int>(hits)), column);
    m_replay->setObjectName(QStringLiteral("replay"));
    enableIf(*m_replay, hits > 0, tr("There are no hits yet."));
    layout->addWidget(turn);
    layout->addWidget(m_replay);
    auto* group = new QButtonGroup(this);
    group->addButton(turntable);
    group->addButton(m_replay);
    return column;
}

void PictureDialog::followPreset() {
    const QSize size = m_preset->currentData().toSize();
    if (size.isValid()) {
        const QSignalBlocker still(m_width);
        m_width->setValue(size.width());
        m_height->setValue(size.height());
    } else {
        m_width->setFocus();
        m_width->selectAll();
    }
}

void PictureDialog::followNumbers() {
    const int known = m_preset->findData(pictureSize());
    m_preset->setCurrentIndex(known < 0 ? m_preset->count() - 1 : known);
}

QSize PictureDialog::pictureSize() const {
    return {m_width->value(), m_height->value()};
}

bool PictureDialog::isTransparent() const {
    return m_transparent->isChecked();
}

bool PictureDialog::hasFloor() const {
    return m_floor->isChecked();
}

bool PictureDialog::hasLabels() const {
    return m_labels->isChecked();
}

bool PictureDialog::hasSelectionMarks() const {
    return m_selectionMarks->isChecked();
}

int PictureDialog::samples() const {
    return m_samples->value();
}

int PictureDialog::turntable() const {
    return m_turntable == nullptr || m_replay->isChecked() ? 0 : m_turntable->value();
}

void PictureDialog::load(const QSettings& settings) {
    const QSize size = settings.value(QStringLiteral("picture/size")).toSize();
    if (size.isValid() && size.width() <= kLargestSide && size.height() <= kLargestSide) {
        m_width->setValue(size.width());
        m_height->setValue(size.height());
    }
    m_samples->setValue(settings.value(QStringLiteral("picture/samples"), kUsualSamples).toInt());
    m_transparent->setChecked(settings.value(QStringLiteral("picture/transparent"), false).toBool());
    m_floor->setChecked(settings.value(QStringLiteral("picture/floor"), true).toBool());
    m_labels->setChecked(settings.value(QStringLiteral("picture/labels"), true).toBool());
    m_selectionMarks->setChecked(settings.value(QStringLiteral("picture/selectionMarks"), false).toBool());
    if (m_turntable != nullptr) {
        m_turntable->setValue(settings.value(QStringLiteral("picture/turntable"), kUsualPictures).toInt());
    }
}

void PictureDialog::save(QSettings& settings) const {
    // The viewport's own size is no size to remember: it changes with the window.
    if (pictureSize() == m_shown) {
        settings.remove(QStringLiteral("picture/size"));
    } else {
        settings.setValue(QStringLiteral("picture/size"), pictureSize());
    }
    settings.setValue(QStringLiteral("picture/samples"), samples());
    settings.setValue(QStringLiteral("picture/transparent"), isTransparent());
    settings.setValue(QStringLiteral("picture/floor"), hasFloor());
    settings.setValue(QStringLiteral("picture/labels"), hasLabels());
    settings.setValue(QStringLiteral("picture/selectionMarks"), hasSelectionMarks());
    if (m_turntable != nullptr) {
        settings.setValue(QStringLiteral("picture/turntable"), m_turntable->value());
    }
}

}  // namespace hitscope
