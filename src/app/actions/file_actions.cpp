// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/file_actions.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QUrl>
#include <algorithm>
#include <memory>

#include "app/actions/menu_building.h"
#include "app/dialogs/dialogs.h"
#include "app/dialogs/texture_locator.h"
#include "app/discard_guard.h"
#include "app/notice_bar.h"
#include "app/session_files.h"
#include "app/settings/app_settings.h"
#include "document/session_file.h"
#include "io/import.h"
#include "models/plain_text.h"
#include "panels/help/help_text.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr float kSmallestExtent = 0.5f;  // metres; projectiles are 0.2 m across
constexpr float kLargestExtent = 200.0f;

QString meshPatterns() {
    QStringList patterns;
    for (const QString& suffix : importSuffixes()) {
        patterns.append(QStringLiteral("*.") + suffix);
    }
    return patterns.join(u' ');
}

QString allMeshesFilter() {
    return FileActions::tr("Meshes (%1)").arg(meshPatterns());
}

QString everythingFilter() {
    return FileActions::tr("Sessions and meshes (*%1 %2)").arg(QLatin1String(kSessionSuffix), meshPatterns());
}

bool isSession(const QString& path) {
    return path.endsWith(QLatin1String(kSessionSuffix), Qt::CaseInsensitive);
}

bool canOpen(const QString& path) {
    return isSession(path) || importSuffixes().contains(QFileInfo(path).suffix().toLower());
}

/// As many as the notice has room for.
QStringList firstOf(const QStringList& notes) {
    constexpr int kMost = 6;
    QStringList lines = notes.mid(0, kMost);
    if (notes.size() > lines.size()) {
        lines.append(FileActions::tr("and %n more", nullptr, static_cast<int>(notes.size() - lines.size())));
    }
    return lines;
}

}  // namespace

QString FileActions::sessionsFilter() {
    return tr("Sessions (*%1)").arg(QLatin1String(kSessionSuffix));
}

FileActions::FileActions(const Parts& parts) : QObject(&parts.window), m_parts(parts) {
    m_parts.files.setAsk([this](std::function<void()> then, std::function<void()> instead) {
        m_parts.guard.ask(std::move(then), std::move(instead));
    });
    connect(&m_parts.files, &SceneFiles::opened, this, &FileActions::takeOpened);
    connect(&m_parts.files, &SceneFiles::made, this, [this](const QString&, SceneFiles::Into into) {
        if (into == SceneFiles::Into::NewScene) {
            m_parts.sessions.leave();
        }
        Q_EMIT said({});
    });
    connect(&m_parts.sessions, &SessionFiles::opened, this, &FileActions::takeSession);
    connect(&m_parts.sessions, &SessionFiles::openingBegun, &m_parts.files, &SceneFiles::cancel);
    connect(&m_parts.sessions, &SessionFiles::saved, this, [this](const QString& path) {
        remember(path);
        Q_EMIT opened();
        Q_EMIT said(tr("Saved %1").arg(QFileInfo(path).fileName()));
    });
    watchFile();
    const SessionTargets& targets = m_parts.session.targets();
    const SessionSettings& settings = m_parts.session.settings();
    connect(&targets, &SessionTargets::added, this, &FileActions::withdrawScaling);
    connect(&targets, &SessionTargets::removed, this, &FileActions::withdrawScaling);
    connect(&targets, &SessionTargets::changed, this, &FileActions::withdrawScaling);
    connect(&settings, &SessionSettings::constantsChanged, this, &FileActions::withdrawScaling);
    connect(&settings, &SessionSettings::flightModeChanged, this, &FileActions::withdrawScaling);
    connect(&m_parts.files, &SceneFiles::cancelled, this,
            [this] { Q_EMIT said(tr("Cancelled. The scene is unchanged.")); });
}

