// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/dialogs/plan_dialog.h"
#include "mesh/section.h"

class QComboBox;

namespace hitscope {

class HitEditing;

/// Asks across which plane hits shall be mirrored.
class MirrorDialog : public PlanDialog {
    Q_OBJECT
public:
    /// `editing` knows which hits are selected; it outlives this.
    MirrorDialog(Session& session, Viewport& viewport, HitEditing& editing, QWidget* parent);

protected:
    void showEvent(QShowEvent* event) override;
    void replan() override;
    [[nodiscard]] HitGroupKind kind() const override { return HitGroupKind::Mirror; }
    [[nodiscard]] QString summary(const HitPlanner::Plan& plan) const override;

private:
    [[nodiscard]] std::vector<Hit> chosen() const;
    [[nodiscard]] Plane planeOn(const Target& target) const;
    void showPlanes();

    HitEditing& m_editing;
    QComboBox* m_hits;
    QComboBox* m_plane;
    QComboBox* m_through;
    std::size_t m_own = 0;  ///< hits that lie in the plane, which have no other image
};

}  // namespace hitscope
