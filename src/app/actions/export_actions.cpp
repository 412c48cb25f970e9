// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/export_actions.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

#include "app/actions/menu_building.h"
#include "app/dialogs/dialogs.h"
#include "app/mesh_exporter.h"
#include "app/settings/app_settings.h"
#include "models/focus_target.h"
#include "panels/help/help_text.h"
#include "session/export_target.h"
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

QString exportName(const Target& target) {
    return target.sourcePath.isEmpty() ? target.name : QFileInfo(target.sourcePath).completeBaseName();
}

QString withSuffix(const QString& path, const QString& suffix) {
    return QFileInfo(path).suffix().compare(suffix, Qt::CaseInsensitive) == 0 ? path : path + u'.' + suffix;
}

}  // namespace

ExportActions::ExportActions(Session& session, Viewport& viewport, AppSettings& settings, QWidget& window)
    : QObject(&window),
      m_session(session),
      m_viewport(viewport),
      m_settings(settings),
      m_window(window),
      m_exporter(new MeshExporter(session.tasks(), this)) {
    connect(m_exporter, &MeshExporter::exported, this,
            [this](const QString& name, const QString& path, const QStringList& notes) {
                const QString text = tr("Exported “%1” to %2").arg(name, path);
                Q_EMIT said(notes.isEmpty() ? text : text + QStringLiteral(". ") + notes.join(u' '));
            });
    connect(m_exporter, &MeshExporter::failed, this, &ExportActions::failed);
    connect(m_exporter, &MeshExporter::cancelled, this,
            [this] { Q_EMIT said(tr("Cancelled. The file is unchanged.")); });
    connect(m_exporter, &MeshExporter::ended, this, &ExportActions::ended);
}

void ExportActions::fill(QMenu& menu) {
    m_export = addAction(
        menu, tr("&Export Deformed Mesh…"), tr("Ctrl+E"), this, [this] { choose(); },
        QStringLiteral("export"));
    connect(&m_session, &Session::sceneReplaced, this, &ExportActions::follow);
    connect(&m_session.targets(), &SessionTargets::added, this, &ExportActions::follow);
    connect(&m_session.targets(), &SessionTargets::removed, this, &ExportActions::follow);
    follow();
}

void ExportActions::follow() {
    enableIf(*m_export, !m_session.targets().empty(), tr("There is no target to export."));
}

void ExportActions::choose() {
    if (const Target* target = focusTarget(m_session)) {
        chooseOne(*target);
    }
}

/// The path that is being written to; empty: none.
QString ExportActions::chooseOne(const Target& target) {
    const QStringList filters{tr("Wavefront OBJ, true normals (*.obj)"),
                              tr("Wavefront OBJ, the paper's normals (*.obj)")};  // by NormalMode
    const NormalMode shown = m_viewport.options().normals;
    QString filter = filters[static_cast<int>(m_settings.exportNormals.value_or(shown))];
    const QString path = QFileDialog::getSaveFileName(
        &m_window, tr("Export deformed mesh “%1”").arg(target.name),
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
    return beginOf(target, full, normals) ? full : QString();
}

bool ExportActions::beginOf(const Target& target, const QString& path, NormalMode normals) {
    if (Status current = m_viewport.syncNow(); !current) {
        Q_EMIT failed(current.error());
        return false;
    }
    Q_EMIT began(target, path);
    m_exporter->start(copyForExport(target, normals), target.name, path);
    return true;
}

void ExportActions::begin(const QString& path, std::optional<NormalMode> normals) {
    if (const Target* target = focusTarget(m_session)) {
        beginOf(*target, path, normals.value_or(m_viewport.options().normals));
    }
}

Status ExportActions::write(const QString& path, std::optional<NormalMode> normals) {
    const Target* target = focusTarget(m_session);
    if (target == nullptr) {
        return Error{"There is nothing to export.", path.toStdString(), "Open a mesh first."};
    }
    if (Status current = m_viewport.syncNow(); !current) {
        return current;
    }
    Q_EMIT began(*target, path);
    const Result<QStringList> written =
        exportTarget(*target, path, normals.value_or(m_viewport.options().normals));
    Q_EMIT ended(path, written.ok());
    return written ? Status(Done{}) : Status(written.error());
}

}  // namespace hitscope
