// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/scene/add_primitive_dialog.h"

#include <QCoreApplication>
#include <QPushButton>

#include "models/quantity_text.h"
#include "ui_add_primitive.h"

namespace hitscope {

AddPrimitiveDialog::AddPrimitiveDialog(PrimitiveKind kind, float size, QWidget* parent)
    : QDialog(parent), m_ui(std::make_unique<Ui::AddPrimitive>()) {
    m_ui->setupUi(this);
    m_ui->buttons->button(QDialogButtonBox::Ok)->setText(tr("Add"));
    for (const PrimitiveTraits& traits : allPrimitives()) {
        m_ui->shape->addItem(primitiveName(traits.kind));
    }
    m_ui->shape->setCurrentIndex(static_cast<int>(kind));
    m_ui->size->showNumber(static_cast<double>(size));
    connect(m_ui->shape, &QComboBox::currentIndexChanged, this, &AddPrimitiveDialog::showKind);
    connect(m_ui->resolution, &QSpinBox::valueChanged, this, &AddPrimitiveDialog::showVertices);
    showKind();
    m_ui->resolution->setFocus();
    m_ui->resolution->selectAll();
}

AddPrimitiveDialog::~AddPrimitiveDialog() = default;

Primitive AddPrimitiveDialog::primitive() const {
    return {static_cast<PrimitiveKind>(m_ui->shape->currentIndex()), m_ui->resolution->value(),
            static_cast<float>(m_ui->size->value())};
}

void AddPrimitiveDialog::showKind() {
    const PrimitiveTraits& traits = traitsOf(primitive().kind);
    m_ui->resolutionLabel->setText(QCoreApplication::translate("hitscope::Primitive", traits.resolution));
    m_ui->resolution->setRange(traits.least, traits.most);
    m_ui->resolution->setValue(traits.usual);
    showVertices();
}

void AddPrimitiveDialog::showVertices() {
    m_ui->vertices->setText(countText(vertexCount(primitive())));
}

}  // namespace hitscope
