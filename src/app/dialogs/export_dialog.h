// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <cstdint>
#include <functional>
#include <optional>

#include "session/export/export_options.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QSettings;
class QSpinBox;

namespace hitscope {

enum class ExportScope : std::uint8_t { OneTarget, SelectedTargets, AllTargets };

/// Asks what is to be exported, and how.
class ExportDialog : public QDialog {
    Q_OBJECT
public:
    /// What there is to export.
    struct Choice {
        QString target;                       ///< the one in focus, for people
        std::size_t targets = 1;              ///< in the scene
        std::size_t selected = 0;             ///< of these; offered where they are several, and not all
        bool isScaled = false;                ///< the one in focus, against its file
        std::size_t hits = 0;                 ///< that made what is shown
        NormalMode shown = NormalMode::True;  ///< normals on the screen
        /// What an export of these would amount to.
        std::function<ExportEstimate(ExportScope, const ExportOptions&)> estimate = {};
    };
    explicit ExportDialog(Choice choice, QWidget* parent = nullptr);

    [[nodiscard]] ExportOptions options() const;
    [[nodiscard]] ExportScope scope() const;

    void load(const QSettings& settings);
    void save(QSettings& settings) const;

private:
    void makeRows(QFormLayout& form);
    QWidget* makeSteps();
    void follow();
    [[nodiscard]] ExportEstimate estimate() const;
    [[nodiscard]] bool isLarge() const;
    [[nodiscard]] bool isOfOne() const { return scope() == ExportScope::OneTarget; }
    void setScope(ExportScope scope);

    Choice m_choice;
    QComboBox* m_what = nullptr;
    QComboBox* m_format = nullptr;
    QComboBox* m_frame = nullptr;
    std::optional<int> m_frameOfOne;  ///< m_frame where one is written; nothing: it is shown
    QComboBox* m_normals = nullptr;
    QCheckBox* m_allNormals = nullptr;
    QCheckBox* m_hasSteps = nullptr;
    QComboBox* m_stepOf = nullptr;
    QSpinBox* m_steps = nullptr;
    QCheckBox* m_readBack = nullptr;
    QLabel* m_preview = nullptr;
    bool m_readsBackSmall = true;   // what the person chose, or the default
    bool m_readsBackLarge = false;  // likewise
};

}  // namespace hitscope
