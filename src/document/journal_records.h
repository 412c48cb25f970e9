// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <cstddef>
#include <span>
#include <string>

#include "core/result.h"
#include "document/document_section.h"
#include "document/session_document.h"

namespace hitscope {

// A journal is a text: what a session was, and what became of it since, a line for each change. A line is 16
// hexadecimal digits, a space, JSON without line ends, and a line end; the digits are a checksum of the JSON
// and of the line's number, from 0, so that a line that is damaged, cut, lost or out of its place is told
// from a good one. All up to the first that is not good counts.
//
//   0  {"format":"hitscope journal","version":1}
//   1  a session file in one line
//   2… {"hits":{"at":5,"remove":1,"insert":[…]}}: an edit of the history
//      {"set":{"lights":{…}}}: one or several sections of a session file, each as a whole
//      {"some":{"targets":[…]}}: of the targets these, each as a whole
//      {"picture":"…"}: what the window showed, small: a JPEG as Base64
//      {"file":"…"}: the session file that it was saved to; empty: none

inline constexpr std::string_view kJournalFormat = "hitscope journal";
inline constexpr int kJournalVersion = 4;           ///< 1 knew no pictures, 2 no file, 3 not "some"
inline constexpr std::size_t kMostPicture = 7'000;  ///< bytes of a JPEG

/// Makes the lines of one journal, in their order; each ends with its line end.
class JournalLines {
public:
    /// The first two.
    [[nodiscard]] std::string begin(const SessionDocument& document);
    /// Hits [at, at + remove) became `insert`.
    [[nodiscard]] std::string edit(std::size_t at, std::size_t remove, std::span<const Hit> insert);
    /// Sections as they are in `document` now; not Section::Hits.
    [[nodiscard]] std::string set(std::span<const Section> sections, const SessionDocument& document);
    /// The targets of `part`, which are among those before, as they are there.
    [[nodiscard]] std::string someTargets(const SessionDocument& part);
    /// `jpeg`: at most kMostPicture.
    [[nodiscard]] std::string picture(const QByteArray& jpeg);
    [[nodiscard]] std::string file(const QString& path);

private:
    std::string line(std::string_view json);

    std::uint64_t m_number = 0;
};

/// What a journal comes to.
struct RecoveredJournal {
    SessionDocument document;     ///< after all good lines; fit for writeDocument()
    std::size_t edits = 0;        ///< of the history, that were good
    std::size_t settings = 0;     ///< lines that set sections, likewise
    std::size_t goodBytes = 0;    ///< from its begin
    std::size_t droppedHits = 0;  ///< on targets that a later line took away without them
    QByteArray picture = {};      ///< the last: bytes of a JPEG, not looked into; empty: none
    QString file = {};            ///< the session file that it was saved to; empty: none
    std::size_t lostLines = 0;    ///< complete ones from the first that is not good on
    std::string problem = {};     ///< why the line behind the good ones does not count; empty: there is none
};

/// Whatever was cut or damaged behind its first two lines is left out and said in `problem`; an error where
/// not even these are good, or where a newer Hitscope wrote it.
[[nodiscard]] Result<RecoveredJournal> readJournal(const QByteArray& bytes);

}  // namespace hitscope
