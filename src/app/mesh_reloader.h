// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "app/file_watch.h"
#include "core/ids.h"
#include "core/result.h"

namespace hitscope {

class Session;
class TaskProgress;

/// Notices when a file of a target's mesh gets another content, its materials and pictures too, and reads the
/// mesh again where that is wanted: beside the window's work, and as one step to undo. Where a target stands,
/// what it is called and how it behaves stays; what becomes of its hits is CarriedHits' to say.
class MeshReloader : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this.
    explicit MeshReloader(Session& session, QObject* parent = nullptr);
    ~MeshReloader() override;

    /// In use, and others than when they were read; without those that were ignored.
    [[nodiscard]] const QStringList& changedFiles() const { return m_changed; }
    /// Reads all of them again; ends with reloaded(), failed() or cancelled().
    void reload();
    /// They stay as they were read, until they change again.
    void ignore();
    /// An export replaces it, until release(), which needs no reading again: the dents would double.
    void hold(const QString& path) { m_watch.hold(path); }
    void release(const QString& path, bool isWritten) { m_watch.release(path, isWritten); }

Q_SIGNALS:
    void changedFilesChanged();
    /// `said`: how the hits were applied, and what the import said, in words; a line each.
    void reloaded(const QStringList& said);
    void failed(const hitscope::Error& error);
    void cancelled();

private:
    struct Work;

    void followSoon();
    void follow();
    void take(const QString& path);
    [[nodiscard]] bool isOther(const QString& path) const;
    [[nodiscard]] std::vector<TargetId> usersOf(const QStringList& paths) const;
    void setChanged(const QStringList& paths);
    void offerBesides(const QStringList& paths);  ///< those that have changed meanwhile
    void prepare(const std::shared_ptr<Work>& work);
    void say(const Work& work, double fraction, const QString& doing);
    void finish(const std::shared_ptr<Work>& work, bool done);
    /// Returns what is to be told of it.
    [[nodiscard]] QStringList apply(Work& work);
    /// Those of its targets that have changed, or gone, are left as they are.
    void leaveOutOthers(Work& work) const;
    void offerAgain(const Work& work);  ///< the files that targets use which were not reloaded
    void giveUp();

    Session& m_session;
    FileWatch m_watch{this};
    QTimer m_soon;
    std::map<QString, std::set<TargetId>> m_users;  ///< of each file that is watched
    QStringList m_changed;
    std::unique_ptr<TaskProgress> m_progress;
    std::shared_ptr<Work> m_work;  ///< null: nothing is read
};

}  // namespace hitscope
