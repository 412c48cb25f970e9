// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mesh_reloader.h"

#include <QFileInfo>
#include <QPointer>
#include <algorithm>
#include <atomic>
#include <utility>

#include "analysis/beside.h"
#include "deform/carried_hits.h"
#include "document/capture.h"
#include "document/mesh_references.h"
#include "document/open_document.h"
#include "session/session.h"
#include "session/shown_number.h"
#include "session/task_list.h"
#include "session/vertex_selection.h"

namespace hitscope {

/// What is being read again. The other thread holds on to it too.
struct MeshReloader::Work {
    QStringList files;
    SessionDocument document;                       ///< its targets are those to read
    std::map<TargetId, CarriedHits::Shape> before;  ///< their meshes
    std::atomic<bool> cancelled = false;
    Status status = Done{};
    PreparedSession prepared;
    std::map<TargetId, std::shared_ptr<const CarriedHits>> carried;
    std::map<TargetId, TargetId> ids;  ///< of those that were reloaded, by the ones before
};

namespace {

const MeshFile* fileOf(const TargetState& target) {
    return std::get_if<MeshFile>(&target.source);
}

Error noRoomForMesh() {
    return {"There is not enough memory to read the mesh again.", "", "Close other programs, and try again."};
}

QString hitsText(std::size_t hits) {
    return MeshReloader::tr("%Ln {hit|hits}", nullptr, trCount(hits));
}

/// Selected and picked vertices of what is replaced, and which hits are shown and selected.
struct KeptSelection {
    explicit KeptSelection(const Session& session)
        : hit(session.hits().selected()),
          shown(session.hits().showsAll() ? std::nullopt : std::optional(session.hits().shown().size())),
          picked(session.selection().picked()) {
        for (const TargetId target : session.selection().targets()) {
            const std::span<const std::uint32_t> selected = session.selection().vertices(target);
            vertices[target] = {selected.begin(), selected.end()};
        }
    }
    /// `ids`: of those whose vertices correspond, by the ones before.
    void restore(Session& session, const std::map<TargetId, TargetId>& ids) const {
        for (const auto& [before, now] : ids) {
            // A table that shows the picked one may select its row.
            if (picked && picked->target == before) {
                session.selection().setPicked(VertexRef{now, picked->vertex});
            }
            if (const auto selected = vertices.find(before); selected != vertices.end()) {
                session.selection().select(now, selected->second, VertexSelection::Combine::Add);
            }
        }
        session.hits().show(shown);
        session.hits().select(hit);
    }

    std::optional<std::size_t> hit;
    std::optional<std::size_t> shown;
    std::optional<VertexRef> picked;
    std::map<TargetId, std::vector<std::uint32_t>> vertices;
};

}  // namespace

MeshReloader::MeshReloader(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    m_soon.setSingleShot(true);
    m_soon.setInterval(0);
    connect(&m_soon, &QTimer::timeout, this, &MeshReloader::follow);
    connect(&m_watch, &FileWatch::changed, this, &MeshReloader::take);
    const SessionTargets& targets = session.targets();
    connect(&targets, &SessionTargets::added, this, &MeshReloader::followSoon);
    connect(&targets, &SessionTargets::removed, this, &MeshReloader::followSoon);
    connect(&session, &Session::sceneReplaced, this, [this] {
        giveUp();
        followSoon();
    });
    followSoon();
}

MeshReloader::~MeshReloader() {
    giveUp();
}

// What is in use

void MeshReloader::followSoon() {
    if (!m_soon.isActive()) {
        m_soon.start();
    }
}

void MeshReloader::follow() {
    m_users.clear();
    std::vector<MeshFile> files;
    const auto use = [&](const MeshFile& file, TargetId target) {
        std::set<TargetId>& users = m_users[file.path];
        if (users.empty()) {
            files.push_back(file);
        }
        users.insert(target);
    };
    std::map<const MeshData*, std::vector<MeshReference>> references;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        const MeshFile* file = fileOf(*target);
        if (file == nullptr) {
            continue;
        }
        use(*file, target->id);
        const auto [known, isNew] = references.try_emplace(target->shape.mesh.get());
        if (isNew) {
            known->second = referencesOf(file->path, *target->shape.mesh);
        }
        for (const MeshReference& reference : known->second) {
            use(MeshFile{reference.path}, target->id);
        }
    }
    m_watch.follow(files);
    QStringList changed = m_changed;
    changed.removeIf([this](const QString& path) { return !isOther(path); });
    setChanged(changed);
}

