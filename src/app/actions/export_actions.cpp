// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/export_actions.h"

#include <QAction>
#include <QCoreApplication>
#include <QEventLoop>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>
#include <algorithm>

#include "analysis/changed_settings.h"
#include "app/actions/menu_building.h"
#include "app/dialogs/dialogs.h"
#include "app/mesh_exporter.h"
#include "app/settings/app_settings.h"
#include "models/focus_target.h"
#include "models/quantity_text.h"
#include "panels/fields/save_name.h"
#include "panels/help/help_text.h"
#include "session/export/export_target.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

/// "teapot" and "_deformed.obj" in `folder`, without characters that file systems refuse.
QString suggestedPath(const QString& folder, QString name, const QString& ending) {
    for (QChar& letter : name) {
        if (!letter.isLetterOrNumber() && letter != u'-' && letter != u'.') {
            letter = u'_';
        }
    }
    return folder + u'/' + (name.isEmpty() ? QStringLiteral("mesh") : name) + ending;
}

/// Of files, whatever they held.
bool isSameSource(const TargetSource& a, const TargetSource& b) {
    const auto* file = std::get_if<MeshFile>(&a);
    const auto* other = std::get_if<MeshFile>(&b);
    return file != nullptr && other != nullptr ? file->path == other->path
                                               : a == b && !std::holds_alternative<std::monostate>(a);
}

/// What the name says of the format goes before what was chosen, as on the command line. PLY is binary where
/// text was not chosen.
ExportOptions namedAs(const QString& path, ExportOptions options) {
    const QString suffix = QFileInfo(path).suffix();
    const std::optional<ExportFormat> named = exportFormatOf(path);
    if (named && suffix.compare(QLatin1String(traitsOf(options.format).suffix), Qt::CaseInsensitive) != 0) {
        const ExportFormatTraits& traits = traitsOf(*named);
        options.format = *named;
        options.allNormals = options.allNormals && traits.hasNormals;
        options.steps = traits.hasSteps ? options.steps : 0;
        options.readBack = options.readBack && *named != ExportFormat::Csv;
    }
    return options;
}

/// Those of all formats, the chosen one's first: a name that has one of them is left as it is.
QStringList suffixesFrom(const QString& chosen) {
    QStringList suffixes{chosen};
    for (const ExportFormatTraits& traits : exportFormats()) {
        suffixes += QLatin1String(traits.suffix);
    }
    return suffixes;
}

QString exportName(const Target& target) {
    return target.sourcePath.isEmpty() ? target.name : QFileInfo(target.sourcePath).completeBaseName();
}

}  // namespace

ExportActions::ExportActions(Session& session, Viewport& viewport, AppSettings& settings, QWidget& window)
    : QObject(&window),
      m_session(session),
      m_viewport(viewport),
      m_settings(settings),
      m_window(window),
      m_exporter(new MeshExporter(session.tasks(), this)) {
    connect(m_exporter, &MeshExporter::exported, this, &ExportActions::tellWritten);
    connect(m_exporter, &MeshExporter::failed, this, &ExportActions::failed);
    connect(m_exporter, &MeshExporter::cancelled, this,
            [this] { Q_EMIT said(tr("Cancelled. The file is unchanged.")); });
    connect(m_exporter, &MeshExporter::begun, this, &ExportActions::writing);
    connect(m_exporter, &MeshExporter::ended, this, &ExportActions::ended);
}

void ExportActions::tellWritten(const QString& name, const QString& path, const QStringList& notes,
                                bool wasReadBack) {
    if (m_handedOver == path) {  // a temporary file, whose place says nothing
        Q_EMIT said(tr("Passed %1 to the other program as %2").arg(name, QFileInfo(path).fileName()));
    } else {
        Q_EMIT said(wasReadBack ? tr("Exported %1; read back, it is the same: %2").arg(name, path)
                                : tr("Exported %1 to %2").arg(name, path));
    }
    if (!notes.isEmpty()) {  // the status bar has no room for them
        Q_EMIT noticeWanted(tr("In %1:").arg(QFileInfo(path).fileName()) + u' ' + notes.join(u' '));
    }
}

void ExportActions::fill(QMenu& menu) {
    m_export = addAction(
        menu, tr("&Export Deformed Mesh…"), tr("Ctrl+E"), this, [this] { choose(); },
        QStringLiteral("export"));
    m_again = addAction(menu, tr("Export A&gain"), tr("Ctrl+Shift+E"), this, [this] { again(); });
    m_again->setObjectName(QStringLiteral("exportAgain"));
    connect(&m_session, &Session::sceneReplaced, this, &ExportActions::follow);
    connect(&m_session.targets(), &SessionTargets::added, this, &ExportActions::follow);
    connect(&m_session.targets(), &SessionTargets::removed, this, &ExportActions::follow);
    follow();
}

