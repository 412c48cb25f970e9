// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_window/worker_watch.h"

#include <QCoreApplication>
#include <algorithm>
#include <chrono>

#include "core/process_memory.h"

namespace hitscope::bench {

namespace {

constexpr std::chrono::milliseconds kBetweenLooksAtWorkers(10);

}  // namespace

WorkerWatch::WorkerWatch()
    : m_thread([this] {
          while (!m_ends) {
              for (const std::int64_t child : childrenOf(QCoreApplication::applicationPid())) {
                  m_most = std::max(m_most.load(), memoryOf(child).most);
              }
              std::this_thread::sleep_for(kBetweenLooksAtWorkers);
          }
      }) {}

WorkerWatch::~WorkerWatch() {
    m_ends = true;
    m_thread.join();
}

}  // namespace hitscope::bench
