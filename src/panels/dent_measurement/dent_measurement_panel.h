// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "analysis/dent_measurement.h"

class QCPCurve;
class QCPItemStraightLine;

namespace Ui {
class DentMeasurementForm;
}

namespace hitscope {

/// The dock "Dent measurement": one dent's figures and its section profile.
class DentMeasurementPanel : public QWidget {
    Q_OBJECT
public:
    /// `session` outlives the panel.
    explicit DentMeasurementPanel(Session& session, QWidget* parent = nullptr);
    ~DentMeasurementPanel() override;

    [[nodiscard]] DentMeasurement& measurement() { return m_measurement; }
    /// How deep the deformed surface lies under the original there, metres along the profile; nothing where
    /// one of them has no point.
    [[nodiscard]] std::optional<double> depthAt(double along) const;
    [[nodiscard]] Status saveCsv(const QString& path) const;

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void showReport();
    void showDistance();
    void drawProfile();
    void applyPalette();
    void readProfile(const QPointF& position);
    void copy();
    void chooseCsv();

    std::unique_ptr<Ui::DentMeasurementForm> m_ui;
    DentMeasurement m_measurement;
    std::vector<QCPCurve*> m_curves;  ///< of the profile's lines, before and after
    QCPItemStraightLine* m_pointer = nullptr;
};

}  // namespace hitscope