/// Whether somebody uses it, and a mesh as another.
bool MeshReloader::isOther(const QString& path) const {
    const auto users = m_users.find(path);
    if (users == m_users.end()) {
        return false;
    }
    const std::string now = m_watch.contentOf(path);
    return std::any_of(users->second.begin(), users->second.end(), [&](TargetId id) {
        const Target* target = m_session.targets().find(id);
        const MeshFile* file = target != nullptr ? fileOf(*target) : nullptr;
        return file != nullptr && (file->path != path || file->sha256.empty() || file->sha256 != now);
    });
}

std::vector<TargetId> MeshReloader::usersOf(const QStringList& paths) const {
    std::set<TargetId> all;
    for (const QString& path : paths) {
        if (const auto users = m_users.find(path); users != m_users.end()) {
            all.insert(users->second.begin(), users->second.end());
        }
    }
    return {all.begin(), all.end()};
}

void MeshReloader::setChanged(const QStringList& paths) {
    if (paths != m_changed) {
        m_changed = paths;
        Q_EMIT changedFilesChanged();
    }
}

void MeshReloader::offerBesides(const QStringList& paths) {
    QStringList all = paths + m_changed;
    all.removeDuplicates();
    setChanged(all);
}

void MeshReloader::take(const QString& path) {
    QStringList changed = m_changed;
    changed.removeAll(path);
    if (isOther(path)) {
        changed << path;
    }
    setChanged(changed);
}

void MeshReloader::ignore() {
    setChanged({});
}

// Reading again

void MeshReloader::reload() {
    if (m_work || m_changed.isEmpty()) {
        return;
    }
    const auto work = std::make_shared<Work>();
    work->files = m_changed;
    work->document = captureSettings(m_session, {});
    const std::vector<TargetId> users = usersOf(m_changed);
    std::erase_if(work->document.targets, [&users](const SavedTarget& target) {
        return !std::binary_search(users.begin(), users.end(), target.id);
    });
    for (const SavedTarget& target : work->document.targets) {
        const PreparedMesh& shape = m_session.targets().find(target.id)->shape;
        work->before[target.id] = {shape.mesh, shape.render};
    }
    m_work = work;
    setChanged({});
    m_progress = std::make_unique<TaskProgress>(
        m_session.tasks(), tr("Reading %1").arg(QFileInfo(work->files.front()).fileName()),
        [this, files = work->files] {
            giveUp();
            offerBesides(files);
            Q_EMIT cancelled();
        },
        tr("Cancel reading; the meshes stay as they are"));
    prepare(work);
}

void MeshReloader::prepare(const std::shared_ptr<Work>& work) {
    const auto report = [self = QPointer(this), work](double fraction, const QString& doing) {
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [self, work, fraction, doing] {
                if (MeshReloader* alive = self.data(); alive != nullptr) {
                    alive->say(*work, fraction, doing);
                }
            },
            Qt::QueuedConnection);
    };
    workBeside(
        this,
        [work, report] {
            Result<PreparedSession> prepared = prepareSession(work->document, {}, {report, &work->cancelled});
            if (!prepared) {
                work->status = prepared.error();
                return;
            }
            work->prepared = std::move(prepared.value());
            std::map<std::pair<const void*, const void*>, std::shared_ptr<const CarriedHits>> made;
            for (const TargetState& target : work->prepared.scene.targets) {
                const CarriedHits::Shape& before = work->before[target.id];
                auto& carried = made[{before.render.get(), target.shape.render.get()}];
                if (!carried) {
                    carried = std::make_shared<const CarriedHits>(
                        before, CarriedHits::Shape{target.shape.mesh, target.shape.render});
                }
                work->carried[target.id] = carried;
            }
        },
        [work](MeshReloader& self, bool done) { self.finish(work, done); });
}

