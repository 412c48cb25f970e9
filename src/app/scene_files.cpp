// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene_files.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QPointer>
#include <QThreadPool>
#include <new>
#include <optional>
#include <utility>

namespace hitscope {

/// One file on its way in. The thread that prepares it holds on to it too; whoever finds that it is no longer
/// SceneFiles' current work drops it.
struct SceneFiles::Work {
    QString path;
    std::unique_ptr<MeshImport> import;
    QStringList notes;
    std::optional<PreparedMesh> prepared;
};

SceneFiles::SceneFiles(Session& session, QObject* parent) : QObject(parent), m_session(session) {}

SceneFiles::~SceneFiles() = default;

void SceneFiles::open(const QString& path) {
    cancel();
    m_work = std::make_shared<Work>();
    m_work->path = QFileInfo(path).absoluteFilePath();
    m_work->import = std::make_unique<MeshImport>(m_work->path);
    MeshImport* import = m_work->import.get();
    connect(import, &MeshImport::progressed, this, &SceneFiles::progressed);
    // Queued: the import is destroyed by what follows, and must not be in the middle of emitting then.
    connect(
        import, &MeshImport::finished, this,
        [this, work = std::weak_ptr(m_work)](const std::shared_ptr<ImportedMesh>& imported) {
            if (work.lock() == m_work && m_work) {
                prepare(imported);
            }
        },
        Qt::QueuedConnection);
    connect(
        import, &MeshImport::failed, this,
        [this, work = std::weak_ptr(m_work)](const Error& error) {
            if (work.lock() == m_work && m_work) {
                fail(error);
            }
        },
        Qt::QueuedConnection);
    Q_EMIT started(m_work->path);
    import->start();
}

void SceneFiles::cancel() {
    if (m_work) {
        end();
    }
}

void SceneFiles::prepare(const std::shared_ptr<ImportedMesh>& imported) {
    Q_EMIT progressed(-1.0, tr("Preparing"));
    m_work->notes = imported->notes;
    m_work->import.reset();
    QThreadPool::globalInstance()->start([self = QPointer(this), work = m_work, imported] {
        try {
            work->prepared = prepareMesh(std::move(imported->mesh));
        } catch (const std::bad_alloc&) {
            work->prepared.reset();
        }
        QMetaObject::invokeMethod(QCoreApplication::instance(), [self, work] {
            if (self) {
                self->take(work);
            }
        });
    });
}

void SceneFiles::take(const std::shared_ptr<Work>& work) {
    if (work != m_work) {
        return;
    }
    if (!work->prepared) {
        fail({"There is not enough memory for this mesh.", work->path.toStdString(),
              "Close other programs, or open a smaller version of the mesh."});
        return;
    }
    m_session.loadMesh(*work->prepared, work->path);
    Q_EMIT opened(work->path, work->notes);
    end();
}

void SceneFiles::fail(const Error& error) {
    const Error kept = error;  // it may live in what end() destroys
    end();
    Q_EMIT failed(kept);
}

void SceneFiles::end() {
    m_work.reset();
    Q_EMIT ended();
}

}  // namespace hitscope
