// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>
#include <functional>
#include <memory>

#include "models/mesh_health_model.h"
#include "models/mesh_statistics_model.h"
#include "session/once_a_turn.h"

namespace Ui {
class MeshStatistics;
}

namespace hitscope {

class DisplacementHistogram;

/// The dock "Mesh statistics": numbers of the target in focus or of all, original, deformed and the change;
/// the histogram of displacements; and the faces that hits have harmed. Measures only while it can be seen.
class MeshStatisticsPanel : public QWidget {
    Q_OBJECT
public:
    /// `session` and `model` outlive the panel.
    MeshStatisticsPanel(Session& session, MeshStatisticsModel& model, QWidget* parent = nullptr);
    ~MeshStatisticsPanel() override;

    /// Where the numbers are of, as they are copied: "teapot".
    [[nodiscard]] QString title() const;

    // Which sections are folded; for settings.
    [[nodiscard]] QByteArray saveState() const;
    void restoreState(const QByteArray& state);

Q_SIGNALS:
    /// Somebody wants to see this box (world).
    void lookWanted(const hitscope::Bounds& bounds);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void makeNumbers();
    void makeHealth();
    void makeCopyMenu();
    void copyIfReady();
    void followTargets();
    void listTargets();
    void showTarget();
    void chooseTarget(int index);
    void showFound();
    void selectHarm(const QModelIndex& index);
    void lookAtHarm(const QModelIndex& index);
    void fitColumns();
    [[nodiscard]] int widestName() const;

    Session& m_session;
    MeshStatisticsModel& m_model;
    QPointer<MeshMeasuring> m_measuring;
    MeshHealthModel m_health;
    std::unique_ptr<Ui::MeshStatistics> m_ui;
    std::unique_ptr<DisplacementHistogram> m_histogram;
    OnceATurn m_list{[this] { listTargets(); }};
    std::function<void(const MeshMeasurement&)> m_copyWhenReady;  ///< empty: nothing is to be copied
};

}  // namespace hitscope
