// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/export_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSettings>
#include <QSignalBlocker>
#include <QSpinBox>
#include <utility>

#include "panels/help/help_text.h"

namespace hitscope {

namespace {

constexpr std::uint64_t kLarge = 100'000'000;  // bytes: reading such a file back takes a while
constexpr int kMostSteps = 1000;               // a morph target each
constexpr int kUsualSteps = 20;

QComboBox* addCombo(QFormLayout& form, const QString& label, const char* name, const QStringList& items) {
    auto* box = new QComboBox;
    box->setObjectName(QLatin1String(name));
    box->addItems(items);
    form.addRow(label, box);
    return box;
}

QCheckBox* addCheck(QFormLayout& form, const QString& text, const char* name, const QString& help) {
    auto* box = new QCheckBox(text);
    box->setObjectName(QLatin1String(name));
    box->setToolTip(help);
    form.addRow({}, box);
    return box;
}

}  // namespace

ExportDialog::ExportDialog(Choice choice, QWidget* parent) : QDialog(parent), m_choice(std::move(choice)) {
    setObjectName(QStringLiteral("exportDialog"));
    setWindowTitle(tr("Export Deformed Mesh"));
    auto* form = new QFormLayout(this);
    makeRows(*form);
    m_preview = new QLabel(this);
    m_preview->setObjectName(QStringLiteral("preview"));
    form->addRow(tr("Size:"), m_preview);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->addButton(tr("&Export To…"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    form->addRow(buttons);
    form->setSizeConstraint(QLayout::SetFixedSize);
    for (QComboBox* box : {m_what, m_format, m_frame, m_normals, m_stepOf}) {
        connect(box, &QComboBox::currentIndexChanged, this, &ExportDialog::follow);
    }
    connect(m_allNormals, &QCheckBox::toggled, this, &ExportDialog::follow);
    connect(m_hasSteps, &QCheckBox::toggled, this, &ExportDialog::follow);
    connect(m_steps, &QSpinBox::valueChanged, this, &ExportDialog::follow);
    connect(m_readBack, &QCheckBox::toggled, this,
            [this](bool on) { (isLarge() ? m_readsBackLarge : m_readsBackSmall) = on; });
    follow();
}

void ExportDialog::makeRows(QFormLayout& form) {
    const auto targets = static_cast<int>(m_choice.targets);
    QStringList formats;
    for (const ExportFormatTraits& traits : exportFormats()) {
        formats += tr(traits.name);
    }
    m_what = addCombo(form, tr("&What:"), "what", {});
    m_what->addItem(m_choice.target, static_cast<int>(ExportScope::OneTarget));
    if (m_choice.selected > 1 && m_choice.selected < m_choice.targets) {
        m_what->addItem(
            tr("The %n selected targets, in one file", nullptr, static_cast<int>(m_choice.selected)),
            static_cast<int>(ExportScope::SelectedTargets));
    }
    m_what->addItem(tr("All %n targets, in one file", nullptr, targets),
                    static_cast<int>(ExportScope::AllTargets));
    enableIf(*m_what, targets > 1, tr("There is one target."));
    m_format = addCombo(form, tr("&Format:"), "format", formats);
    m_frame = addCombo(
        form, tr("&Coordinates:"), "frame",
        {m_choice.isScaled ? tr("Those of the mesh's file, unscaled") : tr("Those of the mesh's file"),
         tr("Those of the scene")});
    m_normals = addCombo(form, tr("&Normals:"), "normals", {tr("True"), tr("The paper's")});  // by NormalMode
    m_normals->setCurrentIndex(static_cast<int>(m_choice.shown));
    m_allNormals = addCheck(form, tr("&Also where the file has none"), "allNormals",
                            tr("One for each corner; otherwise only those are written that the mesh's file "
                               "has and that changed"));
    form.addRow({}, makeSteps());
    m_readBack = addCheck(form, tr("&Read the file back and compare"), "readBack",
                          tr("Every vertex and face is held against what was to be written. For files under "
                             "100 MB this is on at first"));
}

QWidget* ExportDialog::makeSteps() {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    m_hasSteps = new QCheckBox(tr("Ani&mate"), row);
    m_hasSteps->setObjectName(QStringLiteral("hasSteps"));
    m_hasSteps->setToolTip(
        tr("A morph target for each hit or group of hits, and an animation that goes through them. Where "
           "there are more than the most steps, a step has several"));
    m_stepOf = new QComboBox(row);  // by MorphUnit
    m_stepOf->setObjectName(QStringLiteral("stepOf"));
    m_stepOf->addItems({tr("each hit"), tr("each group of hits")});
    m_stepOf->setToolTip(
        tr("Hits of one scatter, mirror, stroke or group that follow one another make one step"));
    m_steps = new QSpinBox(row);
    m_steps->setObjectName(QStringLiteral("steps"));
    m_steps->setRange(1, kMostSteps);
    m_steps->setValue(kUsualSteps);
    m_steps->setPrefix(tr("at most "));
    m_steps->setSuffix(tr(" steps"));
    layout->addWidget(m_hasSteps);
    layout->addWidget(m_stepOf);
    layout->addWidget(m_steps);
    layout->addStretch();
    return row;
}

ExportEstimate ExportDialog::estimate() const {
    return m_choice.estimate ? m_choice.estimate(scope(), options()) : ExportEstimate();
}

bool ExportDialog::isLarge() const {
    return estimate().bytes >= kLarge;
}

void ExportDialog::follow() {
    const ExportFormatTraits& format = traitsOf(options().format);
    const QSignalBlocker stillFrame(m_frame);
    if (!isOfOne() && !m_frameOfOne) {
        m_frameOfOne = m_frame->currentIndex();
        m_frame->setCurrentIndex(1);
    } else if (isOfOne() && m_frameOfOne) {
        m_frame->setCurrentIndex(*std::exchange(m_frameOfOne, std::nullopt));
    }
    enableIf(*m_frame, isOfOne(), tr("Several targets are written as they stand in the scene."));
    const QString noNormals = tr("%1 has no normals of vertices.").arg(tr(format.name));
    enableIf(*m_normals, format.hasNormals, noNormals);
    enableIf(*m_allNormals, format.hasNormals, noNormals);
    enableIf(*m_hasSteps, format.hasSteps && m_choice.hits > 0,
             format.hasSteps ? tr("There are no hits yet.") : tr("Only glTF holds animations."));
    for (QWidget* part : {static_cast<QWidget*>(m_stepOf), static_cast<QWidget*>(m_steps)}) {
        enableIf(*part, m_hasSteps->isEnabled() && m_hasSteps->isChecked(), tr("The hits are not animated."));
    }
    enableIf(*m_readBack, format.format != ExportFormat::Csv,
             tr("A table is not a mesh that could be opened."));
    const ExportEstimate size = estimate();
    {
        const QSignalBlocker still(m_readBack);
        m_readBack->setChecked(size.bytes >= kLarge ? m_readsBackLarge : m_readsBackSmall);
    }
    const QLocale locale;
    const QString bytes =
        locale.formattedDataSize(static_cast<qint64>(size.bytes), 1, QLocale::DataSizeSIFormat);
    const QString vertices = locale.toString(static_cast<qulonglong>(size.vertices));
    m_preview->setText(format.format == ExportFormat::Csv
                           ? tr("About %1; vertices that moved: %2").arg(bytes, vertices)
                           : tr("About %1; vertices: %2, faces: %3")
                                 .arg(bytes, vertices, locale.toString(static_cast<qulonglong>(size.faces))));
}

ExportScope ExportDialog::scope() const {
    return static_cast<ExportScope>(m_what->currentData().toInt());
}

/// Where it is not offered, it stays as it is.
void ExportDialog::setScope(ExportScope scope) {
    if (const int item = m_what->findData(static_cast<int>(scope)); item >= 0) {
        m_what->setCurrentIndex(item);
    }
}

ExportOptions ExportDialog::options() const {
    ExportOptions options;
    options.format = exportFormats()[static_cast<std::size_t>(m_format->currentIndex())].format;
    options.normals = static_cast<NormalMode>(m_normals->currentIndex());
    options.allNormals = traitsOf(options.format).hasNormals && m_allNormals->isChecked();
    options.inWorld = m_frame->currentIndex() == 1;
    const bool hasSteps = traitsOf(options.format).hasSteps && m_choice.hits > 0 && m_hasSteps->isChecked();
    options.steps = hasSteps ? static_cast<std::size_t>(m_steps->value()) : 0;
    options.stepOf = static_cast<MorphUnit>(m_stepOf->currentIndex());
    options.readBack = options.format != ExportFormat::Csv && m_readBack->isChecked();
    return options;
}

void ExportDialog::load(const QSettings& settings) {
    const QString key = settings.value(QStringLiteral("export/format")).toString();
    for (const ExportFormatTraits& traits : exportFormats()) {
        if (key == QLatin1String(traits.key)) {
            m_format->setCurrentIndex(static_cast<int>(traits.format));
        }
    }
    m_frame->setCurrentIndex(settings.value(QStringLiteral("export/inWorld"), false).toBool() ? 1 : 0);
    if (m_choice.targets > 1) {
        setScope(settings.value(QStringLiteral("export/all"), false).toBool() ? ExportScope::AllTargets
                                                                              : ExportScope::OneTarget);
        setScope(ExportScope::SelectedTargets);  // who selects several means them
        if (m_choice.selected == 0 || m_choice.selected == m_choice.targets) {
            setScope(ExportScope::AllTargets);
        }
    }
    m_allNormals->setChecked(settings.value(QStringLiteral("export/allNormals"), false).toBool());
    m_hasSteps->setChecked(settings.value(QStringLiteral("export/hasSteps"), false).toBool());
    m_steps->setValue(settings.value(QStringLiteral("export/steps"), kUsualSteps).toInt());
    const bool byGroup = settings.value(QStringLiteral("export/stepOfGroup"), false).toBool();
    m_stepOf->setCurrentIndex(static_cast<int>(byGroup ? MorphUnit::Group : MorphUnit::Hit));
    m_readsBackSmall = settings.value(QStringLiteral("export/readBack"), true).toBool();
    m_readsBackLarge = settings.value(QStringLiteral("export/readBackLarge"), false).toBool();
    follow();
}

void ExportDialog::save(QSettings& settings) const {
    settings.setValue(QStringLiteral("export/format"), QLatin1String(traitsOf(options().format).key));
    settings.setValue(QStringLiteral("export/inWorld"), m_frameOfOne.value_or(m_frame->currentIndex()) == 1);
    if (m_choice.targets > 1 && scope() != ExportScope::SelectedTargets) {
        settings.setValue(QStringLiteral("export/all"), scope() == ExportScope::AllTargets);
    }
    settings.setValue(QStringLiteral("export/allNormals"), m_allNormals->isChecked());
    settings.setValue(QStringLiteral("export/hasSteps"), m_hasSteps->isChecked());
    settings.setValue(QStringLiteral("export/steps"), m_steps->value());
    settings.setValue(QStringLiteral("export/stepOfGroup"), options().stepOf == MorphUnit::Group);
    settings.setValue(QStringLiteral("export/readBack"), m_readsBackSmall);
    settings.setValue(QStringLiteral("export/readBackLarge"), m_readsBackLarge);
}

}  // namespace hitscope
