// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>

namespace hitscope::bench {

/// Nanoseconds on a clock that does not go back.
[[nodiscard]] std::int64_t nowInNanoseconds();

/// How long the event loop keeps an event waiting: another thread posts one each millisecond, unless the one
/// before still waits. What a key or click meanwhile would have waited.
class LoopWatch : public QObject {
public:
    /// `seen` is called in the loop with each event that arrives.
    explicit LoopWatch(std::function<void()> seen);
    ~LoopWatch() override;

    void restart() { m_longest = 0; }
    /// Seconds that an event has waited at most since restart(); the one that is on its way counts.
    [[nodiscard]] double longest() const;

protected:
    bool event(QEvent* event) override;

private:
    void post();

    std::function<void()> m_seen;
    std::int64_t m_longest = 0;           ///< nanoseconds
    std::atomic<std::int64_t> m_sent{0};  ///< when the event on its way was posted; 0: none is
    std::atomic<bool> m_ends{false};
    std::thread m_thread;
};

}  // namespace hitscope::bench
