// SPDX-License-Identifier: GPL-3.0-or-later
// The window's part in opening, placing and saving.
#include <QApplication>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
#include <QMimeData>
#include <QSessionManager>
#include <QStatusBar>
#include <QUrl>
#include <algorithm>

#include "app/actions/hit_actions.h"
#include "app/actions/picture_actions.h"
#include "app/dialogs/dialogs.h"
#include "app/dialogs/texture_locator.h"
#include "app/discard_guard.h"
#include "app/main_window.h"
#include "app/mesh_exporter.h"
#include "app/notice_bar.h"
#include "app/scene_files.h"
#include "app/settings/settings_keeper.h"
#include "io/import.h"
#include "models/focus_target.h"
#include "panels/help/help_text.h"
#include "session/export_target.h"
#include "session/shown_number.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr float kSmallestExtent = 0.5f;  // metres; projectiles are 0.2 m across
constexpr float kLargestExtent = 200.0f;

QString allMeshesFilter() {
    QStringList patterns;
    for (const QString& suffix : importSuffixes()) {
        patterns.append(QStringLiteral("*.") + suffix);
    }
    return MainWindow::tr("Meshes (%1)").arg(patterns.join(u' '));
}

bool canOpen(const QString& path) {
    return importSuffixes().contains(QFileInfo(path).suffix().toLower());
}

QStringList droppedFiles(const QMimeData& data) {
    QStringList paths;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile()) {
            paths.append(url.toLocalFile());
        }
    }
    return paths;
}

/// "teapot" and "_deformed.obj" in `folder`, without characters that file systems refuse.
QString suggestedPath(const QString& folder, QString name, const QString& ending) {
    for (QChar& letter : name) {
        if (!letter.isLetterOrNumber() && letter != u'-' && letter != u'.') {
            letter = u'_';
        }
    }
    return folder + u'/' + (name.isEmpty() ? QStringLiteral("mesh") : name) + ending;
}

QString exportName(const Target& target) {
    return target.sourcePath.isEmpty() ? target.name : QFileInfo(target.sourcePath).completeBaseName();
}

QString withSuffix(const QString& path, const QString& suffix) {
    return QFileInfo(path).suffix().compare(suffix, Qt::CaseInsensitive) == 0 ? path : path + u'.' + suffix;
}

}  // namespace

void MainWindow::connectFiles() {
    connect(m_files, &SceneFiles::opened, this, &MainWindow::saidOpened);
    connect(m_files, &SceneFiles::made, statusBar(), &QStatusBar::clearMessage);
    connect(m_files, &SceneFiles::failed, this, [this](const Error& error) { showError(this, error); });
    m_exporter = new MeshExporter(m_session.tasks(), this);
    connect(m_exporter, &MeshExporter::exported, this, [this](const QString& name, const QString& path) {
        statusBar()->showMessage(tr("Exported “%1” to %2").arg(name, path), kMessageStays);
    });
    connect(m_exporter, &MeshExporter::failed, this, [this](const Error& error) { showError(this, error); });
    connect(m_exporter, &MeshExporter::cancelled, this,
            [this] { statusBar()->showMessage(tr("Cancelled. The file is unchanged."), kMessageStays); });
    m_guard = new DiscardGuard(
        m_session, *this, [this](const std::vector<TargetId>& targets) { return chooseExports(targets); });
    m_guard->letGo();  // of what was there before the window
    connect(m_exporter, &MeshExporter::ended, m_guard, &DiscardGuard::exportEnds);
    connect(m_hitActions, &HitActions::exportBegan, m_guard, &DiscardGuard::hitsExportBegins);
    connect(m_hitActions, &HitActions::exported, m_guard, &DiscardGuard::hitsExported);
    m_keeper = new SettingsKeeper([this](QSettings& settings) { saveSettings(settings); }, this);
    connect(m_keeper, &SettingsKeeper::failed, this, [this](const QString& file) {
        m_notice->say(
            tr("Settings cannot be saved: %1 cannot be written. Changes last until the window is closed.")
                .arg(QDir::toNativeSeparators(file)));
    });
    // Directly: the desktop waits for the answer.
    connect(
        qApp, &QGuiApplication::commitDataRequest, this,
        [this](QSessionManager& manager) {
            m_keeper->saveNow();
            m_guard->answer(manager);
        },
        Qt::DirectConnection);
    connect(m_files, &SceneFiles::cancelled, this,
            [this] { statusBar()->showMessage(tr("Cancelled. The scene is unchanged."), kMessageStays); });
}

void MainWindow::openFiles(const QStringList& paths) {
    m_files->open(paths);
}

QStringList MainWindow::chooseMeshes(const QString& title) {
    QStringList filters{allMeshesFilter()};
    filters += importNameFilters();
    filters += tr("All files (*)");
    return QFileDialog::getOpenFileNames(this, title, existingFolder(m_settings.folder),
                                         filters.join(QStringLiteral(";;")));
}

