// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/collect_session.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSet>
#include <algorithm>
#include <limits>
#include <new>
#include <utility>

#include "document/capture.h"
#include "document/document_json.h"
#include "io/file_scope.h"
#include "io/staged_files.h"
#include "mesh/missing_textures.h"
#include "session/target_plan.h"

namespace hitscope {

namespace {

const QString kMeshes = QStringLiteral("meshes");
const QString kTextures = QStringLiteral("textures");

QString translated(const char* words) {
    return QCoreApplication::translate("hitscope::CollectSession", words);
}

/// The same way from the mesh; empty: it does not simply lead down.
QString wayDown(const QString& name) {
    QString local = name;
    local.replace(u'\\', u'/');
    const bool goesUp = local.split(u'/').contains(QLatin1String(".."));
    const QString clean = QDir::cleanPath(local);
    return goesUp || QDir::isAbsolutePath(clean) || clean.contains(u':') ? QString() : clean;
}

QString fileNameOf(const QString& name) {
    QString local = name;
    return QFileInfo(local.replace(u'\\', u'/')).fileName();
}

class Planner {
public:
    Collection plan(SessionDocument document, const ReferencesByMesh& references) {
        for (SavedTarget& target : document.targets) {
            if (auto* file = std::get_if<MeshFile>(&target.source.mesh)) {
                const auto named = references.find(file->path);
                const QString place = placeMesh(
                    file->path, named != references.end() ? named->second : std::vector<MeshReference>());
                target.source.relativePath = place;
                file->path = place;  // whoever gets the folder need not know where it was made
            }
            for (LocatedTexture& texture : target.textures) {
                texture.relativePath = placeTexture(texture.path);
                texture.path = texture.relativePath;
            }
        }
        m_collection.document = std::move(document);
        return std::move(m_collection);
    }

private:
    /// False: another file is there.
    bool put(const QString& source, const QString& place) {
        const auto [at, isNew] = m_sources.try_emplace(place, source);
        if (isNew) {
            m_collection.files.push_back({source, place});
        }
        return at->second == source;
    }

    QString placeMesh(const QString& path, const std::vector<MeshReference>& references) {
        const QFileInfo mesh(path);
        QString& below = m_meshFolders[mesh.absolutePath()];
        if (below.isEmpty()) {
            const QString name = mesh.completeBaseName();
            below = freeName(kMeshes + u'/' + (name.isEmpty() ? QStringLiteral("mesh") : name), {});
        }
        const QString place = below + u'/' + mesh.fileName();
        if (put(path, place)) {
            placeReferences(mesh.fileName(), below, references);
        }
        return place;
    }

    /// What leads down first: where other names end is for those that are left to find.
    void placeReferences(const QString& mesh, const QString& below,
                         const std::vector<MeshReference>& references) {
        std::vector<MeshReference> others;
        for (const MeshReference& reference : references) {
            const QString way = wayDown(reference.name);
            const bool leadsThere = reference.kind != MeshReference::Kind::PictureByName && !way.isEmpty();
            if (!leadsThere || !put(reference.path, below + u'/' + way)) {
                others.push_back(reference);
            }
        }
        for (const MeshReference& reference : others) {
            const bool isFound = reference.kind != MeshReference::Kind::Data &&
                                 put(reference.path, below + u'/' + fileNameOf(reference.name));
            if (!isFound) {
                m_collection.notes << translated(QT_TRANSLATE_NOOP(
                                                     "hitscope::CollectSession",
                                                     "%1 names “%2” in a way that holds in its folder alone; "
                                                     "the collected mesh will not find it."))
                                          .arg(mesh, reference.name);
            }
        }
    }

    QString placeTexture(const QString& path) {
        QString& place = m_textures[path];
        if (place.isEmpty()) {
            const QFileInfo info(path);
            const QString suffix = info.suffix().isEmpty() ? QString() : u'.' + info.suffix();
            place = freeName(kTextures + u'/' + info.completeBaseName(), suffix);
            put(path, place);
        }
        return place;
    }

    QString freeName(const QString& wanted, const QString& suffix) {
        QString name = wanted + suffix;  // the same in other letters counts: not all systems tell them apart
        for (int number = 2; m_names.contains(name.toLower()); ++number) {
            name = wanted + u'-' + QString::number(number) + suffix;
        }
        m_names.insert(name.toLower());
        return name;
    }

