// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "deform/dent_form.h"

class QComboBox;

namespace hitscope {

/// Two boxes in a row: the fall-off profile of a dent, and which way its vertices move.
class FormFields : public QWidget {
    Q_OBJECT
public:
    explicit FormFields(QWidget* parent = nullptr);

    void show(const DentForm& form);  ///< emits nothing
    /// They stand for several hits that differ in the profile, or in the direction.
    void showDiffering(bool profile, bool direction);

Q_SIGNALS:
    void profileChosen(hitscope::DentProfile profile);
    void directionChosen(hitscope::DentDirection direction);

private:
    QComboBox* m_profile = nullptr;
    QComboBox* m_direction = nullptr;
};

}  // namespace hitscope
