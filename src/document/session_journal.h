// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <set>

#include "document/capture.h"
#include "document/journal_writer.h"

namespace hitscope {

class Session;

/// Keeps the journal of a session: every change of it goes to a JournalWriter, edits of the history at once,
/// new targets in the next turn of the event loop or before the first edit that may be about them, all else
/// kSoon later and in one piece, since sliders and cameras change often.
class SessionJournal : public QObject {
    Q_OBJECT
public:
    static constexpr int kSoon = 200;  ///< milliseconds

    /// `session` outlives this. `view`: what the window adds; called when something is written.
    SessionJournal(Session& session, std::function<CapturedView()> view, const QString& folder,
                   QObject* parent = nullptr);
    ~SessionJournal() override;

    /// What there is now was recovered: it is worth keeping whatever it is. The snapshot goes to the writer.
    void keep();
    /// Cameras or display are others.
    void viewChanged();
    /// The session is as its file has it, or is not wanted any more: the journal goes, until the next change.
    void finish();
    /// What has been noted goes to the writer now.
    void flush();
    [[nodiscard]] JournalWriter& writer() { return m_writer; }
    /// There is something to recover.
    [[nodiscard]] bool isBegun() const { return m_isBegun; }

Q_SIGNALS:
    void begun();  ///< anew, with a snapshot

private:
    void followHits();
    void note(Section section);
    void noteTarget(TargetId id);
    void writeNoted();
    void startOver();
    [[nodiscard]] bool isWorthIt() const;

    Session& m_session;
    std::function<CapturedView()> m_view;
    JournalWriter m_writer;
    QTimer m_soon;
    std::set<Section> m_noted;
    std::set<TargetId> m_changed;  ///< targets: one that moves is written without the others
    std::uint64_t m_revision = 0;  ///< of the history that the journal has
    bool m_isBegun = false;
    bool m_hadHits = false;        ///< when the journal went
    bool m_startsOver = false;     ///< with the next flush()
    bool m_hasNewTargets = false;  ///< that the writer does not know
};

}  // namespace hitscope
