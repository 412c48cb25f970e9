// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/hit_history/hit_editor.h"

#include <QLineEdit>
#include <QLocale>
#include <QPushButton>

#include "io/number_text.h"
#include "models/quantity_text.h"
#include "ui_hit_editor.h"

namespace hitscope {

namespace {

QLocale numbers() {
    QLocale locale = QLocale::c();
    locale.setNumberOptions(QLocale::RejectGroupSeparator);
    return locale;
}

QString described(const ParameterDescriptor& parameter) {
    return HitEditor::tr("%1\nFrom %2 to %3 %4")
        .arg(QString::fromUtf8(parameter.description), quantityText(parameter.minimum),
             quantityText(parameter.maximum), QString::fromUtf8(parameter.unit));
}

}  // namespace

HitEditor::HitEditor(const Hit& hit, const QString& title, QWidget* parent)
    : QDialog(parent), m_ui(std::make_unique<Ui::HitEditor>()), m_before(hit), m_hit(hit) {
    m_ui->setupUi(this);
    setWindowTitle(title);
    m_fields = {{{m_ui->pointX, &m_hit.point.x},
                 {m_ui->pointY, &m_hit.point.y},
                 {m_ui->pointZ, &m_hit.point.z},
                 {m_ui->directionX, &m_hit.direction.x},
                 {m_ui->directionY, &m_hit.direction.y},
                 {m_ui->directionZ, &m_hit.direction.z},
                 {m_ui->maxDistance, &m_hit.constants.maxDistance},
                 {m_ui->power, &m_hit.constants.power},
                 {m_ui->maxMagnitude, &m_hit.constants.maxMagnitude}}};
    constexpr std::size_t kFirstConstant = 6;
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        const Field& field = m_fields[i];
        std::string text;
        appendTwiceRoundedFloat(text, *field.value);  // it is read as a double first
        field.edit->setText(QString::fromStdString(text));
        connect(field.edit, &QLineEdit::textChanged, this, &HitEditor::read);
        if (i >= kFirstConstant) {
            field.edit->setToolTip(described(deformationParameters()[i - kFirstConstant]));
        }
    }
    connect(m_ui->buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_ui->buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    read();
}

HitEditor::~HitEditor() = default;

void HitEditor::read() {
    QString problem;
    m_hit = m_before;
    for (const Field& field : m_fields) {
        bool isNumber = false;
        *field.value = numbers().toFloat(field.edit->text().trimmed(), &isNumber);
        if (!isNumber && problem.isEmpty()) {
            problem = tr("“%1” is not a number.").arg(field.edit->text().left(20));
        }
    }
    if (problem.isEmpty()) {
        const Result<Hit> checked = checkedHit(m_hit);
        if (checked) {
            m_hit = checked.value();
        } else {
            problem = QString::fromStdString(checked.error().what);
        }
    }
    m_ui->problem->setText(problem);
    m_ui->buttons->button(QDialogButtonBox::Ok)->setEnabled(problem.isEmpty());
}

}  // namespace hitscope
