// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/scale_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "panels/fields/number_box.h"

namespace hitscope {

namespace {

constexpr double kLeastExtent = 1.0e-6;  // metres, as of the shapes that can be added
constexpr double kMostExtent = 1.0e6;

}  // namespace

ScaleDialog::ScaleDialog(const QString& name, double extent, QWidget* parent)
    : QDialog(parent), m_now(extent), m_extent(new NumberBox(this)), m_factor(new NumberBox(this)) {
    setWindowTitle(tr("Scale"));
    m_extent->setObjectName(QStringLiteral("extent"));
    m_extent->setSuffix(tr(" m"));
    m_extent->setRange(kLeastExtent, kMostExtent);
    m_extent->showNumber(extent);
    m_factor->setObjectName(QStringLiteral("factor"));
    m_factor->setRange(kLeastExtent / extent, kMostExtent / extent);
    m_factor->showNumber(1.0);
    m_extent->setSingleStep(0.0);  // by the number itself
    m_factor->setSingleStep(0.0);
    connect(m_extent, &NumberBox::edited, this, [this](double size) { m_factor->showNumber(size / m_now); });
    connect(m_factor, &NumberBox::edited, this,
            [this](double times) { m_extent->showNumber(times * m_now); });
    auto* form = new QFormLayout;
    form->addRow(tr("Largest &extent"), m_extent);
    form->addRow(tr("&Factor"), m_factor);
    auto* note = new QLabel(tr("“%1” stays where it is, and its hits are scaled with it. Exports keep the "
                               "coordinates of its file, unless you choose those of the scene.")
                                .arg(name),
                            this);
    note->setTextFormat(Qt::PlainText);
    note->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("Scale"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addLayout(form);
    column->addWidget(note);
    column->addWidget(buttons);
    m_extent->setFocus();
    m_extent->selectAll();
}

double ScaleDialog::extent() const {
    return m_extent->value();
}

}  // namespace hitscope
