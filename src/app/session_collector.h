// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <memory>

#include "core/result.h"
#include "document/capture.h"

class QMenu;
class QWidget;

namespace hitscope {

class Session;
class SessionFiles;
class TaskProgress;

/// File > Collect for Sharing: the session with its meshes, materials and textures in one folder, which can
/// be moved and handed on. Written beside the window's work.
class SessionCollector : public QObject {
    Q_OBJECT
public:
    /// `view` says how the window looks at the session. All outlive this.
    SessionCollector(Session& session, const SessionFiles& files, std::function<CapturedView()> view,
                     QWidget& window);
    ~SessionCollector() override;

    void fill(QMenu& menu);
    /// As it is now, into `folder`; ends with collected(), failed() or cancelled(). Cancelled too late it
    /// ends with collected().
    void collect(const QString& folder);

Q_SIGNALS:
    /// `notes`: what could not be collected.
    void collected(const QString& folder, const QStringList& notes);
    void said(const QString& text);          ///< how it ended
    void noticeWanted(const QString& text);  ///< what could not be collected
    void failed(const hitscope::Error& error);
    void cancelled();

private:
    struct Work;

    void choose();
    [[nodiscard]] QString nameOfSession() const;
    [[nodiscard]] QString proposedFolder() const;
    void say(const Work& work, double fraction, const QString& doing);
    void tellCollected(const QString& folder, const QStringList& notes);
    void finish(const std::shared_ptr<Work>& work, bool done);
    void giveUp();

    Session& m_session;
    const SessionFiles& m_files;
    std::function<CapturedView()> m_view;
    QWidget& m_window;
    std::unique_ptr<TaskProgress> m_progress;
    std::shared_ptr<Work> m_work;  ///< null: nothing is collected
};

}  // namespace hitscope