void FileActions::fill(QMenu& menu) {
    addAction(menu, tr("&New Session"), QKeySequence::New, this,
              [this] { m_parts.guard.ask([this] { startNew(); }); });
    m_open = addAction(
        menu, tr("&Open…"), QKeySequence::Open, this, [this] { choose(); }, QStringLiteral("open"));
    m_recent = menu.addMenu(tr("Open &Recent"));
    m_recent->setToolTipsVisible(true);
    connect(m_recent, &QMenu::aboutToShow, this, &FileActions::showRecent);
    addAction(menu, tr("A&dd to Scene…"), tr("Ctrl+Shift+O"), this, [this] { chooseAddition(); });
    menu.addSeparator();
    m_scenes = menu.addMenu(tr("S&cenes"));
    fillScenes(*m_scenes);
    menu.addSeparator();
    m_save = addAction(
        menu, tr("&Save Session"), QKeySequence::Save, this, [this] { this->save(); },
        QStringLiteral("save"));
    m_save->setStatusTip(tr("Save targets, hits and settings in one file"));
    addAction(menu, tr("Save Session &As…"), tr("Ctrl+Shift+S"), this, [this] { saveAs(); });
    m_revert = addAction(menu, tr("Re&vert to Saved…"), {}, this, [this] { askAndRevert(); });
    connect(&m_parts.sessions, &SessionFiles::changed, this, &FileActions::followFile);
    followFile();
}

void FileActions::followFile() {
    const bool hasFile = !m_parts.sessions.path().isEmpty();
    enableIf(*m_revert, hasFile && m_parts.sessions.isModified(),
             hasFile ? tr("The session is as it was saved.") : tr("The session was never saved."));
}

// Sessions

/// What is being opened does not take the place of what comes next.
void FileActions::giveUpOpening() {
    m_parts.files.cancel();
    m_parts.sessions.cancel();
}

void FileActions::startNew() {
    giveUpOpening();
    loadTeapot(m_parts.session);
    m_parts.sessions.leave();
    Q_EMIT startedNew();
}

void FileActions::takeSession(const QString& path, const QStringList& notes) {
    if (!path.isEmpty()) {
        remember(path);
        Q_EMIT opened();
        Q_EMIT said(tr("Opened %1").arg(QFileInfo(path).fileName()));
    }
    if (!notes.isEmpty()) {
        sayNotes(firstOf(notes));
    }
}

void FileActions::remember(const QString& path) {
    m_parts.settings.folder = QFileInfo(path).absolutePath();
    m_parts.settings.addRecentFile(path);
}

// Scenes and meshes

void FileActions::fillScenes(QMenu& menu) {
    QMenu& rows = *menu.addMenu(tr("Paper's &Tables"));
    for (std::size_t row = 0; row < paperRows().size(); ++row) {
        addAction(rows, tr("Row %1: %2").arg(row + 1).arg(paperRows()[row].label()), {}, this, [this, row] {
            m_parts.guard.ask([this, row] {
                giveUpOpening();
                loadPaperRow(m_parts.session, static_cast<int>(row));
                m_parts.sessions.leave();
            });
        });
    }
    addAction(menu, tr("&Utah Teapot"), {}, this, [this] { m_parts.guard.ask([this] { startNew(); }); });
    for (const SampleScene sample : allSampleScenes()) {
        addAction(menu, sampleSceneName(sample), {}, this,
                  [this, sample] { m_parts.guard.ask([this, sample] { loadSample(sample); }); });
    }
}

void FileActions::fillMesh(QMenu& menu) {
    m_placeMesh = addAction(menu, tr("&Centre and Scale…"), {}, this, [this] { choosePlacement(); });
    m_fileCoordinates = addAction(menu, tr("File's Own C&oordinates"), {}, this, [this] { place(0.0); });
    connect(&m_parts.session, &Session::sceneReplaced, this, &FileActions::follow);
    connect(&m_parts.session.targets(), &SessionTargets::added, this, &FileActions::follow);
    connect(&m_parts.session.targets(), &SessionTargets::removed, this, &FileActions::follow);
    follow();
}

void FileActions::follow() {
    const bool oneMesh = m_parts.session.targets().size() == 1;
    const QString onlyOne = tr("This is for scenes of one mesh.");
    enableIf(*m_placeMesh, oneMesh, onlyOne);
    enableIf(*m_fileCoordinates,
             oneMesh && !m_parts.session.targets().front()->deformed.original().placement.isIdentity(),
             oneMesh ? tr("The mesh has its file's own coordinates.") : onlyOne);
}