void MainWindow::chooseFile() {
    askAndOpen(chooseMeshes(tr("Open meshes")));
}

void MainWindow::askAndOpen(const QStringList& paths) {
    if (!paths.isEmpty()) {
        m_guard->ask([this, paths] { openFiles(paths); });
    }
}

void MainWindow::chooseAddition() {
    m_files->open(chooseMeshes(tr("Add meshes to the scene")), SceneFiles::Into::ThisScene);
}

void MainWindow::loadSample(SampleScene scene) {
    m_files->make(sampleSceneName(scene), SceneFiles::Into::NewScene,
                  [scene] { return planSampleScene(scene); });
}

void MainWindow::saidOpened(const QStringList& paths, const QStringList& allNotes) {
    for (const QString& path : paths) {
        m_settings.folder = QFileInfo(path).absolutePath();
        m_settings.addRecentFile(path);
    }
    m_keeper->lookSoon();
    QStringList notes = allNotes;
    for (const QString& texture : m_textureLocator->useRemembered()) {
        notes.removeIf([&texture](const QString& note) { return note.contains(u'"' + texture + u'"'); });
    }
    QStringList lines;
    for (const QString& note : notes.mid(0, 6)) {
        lines.append(note);
    }
    if (notes.size() > lines.size()) {
        lines.append(tr("and %n more", nullptr, static_cast<int>(notes.size() - lines.size())));
    }
    const glm::vec3 size = m_session.sceneBounds().size();
    const float extent = std::max({size.x, size.y, size.z});
    const bool oneMesh = m_session.targets().size() == 1;
    // What goes by the mesh's size fits it.
    const bool dentFits = m_session.constantsSetting().relative;
    const bool projectileFits =
        m_session.flightMode() == FlightMode::Quick || m_session.flightMode() == FlightMode::Instant;
    const bool isUsual = extent >= kSmallestExtent && extent <= kLargestExtent;
    if (oneMesh && extent > 0.0f && !isUsual && !(dentFits && projectileFits)) {
        const ProjectileSettings projectile =
            projectileOf(m_session.flightMode(), m_session.projectileSettings(), extent, extent);
        const float reach = dentFits ? 2.0f * projectile.radius : m_session.constants().maxDistance;
        const QString text = dentFits
                                 ? tr("This mesh is %1 m across; a projectile is %2 m. With Quick or Instant "
                                      "in the tool bar, it goes by the size of the mesh.")
                                 : tr("This mesh is %1 m across; hits reach %2 m around where they land.");
        lines.prepend(text.arg(shownNumber(static_cast<double>(extent), 'g', 3),
                               shownNumber(static_cast<double>(reach), 'g', 3)));
        m_notice->say(lines.join(u'\n'),
                      tr("Scale to %1 m").arg(shownNumber(static_cast<double>(kUsualExtent))),
                      [this] { m_guard->ask([this] { placeMesh(kUsualExtent); }); });
    } else if (m_textureLocator->isAnyMissing()) {
        m_notice->say(lines.join(u'\n'), tr("Locate…"), [this] { m_textureLocator->locate(); });
    } else if (!lines.isEmpty()) {
        m_notice->say(lines.join(u'\n'));
    }
    statusBar()->showMessage(paths.size() == 1
                                 ? tr("Opened %1").arg(QFileInfo(paths.front()).fileName())
                                 : tr("Opened %n file(s)", nullptr, static_cast<int>(paths.size())),
                             kMessageStays);
}

void MainWindow::showRecentFiles() {
    m_recentMenu->clear();
    for (const QString& path : m_settings.recentFiles) {
        QAction* action =
            m_recentMenu->addAction(QFileInfo(path).fileName(), this, [this, path] { askAndOpen({path}); });
        action->setToolTip(path);
    }
    if (m_settings.recentFiles.isEmpty()) {
        enableIf(*m_recentMenu->addAction(tr("No files yet")), false,
                 tr("Files that are opened are listed here."));
        return;
    }
    m_recentMenu->addSeparator();
    m_recentMenu->addAction(tr("Clear This List"), this, [this] { m_settings.recentFiles.clear(); });
}

void MainWindow::chooseExport() {
    if (const Target* target = focusTarget(m_session)) {
        chooseExportOf(*target);
    }
}

/// The path that is being written to; empty: none.
QString MainWindow::chooseExportOf(const Target& target) {
    const QStringList filters{tr("Wavefront OBJ, true normals (*.obj)"),
                              tr("Wavefront OBJ, the paper's normals (*.obj)")};  // by NormalMode
    const NormalMode shown = m_viewport->options().normals;
    QString filter = filters[static_cast<int>(m_settings.exportNormals.value_or(shown))];
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Export deformed mesh “%1”").arg(target.name),
        suggestedPath(existingFolder(m_settings.folder), exportName(target), QStringLiteral("_deformed.obj")),
        filters.join(QStringLiteral(";;")), &filter);
    if (path.isEmpty()) {
        return {};
    }
    const NormalMode normals =
        filter == filters[static_cast<int>(NormalMode::Paper)] ? NormalMode::Paper : NormalMode::True;
    m_settings.exportNormals = normals == shown ? std::nullopt : std::optional(normals);
    const QString full = withSuffix(path, QStringLiteral("obj"));
    m_settings.folder = QFileInfo(full).absolutePath();
    return beginExportOf(target, full, normals) ? full : QString();
}