    Collection m_collection;
    std::map<QString, QString> m_sources;      // by place
    std::map<QString, QString> m_meshFolders;  // by the meshes' own
    std::map<QString, QString> m_textures;     // by path
    QSet<QString> m_names;
};

// Looking

/// Each path once.
std::vector<const SavedTarget*> withFiles(const SessionDocument& document) {
    std::vector<const SavedTarget*> found;
    QSet<QString> known;
    for (const SavedTarget& target : document.targets) {
        const auto* file = std::get_if<MeshFile>(&target.source.mesh);
        if (file != nullptr && !known.contains(file->path)) {
            known.insert(file->path);
            found.push_back(&target);
        }
    }
    return found;
}

std::string listOf(const QStringList& names) {
    constexpr qsizetype kMost = 5;
    const QString first = names.mid(0, kMost).join(QStringLiteral(", "));
    return (names.size() > kMost ? first + QStringLiteral(", …") : first).toStdString();
}

/// That there is a mesh for each target, and that it is what it was.
Status checkMeshes(const SessionDocument& document) {
    QStringList unknown;
    QStringList gone;
    QStringList changed;
    for (const SavedTarget& target : document.targets) {
        if (std::holds_alternative<std::monostate>(target.source.mesh)) {
            unknown << target.name;
        }
    }
    for (const SavedTarget* target : withFiles(document)) {
        const auto& file = std::get<MeshFile>(target->source.mesh);
        if (!QDir::isAbsolutePath(file.path) || !QFileInfo(file.path).isFile()) {
            gone << file.path;
        } else if (!file.sha256.empty() && meshFileAt(file.path).sha256 != file.sha256) {
            changed << file.path;
        }
    }
    if (!gone.isEmpty()) {
        return Error{"Meshes of this session are not there.", listOf(gone),
                     "Put them back, or open the session and choose where they are now."};
    }
    if (!changed.isEmpty()) {
        return Error{"Meshes have changed since they were read.", listOf(changed),
                     "Reload them in the window and save the session, then collect it."};
    }
    if (!unknown.isEmpty()) {
        return Error{"The session does not say what targets were made from.", listOf(unknown),
                     "Remove them first."};
    }
    return Done{};
}

/// Pictures that are gone could not be found again; the session is as it is without them.
void leaveOutGone(SessionDocument& document, QStringList& notes) {
    for (SavedTarget& target : document.targets) {
        std::erase_if(target.textures, [&notes](const LocatedTexture& texture) {
            const bool isGone = !QFileInfo(texture.path).isFile();
            if (isGone) {
                notes << translated(
                             QT_TRANSLATE_NOOP("hitscope::CollectSession", "The texture %1 is not there."))
                             .arg(QDir::toNativeSeparators(texture.path));
            }
            return isGone;
        });
    }
}

Error cancelledCollecting() {
    return {"Collecting was cancelled.", "", ""};
}

// Writing

/// That nothing of what is to come has its place taken.
Status checkFree(const Collection& collection, const QString& folder, const QString& name) {
    QStringList wanted = {name};
    for (const CollectedFile& file : collection.files) {
        wanted << file.place.section(u'/', 0, 0);
    }
    wanted.removeDuplicates();
    QStringList there;
    for (const QString& entry : wanted) {
        const QFileInfo info(QDir(folder).filePath(entry));
        if (info.exists() || info.isSymLink()) {
            there << QDir::toNativeSeparators(info.filePath());
        }
    }
    return there.isEmpty() ? Status(Done{})
                           : Error{"There is something of that name already.", listOf(there),
                                   "Choose another folder, or a new one."};
}

Status copyFiles(const Collection& collection, const QString& folder, StagedFiles& staged,
                 const PrepareControl& control) {
    double all = 1.0;
    for (const CollectedFile& file : collection.files) {
        all += static_cast<double>(QFileInfo(file.source).size());
    }
    double done = 0.0;
    for (const CollectedFile& file : collection.files) {
        if (control.isCancelled()) {
            return cancelledCollecting();
        }
        const QFileInfo source(file.source);
        if (control.progress) {
            control.progress(done / all,
                             translated(QT_TRANSLATE_NOOP("hitscope::CollectSession", "Copying %1"))
                                 .arg(source.fileName()));
        }
        const Status copied = staged.addCopy(source.canonicalFilePath(), QDir(folder).filePath(file.place),
                                             std::numeric_limits<qint64>::max());
        if (!copied) {
            return copied;
        }
        done += static_cast<double>(source.size());
    }
    return Done{};
}

/// The session last: it refers to the others.
Status writeCollection(Collection& collection, const QString& folder, const QString& name,
                       const PrepareControl& control) {
    StagedFiles staged;
    if (const Status copied = copyFiles(collection, folder, staged, control); !copied) {
        return copied;
    }
    numberTargets(1, collection.document);
    const QByteArray bytes = writeDocument(collection.document);
    const Status added =
        staged.add(QDir(folder).filePath(name), {bytes.constData(), static_cast<std::size_t>(bytes.size())},
                   StagedFiles::Existing::Keep);
    if (!added) {
        return added;
    }
    return control.isCancelled() ? Status(cancelledCollecting()) : staged.commit();
}

}  // namespace

Collection planCollection(SessionDocument document, const ReferencesByMesh& references) {
    return Planner().plan(std::move(document), references);
}

Result<QStringList> collectSession(SessionDocument document, const MeshesByPath& meshes,
                                   const QString& folder, const QString& name,
                                   const PrepareControl& control) try {
    if (control.progress) {
        control.progress(-1.0, translated(QT_TRANSLATE_NOOP("hitscope::CollectSession", "Checking meshes")));
    }
    if (const Status checked = checkMeshes(document); !checked) {
        return checked.error();
    }
    QStringList notes;
    leaveOutGone(document, notes);
    ReferencesByMesh references;
    for (const auto& [path, mesh] : meshes) {
        references[path] = allReferencesOf(path, *mesh);
        for (const std::string& texture : missingTextures(*mesh)) {
            notes << translated(QT_TRANSLATE_NOOP("hitscope::CollectSession",
                                                  "The texture “%1” of %2 is missing here too."))
                         .arg(fileNameText(texture), QFileInfo(path).fileName());
        }
    }
    const QString place = QDir::cleanPath(QFileInfo(folder).absoluteFilePath());
    Collection collection = planCollection(std::move(document), references);
    if (const Status isFree = checkFree(collection, place, name); !isFree) {
        return isFree.error();
    }
    if (const Status written = writeCollection(collection, place, name, control); !written) {
        return written.error();
    }
    return notes + collection.notes;
} catch (const std::bad_alloc&) {
    return Error{"There is not enough memory to collect this session.", "",
                 "Close other programs and try again."};
}

}  // namespace hitscope
