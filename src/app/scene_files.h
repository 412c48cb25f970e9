// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>

#include "io/import.h"
#include "session/session.h"

namespace hitscope {

/// Opens mesh files into a session without holding up the window: the file is read by another process, and
/// what the session needs besides is worked out on another thread. One at a time; opening another gives the
/// first up.
class SceneFiles : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this.
    explicit SceneFiles(Session& session, QObject* parent = nullptr);
    ~SceneFiles() override;

    void open(const QString& path);
    /// Gives up what is being opened; the scene stays as it is.
    void cancel();
    [[nodiscard]] bool isOpening() const { return m_work != nullptr; }

Q_SIGNALS:
    void started(const QString& path);
    /// fraction in [0, 1]; negative: not known.
    void progressed(double fraction, const QString& doing);
    /// The session has the mesh. `notes`: what was dropped or mended on the way, in words.
    void opened(const QString& path, const QStringList& notes);
    void failed(const hitscope::Error& error);
    void ended();  ///< after opened, failed or cancelled

private:
    struct Work;

    void prepare(const std::shared_ptr<ImportedMesh>& imported);
    void take(const std::shared_ptr<Work>& work);
    void fail(const Error& error);
    void end();

    Session& m_session;
    std::shared_ptr<Work> m_work;  ///< null: nothing is being opened
};

}  // namespace hitscope
