// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>

#include "session/mesh_steps/mesh_edit.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSpinBox;

namespace hitscope {

class NumberBox;

/// Asks how a mesh is to be refined, simplified or smoothed, and says what it would have then, which is
/// worked out beside the window.
class MeshStepDialog : public QDialog {
    Q_OBJECT
public:
    enum class Kind : std::uint8_t { Refine, Simplify, Smooth };
    /// `edit`: with the target's hits and selected vertices; what the dialog starts from.
    MeshStepDialog(Kind kind, std::shared_ptr<const MeshData> mesh, const QString& target, MeshEdit edit,
                   QWidget* parent = nullptr);
    ~MeshStepDialog() override;

    [[nodiscard]] MeshEdit edit() const;

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Preview;
    using Choice = std::array<double, 6>;  ///< all fields as numbers
    [[nodiscard]] Choice choice() const;
    void makeRefineRows(QFormLayout& form);
    void makeOtherRows(QFormLayout& form);
    void makeRegionRow(QFormLayout& form);
    void makeApplyRow(QFormLayout& form);
    [[nodiscard]] float usualLength() const;
    void follow();
    void beginPreview();
    [[nodiscard]] QString resultText(const Preview& preview, bool changes) const;
    void propose(float length);
    void showPreview(const Preview& preview, bool done);
    void stopPreview();

    Kind m_kind;
    std::shared_ptr<const MeshData> m_mesh;
    MeshEdit m_edit;
    NumberBox* m_length = nullptr;
    QComboBox* m_method = nullptr;
    QCheckBox* m_keepQuads = nullptr;
    QSpinBox* m_share = nullptr;  ///< per cent
    QSpinBox* m_passes = nullptr;
    QCheckBox* m_keepBorders = nullptr;
    QComboBox* m_region = nullptr;
    QCheckBox* m_apply = nullptr;
    QLabel* m_result = nullptr;
    QPushButton* m_accept = nullptr;  ///< once it is known what comes of it
    QTimer m_soon;
    std::shared_ptr<Preview> m_preview;  ///< null: none is worked out
    std::optional<Choice> m_choice;      ///< that the preview is of
    float m_proposed = 0.0f;             ///< length
    bool m_proposesLength = true;        ///< nobody has chosen another
    bool m_acceptsWhenReady = false;     ///< Return was pressed before it was known what comes of it
};

}  // namespace hitscope