/// One file by its name, several by their folder.
QStringList MainWindow::chooseExports(const std::vector<TargetId>& targets) {
    if (targets.size() != 1) {
        return exportAllInto(targets);
    }
    const Target* target = m_session.target(targets.front());
    const QString path = target != nullptr ? chooseExportOf(*target) : QString();
    return path.isEmpty() ? QStringList() : QStringList{path};
}

QStringList MainWindow::exportAllInto(const std::vector<TargetId>& targets) {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for the deformed meshes"),
                                                             existingFolder(m_settings.folder));
    QStringList paths;
    if (folder.isEmpty()) {
        return paths;
    }
    m_settings.folder = folder;
    for (const TargetId id : targets) {
        const Target* target = m_session.target(id);
        if (target == nullptr) {
            continue;
        }
        QString path = suggestedPath(folder, exportName(*target), QStringLiteral("_deformed.obj"));
        for (int n = 1; QFileInfo::exists(path) || paths.contains(path); ++n) {
            path = suggestedPath(folder, exportName(*target), QStringLiteral("_deformed-%1.obj").arg(n));
        }
        if (!beginExportOf(*target, path, m_settings.exportNormals.value_or(m_viewport->options().normals))) {
            break;
        }
        paths << path;
    }
    return paths;
}

bool MainWindow::beginExportOf(const Target& target, const QString& path, NormalMode normals) {
    if (Status current = m_viewport->syncNow(); !current) {
        showError(this, current.error());
        return false;
    }
    m_guard->exportBegins(target, path);
    m_exporter->start(copyForExport(target, normals), target.name, path);
    return true;
}

void MainWindow::beginExport(const QString& path, std::optional<NormalMode> normals) {
    if (const Target* target = focusTarget(m_session)) {
        beginExportOf(*target, path, normals.value_or(m_viewport->options().normals));
    }
}

Status MainWindow::exportTo(const QString& path, std::optional<NormalMode> normals) {
    const Target* target = focusTarget(m_session);
    if (target == nullptr) {
        return Error{"There is nothing to export.", path.toStdString(), "Open a mesh first."};
    }
    if (Status current = m_viewport->syncNow(); !current) {
        return current;
    }
    m_guard->exportBegins(*target, path);
    Status written = exportTarget(*target, path, normals.value_or(m_viewport->options().normals));
    m_guard->exportEnds(path, written.ok());
    return written;
}

/// Keys that people press by habit say what will be there.
void MainWindow::sayNotYet(const QString& text) {
    m_notice->say(text, tr("Export Deformed Mesh…"), [this] { chooseExport(); });
}

Status MainWindow::savePictureTo(const QString& path) {
    return m_pictures->save(path);
}

void MainWindow::choosePlacement() {
    bool accepted = false;
    const double extent = QInputDialog::getDouble(
        this, tr("Centre and scale"),
        tr("Largest extent of the mesh, in metres.\nIts hits are cleared; the file's own "
           "coordinates are kept for export."),
        kUsualExtent, 0.01, 1000.0, 2, &accepted, {}, 0.5);
    if (accepted) {
        m_guard->ask([this, extent] { placeMesh(extent); });
    }
}

void MainWindow::placeMesh(double extent) {
    if (m_session.targets().size() != 1) {
        return;
    }
    const Target& target = *m_session.targets().front();
    const QString sourcePath = target.sourcePath;
    MeshData mesh = target.deformed.original();
    if (extent > 0.0) {
        place(mesh, static_cast<float>(extent));
    } else if (!mesh.filePositions.empty()) {
        std::transform(mesh.filePositions.begin(), mesh.filePositions.end(), mesh.positions.begin(),
                       [](const glm::dvec3& position) { return glm::vec3(position); });
        mesh.placement = {};
    }
    m_session.loadMesh(std::move(mesh), sourcePath);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QStringList files = droppedFiles(*event->mimeData());
    if (std::any_of(files.begin(), files.end(), canOpen)) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    QStringList files = droppedFiles(*event->mimeData());
    files.erase(
        std::remove_if(files.begin(), files.end(), [](const QString& path) { return !canOpen(path); }),
        files.end());
    if (!files.isEmpty()) {
        event->acceptProposedAction();
        activateWindow();
        // Later: the program that was dragged from waits for the drop's end.
        QMetaObject::invokeMethod(
            this, [this, files] { askAndOpen(files); }, Qt::QueuedConnection);
    }
}

}  // namespace hitscope
