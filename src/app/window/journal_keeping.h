// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

namespace hitscope {

class Session;
class SessionFiles;
class SessionJournal;
class Viewport;
class WindowView;

/// The journal of the window's session: begins with the first change, goes when the session is saved or given
/// up.
class JournalKeeping : public QObject {
    Q_OBJECT
public:
    /// All outlive this but `parent`. It is there before the window has been shown.
    JournalKeeping(Session& session, SessionFiles& files, WindowView& view, Viewport& viewport,
                   QObject* parent);

    void viewChanged();  ///< what the window adds to the session
    void flush();        ///< what has been noted goes to the file now
    void finish();       ///< the session is saved, or is not wanted any more

Q_SIGNALS:
    void noticeWanted(const QString& text);  ///< why there can be no journal
    /// What was recovered is kept anew, or is saved, or is not wanted: what it was recovered from may go.
    void recoveredKept();

private:
    [[nodiscard]] bool isAsSaved() const;
    void noteFile();
    void takeSaved();
    void takeOpened(const QString& path);
    void lookWhetherKept();
    void tellKept();

    SessionFiles& m_files;
    SessionJournal* m_journal;
    QString m_file;            ///< that the journal names
    QTimer m_untilKept;        ///< runs while what was recovered is not kept anew
    std::size_t m_wanted = 0;  ///< calls of the writer that have to be kept for that
};

}  // namespace hitscope
