// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <memory>

#include "app/shot_series.h"

namespace Ui {
class ShotSeries;
}

namespace hitscope {

/// Asks for a series of shots: a burst, or a sequence along a path. Stays open, so that the camera can be
/// moved and the same shot again; what was asked for last is remembered.
class ShotSeriesDialog : public QDialog {
    Q_OBJECT
public:
    explicit ShotSeriesDialog(QWidget* parent = nullptr);
    ~ShotSeriesDialog() override;

    void setPattern(ShotSeries::Pattern pattern);
    /// Whether shots fly at all in the session's flight mode: where not, the series has no say in it.
    void setShotsFly(bool fly);
    [[nodiscard]] ShotSeries series() const;

Q_SIGNALS:
    void shotsWanted(const hitscope::ShotSeries& series);
    void saveWanted(const hitscope::ShotSeries& series);

protected:
    void hideEvent(QHideEvent* event) override;

private:
    void showSeries(const ShotSeries& series);
    void choose(int index);
    void keep();

    std::unique_ptr<Ui::ShotSeries> m_ui;
    QString m_flightHelp;
    ShotSeries::Pattern m_shown = ShotSeries::Pattern::Burst;
};

}  // namespace hitscope
