// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/hit_effects.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "analysis/background_pool.h"

namespace hitscope {

namespace {

/// Brings rows to where the edit has put their hits. Those it replaced are gone. `rows` ascend.
void shift(std::vector<HistoryEffects::Changes::Row>& rows, std::size_t first, std::size_t before,
           std::size_t after) {
    if (rows.empty() || rows.back().row < first) {
        return;
    }
    std::erase_if(rows,
                  [=](const auto& changed) { return changed.row >= first && changed.row < first + before; });
    for (auto& changed : rows) {
        if (changed.row >= first) {
            changed.row = static_cast<std::uint32_t>(changed.row + after - before);
        }
    }
}

/// Hits that came one by one are one edit.
void join(std::vector<HistoryEdit>& edits, std::vector<HistoryEdit> more) {
    for (HistoryEdit& edit : more) {
        HistoryEdit* last = edits.empty() ? nullptr : &edits.back();
        if (last != nullptr && edit.before.empty() && last->first + last->after.size() == edit.first) {
            last->after.insert(last->after.end(), edit.after.begin(), edit.after.end());
        } else {
            edits.push_back(std::move(edit));
        }
    }
}

}  // namespace

/// What both threads know. The pool's one thread works as long as there is something to do.
struct HitEffects::Worker : std::enable_shared_from_this<HitEffects::Worker> {
    struct Task {
        std::uint64_t number = 0;
        std::vector<HistoryEdit> edits;
        HistoryEffects::Shapes shapes;
    };
    struct Result {
        std::uint64_t number = 0;  ///< of the task
        HistoryEffects::Changes changes;
    };
    struct Question {
        std::uint64_t number = 0;  ///< after this task
        std::size_t row = 0;
        TargetId target;
        std::uint64_t serial = 0;  ///< among the questions
        std::vector<std::uint32_t> answer = {};
    };

    std::mutex mutex;
    std::condition_variable done;
    Task task;                         // guarded by the mutex, as all up to `stop` is
    std::optional<Question> question;  // not answered yet
    std::optional<Question> answered;  // not taken yet
    bool isRunning = false;
    std::uint64_t followed = 0;
    std::vector<Result> results;  // oldest first
    HitEffects* owner = nullptr;
    bool isAnnounced = false;  // the owner has been asked to take what there is
    std::atomic<bool> stop = false;
    HistoryEffects effects;  // of the thread that runs

    void run();
    void runIfIdle();
    void announce();
};

/// The mutex is held.
void HitEffects::Worker::runIfIdle() {
    if (!isRunning) {
        isRunning = true;
        startInBackground([self = shared_from_this()] { self->run(); });
    }
}

/// The mutex is held.
void HitEffects::Worker::announce() {
    if (owner != nullptr && !std::exchange(isAnnounced, true)) {
        QMetaObject::invokeMethod(owner, &HitEffects::take, Qt::QueuedConnection);
    }
    done.notify_all();
}

void HitEffects::Worker::run() {
    std::unique_lock lock(mutex);
    while (!stop) {
        if (task.number > followed) {
            const Task now = std::exchange(task, Task{task.number, {}, {}});
            lock.unlock();
            HistoryEffects::Changes changes = effects.follow(now.edits, now.shapes, stop);
            lock.lock();
            followed = now.number;
            results.push_back({now.number, std::move(changes)});
            announce();
        } else if (question) {
            Question now = *std::exchange(question, std::nullopt);
            if (now.number != followed) {
                continue;  // the rows are others now
            }
            lock.unlock();
            now.answer = effects.movedBy(now.row);
            lock.lock();
            answered = std::move(now);
            announce();
        } else {
            break;
        }
    }
    isRunning = false;
    done.notify_all();
}

HitEffects::HitEffects(Session& session, QObject* parent)
    : QObject(parent), m_session(session), m_worker(std::make_shared<Worker>()) {
    connect(&session, &Session::sceneReplaced, this, &HitEffects::startOver);
    connect(&session.targets(), &SessionTargets::added, this, &HitEffects::followShape);
    connect(&session.targets(), &SessionTargets::removed, this, [this](TargetId target) {
        m_counts.erase(target);
        followShape(target);
        Q_EMIT countsChanged(target, {});
    });
    connect(&session.hits(), &SessionHits::appended, this, &HitEffects::follow);
    connect(&session.hits(), &SessionHits::changed, this, &HitEffects::follow);
    connect(&session.hits(), &SessionHits::rearranged, this, &HitEffects::follow);
    connect(&session.hits(), &SessionHits::shownChanged, this, &HitEffects::followApplied);
    connect(&session.readBack(), &ReadBack::capacityChanged, this, &HitEffects::followApplied);
    startOver();
}

HitEffects::~HitEffects() {
    const std::lock_guard lock(m_worker->mutex);
    m_worker->stop = true;
    m_worker->owner = nullptr;
}

/// With a new worker; the one before stops as soon as it can.
void HitEffects::startOver() {
    {
        const std::lock_guard lock(m_worker->mutex);
        m_worker->stop = true;
        m_worker->owner = nullptr;
    }
    m_worker = std::make_shared<Worker>();
    m_worker->owner = this;
    m_asked = 0;
    m_followed = 0;
    m_shifts.clear();
    m_effects.clear();
    m_counts.clear();
    HistoryEffects::Shapes shapes;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        shapes[target->id] = target->deformed.sharedRender();
    }
    m_revision = m_session.hits().history().revision();
    m_hasToFollow = false;
    submit({m_applied.startOver(m_session.hits().history().hits(), m_session.hits().applied())}, shapes);
}

