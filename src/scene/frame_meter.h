// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <memory>

#include "session/frame_costs.h"

namespace hitscope {

/// Measures what SceneGpu does, on the CPU by the clock and on the GPU by timer queries, and reports it. A
/// context is current for every call and the destructor.
class FrameMeter {
public:
    /// `costs` outlives the meter.
    explicit FrameMeter(FrameCosts& costs);
    ~FrameMeter();
    FrameMeter(const FrameMeter&) = delete;
    FrameMeter& operator=(const FrameMeter&) = delete;

    /// The stretches of the work, in their order.
    enum class Part : std::uint8_t { Preparation, Deformation, ReadBack, Drawing };
    void begin();
    /// What was done since begin() or the part before is that part.
    void endOf(Part part);
    /// The hits [first, first + count) are what Deformation applies; `arrived`: they are new.
    void applying(std::size_t first, std::size_t count, bool arrived);
    void comparing() { m_cost.pipelines = 2; }  ///< a second pipeline has its part in this frame
    /// The work is done. Without Drawing it was no frame.
    void end();
    /// Reports the GPU's times that have arrived; all of them are asked for, also the youngest.
    void collect();

private:
    void collect(std::size_t notYet);

    FrameCosts& m_costs;
    struct Queries;
    std::unique_ptr<Queries> m_queries;  ///< null: the driver has none
    QElapsedTimer m_clock;
    qint64 m_last = 0;  ///< nanoseconds by m_clock
    double m_preparation = 0.0;
    FrameCost m_cost;
    std::size_t m_firstApplied = 0;
    std::size_t m_applied = 0;
    bool m_drew = false;
};

}  // namespace hitscope
