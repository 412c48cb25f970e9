// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>

#include "models/mesh_statistics_model.h"

namespace Ui {
class MeshStatistics;
}

namespace hitscope {

/// The dock "Mesh statistics": the target in focus, original and deformed side by side.
class MeshStatisticsPanel : public QWidget {
    Q_OBJECT
public:
    /// `session` and `model` outlive the panel.
    MeshStatisticsPanel(Session& session, MeshStatisticsModel& model, QWidget* parent = nullptr);
    ~MeshStatisticsPanel() override;

private:
    void listTargets();
    void showTarget();
    void mergeSharedCells();

    Session& m_session;
    MeshStatisticsModel& m_model;
    std::unique_ptr<Ui::MeshStatistics> m_ui;
};

}  // namespace hitscope
