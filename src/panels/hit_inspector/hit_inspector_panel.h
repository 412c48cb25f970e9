// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "models/constants_presets.h"
#include "session/hit_editing.h"

namespace Ui {
class HitInspector;
}

namespace hitscope {

class DirectionFields;
class FalloffPlot;
class FormFields;
class NumberBox;
class ParameterEditor;

/// The dock "Hit": what the selected hits are made of, changed live: constants by slider, box and preset,
/// form, direction as it was shot, into the surface or by angles, and the point. Of several hits it shows
/// where they differ, and what is changed is changed in all of them.
class HitInspectorPanel : public QWidget {
    Q_OBJECT
public:
    /// Both outlive the panel. Presets are read from the application's QSettings.
    HitInspectorPanel(Session& session, HitEditing& editing, QWidget* parent = nullptr);
    ~HitInspectorPanel() override;

    void editFirst();      ///< gives the first box the focus
    void followPresets();  ///< there are others now

private:
    /// What HitEditing tells gestures apart by; the constants come first.
    enum Part : int {
        Preset = 3,
        Direction,
        Elevation,
        PointX,
        PointY,
        PointZ,
        Profile,
        Push,
        Radius,
        Curve
    };

    void makeEditors();
    void makeForm();
    void makeDirection();
    void makePoint();
    void listPresets();
    void show();
    void showTitle();
    void showConstants(const Hit& hit);
    void showPreset(const Hit& hit);
    void showForm(const Hit& hit);
    void showDirection(const Hit& hit);
    void showPoint(const Hit& hit);
    void choosePreset(int row);
    void once(int part, const HitEditing::Edit& edit);
    /// Of the target that a hit is on; 1 where constants are not relative.
    [[nodiscard]] DeformationConstants presetFor(const ConstantsPreset& preset, const Hit& hit) const;
    /// Whether `part` of all selected hits is that of `hit`.
    template <class Value>
    [[nodiscard]] bool isSame(const Hit& hit, const Value& part) const;

    Session& m_session;
    HitEditing& m_editing;
    std::unique_ptr<Ui::HitInspector> m_ui;
    std::vector<ParameterEditor*> m_editors;  ///< in the order of deformationParameters()
    FormFields* m_form = nullptr;
    ParameterEditor* m_radius = nullptr;  ///< of a press
    FalloffPlot* m_falloff = nullptr;     ///< of another form than the paper's
    DirectionFields* m_direction = nullptr;
    std::array<NumberBox*, 3> m_point{};
    ConstantsPresets m_presets;
};

}  // namespace hitscope
