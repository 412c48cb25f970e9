// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "analysis/mesh_measuring.h"

class QLabel;
class QPushButton;

namespace hitscope {

class HistogramPlot;

/// Keeps a histogram of displacements up to date with what is measured, and turns the range between its
/// handles into a selection of vertices (Session::selection()).
class DisplacementHistogram : public QObject {
    Q_OBJECT
public:
    struct Widgets {
        HistogramPlot& plot;
        QLabel& between;      ///< says what the handles enclose
        QPushButton& select;  ///< selects it
        QPushButton& whole;   ///< handles to the ends
    };
    /// All outlive this.
    DisplacementHistogram(Session& session, const MeshMeasuring& measuring, const Widgets& widgets);

private:
    void follow();
    void showBetween(double low, double high);
    void select();
    void reset();
    [[nodiscard]] std::size_t countBetween(double low, double high) const;

    Session& m_session;
    const MeshMeasuring& m_measuring;
    Widgets m_widgets;
    bool m_isChosen = false;  ///< the handles stand where somebody put them
};

}  // namespace hitscope