void ExportActions::follow() {
    const bool isAny = !m_session.targets().empty();
    // Another target under the same name would be written over the file of the first.
    const bool isThere = m_last && !lastTargets().empty();
    enableIf(*m_export, isAny, tr("There is no target to export."));
    enableIf(*m_again, isThere,
             m_last ? tr("What was exported last is not in the scene.") : tr("Nothing was exported yet."));
    m_again->setText(isThere ? tr("Export A&gain to %1").arg(menuText(QFileInfo(m_last->path).fileName()))
                             : tr("Export A&gain"));
}

/// It, or what a refined or reloaded mesh has made of it; null: it is not in the scene.
const Target* ExportActions::find(const Written& written) const {
    if (const Target* target = m_session.targets().find(written.id)) {
        return target;
    }
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        if (isSameSource(target->source, written.source) && target->name == written.name) {
            return target.get();
        }
    }
    return nullptr;
}

/// What was exported last; none where a part of it is not in the scene.
std::vector<const Target*> ExportActions::lastTargets() const {
    if (m_last->scope == ExportScope::AllTargets) {
        return targets(ExportScope::AllTargets);
    }
    std::vector<const Target*> found;
    for (const Written& written : m_last->targets) {
        found.push_back(find(written));
    }
    return std::find(found.begin(), found.end(), nullptr) == found.end() ? found
                                                                         : std::vector<const Target*>();
}

/// Of one: that in focus. None in an empty scene.
std::vector<const Target*> ExportActions::targets(ExportScope scope) const {
    std::vector<const Target*> chosen;
    if (scope == ExportScope::OneTarget) {
        const Target* target = focusTarget(m_session);
        return target != nullptr ? std::vector{target} : chosen;
    }
    for (const auto& target : m_session.targets()) {
        if (scope == ExportScope::AllTargets || m_session.targets().isSelected(target->id)) {
            chosen.push_back(&*target);
        }
    }
    return chosen;
}

void ExportActions::choose() {
    const Target* target = focusTarget(m_session);
    if (target == nullptr) {
        return;
    }
    ExportDialog::Choice choice;
    choice.target = tr("“%1”").arg(target->name);
    choice.targets = m_session.targets().size();
    choice.selected = m_session.targets().allSelected().size();
    choice.isScaled = target->deformed.original().placement.scale != 1.0;
    choice.hits = m_session.hits().shown().size();
    choice.shown = m_settings.exportNormals.value_or(m_viewport.options().normals);
    choice.estimate = [this](ExportScope scope, const ExportOptions& options) {
        return estimateExport(targets(scope), options, m_session.hits().shown());
    };
    ExportDialog dialog(std::move(choice), &m_window);
    if (!m_session.hits().showsAll()) {  // the history was moved back
        dialog.setWindowTitle(tr("Export After Hit %1 of %2")
                                  .arg(countText(m_session.hits().shown().size()),
                                       countText(m_session.hits().history().size())));
    }
    dialog.load(QSettings());
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    dialog.save(*ChangedSettings());
    ExportOptions options = dialog.options();
    const NormalMode shown = m_viewport.options().normals;
    m_settings.exportNormals = options.normals == shown ? std::nullopt : std::optional(options.normals);
    const bool isAny = !targets(dialog.scope()).empty();
    const QString path = isAny ? choosePath(targets(dialog.scope()), options.format) : QString();
    const std::vector<const Target*> chosen = targets(dialog.scope());  // as they are after the questions
    if (!path.isEmpty() && !chosen.empty()) {
        options = namedAs(path, options);
        m_last = Last{path, dialog.scope(), {}, options};
        for (const Target* each : chosen) {
            m_last->targets.push_back({each->id, each->name, each->source});
        }
        beginOf(chosen, path, options);
        follow();
    }
}

void ExportActions::again() {
    if (m_last && !lastTargets().empty()) {
        beginOf(lastTargets(), m_last->path, m_last->options);
    }
}

/// Of a target's own file; empty: it is none.
QString ExportActions::whatReplacingDoes(const QString& path) const {
    const QString replaced = QFileInfo(path).canonicalFilePath();
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        const auto* source = std::get_if<MeshFile>(&target->source);
        if (source != nullptr && QFileInfo(source->path).canonicalFilePath() == replaced) {
            return tr("The target “%1” was read from it. A session that refers to it then starts from the "
                      "dented mesh and applies the hits to it again. The original is lost.")
                .arg(target->name);
        }
    }
    return {};
}

