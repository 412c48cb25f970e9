// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>
#include <QStringList>

#include "scene/scene_gpu.h"

class QPainter;

namespace hitscope {

/// What is written over a picture about change: the colour bar with its unit, how much is exaggerated, which
/// side of the wipe is which.
class ChangeOverlay {
public:
    /// Over a picture of `view`, whose upper left corner is the painter's origin; the painter's units are
    /// logical pixels. Needs a QGuiApplication, as it writes.
    [[nodiscard]] static bool isNeeded(const SceneGpu::View& view);
    void paint(QPainter& painter, const SceneGpu::View& view);

private:
    struct Legend {
        QString title;
        ShownChange change;
        Theme theme = Theme::Dark;
        float pixelRatio = 1.0f;
        bool between = false;    ///< two pictures
        bool unchanged = false;  ///< there is nothing to have a scale for
        double barHeight = 0.0;  ///< logical pixels
        double notes = 0.0;      ///< width of what is written below in the middle; 0: nothing is
        bool operator==(const Legend& other) const;
    };
    void paintLegend(QPainter& painter, const QSizeF& size, const Legend& legend);

    Legend m_drawn;
    QImage m_bar;  ///< of m_drawn: text is dear to draw in every frame
};

}  // namespace hitscope
