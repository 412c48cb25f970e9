// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>
#include <memory>
#include <stop_token>

#include "analysis/beside.h"
#include "session/task_list.h"

namespace hitscope {

/// One background job at a time, for an owner that has this as a member. A `Job` has
/// run(std::stop_token), which is called on a thread of the pool and touches nothing of the session. Goes
/// when its owner does: nobody waits for the job then.
template <class Job>
class JobBeside {
public:
    JobBeside() { m_worthShowing.setSingleShot(true); }
    ~JobBeside() { cancel(); }
    JobBeside(const JobBeside&) = delete;
    JobBeside& operator=(const JobBeside&) = delete;

    /// A job that takes longer than a moment is listed among the tasks, as `text`. `tasks` outlives this.
    void showIn(TaskList& tasks, const QString& text) {
        QObject::connect(&m_worthShowing, &QTimer::timeout, &m_worthShowing,
                         [this, &tasks, text] { m_progress = std::make_unique<TaskProgress>(tasks, text); });
        m_worthShowing.setInterval(kWorthShowing);
    }

    [[nodiscard]] bool isRunning() const { return m_job != nullptr; }
    /// None runs. When it is over, and has not been cancelled, (owner.*take)(job, done); not done: there was
    /// no memory for it, and the copies that it worked on are of no use any more.
    template <class Owner>
    void start(Owner& owner, std::shared_ptr<Job> job, void (Owner::*take)(Job& job, bool done)) {
        m_job = job;
        m_stop = std::stop_source();
        m_sinceStart.start();
        if (m_worthShowing.interval() > 0) {
            m_worthShowing.start();
        }
        workBeside(
            &owner, [job, stop = m_stop.get_token()] { job->run(stop); },
            // This is a part of the owner, and there if that is.
            [this, job, take](Owner& told, bool done) {
                if (m_job == job) {
                    m_took = m_sinceStart.elapsed();
                    end();
                    (told.*take)(*job, done);
                }
            });
    }
    /// Asks it to stop; nobody is told of it any more.
    void cancel() {
        if (m_job) {
            m_stop.request_stop();
            end();
        }
    }

    /// Milliseconds until the next one may start, so that `least` lie between two starts and no more than a
    /// quarter of the time is spent on them; at most kLongestPause.
    [[nodiscard]] int pause(qint64 least) const {
        if (!m_sinceStart.isValid()) {
            return 0;
        }
        const qint64 left = std::max(least, 4 * m_took) - m_sinceStart.elapsed();
        return static_cast<int>(std::clamp<qint64>(left, 0, kLongestPause));
    }

private:
    static constexpr int kWorthShowing = 600;       // milliseconds
    static constexpr qint64 kLongestPause = 5'000;  // milliseconds

    void end() {
        m_job.reset();
        m_worthShowing.stop();
        m_progress.reset();
    }

    std::shared_ptr<Job> m_job;  ///< null: none runs
    std::stop_source m_stop;
    std::unique_ptr<TaskProgress> m_progress;
    QTimer m_worthShowing;
    QElapsedTimer m_sinceStart;
    qint64 m_took = 0;  ///< milliseconds, the last one
};

}  // namespace hitscope
