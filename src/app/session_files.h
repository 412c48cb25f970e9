// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>

#include "core/result.h"
#include "document/capture.h"
#include "document/open_document.h"

namespace hitscope {

class Session;
class TaskProgress;

/// The file that a session is in: whether anything was changed since, saving it, opening another. Reading and
/// writing go on beside the window's work; one thing at a time.
class SessionFiles : public QObject {
    Q_OBJECT
public:
    /// How the window looks at the session: `capture` says it, `restore` goes by a document.
    struct View {
        std::function<CapturedView()> capture;
        std::function<void(const SessionDocument&)> restore;
    };
    /// `session` outlives this.
    SessionFiles(Session& session, View view, QObject* parent = nullptr);
    ~SessionFiles() override;

    /// Calls `then` where the session as it is may be replaced, and `instead` where it may not; at once or
    /// later.
    using Ask = std::function<void(std::function<void()> then, std::function<void()> instead)>;
    /// Is asked before a session is replaced that was changed while another was being opened.
    void setAsk(Ask ask) { m_ask = std::move(ask); }

    [[nodiscard]] const QString& path() const { return m_file.path; }  ///< empty: it was never saved
    /// Whether its file is another one now than was opened or saved here, by size or time; not where it is
    /// gone, nor while it is being saved to.
    [[nodiscard]] bool isChangedByOthers() const;
    [[nodiscard]] bool isModified() const;  ///< since it was saved, opened or let go
    [[nodiscard]] bool isRecovered() const { return m_file.isRecovered; }  ///< and not saved since
    [[nodiscard]] bool isBusy() const { return m_work != nullptr; }

    /// Writes it there, whole or not at all; ends with saved(), notSaved() or saveCancelled(). What is
    /// changed meanwhile is not in it, unless it is called again before: then it is written once more, and
    /// the end of that is told. If another scene takes the place of this one before, it is written all
    /// the same, which nobody is told; undone, the scene is in that file.
    void save(const QString& path);
    /// Replaces the session by the file's; ends with opened(), failed() or cancelled(), of which the last two
    /// leave the session as it is. Where meshes are missing or changed, troubled() asks on the way.
    void open(const QString& path);
    enum class Ended : std::uint8_t { NotOpened, InPart, Whole };  ///< InPart: without what is missing
    struct Origin {
        QString file = {};                      ///< that it was in before, and is saved to; empty: none
        QString noteInPart = {};                ///< among the notes where it is opened in part
        std::function<void(Ended)> ended = {};  ///< called once; not where this goes before
    };
    /// Likewise by a document that is in no file: what was recovered. Counts as modified.
    void openDocument(SessionDocument document, Origin origin);
    /// Gives up what is being opened; what is being saved stays wanted.
    void cancel();

    // Answers to troubled()
    [[nodiscard]] const std::vector<MeshTrouble>& troubles() const;  ///< valid until one of these is called
    void lookAgain(const QString& missing, const QString& found);    ///< a file in the place of another
    void goOn();  ///< without what is missing, and with what has changed

    /// Another scene has taken the place of this one: it is in no file. Undone, the file is this one's again.
    void leave();
    /// What there is now needs no saving.
    void letGo();

Q_SIGNALS:
    void changed();                                     ///< path() or isModified()
    void writing(const QString& path);                  ///< a save begins
    void written(const QString& path, bool isWritten);  ///< and ends; before what is told of it
    void saved(const QString& path);
    void left();  ///< leave()
    void openingBegun();
    void troubled();
    /// `path`: empty for what was recovered. `notes`: of the import, and what was left out.
    void opened(const QString& path, const QStringList& notes);
    void failed(const hitscope::Error& error);    ///< to open
    void notSaved(const hitscope::Error& error);  ///< the file, if there is one, is as it was
    void cancelled();
    void saveCancelled();  ///< the file is as it was
    void saveEnded();      ///< whatever came of it; last
    /// What was opened has been drawn, and these targets are not what they were when it was saved.
    void differs(const QStringList& targets);

private:
    struct Work;
    struct FileStamp {
        qint64 size = -1;  ///< bytes; -1: there is no file
        qint64 time = 0;   ///< milliseconds
        bool operator==(const FileStamp&) const = default;
    };
    [[nodiscard]] static FileStamp stampOf(const QString& path);

    void begin(const QString& doing, std::function<void()> cancel, const QString& cancelHelp);
    void beginOpening(const QString& name);
    void leaveSaving();
    [[nodiscard]] bool isSavingTo(const QString& path) const;
    void takeWritten(const std::shared_ptr<Work>& work, bool done);
    void keepWritten(const Work& work);
    void tellWritten(const Work& work, bool done, bool isOfThis);
    void say(const Work& work, double fraction, const QString& doing);
    void prepare();
    void take(const std::shared_ptr<Work>& work, bool done);
    void replaceBy(const std::shared_ptr<Work>& work);
    void checkPositions();
    void follow();
    void followScene();
    void end();
    void fail(const Error& error);

    Session& m_session;
    View m_view;
    Ask m_ask;
    /// What the session is in.
    struct File {
        QString path;
        std::uint64_t kept = 0;    ///< SessionUndo::state() that is saved
        bool isRecovered = false;  ///< and was not saved since
        FileStamp stamp = {};      ///< of the file as it was opened or saved
    };
    File m_file;
    std::map<std::uint64_t, File> m_others;  ///< of scenes that undo and redo lead to
    std::uint64_t m_scene = 0;               ///< SessionUndo::scene() that m_file is of
    bool m_wasModified = false;
    std::unique_ptr<TaskProgress> m_progress;
    std::shared_ptr<Work> m_work;                ///< null: nothing goes on
    std::unique_ptr<SessionDocument> m_toCheck;  ///< its positions, once they are known here; null: none
};

}  // namespace hitscope
