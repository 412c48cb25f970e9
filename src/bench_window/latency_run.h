// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "bench_window/driven_window.h"
#include "bench_window/latency.h"
#include "bench_window/latency_row.h"
#include "session/flight_mode.h"
#include "view/picture_detail.h"

class QLabel;

namespace hitscope {
class AimPreview;
}

namespace hitscope::bench {

/// What is measured, in the order in which it is done, and the rows that come of it.
class LatencyRun {
public:
    LatencyRun(DrivenWindow& window, const Repeats& repeats) : m_window(window), m_repeats(repeats) {}

    void refinements();
    void refine(const QString& what, const std::function<void(bool isOdd)>& act);
    void openings(const QString& mesh);
    void frames();
    void framesCloseUp();  ///< the camera stays there
    [[nodiscard]] Row moving(const QString& what, std::optional<PictureDetail> detail, int frames);
    void aims();
    void aimsOver(AimPreview& preview, const QLabel& label, bool isRefined);
    void clicks(FlightMode mode, const QString& what);
    void scatter();
    void exports();
    [[nodiscard]] QJsonObject result() const;

private:
    /// Does `once` as often as asked for; false of it ends that.
    void repeat(const std::function<bool()>& once);
    bool openOnce(const QString& mesh, Row& coarse, Row& full);
    bool clickOnce(Row& click, Row& undo, Row& redo);
    bool stepBack(bool redo, Row& row);
    bool isGood() const { return m_window.error().isEmpty(); }
    [[nodiscard]] std::size_t hits() { return m_window.session().hits().history().size(); }
    /// Of many hits, some of which are shown before.
    [[nodiscard]] bool isAllApplied() { return m_window.session().readBack().isUpToDate(); }
    [[nodiscard]] std::size_t movedVertices();
    void take(Row row);

    DrivenWindow& m_window;
    Repeats m_repeats;
    std::vector<Row> m_rows;
    std::size_t m_moved = 0;
};

}  // namespace hitscope::bench
