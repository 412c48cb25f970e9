// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/copy_as_file.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>
#include <QPointer>
#include <memory>
#include <utility>

#include "app/actions/export_actions.h"
#include "app/actions/menu_building.h"
#include "document/session_file.h"
#include "io/save_image.h"
#include "models/focus_target.h"
#include "panels/help/help_text.h"
#include "session/session.h"
#include "viewport/viewport.h"

namespace hitscope {

CopyAsFile::CopyAsFile(Parts parts, QObject* parent) : QObject(parent), m_parts(std::move(parts)) {}

void CopyAsFile::fill(QMenu& menu) {
    QMenu& files = *menu.addMenu(tr("Copy as &File"));
    files.setToolTipsVisible(true);
    addAction(files, tr("&Picture"), {}, this, [this] {
        copyPicture();
    })->setToolTip(tr("A PNG file of what the viewport shows"));
    addAction(files, tr("&Session"), {}, this, [this] {
        copySession();
    })->setToolTip(tr("A session file, which names its meshes by their full paths"));
    QAction* mesh =
        addAction(files, tr("Deformed &Mesh"), {}, this, [this] { copyTarget(QStringLiteral(".obj")); });
    QAction* changes =
        addAction(files, tr("&Vertex Changes"), {}, this, [this] { copyTarget(QStringLiteral(".csv")); });
    connect(&files, &QMenu::aboutToShow, this, [this, mesh, changes] {
        const bool isAny = focusTarget(m_parts.viewport.session()) != nullptr;
        const QString why = tr("There is no target.");
        mesh->setToolTip(tr("An OBJ file of the selected target, as it is when it is pasted"));
        changes->setToolTip(
            tr("A CSV file of the selected target's vertices, as they are when it is pasted"));
        enableIf(*mesh, isAny, why);
        enableIf(*changes, isAny, why);
    });
}

void CopyAsFile::copy(const QString& name, const DraggedFile::Write& write) {
    QGuiApplication::clipboard()->setMimeData(new DraggedFile(name, write));
    Q_EMIT said(tr("%1 copied as a file.").arg(name));
}

QString CopyAsFile::sessionName() const {
    QString name = m_parts.viewport.session().sceneName();
    name.replace(u'/', u'_');
    return name.isEmpty() ? QStringLiteral("session") : name;
}

void CopyAsFile::copyPicture() {
    Result<Image> drawn = m_parts.viewport.drawPicture(m_parts.viewport.pictureRequest());
    if (!drawn) {
        Q_EMIT failed(drawn.error());
        return;
    }
    const auto image = std::make_shared<Image>(std::move(drawn).value());
    copy(sessionName() + QStringLiteral(".png"),
         [image](const QString& path) { return savePicture(*image, path).ok(); });
}

void CopyAsFile::copySession() {
    const auto document = std::make_shared<SessionDocument>(m_parts.capture());
    copy(sessionName() + QLatin1String(kSessionSuffix),
         [document](const QString& path) { return writeSessionFile(*document, path).ok(); });
}

void CopyAsFile::copyTarget(const QString& ending) {
    const Target* const target = focusTarget(m_parts.viewport.session());
    if (target == nullptr) {
        return;
    }
    QString name = target->name;
    name.replace(u'/', u'_');
    copy(name + QStringLiteral("_deformed") + ending,
         [exports = QPointer<ExportActions>(&m_parts.exports), id = target->id](const QString& path) {
             return !exports.isNull() && exports->writeTarget(id, path);
         });
}

}  // namespace hitscope