QStringList FileActions::openable(const QMimeData& data) {
    QStringList paths;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile() && canOpen(url.toLocalFile())) {
            paths.append(url.toLocalFile());
        }
    }
    return paths;
}

/// `first`: the filter that is chosen.
QStringList FileActions::chooseMeshes(const QString& title, const QString& first) {
    QStringList filters{first};
    filters += importNameFilters();
    filters += tr("All files (*)");
    return QFileDialog::getOpenFileNames(&m_parts.window, title, existingFolder(m_parts.settings.folder),
                                         filters.join(QStringLiteral(";;")));
}

void FileActions::choose() {
    askAndOpen(chooseMeshes(
        tr("Open session or meshes"),
        QStringList{everythingFilter(), sessionsFilter(), allMeshesFilter()}.join(QStringLiteral(";;"))));
}

void FileActions::askAndOpen(const QStringList& paths) {
    if (!paths.isEmpty()) {
        m_parts.guard.ask([this, paths] { open(paths); });
    }
}

void FileActions::askAndOpenDocument(SessionDocument document) {
    const auto shared = std::make_shared<SessionDocument>(std::move(document));
    m_parts.guard.ask([this, shared] { m_parts.sessions.openDocument(*shared, {}); });
}

void FileActions::open(const QStringList& paths) {
    const auto session = std::find_if(paths.begin(), paths.end(), isSession);
    giveUpOpening();
    if (session == paths.end()) {
        m_parts.files.open(paths);
    } else {
        if (paths.size() > 1) {
            m_parts.notice.say(tr("A session opens by itself: %1 was opened, the other files were not.")
                                   .arg(QFileInfo(*session).fileName()));
        }
        m_parts.sessions.open(*session);
    }
}

void FileActions::chooseAddition() {
    m_parts.files.open(chooseMeshes(tr("Add meshes to the scene"), allMeshesFilter()),
                       SceneFiles::Into::ThisScene);
}

void FileActions::loadSample(SampleScene scene) {
    giveUpOpening();
    m_parts.files.make(sampleSceneName(scene), SceneFiles::Into::NewScene,
                       [scene] { return planSampleScene(scene); });
}

void FileActions::takeOpened(const QStringList& paths, const QStringList& allNotes, SceneFiles::Into into) {
    if (into == SceneFiles::Into::NewScene) {
        m_parts.sessions.leave();
    }
    for (const QString& path : paths) {
        remember(path);
    }
    Q_EMIT opened();
    QStringList notes = allNotes;
    for (const QString& texture : m_parts.textures.useRemembered()) {
        notes.removeIf([&texture](const QString& note) { return note.contains(u'"' + texture + u'"'); });
    }
    sayOpened(notes);
    Q_EMIT said(paths.size() == 1 ? tr("Opened %1").arg(QFileInfo(paths.front()).fileName())
                                  : tr("Files opened: %1").arg(paths.size()));
}

/// What was dropped or mended on the way, and whether the mesh's size asks for something.
void FileActions::sayOpened(const QStringList& notes) {
    m_sizeQuestion = sizeQuestion();
    if (m_sizeQuestion.isEmpty()) {
        sayNotes(firstOf(notes));
        return;
    }
    m_sizeNotes = firstOf(notes);
    m_sizeNotice = m_parts.notice.say((QStringList(m_sizeQuestion) + m_sizeNotes).join(u'\n'),
                                      tr("Scale to %1 m").arg(shownNumber(static_cast<double>(kUsualExtent))),
                                      [this] { place(kUsualExtent); });
}

