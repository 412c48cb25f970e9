// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <memory>

#include "session/primitive_target.h"

namespace Ui {
class AddPrimitive;
}

namespace hitscope {

/// Asks for a primitive: shape, fineness, size; shows how many vertices that makes.
class AddPrimitiveDialog : public QDialog {
    Q_OBJECT
public:
    /// `size`: metres, to begin with.
    AddPrimitiveDialog(PrimitiveKind kind, float size, QWidget* parent = nullptr);
    ~AddPrimitiveDialog() override;

    [[nodiscard]] Primitive primitive() const;

private:
    void showKind();
    void showVertices();

    std::unique_ptr<Ui::AddPrimitive> m_ui;
};

}  // namespace hitscope
