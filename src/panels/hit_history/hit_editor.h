// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <array>
#include <memory>

#include "deform/hit.h"

class QLineEdit;

namespace Ui {
class HitEditor;
}

namespace hitscope {

/// Changes point, direction and constants of one hit. Numbers are shown in as many digits as they need, so
/// that what is not touched keeps its bits; what checkedHit() refuses cannot be accepted, and it says why.
class HitEditor : public QDialog {
    Q_OBJECT
public:
    HitEditor(const Hit& hit, const QString& title, QWidget* parent = nullptr);
    ~HitEditor() override;

    [[nodiscard]] const Hit& hit() const { return m_hit; }  ///< valid once accepted

private:
    struct Field {
        QLineEdit* edit = nullptr;
        float* value = nullptr;  ///< in m_hit
    };
    void read();

    std::unique_ptr<Ui::HitEditor> m_ui;
    Hit m_before;
    Hit m_hit;
    std::array<Field, 9> m_fields;
};

}  // namespace hitscope