void MeshReloader::say(const Work& work, double fraction, const QString& doing) {
    if (&work == m_work.get()) {
        m_progress->say(doing);
        m_progress->report(fraction);
    }
}

void MeshReloader::giveUp() {
    if (m_work) {
        m_work->cancelled = true;
        m_work.reset();
        m_progress.reset();
    }
}

void MeshReloader::finish(const std::shared_ptr<Work>& work, bool done) {
    if (work != m_work) {
        return;
    }
    m_work.reset();
    m_progress.reset();
    std::optional<Error> error;
    if (!done) {
        error = noRoomForMesh();
    } else if (!work->status) {
        error = work->status.error();
    } else if (!work->prepared.isWhole()) {
        const auto& troubles = work->prepared.troubles;
        const auto missing = std::find_if(troubles.begin(), troubles.end(), [](const MeshTrouble& trouble) {
            return trouble.kind != MeshTrouble::Kind::Changed;
        });
        error = Error{missing->error.what, missing->error.where,
                      "The targets stay as they were; reload the mesh when its file can be read."};
    }
    if (error) {
        offerBesides(work->files);
        Q_EMIT failed(*error);
        return;
    }
    leaveOutOthers(*work);
    if (!work->prepared.scene.targets.empty()) {
        Q_EMIT reloaded(apply(*work));
    }
    offerAgain(*work);
}

void MeshReloader::leaveOutOthers(Work& work) const {
    std::erase_if(work.prepared.scene.targets, [&](const TargetState& target) {
        const Target* now = m_session.targets().find(target.id);
        return now == nullptr || now->shape.mesh != work.before[target.id].mesh;
    });
}

/// What was refined meanwhile, say, still uses its file as it was.
void MeshReloader::offerAgain(const Work& work) {
    std::set<TargetId> reloaded;
    for (const auto& [before, now] : work.ids) {
        reloaded.insert(now);
    }
    follow();
    QStringList left = work.files;
    left.removeIf([&](const QString& path) {
        const std::vector<TargetId> users = usersOf({path});
        return m_changed.contains(path) || !isOther(path) ||
               std::all_of(users.begin(), users.end(), [&](TargetId id) { return reloaded.contains(id); });
    });
    if (left.isEmpty()) {
        return;
    }
    offerBesides(left);
    QStringList names;
    for (const QString& path : left) {
        names << QFileInfo(path).fileName();
    }
    Q_EMIT failed({"Not reloaded: " + names.join(QStringLiteral(", ")).toStdString() +
                       ". Its target was changed meanwhile and stays as it is.",
                   "", "Reload the mesh again."});
}

QStringList MeshReloader::apply(Work& work) {
    const KeptSelection selection(m_session);
    std::size_t alongWith = 0;
    std::size_t inPlace = 0;
    const auto carried = [&](const Hit& hit) {
        const CarriedHits& how = *work.carried[hit.target];
        ++(how.isByVertex() ? alongWith : inPlace);
        return how.carried(hit);
    };
    work.ids = m_session.targets().replaceMeshes(work.prepared.scene.targets, carried);
    std::map<TargetId, TargetId> ids = work.ids;
    QStringList byVertex;
    QStringList byPosition;
    for (const TargetState& target : work.prepared.scene.targets) {
        const bool isByVertex = work.carried[target.id]->isByVertex();
        (isByVertex ? byVertex : byPosition) << QFileInfo(target.sourcePath).fileName();
        if (!isByVertex) {
            ids.erase(target.id);
        }
    }
    selection.restore(m_session, ids);
    byVertex.removeDuplicates();
    byPosition.removeDuplicates();
    QStringList said;
    if (!byVertex.isEmpty()) {
        said << tr("Reloaded %1. Its vertices correspond, and %2 went along with the triangles.")
                    .arg(byVertex.join(QStringLiteral(", ")), hitsText(alongWith));
    }
    if (!byPosition.isEmpty()) {
        said << tr("Reloaded %1. Its vertices do not correspond, and %2 stayed at the same place in space.")
                    .arg(byPosition.join(QStringLiteral(", ")), hitsText(inPlace));
    }
    return said + work.prepared.notes;
}

}  // namespace hitscope
