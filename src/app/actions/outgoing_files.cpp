// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/outgoing_files.h"

#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QLocale>
#include <QMenu>
#include <QPointer>
#include <QTemporaryDir>
#include <future>
#include <memory>
#include <utility>

#include "app/actions/export_actions.h"
#include "app/actions/menu_building.h"
#include "document/document_json.h"
#include "document/session_file.h"
#include "io/save_image.h"
#include "io/staged_files.h"
#include "models/focus_target.h"
#include "panels/help/help_text.h"
#include "session/session.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr qint64 kLongestText = 64 << 20;  // bytes; other programs take the whole clipboard into memory

}  // namespace

OutgoingFiles::OutgoingFiles(Parts parts, QObject* parent) : QObject(parent), m_parts(std::move(parts)) {}

void OutgoingFiles::fill(QMenu& menu) {
    fillFiles(*menu.addMenu(tr("Copy as &File")));
    fillTexts(*menu.addMenu(tr("Copy as &Text")));
}

void OutgoingFiles::fillFiles(QMenu& menu) {
    menu.setToolTipsVisible(true);
    addAction(menu, tr("&Picture"), {}, this, [this] {
        copy(picture());
    })->setToolTip(tr("A PNG file of what the viewport shows"));
    addAction(menu, tr("&Session"), {}, this, [this] {
        copy(session());
    })->setToolTip(tr("A session file, which names its meshes by their full paths"));
    addOfTarget(menu, tr("Deformed &Mesh"),
                tr("An OBJ file of the selected target, as it is when it is pasted"),
                [this] { copy(mesh()); });
    addOfTarget(menu, tr("&Vertex Changes"),
                tr("A CSV file of the selected target's vertices, as they are when it is pasted"),
                [this] { copy(changes()); });
}

void OutgoingFiles::fillTexts(QMenu& menu) {
    menu.setToolTipsVisible(true);
    addAction(menu, tr("&Session"), {}, this, [this] {
        copySessionText();
    })->setToolTip(tr("What a session file says; Paste opens it"));
    addOfTarget(menu, tr("Deformed &Mesh"), tr("The selected target as OBJ; Paste opens it"),
                [this] { copyTargetText(QStringLiteral(".obj")); });
    addOfTarget(menu, tr("&Vertex Changes"), tr("The selected target's vertices as CSV"),
                [this] { copyTargetText(QStringLiteral(".csv")); });
}

/// An entry that needs a target.
void OutgoingFiles::addOfTarget(QMenu& menu, const QString& text, const QString& tip,
                                const std::function<void()>& act) {
    QAction* action = addAction(menu, text, {}, this, act);
    connect(&menu, &QMenu::aboutToShow, action, [this, action, tip] {
        action->setToolTip(tip);
        enableIf(*action, focusTarget(m_parts.viewport.session()) != nullptr, tr("There is no target."));
    });
}

void OutgoingFiles::copy(DraggedFile* file) {
    if (file != nullptr) {
        const QString name = file->name();
        QGuiApplication::clipboard()->setMimeData(file);
        Q_EMIT said(tr("%1 copied as a file.").arg(name));
    }
}

QString OutgoingFiles::sessionName() const {
    QString name = m_parts.viewport.session().sceneName();
    name.replace(u'/', u'_');
    return name.isEmpty() ? QStringLiteral("session") : name;
}

DraggedFile* OutgoingFiles::picture() {
    Result<Image> drawn = m_parts.viewport.drawShown();
    if (!drawn) {
        Q_EMIT failed(drawn.error());
        return nullptr;
    }
    // While it is dragged, or another program is brought to the front: longer than an event may wait.
    const std::shared_future<QByteArray> encoded =
        std::async(std::launch::async, encodePng, std::move(drawn).value()).share();
    return new DraggedFile(sessionName() + QStringLiteral(".png"), [encoded](const QString& path) {
        const QByteArray& bytes = encoded.get();
        return writeWhole(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())}).ok();
    });
}

DraggedFile* OutgoingFiles::session() {
    const auto document = std::make_shared<SessionDocument>(m_parts.capture());
    return new DraggedFile(sessionName() + QLatin1String(kSessionSuffix), [document](const QString& path) {
        return writeSessionFile(*document, path).ok();
    });
}

DraggedFile* OutgoingFiles::target(const QString& ending) {
    const Target* const target = focusTarget(m_parts.viewport.session());
    if (target == nullptr) {
        return nullptr;
    }
    QString name = target->name;
    name.replace(u'/', u'_');
    return new DraggedFile(
        name + QStringLiteral("_deformed") + ending,
        [exports = QPointer<ExportActions>(&m_parts.exports), id = target->id](const QString& path) {
            return !exports.isNull() && exports->writeTarget(id, path);
        });
}

void OutgoingFiles::copySessionText() {
    takeText(writeDocument(m_parts.capture()), tr("The session"));
}

void OutgoingFiles::copyTargetText(const QString& ending) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("mesh") + ending);
    const Target* const target = focusTarget(m_parts.viewport.session());
    if (target == nullptr) {
        return;
    }
    const QString name = tr("“%1”").arg(target->name);
    if (QFile file(path); m_parts.exports.writeTarget(target->id, path) && file.open(QIODevice::ReadOnly)) {
        takeText(file.read(kLongestText + 1), name);
    }
}

void OutgoingFiles::takeText(const QByteArray& text, const QString& what) {
    if (text.size() > kLongestText) {
        Q_EMIT failed({"This is more text than the clipboard is for.",
                       {},
                       "Up to " + QLocale().formattedDataSize(kLongestText).toStdString() +
                           " can be copied. Export it to a file, or copy it as one."});
        return;
    }
    QGuiApplication::clipboard()->setText(QString::fromUtf8(text));
    Q_EMIT said(tr("%1 copied as text, %2.").arg(what, QLocale().formattedDataSize(text.size())));
}

}  // namespace hitscope
