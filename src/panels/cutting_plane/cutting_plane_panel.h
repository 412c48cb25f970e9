// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QWidget>
#include <functional>
#include <memory>

#include "core/result.h"
#include "models/section_report.h"

namespace Ui {
class CuttingPlaneForm;
}

namespace hitscope {

/// The dock "Cutting plane": where the plane is, what of it is drawn, and the section as a plot. Holds no
/// plane of its own: it shows what setCut() was given and says what somebody wants instead.
class CuttingPlanePanel : public QWidget {
    Q_OBJECT
public:
    /// `session` outlives the panel.
    explicit CuttingPlanePanel(const Session& session, QWidget* parent = nullptr);
    ~CuttingPlanePanel() override;

    /// `bounds`: of the targets, world. Emits nothing.
    void setCut(const CuttingPlane& cut, const Bounds& bounds);
    void setSection(std::shared_ptr<const SceneSection> section);
    [[nodiscard]] Status saveCsv(const QString& path) const;

Q_SIGNALS:
    void edited(const hitscope::CuttingPlane& cut);
    void normalChosen(const glm::vec3& normal);  ///< unit; through the middle of the scene
    void fromViewWanted();
    void resetWanted();
    void moving(bool on);  ///< the offset's slider is held

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void connectPlane();
    void connectReadOut();
    void edit(const std::function<void(CuttingPlane&)>& change);
    void editNormal();
    void showNormal();
    void showOffset();
    void showSection();
    [[nodiscard]] QRectF room() const;
    void chooseCsv();

    const Session& m_session;
    std::unique_ptr<Ui::CuttingPlaneForm> m_ui;
    CuttingPlane m_cut;
    Bounds m_bounds;
    std::shared_ptr<const SceneSection> m_section;
    SectionScope m_scope;
    bool m_showing = false;  ///< what changes is shown, not edited
};

}  // namespace hitscope
