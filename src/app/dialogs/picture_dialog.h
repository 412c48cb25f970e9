// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QSize>

class QCheckBox;
class QComboBox;
class QRadioButton;
class QSettings;
class QSpinBox;

namespace hitscope {

/// Asks what a picture, or a sequence of them, is to be like.
class PictureDialog : public QDialog {
    Q_OBJECT
public:
    enum class Kind : std::uint8_t { Picture, Sequence };
    /// `shown`: pixels of the viewport; `hits`: what a replay would show, 0: there is nothing to replay.
    PictureDialog(Kind kind, const QSize& shown, std::size_t hits, QWidget* parent = nullptr);

    [[nodiscard]] QSize pictureSize() const;  ///< pixels
    [[nodiscard]] bool isTransparent() const;
    [[nodiscard]] bool hasFloor() const;
    [[nodiscard]] bool hasLabels() const;  ///< the colour bar and the notes
    [[nodiscard]] bool hasSelectionMarks() const;
    [[nodiscard]] int turntable() const;  ///< pictures; 0: a replay
    [[nodiscard]] int samples() const;    ///< as in PictureRequest

    void load(const QSettings& settings);
    void save(QSettings& settings) const;

private:
    QWidget* makeSize();
    QWidget* makeSequence(std::size_t hits);
    QSpinBox* makeSamples();
    void followPreset();
    void followNumbers();

    QSize m_shown;
    QComboBox* m_preset = nullptr;
    QSpinBox* m_width = nullptr;
    QSpinBox* m_height = nullptr;
    QCheckBox* m_transparent = nullptr;
    QCheckBox* m_floor = nullptr;
    QCheckBox* m_labels = nullptr;
    QCheckBox* m_selectionMarks = nullptr;
    QRadioButton* m_replay = nullptr;
    QSpinBox* m_turntable = nullptr;
    QSpinBox* m_samples = nullptr;
};

}  // namespace hitscope
