// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene_files.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QTimer>
#include <atomic>
#include <chrono>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/beside.h"
#include "app/opening_progress.h"
#include "core/give_up.h"
#include "session/task_list.h"

namespace hitscope {

/// What is on its way in. The thread that prepares it holds on to it too; whoever finds that it is no longer
/// SceneFiles' current work drops it.
struct SceneFiles::Work {
    Into into = Into::NewScene;
    QString name;
    std::uint64_t state = 0;  ///< SessionUndo::state() that is to be replaced
    QStringList paths;        ///< empty: it is made by us
    qsizetype next = 0;       ///< of paths
    OpeningProgress progress{{}};
    QElapsedTimer clock;       ///< of the file that is being opened; then of its mesh's preparation
    double readSeconds = 0.0;  ///< that it took
    std::unique_ptr<MeshImport> import;
    QStringList read;  ///< the paths that could be
    QStringList notes;
    std::optional<Error> firstError;
    std::optional<ScenePlan> made;  ///< by the other thread, last
    ScenePlan scene;
    std::atomic<bool> isCancelled = false;

    /// On the other thread. Given up, there is nothing made.
    void make(const std::function<ScenePlan()>& how) {
        const std::function<bool()> isWanted = [this] { return !isCancelled; };
        const GiveUpScope watched(isWanted, GiveUpScope::Asked::Anywhere);
        try {
            made = how();
        } catch (const GivenUp&) {
            made.reset();
        }
    }
};

namespace {

Error outOfMemory(const QString& location) {
    return {"There is not enough memory for this mesh.", location.toStdString(),
            "Close other programs, or open a smaller version of the mesh."};
}

QString sceneNameOf(const ScenePlan& scene) {
    const QString first = scene.targets.front().name;
    const auto others = static_cast<int>(scene.targets.size()) - 1;
    return others == 0 ? first : SceneFiles::tr("%1 and %2 more").arg(first, QString::number(others));
}

}  // namespace

SceneFiles::SceneFiles(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    constexpr int kBetween = 100;  // milliseconds
    m_preparing.setInterval(kBetween);
    connect(&m_preparing, &QTimer::timeout, this, &SceneFiles::sayPreparing);
    connect(this, &SceneFiles::started, this, &SceneFiles::beginTask);
    connect(this, &SceneFiles::progressed, this, &SceneFiles::say);
    connect(this, &SceneFiles::ended, this, [this] {
        m_preparing.stop();
        m_progress.reset();
    });
}

/// Several files are one task, so that what is said to be left is left of all.
void SceneFiles::beginTask(const QString& name) {
    m_preparing.stop();
    m_name = QFileInfo(name).fileName();
    if (m_work && m_work->paths.size() > 1) {
        m_name = tr("%1 (%2 of %3)")
                     .arg(m_name, QString::number(m_work->next), QString::number(m_work->paths.size()));
    }
    const QString doing = tr("Opening %1").arg(m_name);
    if (m_progress) {
        m_progress->say(doing);
        return;
    }
    m_progress = std::make_unique<TaskProgress>(
        m_session.tasks(), doing, [this] { cancelAndTell(); },
        tr("Cancel opening; the scene stays unchanged"));
}

SceneFiles::~SceneFiles() {
    if (m_work) {
        m_work->isCancelled = true;
    }
}

void SceneFiles::say(double fraction, const QString& doing) {
    if (!m_progress) {
        return;
    }
    if (!doing.isEmpty()) {
        m_progress->say(tr("%1 %2", "Reading teapot.obj").arg(doing, m_name));
    }
    const bool isFile = m_work && m_work->next > 0;
    if (!isFile) {
        m_progress->report(fraction);
    } else if (fraction >= 0.0) {
        m_progress->report(m_work->progress.reading(static_cast<std::size_t>(m_work->next - 1), fraction));
    }
}

void SceneFiles::sayPreparing() {
    constexpr double kMillisecond = 1.0e-3;
    if (m_progress && m_work && m_work->next > 0) {
        m_progress->report(
            m_work->progress.preparing(static_cast<std::size_t>(m_work->next - 1), m_work->readSeconds,
                                       kMillisecond * static_cast<double>(m_work->clock.elapsed())));
    }
}

void SceneFiles::open(const QStringList& paths, Into into) {
    if (paths.isEmpty()) {
        return;
    }
    cancel();
    auto work = std::make_shared<Work>();
    work->into = into;
    work->state = m_session.steps().state();
    std::vector<double> sizes;
    for (const QString& path : paths) {
        const QFileInfo file(path);
        work->paths << file.absoluteFilePath();
        sizes.push_back(static_cast<double>(file.size()));
    }
    work->progress = OpeningProgress(std::move(sizes));
    m_work = std::move(work);
    importNext();
}

void SceneFiles::make(const QString& name, Into into, const std::function<ScenePlan()>& make) {
    cancel();
    auto work = std::make_shared<Work>();
    work->into = into;
    work->state = m_session.steps().state();
    work->name = name;
    m_work = std::move(work);
    Q_EMIT started(name);
    Q_EMIT progressed(-1.0, tr("Creating"));
    runElsewhere(make, [this] { deliver(); });
}

void SceneFiles::cancel() {
    if (m_work) {
        end();
    }
}

void SceneFiles::cancelAndTell() {
    cancel();
    Q_EMIT cancelled();
}

void SceneFiles::importNext() {
    const std::shared_ptr<Work> work = m_work;
    if (!work) {
        return;
    }
    if (work->next == work->paths.size()) {
        deliver();
        return;
    }
    const QString path = work->paths[work->next++];
    work->import = std::make_unique<MeshImport>(path);
    MeshImport* import = work->import.get();
    connect(import, &MeshImport::progressed, this, &SceneFiles::progressed);
    // Queued: the import is destroyed by what follows, and must not be in the middle of emitting then.
    connect(
        import, &MeshImport::finished, this,
        [this, current = std::weak_ptr(work)](const std::shared_ptr<ImportedMesh>& imported) {
            if (m_work && current.lock() == m_work) {
                takeImported(imported);
            }
        },
        Qt::QueuedConnection);
    connect(
        import, &MeshImport::failed, this,
        [this, current = std::weak_ptr(work)](const Error& error) {
            if (m_work && current.lock() == m_work) {
                leaveOut(error);
            }
        },
        Qt::QueuedConnection);
    work->clock.start();
    Q_EMIT started(path);
    import->start();
}

void SceneFiles::takeImported(const std::shared_ptr<ImportedMesh>& imported) {
    const std::shared_ptr<Work> work = m_work;
    if (!work) {
        return;
    }
    constexpr double kMillisecond = 1.0e-3;
    work->readSeconds = kMillisecond * static_cast<double>(work->clock.restart());
    Q_EMIT progressed(1.0, tr("Preparing"));
    m_preparing.start();
    const QString path = work->paths[work->next - 1];
    const bool several = work->paths.size() > 1;
    for (const QString& note : imported->notes) {
        work->notes << (several ? QFileInfo(path).fileName() + QStringLiteral(": ") + note : note);
    }
    work->import.reset();
    const bool isAlone = !several && work->into == Into::NewScene;
    if (isAlone && m_makeDrawing) {
        showThenPrepare(imported, path);
    } else {
        prepare(imported, path);
    }
}

void SceneFiles::showThenPrepare(const std::shared_ptr<ImportedMesh>& imported, const QString& path) {
    const auto picture = std::make_shared<QImage>();
    workBeside(
        this, [imported, picture, drawing = m_makeDrawing()] { *picture = drawing(imported->mesh); },
        [work = m_work, picture, imported, path](SceneFiles& self, bool) {
            if (work == self.m_work) {
                if (!picture->isNull()) {
                    Q_EMIT self.seen(*picture);
                }
                self.prepare(imported, path);
            }
        });
}

void SceneFiles::prepare(const std::shared_ptr<ImportedMesh>& imported, const QString& path) {
    runElsewhere(
        [imported, path] {
            ScenePlan plan;
            plan.targets.push_back(planMesh(std::move(imported->mesh), path));
            return plan;
        },
        [this, work = m_work, path] {
            work->read << path;
            importNext();
        });
}

void SceneFiles::leaveOut(const Error& error) {
    const std::shared_ptr<Work> work = m_work;
    if (!work) {
        return;
    }
    // It may live in what is destroyed below.
    const Error kept = error;  // NOLINT(performance-unnecessary-copy-initialization)
    work->import.reset();
    work->firstError = work->firstError.value_or(kept);
    work->notes << tr("Left out: %1").arg(QString::fromStdString(kept.message()));
    importNext();
}

/// Adds what `make` makes to the work's scene and calls `then`, unless the work was given up.
void SceneFiles::runElsewhere(const std::function<ScenePlan()>& make, const std::function<void()>& then) {
    workBeside(
        this, [work = m_work, make] { work->make(make); },
        [work = m_work, then](SceneFiles& self, bool) { self.takeMade(work, then); });
}

void SceneFiles::takeMade(const std::shared_ptr<Work>& work, const std::function<void()>& then) {
    if (work != m_work) {
        return;
    }
    if (!work->made) {
        fail(outOfMemory(work->paths.isEmpty() ? work->name : work->paths[work->next - 1]));
        return;
    }
    std::move(work->made->targets.begin(), work->made->targets.end(),
              std::back_inserter(work->scene.targets));
    work->scene.name = work->made->name;
    work->scene.floorHeight = work->made->floorHeight;
    work->made.reset();
    then();
}

void SceneFiles::deliver() {
    const std::shared_ptr<Work> work = m_work;
    if (!work) {
        return;
    }
    if (work->scene.targets.empty()) {
        fail(work->firstError.value_or(outOfMemory(work->name)));
        return;
    }
    if (m_ready && !m_ready(work->scene)) {
        // Another thread may be at it, and needs the processor.
        constexpr std::chrono::milliseconds kLookApart{2};
        QTimer::singleShot(kLookApart, this, [this, current = std::weak_ptr(work)] {
            if (m_work && current.lock() == m_work) {
                deliver();
            }
        });
        return;
    }
    if (work->into == Into::ThisScene) {
        m_session.targets().add(std::move(work->scene.targets));
        finish(work);
    } else if (!m_ask || work->state == m_session.steps().state()) {
        replaceBy(work);
    } else {
        askAndReplace(work);
    }
}

/// What was done meanwhile may be worth keeping.
void SceneFiles::askAndReplace(const std::shared_ptr<Work>& work) {
    m_ask(
        [this, work] {
            if (work == m_work) {
                replaceBy(work);
            }
        },
        [this, work] {
            if (work == m_work) {
                cancelAndTell();
            }
        });
}

void SceneFiles::replaceBy(const std::shared_ptr<Work>& work) {
    if (!work->paths.isEmpty()) {
        makeRoom(work->scene.targets, {});
        work->scene.name = sceneNameOf(work->scene);
    }
    m_session.loadScene(std::move(work->scene));
    finish(work);
}

void SceneFiles::finish(const std::shared_ptr<Work>& work) {
    if (work->paths.isEmpty()) {
        Q_EMIT made(work->name, work->into);
    } else {
        Q_EMIT opened(work->read, work->notes, work->into);
    }
    end();
}

void SceneFiles::fail(const Error& error) {
    // It may live in what end() destroys.
    const Error kept = error;  // NOLINT(performance-unnecessary-copy-initialization)
    end();
    Q_EMIT failed(kept);
}

void SceneFiles::end() {
    if (m_work) {
        m_work->isCancelled = true;  // who still works for it may stop
    }
    m_work.reset();
    Q_EMIT ended();
}

}  // namespace hitscope
