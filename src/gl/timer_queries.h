// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "gl/objects.h"

namespace hitscope::gl {

/// Asks the GPU when it passes certain marks of a frame (GL_TIMESTAMP), and learns the answers some frames
/// later. Never waits: a frame for which no queries are free is not measured. A context is current for every
/// call and the destructor.
class TimerQueries {
public:
    /// Whether this context can tell the time.
    [[nodiscard]] static bool isAvailable();

    /// frames: how many may be on their way at once; marks: of a frame, at most. isAvailable().
    TimerQueries(std::size_t frames, std::size_t marks);

    /// A frame starts; its first mark is here. False: it is not measured.
    bool begin(std::uint64_t frame);
    /// The next mark: what was asked of the GPU before is done when it passes. Nothing without begin(), or
    /// where there are no more marks.
    void mark();
    void end();

    /// Seconds between the marks of a frame, in their order: one fewer than marks.
    using Sink = std::function<void(std::uint64_t frame, std::span<const double> seconds)>;
    /// Delivers the frames whose answers are there, oldest first. The youngest `notYet` are not asked about,
    /// since asking for what the driver has not sent off can make it do so.
    void poll(std::size_t notYet, const Sink& sink);
    /// Frames that poll() has still to deliver.
    [[nodiscard]] std::size_t pending() const { return m_pending; }

private:
    struct Slot {
        std::uint64_t frame = 0;
        std::size_t marks = 0;  ///< made
        std::vector<Query> queries;
    };
    [[nodiscard]] Slot& slot(std::size_t pending) { return m_slots[(m_first + pending) % m_slots.size()]; }

    std::vector<Slot> m_slots;
    std::size_t m_first = 0;    ///< the oldest that is pending
    std::size_t m_pending = 0;  ///< slots in use from there on
    Slot* m_open = nullptr;     ///< between begin() and end()
};

}  // namespace hitscope::gl