QString FileActions::sizeQuestion() const {
    const glm::vec3 size = m_parts.session.targets().bounds().size();
    const float extent = std::max({size.x, size.y, size.z});
    const bool oneMesh = m_parts.session.targets().size() == 1;
    // What goes by the mesh's size fits it.
    const bool dentFits = m_parts.session.settings().constantsSetting().relative;
    const bool projectileFits = m_parts.session.settings().flightMode() == FlightMode::Quick ||
                                m_parts.session.settings().flightMode() == FlightMode::Instant;
    const bool isUsual = extent >= kSmallestExtent && extent <= kLargestExtent;
    if (!oneMesh || extent <= 0.0f || isUsual || (dentFits && projectileFits)) {
        return {};
    }
    const ProjectileSettings projectile = projectileOf(
        m_parts.session.settings().flightMode(), m_parts.session.settings().projectile(), extent, extent);
    const float reach =
        dentFits ? 2.0f * projectile.radius : m_parts.session.settings().constants().maxDistance;
    const QString text = dentFits
                             ? tr("This mesh is %1 m across; a projectile is %2 m. With Quick or Instant "
                                  "in the tool bar, it goes by the size of the mesh.")
                             : tr("This mesh is %1 m across; hits reach %2 m around where they land.");
    return text.arg(shownNumber(static_cast<double>(extent), 'g', 3),
                    shownNumber(static_cast<double>(reach), 'g', 3));
}

/// The mesh was scaled or removed, or others were added, say: what the notice says is not so any more.
void FileActions::withdrawScaling() {
    if (m_sizeNotice == 0 || !m_parts.notice.isSaying(m_sizeNotice) || sizeQuestion() == m_sizeQuestion) {
        return;
    }
    m_sizeNotice = 0;
    m_parts.notice.clear();
    sayNotes(m_sizeNotes);
}

void FileActions::sayNotes(const QStringList& lines) {
    if (lines.isEmpty()) {
        return;
    }
    if (m_parts.textures.isAnyMissing()) {
        m_parts.notice.say(lines.join(u'\n'), tr("Locate…"), [this] { m_parts.textures.locate(); });
    } else {
        m_parts.notice.say(lines.join(u'\n'));
    }
}

void FileActions::showRecent() {
    m_recent->clear();
    for (const QString& path : m_parts.settings.recentFiles) {
        QAction* action = m_recent->addAction(menuText(QFileInfo(path).fileName()), this,
                                              [this, path] { askAndOpen({path}); });
        action->setToolTip(asPlainText(path));
    }
    if (m_parts.settings.recentFiles.isEmpty()) {
        enableIf(*m_recent->addAction(tr("No files yet")), false,
                 tr("Files that are opened are listed here."));
        return;
    }
    m_recent->addSeparator();
    m_recent->addAction(tr("Clear This List"), this, [this] { m_parts.settings.recentFiles.clear(); });
}

void FileActions::choosePlacement() {
    bool accepted = false;
    const double extent = QInputDialog::getDouble(&m_parts.window, tr("Centre and Scale"),
                                                  tr("Largest extent of the mesh, in metres.\nIts hits are "
                                                     "cleared, which can be undone; the file's own "
                                                     "coordinates are kept for export."),
                                                  kUsualExtent, 0.01, 1000.0, 2, &accepted, {}, 0.5);
    if (accepted) {
        place(extent);
    }
}

void FileActions::place(double extent) {
    if (m_parts.session.targets().size() != 1) {
        return;
    }
    const Target& target = *m_parts.session.targets().front();
    if (!target.steps.empty()) {
        Q_EMIT said(tr("The mesh was changed at this size, by the Mesh menu: undo that first."));
        return;
    }
    const TargetSource source = target.source;
    MeshData mesh = target.deformed.original();
    if (extent > 0.0) {
        hitscope::place(mesh, static_cast<float>(extent));
    } else if (!mesh.filePositions.empty()) {
        std::transform(mesh.filePositions.begin(), mesh.filePositions.end(), mesh.positions.begin(),
                       [](const glm::dvec3& position) { return glm::vec3(position); });
        mesh.placement = {};
    }
    ScenePlan plan;
    TargetPlan placed = planMesh(prepareMesh(std::move(mesh)), source);
    placed.name = target.name;
    placed.sourcePath = target.sourcePath;
    placed.textures = target.textures;
    plan.targets.push_back(std::move(placed));
    plan.name = target.name;
    m_parts.session.loadScene(std::move(plan), SessionUndo::Kind::PlaceMesh);
    Q_EMIT said(tr("Placed the mesh. Undo (Ctrl+Z) brings back how it was, with its hits."));
}

}  // namespace hitscope
