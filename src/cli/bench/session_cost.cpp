// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/session_cost.h"

#include <QDir>
#include <QFileInfo>
#include <array>
#include <memory>

#include "cli/bench/random_hits.h"
#include "document/journal_records.h"
#include "document/open_document.h"
#include "document/session_file.h"
#include "document/session_journal.h"
#include "session/session.h"

namespace hitscope::bench {

namespace {

constexpr std::uint32_t kSeedOfHits = 1;
constexpr std::size_t kMoreHits = 64;
constexpr int kJournalPatience = 60'000;  // milliseconds

/// A session that grows a little while it is measured.
class KeptSession {
public:
    KeptSession(std::size_t hits, const QString& folder)
        : m_folder(folder), m_file(QDir(folder).filePath(QStringLiteral("bench.hitscope"))), m_hits(hits) {}

    Status open() {
        loadTeapot(m_session);
        const Target& target = *m_session.targets().front();
        m_random =
            std::make_unique<RandomHits>(std::vector<HitTarget>{{target.id, target.shape.render.get()}},
                                         DeformationConstants{}, kSeedOfHits);
        for (std::size_t i = 0; i < m_hits; ++i) {
            if (Status added = m_session.hits().add(m_random->next(1)); !added) {
                return added;
            }
        }
        m_more = m_random->next(kMoreHits);
        return Done{};
    }
    [[nodiscard]] qint64 fileBytes() const { return QFileInfo(m_file).size(); }

    Status capture() {
        m_captured = captureSession(m_session, {});
        return Done{};
    }
    Status save() { return writeSessionFile(captureSession(m_session, {}), m_file); }
    Status read() {
        Result<SessionDocument> document = readSessionFile(m_file);
        return document ? restore(std::move(document).value()) : Status(document.error());
    }
    Status prepareRecovery() {
        if (Status whole = toAllHits(); whole && m_journalBytes.isEmpty()) {
            m_journalBytes = QByteArray::fromStdString(JournalLines().begin(captureSession(m_session, {})));
        }
        return Done{};
    }
    Status recover() {
        Result<RecoveredJournal> journal = readJournal(m_journalBytes);
        return journal ? restore(std::move(journal).value().document) : Status(journal.error());
    }
    Status goTo(std::size_t step) {
        m_session.goToStep(step);
        return Done{};
    }
    /// All hits that are measured, and no more: the variants come in any order.
    Status toAllHits() { return goTo(m_hits); }

    Status hit() {
        for (const Hit& hit : m_more) {
            if (Status added = m_session.hits().add({&hit, 1}); !added) {
                return added;
            }
        }
        return Done{};
    }
    /// To the length measured, with the journal on or off.
    Status prepareHits(bool journalled) {
        m_session.goToStep(m_hits);
        if (journalled && !m_journal) {
            m_journal = std::make_unique<SessionJournal>(
                m_session, [] { return CapturedView(); }, m_folder);
            if (Status begun = hit(); !begun) {
                return begun;
            }
            m_journal->flush();
            m_session.goToStep(m_hits);
        } else if (!journalled) {
            m_journal.reset();
        }
        if (m_journal && !m_journal->writer().wait(kJournalPatience)) {
            return Error{"The journal was not written in time.", m_folder.toStdString(), "Try another disk."};
        }
        return Done{};
    }
    Status prepareFlush() {
        Status prepared = prepareHits(true);
        m_power = m_power < 0.05f ? 0.06f : 0.04f;
        DeformationConstants constants;
        constants.power = m_power;
        return prepared ? m_session.settings().setConstants(constants) : prepared;
    }
    Status flush() {
        m_journal->flush();
        return Done{};
    }

private:
    Status restore(SessionDocument document) {
        Result<PreparedSession> prepared = prepareSession(std::move(document), {});
        if (!prepared) {
            return prepared.error();
        }
        Session opened;
        restoreSession(opened, prepared.value());
        return opened.hits().history().size() == m_hits
                   ? Status(Done{})
                   : Status(Error{"The session did not come back whole.", "", ""});
    }

    QString m_folder;
    QString m_file;
    std::size_t m_hits;
    Session m_session;
    std::unique_ptr<RandomHits> m_random;
    std::vector<Hit> m_more;
    SessionDocument m_captured;
    QByteArray m_journalBytes;
    float m_power = 0.0f;
    std::unique_ptr<SessionJournal> m_journal;  ///< before the session goes
};

}  // namespace

Result<SessionFigures> measureSession(std::size_t hits, const QString& folder, const Plan& plan) {
    KeptSession kept(hits, folder);
    if (const Status opened = kept.open(); !opened) {
        return opened.error();
    }
    constexpr double kEach = kMoreHits;
    const std::function<Status()> toAllHits = [&] { return kept.toAllHits(); };
    const std::array variants = {
        Variant{"save", 1.0, toAllHits, [&] { return kept.save(); }},
        Variant{"capture", 1.0, toAllHits, [&] { return kept.capture(); }},
        Variant{"open", 1.0, {}, [&] { return kept.read(); }},
        Variant{"recover", 1.0, [&] { return kept.prepareRecovery(); }, [&] { return kept.recover(); }},
        Variant{"back", 1.0, toAllHits, [&] { return kept.goTo(0); }},
        Variant{"forward", 1.0, [&] { return kept.goTo(0); }, [&] { return kept.goTo(hits); }},
        Variant{"hit", kEach, [&] { return kept.prepareHits(false); }, [&] { return kept.hit(); }},
        Variant{"journalled", kEach, [&] { return kept.prepareHits(true); }, [&] { return kept.hit(); }},
        Variant{"flush", 1.0, [&] { return kept.prepareFlush(); }, [&] { return kept.flush(); }},
    };
    Result<std::vector<Samples>> samples = measure(variants, plan);
    if (!samples) {
        return samples.error();
    }
    std::vector<Samples>& all = samples.value();
    return SessionFigures{std::move(all[0]), std::move(all[1]), std::move(all[2]), std::move(all[3]),
                          std::move(all[4]), std::move(all[5]), std::move(all[6]), std::move(all[7]),
                          std::move(all[8]), kept.fileBytes()};
}

}  // namespace hitscope::bench
