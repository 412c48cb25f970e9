// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <thread>

namespace hitscope::bench {

/// The most memory that a process started by this one has had, looked at 100 times a second from another
/// thread while this lives.
class WorkerWatch {
public:
    WorkerWatch();
    ~WorkerWatch();
    WorkerWatch(const WorkerWatch&) = delete;
    WorkerWatch& operator=(const WorkerWatch&) = delete;
    [[nodiscard]] double most() const { return m_most; }  ///< bytes (RSS); 0: none was seen

private:
    std::atomic<double> m_most{0.0};
    std::atomic<bool> m_ends{false};
    std::thread m_thread;
};

}  // namespace hitscope::bench