void HitEffects::followShape(TargetId id) {
    const Target* target = m_session.targets().find(id);
    submit({}, {{id, target != nullptr ? target->deformed.sharedRender() : nullptr}});
}

void HitEffects::follow() {
    std::optional<std::vector<HistoryEdit>> edits = m_session.hits().history().editsSince(m_revision);
    if (!edits) {
        startOver();
        return;
    }
    m_revision = m_session.hits().history().revision();
    m_hasToFollow = false;
    std::vector<HistoryEdit> made =
        m_applied.follow(*edits, m_session.hits().history().hits(), m_session.hits().applied());
    if (!made.empty()) {
        submit(std::move(made), {});
    }
}

/// Dragging the scrubber asks for many states, of which the last one counts: no more than one is worked out
/// at a time.
void HitEffects::followApplied() {
    m_hasToFollow = true;
    if (isAnswered()) {
        const std::size_t rows = m_effects.size();
        follow();
        if (rows > 0) {
            Q_EMIT effectsChanged(0, static_cast<int>(rows) - 1);  // some are not applied any more
        }
    }
}

void HitEffects::submit(std::vector<HistoryEdit> edits, const HistoryEffects::Shapes& shapes) {
    ++m_asked;
    for (const HistoryEdit& edit : edits) {
        const auto at = m_effects.begin() + static_cast<std::ptrdiff_t>(edit.first);
        const auto gap = m_effects.erase(at, at + static_cast<std::ptrdiff_t>(edit.before.size()));
        m_effects.insert(gap, edit.after.size(), std::nullopt);
        m_shifts.push_back({m_asked, edit.first, edit.before.size(), edit.after.size()});
    }
    const std::lock_guard lock(m_worker->mutex);
    m_worker->task.number = m_asked;
    join(m_worker->task.edits, std::move(edits));
    for (const auto& [id, shape] : shapes) {
        m_worker->task.shapes[id] = shape;
    }
    m_worker->runIfIdle();
}

void HitEffects::take() {
    std::vector<Worker::Result> results;
    std::optional<Worker::Question> answered;
    {
        const std::lock_guard lock(m_worker->mutex);
        m_worker->isAnnounced = false;
        results = std::exchange(m_worker->results, {});
        answered = std::exchange(m_worker->answered, std::nullopt);
    }
    for (auto& [number, changes] : results) {
        m_followed = number;
        while (!m_shifts.empty() && m_shifts.front().number <= m_followed) {
            m_shifts.pop_front();
        }
        takeRows(changes.rows);
        for (const HistoryEffects::Changes::Counts& counts : changes.counts) {
            takeCounts(counts);
        }
    }
    if (m_hasToFollow) {
        followApplied();
    }
    if (answered && answered->number == m_asked && answered->serial == m_questions) {
        Q_EMIT verticesFound(answered->target, answered->answer);
    }
}

void HitEffects::takeRows(std::vector<HistoryEffects::Changes::Row>& rows) {
    for (const Shift& moved : m_shifts) {
        shift(rows, moved.first, moved.before, moved.after);
    }
    for (const HistoryEffects::Changes::Row& changed : rows) {
        m_effects[changed.row] = changed.effect;
    }
    if (!rows.empty()) {
        Q_EMIT effectsChanged(static_cast<int>(rows.front().row), static_cast<int>(rows.back().row));
    }
}

void HitEffects::takeCounts(const HistoryEffects::Changes::Counts& counts) {
    const Target* target = m_session.targets().find(counts.target);
    if (target == nullptr) {
        return;
    }
    if (counts.fromZero && counts.vertices.empty()) {
        m_counts.erase(counts.target);
    } else {
        ZeroArray<std::uint32_t>& known = m_counts[counts.target];
        if (counts.fromZero || known.empty()) {
            known = ZeroArray<std::uint32_t>(target->deformed.positions().size());
        }
        for (std::size_t i = 0; i < counts.vertices.size(); ++i) {
            if (known[counts.vertices[i]] != counts.counts[i]) {  // what stays 0 takes no memory
                known[counts.vertices[i]] = counts.counts[i];
            }
        }
    }
    Q_EMIT countsChanged(counts.target, counts.fromZero ? std::vector<std::uint32_t>() : counts.vertices);
}

std::optional<HitEffect> HitEffects::effect(std::size_t row) const {
    return row < m_effects.size() ? m_effects[row] : std::nullopt;
}

std::span<const std::uint32_t> HitEffects::counts(TargetId target) const {
    const auto known = m_counts.find(target);
    return known == m_counts.end() ? std::span<const std::uint32_t>() : known->second.all();
}

void HitEffects::finish() {
    do {
        {
            std::unique_lock lock(m_worker->mutex);
            m_worker->done.wait(lock, [this] { return !m_worker->isRunning; });
        }
        take();
    } while (!isUpToDate());
}

void HitEffects::findVertices(std::size_t row) {
    if (row >= m_session.hits().history().size()) {
        return;
    }
    const std::lock_guard lock(m_worker->mutex);
    m_worker->question = {m_asked, row, m_session.hits().history().hits()[row].target, ++m_questions};
    m_worker->runIfIdle();
}

}  // namespace hitscope
