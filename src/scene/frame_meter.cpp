// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/frame_meter.h"

#include <numeric>

#include "gl/timer_queries.h"

namespace hitscope {

namespace {

constexpr std::size_t kFramesOnTheirWay = 8;
constexpr std::size_t kMarks = 5;            // before the first part and after each
constexpr std::size_t kLate = 2;             // frames whose answers are not asked for while frames follow
constexpr std::size_t kDeformationPart = 1;  // in the marks' intervals

}  // namespace

struct FrameMeter::Queries {
    gl::TimerQueries timers{kFramesOnTheirWay, kMarks};
};

FrameMeter::FrameMeter(FrameCosts& costs) : m_costs(costs) {
    const bool available = gl::TimerQueries::isAvailable();
    if (available) {
        m_queries = std::make_unique<Queries>();
    }
    m_costs.setMeasuresGpu(available);
    m_clock.start();
}

FrameMeter::~FrameMeter() = default;

void FrameMeter::begin() {
    collect(kLate);
    m_cost = {};
    m_preparation = 0.0;
    m_applied = 0;
    m_drew = false;
    m_last = m_clock.nsecsElapsed();
    if (m_queries) {
        m_queries->timers.begin(m_costs.nextFrame());
    }
}

void FrameMeter::endOf(Part part) {
    const qint64 now = m_clock.nsecsElapsed();
    const double seconds = static_cast<double>(now - m_last) * 1.0e-9;
    m_last = now;
    if (m_queries) {
        m_queries->timers.mark();
    }
    switch (part) {
        case Part::Preparation:
            m_preparation = seconds;
            break;
        case Part::Deformation:
            m_cost.deformation = seconds;
            break;
        case Part::ReadBack:
            m_cost.readBack = seconds;
            break;
        case Part::Drawing:
            m_cost.drawing = seconds + m_preparation;
            m_drew = true;
            break;
    }
}

void FrameMeter::applying(std::size_t first, std::size_t count, bool arrived) {
    m_firstApplied = first;
    m_applied = count;
    m_cost.hits = arrived ? static_cast<std::uint32_t>(count) : 0;
}

void FrameMeter::end() {
    if (m_queries) {
        m_queries->timers.end();
    }
    m_costs.addApplied(m_costs.nextFrame(), m_firstApplied, m_applied, m_cost.deformation);
    if (m_drew) {
        m_costs.addFrame(m_cost);
    } else {
        m_costs.addWork(m_cost);
    }
}

void FrameMeter::collect() {
    collect(0);
}

void FrameMeter::collect(std::size_t notYet) {
    if (m_queries) {
        m_queries->timers.poll(notYet, [this](std::uint64_t frame, std::span<const double> parts) {
            if (parts.size() > kDeformationPart) {
                m_costs.addGpuTimes(frame, std::accumulate(parts.begin(), parts.end(), 0.0),
                                    parts[kDeformationPart]);
            }
        });
    }
}

}  // namespace hitscope
