// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/journal_writer.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <variant>

#include "document/journal_file.h"

namespace hitscope {

namespace {

using Clock = std::chrono::steady_clock;

struct Begin {
    std::unique_ptr<SessionDocument> document;
};
struct Edit {
    std::size_t at = 0;
    std::size_t remove = 0;
    std::vector<Hit> insert;
};
struct Set {
    std::vector<Section> sections;
    std::unique_ptr<SessionDocument> part;
    bool some = false;  ///< targets of many

    /// Nothing is left of the one before.
    [[nodiscard]] bool replaces(const Set& before) const {
        const auto isSame = [](const SavedTarget& a, const SavedTarget& b) { return a.id == b.id; };
        const std::vector<SavedTarget>& other = before.part->targets;
        return sections == before.sections && some == before.some &&
               (!some ||
                std::equal(part->targets.begin(), part->targets.end(), other.begin(), other.end(), isSame));
    }
};
struct Picture {
    QByteArray jpeg;
};
struct File {
    QString path;
};
struct Finish {};
struct Lost {};  ///< changes that found no room
using Change = std::variant<Begin, Edit, Set, Picture, File, Finish, Lost>;

std::size_t bytesOf(const SessionDocument& part) {
    return sizeof(Change) + sizeof(SessionDocument) + part.targets.size() * sizeof(SavedTarget);
}

}  // namespace

class JournalWriter::Thread {
public:
    Thread(JournalWriter& owner, const QString& folder, int tryAgain)
        : m_owner(owner), m_tryAgain(tryAgain), m_file(folder), m_thread([this] { run(); }) {}
    ~Thread() {
        {
            const std::lock_guard lock(m_mutex);
            m_mayStop = true;
        }
        m_news.notify_all();
        m_thread.join();
    }
    Thread(const Thread&) = delete;
    Thread& operator=(const Thread&) = delete;

    void hand(Change change, std::size_t bytes) {
        {
            const std::lock_guard lock(m_mutex);
            ++m_handedOver;
            put(std::move(change), bytes);
        }
        m_news.notify_all();
    }
    std::size_t handedOver() const {
        const std::lock_guard lock(m_mutex);
        return m_handedOver;
    }
    std::size_t synced() const {
        const std::lock_guard lock(m_mutex);
        return m_synced;
    }
    bool isKept(std::size_t calls) const {
        const std::lock_guard lock(m_mutex);
        return m_keeps && m_synced >= calls;
    }
    bool wait(int milliseconds) {
        std::unique_lock lock(m_mutex);
        ++m_callers;
        m_news.notify_all();
        const bool isDone = m_done.wait_for(lock, std::chrono::milliseconds(milliseconds),
                                            [this] { return m_synced == m_handedOver; });
        --m_callers;
        return isDone;
    }
    QString path() const {
        const std::lock_guard lock(m_mutex);
        return m_path;
    }

private:
    /// A queue that nobody empties does not grow: a state replaces the one before, and too much is given up.
    void put(Change change, std::size_t bytes) {
        if (std::holds_alternative<Begin>(change) || std::holds_alternative<Finish>(change)) {
            m_waiting.clear();
            m_waitingBytes = 0;
        }
        const auto* set = std::get_if<Set>(&change);
        auto* before = m_waiting.empty() ? nullptr : std::get_if<Set>(&m_waiting.back());
        if (set != nullptr && before != nullptr && set->replaces(*before)) {
            m_waiting.back() = std::move(change);
            return;
        }
        m_waitingBytes += bytes;
        if (m_waitingBytes > kMostWaiting && !m_waiting.empty()) {
            m_waiting.clear();
            m_waitingBytes = 0;
            m_waiting.emplace_back(Lost());
            return;
        }
        m_waiting.push_back(std::move(change));
    }

    /// Somebody is in wait(), and not all is on the disk.
    [[nodiscard]] bool isWaitedFor() const { return m_callers > 0 && m_synced != m_handedOver; }

    void run() {
        std::unique_lock lock(m_mutex);
        for (bool isOver = false; !isOver;) {
            const auto isNews = [this] { return m_mayStop || !m_waiting.empty() || isWaitedFor(); };
            if (const std::optional<Clock::time_point> until = nextDeadline()) {
                m_news.wait_until(lock, *until, isNews);
            } else {
                m_news.wait(lock, isNews);
            }
            std::deque<Change> changes = std::exchange(m_waiting, {});
            m_waitingBytes = 0;
            isOver = m_mayStop;
            const bool isUrgent = isOver || isWaitedFor();
            const std::size_t handed = m_handedOver;
            lock.unlock();
            for (Change& change : changes) {
                std::visit([this](auto& kind) { apply(kind); }, change);
            }
            changes.clear();  // without the lock
            const bool isSynced = syncIfDue(isUrgent);
            askAgainIfDue();
            lock.lock();
            m_path = m_file.isOpen() ? m_file.path() : QString();
            if (isSynced) {
                m_synced = handed;
                m_keeps = m_follows && m_file.isOpen();
                m_done.notify_all();
            }
        }
    }

    // What follows is on the thread, without the lock.

    [[nodiscard]] std::optional<Clock::time_point> nextDeadline() const {
        std::optional<Clock::time_point> deadline = m_askAt;
        if (m_unsyncedSince) {
            const auto sync = *m_unsyncedSince + std::chrono::milliseconds(kSyncWithin);
            deadline = deadline ? std::min(*deadline, sync) : sync;
        }
        return deadline;
    }

