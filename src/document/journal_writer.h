// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QLatin1StringView>
#include <QObject>
#include <QString>
#include <memory>
#include <span>
#include <vector>

#include "core/result.h"
#include "deform/hit.h"
#include "document/document_section.h"
#include "document/session_document.h"

namespace hitscope {

/// Keeps a journal of a session in a file of its own, on a thread of its own: what is handed over is written
/// at once and synced kSyncWithin later at most, and the caller never waits. The file is locked as long as
/// this lives, so that others see that it is in use; a process that dies leaves it to findJournals().
///
/// Where it cannot be written (no room, no permission), failed() says so once, and work goes on: what comes
/// is dropped, and kTryAgain later snapshotWanted() asks for a new begin().
class JournalWriter : public QObject {
    Q_OBJECT
public:
    static constexpr QLatin1StringView kSuffix{".journal"};
    static constexpr QLatin1StringView kBegunSuffix{".journal-new"};    ///< until its snapshot is in it
    static constexpr int kSyncWithin = 500;                             ///< milliseconds
    static constexpr std::size_t kMostWaiting = std::size_t{64} << 20;  ///< bytes of what is not yet written

    /// `folder` is made where it is missing. `tryAgain`: milliseconds, for tests.
    explicit JournalWriter(const QString& folder, QObject* parent = nullptr, int tryAgain = 10'000);
    /// Writes and syncs what was handed over, and leaves the file, as a process that dies does.
    ~JournalWriter() override;

    /// From now on the journal is about this session. A journal before is replaced once this is synced.
    void begin(SessionDocument document);
    /// Hits [at, at + remove) became `insert`. Before begin(), and after finish(), nothing.
    void edit(std::size_t at, std::size_t remove, std::span<const Hit> insert);
    /// These sections are now as in `part`, of which nothing else counts; not Section::Hits.
    void set(std::vector<Section> sections, SessionDocument part);
    /// The targets of `part`, which the journal knows, are now as there; nothing else of it counts.
    void setSome(SessionDocument part);
    /// What the window shows: a JPEG of at most kMostPicture bytes, for who decides whether to recover it.
    void setPicture(const QByteArray& jpeg);
    /// The session file that the session was saved to; empty: none.
    void setFile(const QString& path);
    /// The session was saved, or given up: there is nothing to recover, and the file goes.
    void finish();

    /// Of the calls so far how many are on the disk, or were given up with the failure said.
    [[nodiscard]] std::size_t handedOver() const;
    [[nodiscard]] std::size_t synced() const;
    /// Whether the first so many calls are on the disk, or in a snapshot there; given up is not.
    [[nodiscard]] bool isKept(std::size_t calls) const;
    /// Until all is, which is synced at once; for tests, and before something dangerous. Returns whether it
    /// is.
    bool wait(int milliseconds);
    [[nodiscard]] QString path() const;  ///< empty: there is no file

Q_SIGNALS:
    void failed(const hitscope::Error& error);  ///< once until it works again
    /// The journal has grown large beside its session, or there was trouble: begin() would do it good.
    void snapshotWanted();

private:
    class Thread;
    std::unique_ptr<Thread> m_thread;
};

}  // namespace hitscope
