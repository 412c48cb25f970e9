// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QTimer>

#include "viewport/navigation.h"

namespace hitscope {

/// Says in a corner of a view how the camera looks: projection, and the name of a view along an axis; for a
/// moment after it was changed by hand also the field of view; and how to get the scene back once it is out
/// of the picture.
class ViewLabel : public QLabel {
    Q_OBJECT
public:
    /// `navigation` outlives the label.
    ViewLabel(const Navigation& navigation, QWidget* over);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void follow();

    const Navigation& m_navigation;
    QTimer m_fieldOfViewStays;
};

/// "Perspective", "Front, orthographic".
[[nodiscard]] QString viewText(const Camera& camera);
/// "Front", as menus name it.
[[nodiscard]] QString standardViewName(StandardView view);

}  // namespace hitscope