/// Empty: none was chosen.
QString ExportActions::choosePath(const std::vector<const Target*>& targets, ExportFormat format) {
    const QString suffix = QLatin1String(traitsOf(format).suffix);
    const QString name = targets.size() > 1 ? QStringLiteral("scene") : exportName(*targets.front());
    const QString path = askSaveName(
        &m_window, {.title = tr("Export Deformed Mesh"),
                    .suggested = suggestedPath(existingFolder(m_settings.folder), name,
                                               QStringLiteral("_deformed.") + suffix),
                    .filters = {tr("%1 (*.%2)").arg(tr(traitsOf(format).name), suffix)},
                    .suffixes = suffixesFrom(suffix),
                    .consequence = [this](const QString& chosen) { return whatReplacingDoes(chosen); }});
    if (!path.isEmpty()) {
        m_settings.folder = QFileInfo(path).absolutePath();
    }
    return path;
}

void ExportActions::tellBegin(const std::vector<const Target*>& targets, const QString& path,
                              ExportFormat format) {
    if (format == ExportFormat::Csv) {
        return;  // hits that only a table shows are lost with the session
    }
    Q_EMIT began(targets, path);
}

void ExportActions::beginOf(const std::vector<const Target*>& targets, const QString& path,
                            const ExportOptions& options) {
    if (Status current = m_viewport.syncNow(); !current) {
        Q_EMIT failed(current.error());
        return;
    }
    tellBegin(targets, path, options.format);
    QString name = targets.size() == 1 ? tr("“%1”").arg(targets.front()->name)
                                       : tr("%n targets", nullptr, static_cast<int>(targets.size()));
    if (targets.size() == 1 && !options.inWorld &&
        targets.front()->deformed.original().placement.scale != 1.0) {
        name = tr("%1 in the size of its file").arg(name);
    }
    if (!m_session.hits().showsAll()) {
        name = tr("%1 after hit %2 of %3")
                   .arg(name, countText(m_session.hits().shown().size()),
                        countText(m_session.hits().history().size()));
    }
    m_exporter->start(copyForExport(m_session, targets, options), name, path);
}

ExportOptions ExportActions::shownAs(const QString& path, std::optional<NormalMode> normals) const {
    ExportOptions options;
    options.format = exportFormatOf(path).value_or(ExportFormat::Obj);
    options.normals = normals.value_or(m_viewport.options().normals);
    return options;
}

void ExportActions::begin(const QString& path, std::optional<NormalMode> normals) {
    if (const Target* target = focusTarget(m_session)) {
        beginOf({target}, path, shownAs(path, normals));
    }
}

/// What asks for the file waits for it, but the window goes on meanwhile.
bool ExportActions::writeTarget(TargetId target, const QString& path) {
    const Target* const found = m_session.targets().find(target);
    if (found == nullptr) {
        Q_EMIT failed({"The target is gone.", {}, {}});
        return false;
    }
    if (Status current = m_viewport.syncNow(); !current) {
        Q_EMIT failed(current.error());
        return false;
    }
    bool isDone = false;
    m_handedOver = path;
    const int job = m_exporter->start(copyForExport(m_session, {&found, 1}, shownAs(path, {})),
                                      tr("“%1”").arg(found->name), path);
    QEventLoop waiting;
    connect(m_exporter, &MeshExporter::ended, &waiting, [&](const QString&, bool isWritten, int of) {
        if (of == job) {
            isDone = isWritten;
            waiting.quit();
        }
    });
    connect(m_exporter, &QObject::destroyed, &waiting, &QEventLoop::quit);
    connect(QCoreApplication::instance(), &QCoreApplication::aboutToQuit, &waiting, &QEventLoop::quit);
    waiting.exec(QEventLoop::ExcludeUserInputEvents);
    return isDone;
}

Status ExportActions::write(const QString& path, std::optional<NormalMode> normals) {
    const Target* target = focusTarget(m_session);
    if (target == nullptr) {
        return Error{"There is nothing to export.", path.toStdString(), "Open a mesh first."};
    }
    if (Status current = m_viewport.syncNow(); !current) {
        return current;
    }
    const ExportOptions options = shownAs(path, normals);
    tellBegin({target}, path, options.format);
    const Result<ExportReport> written = exportTarget(m_session, *target, path, options);
    Q_EMIT ended(path, written.ok());
    return written ? Status(Done{}) : Status(written.error());
}

}  // namespace hitscope