    void apply(Begin& begin) {
        const Status begun = m_file.begin(*begin.document);
        m_follows = begun.ok();
        m_unsyncedSince.reset();
        m_hasAsked = false;
        if (begun) {
            m_hasFailed = false;
            m_askAt.reset();
        } else {
            fail(begun.error());
        }
    }
    void apply(const Edit& edit) {
        if (m_follows) {
            append(m_file.lines().edit(edit.at, edit.remove, edit.insert));
        }
    }
    void apply(const Set& set) {
        if (m_follows) {
            append(set.some ? m_file.lines().someTargets(*set.part)
                            : m_file.lines().set(set.sections, *set.part));
        }
    }
    void apply(const Picture& picture) {
        if (m_follows) {
            append(m_file.lines().picture(picture.jpeg));
        }
    }
    void apply(const File& file) {
        if (m_follows) {
            append(m_file.lines().file(file.path));
        }
    }
    void apply(const Finish& /*finish*/) {
        m_file.remove();
        m_follows = false;
        m_unsyncedSince.reset();
        m_askAt.reset();
        m_hasFailed = false;
    }
    void apply(const Lost& /*lost*/) {
        m_follows = false;
        m_askAt = Clock::now();
    }

    void append(const std::string& text) {
        if (const Status appended = m_file.append(text); !appended) {
            fail(appended.error());
            return;
        }
        m_unsyncedSince = m_unsyncedSince.value_or(Clock::now());
        if (m_file.isLarge() && !std::exchange(m_hasAsked, true)) {
            ask();
        }
    }

    /// Returns whether all that was written is on the disk.
    bool syncIfDue(bool isUrgent) {
        if (!m_unsyncedSince) {
            return true;
        }
        if (!isUrgent && Clock::now() < *m_unsyncedSince + std::chrono::milliseconds(kSyncWithin)) {
            return false;
        }
        m_unsyncedSince.reset();
        if (const Status synced = m_file.sync(); !synced) {
            fail(synced.error());
        }
        return true;
    }

    void fail(const Error& error) {
        m_follows = false;
        m_askAt = Clock::now() + m_tryAgain;
        if (!std::exchange(m_hasFailed, true)) {
            QMetaObject::invokeMethod(
                &m_owner, [&owner = m_owner, error] { Q_EMIT owner.failed(error); }, Qt::QueuedConnection);
        }
    }
    void askAgainIfDue() {
        if (m_askAt && Clock::now() >= *m_askAt) {
            m_askAt = Clock::now() + m_tryAgain;
            ask();
        }
    }
    void ask() { QMetaObject::invokeMethod(&m_owner, &JournalWriter::snapshotWanted, Qt::QueuedConnection); }

    JournalWriter& m_owner;
    const std::chrono::milliseconds m_tryAgain;

    mutable std::mutex m_mutex;
    std::condition_variable m_news;
    std::condition_variable m_done;
    std::deque<Change> m_waiting;
    std::size_t m_waitingBytes = 0;
    std::size_t m_handedOver = 0;
    std::size_t m_synced = 0;
    int m_callers = 0;     ///< in wait()
    bool m_keeps = false;  ///< what is synced is in the file
    bool m_mayStop = false;
    QString m_path;

    // The thread's own.
    JournalFile m_file;
    bool m_follows = false;  ///< the file is what the session is, but for what waits
    bool m_hasFailed = false;
    bool m_hasAsked = false;                           ///< since it has become large
    std::optional<Clock::time_point> m_unsyncedSince;  ///< something is written and not yet on the disk
    std::optional<Clock::time_point> m_askAt;          ///< for a snapshot, since there was trouble
    std::thread m_thread;                              ///< last: it uses all of the above
};

JournalWriter::JournalWriter(const QString& folder, QObject* parent, int tryAgain)
    : QObject(parent), m_thread(std::make_unique<Thread>(*this, folder, tryAgain)) {}

JournalWriter::~JournalWriter() = default;

void JournalWriter::begin(SessionDocument document) {
    m_thread->hand(Begin{std::make_unique<SessionDocument>(std::move(document))}, 0);
}

void JournalWriter::edit(std::size_t at, std::size_t remove, std::span<const Hit> insert) {
    m_thread->hand(Edit{at, remove, {insert.begin(), insert.end()}}, sizeof(Change) + insert.size_bytes());
}

void JournalWriter::setSome(SessionDocument part) {
    const std::size_t bytes = bytesOf(part);
    auto some = std::make_unique<SessionDocument>(std::move(part));
    m_thread->hand(Set{{Section::Targets}, std::move(some), true}, bytes);
}

void JournalWriter::set(std::vector<Section> sections, SessionDocument part) {
    std::size_t bytes = bytesOf(part);
    for (const SavedSelection::Vertices& vertices : part.selection.vertices) {
        bytes += vertices.vertices.size() * sizeof(std::uint32_t);
    }
    part.hits.clear();
    m_thread->hand(Set{std::move(sections), std::make_unique<SessionDocument>(std::move(part))}, bytes);
}

void JournalWriter::setFile(const QString& path) {
    m_thread->hand(File{path}, sizeof(Change) + 2 * static_cast<std::size_t>(path.size()));
}

void JournalWriter::setPicture(const QByteArray& jpeg) {
    if (static_cast<std::size_t>(jpeg.size()) <= kMostPicture) {
        m_thread->hand(Picture{jpeg}, sizeof(Change) + static_cast<std::size_t>(jpeg.size()));
    }
}

void JournalWriter::finish() {
    m_thread->hand(Finish(), 0);
}

std::size_t JournalWriter::handedOver() const {
    return m_thread->handedOver();
}

std::size_t JournalWriter::synced() const {
    return m_thread->synced();
}

bool JournalWriter::isKept(std::size_t calls) const {
    return m_thread->isKept(calls);
}

bool JournalWriter::wait(int milliseconds) {
    return m_thread->wait(milliseconds);
}

QString JournalWriter::path() const {
    return m_thread->path();
}

}  // namespace hitscope
