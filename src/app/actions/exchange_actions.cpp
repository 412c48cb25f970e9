// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/exchange_actions.h"

#include <QAction>
#include <QClipboard>
#include <QDropEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QImageReader>
#include <QMenu>
#include <QMimeData>
#include <QUrl>
#include <QWidget>
#include <memory>

#include "app/actions/camera_actions.h"
#include "app/actions/file_actions.h"
#include "app/actions/hit_actions.h"
#include "app/actions/menu_building.h"
#include "app/actions/outgoing_files.h"
#include "app/actions/pasted_text.h"
#include "app/actions/shot_actions.h"
#include "app/dialogs/texture_locator.h"
#include "document/document_json.h"
#include "document/session_document.h"
#include "scene/picture.h"
#include "viewport/viewport.h"

namespace hitscope {

ExchangeActions::ExchangeActions(const Parts& parts, QWidget& window)
    : QObject(&window),
      m_parts(parts),
      m_window(window),
      m_outgoing(new OutgoingFiles({parts.viewport, parts.exports, parts.capture}, this)) {
    connect(m_outgoing, &OutgoingFiles::said, this, &ExchangeActions::said);
    connect(m_outgoing, &OutgoingFiles::failed, this, &ExchangeActions::failed);
    window.setAcceptDrops(true);
    window.installEventFilter(this);
}

/// What is dragged out of the window does not come in again.
bool ExchangeActions::eventFilter(QObject* watched, QEvent* event) {
    const bool isDrop = event->type() == QEvent::Drop;
    if (watched != &m_window || (!isDrop && event->type() != QEvent::DragEnter)) {
        return QObject::eventFilter(watched, event);
    }
    auto& drop = *static_cast<QDropEvent*>(event);  // what enters is one too
    if (drop.source() != nullptr || !canTake(*drop.mimeData())) {
        drop.ignore();
    } else {
        drop.acceptProposedAction();
        if (isDrop) {
            takeDrop(drop);
        }
    }
    return true;
}

/// Later: the program that was dragged from waits for the drop's end.
void ExchangeActions::takeDrop(QDropEvent& event) {
    m_window.activateWindow();
    auto dropped = std::make_shared<QMimeData>();
    dropped->setUrls(event.mimeData()->urls());
    QMetaObject::invokeMethod(
        this, [this, dropped] { take(*dropped); }, Qt::QueuedConnection);
}

void ExchangeActions::fill(QMenu& menu) {
    addAction(menu, tr("Copy P&icture"), tr("Ctrl+F12"), this, [this] { copyPicture(); });
    m_outgoing->fill(menu);
    addAction(menu, tr("&Paste"), QKeySequence::Paste, this, [this] { paste(); })
        ->setToolTip(
            tr("Files of meshes, sessions, hits, shots and pictures; sessions, meshes, hits and cameras "
               "as text; a picture as a missing texture"));
}

/// Files of hits and shots.
QStringList ExchangeActions::tables(const QMimeData& data) {
    QStringList paths;
    for (const QUrl& url : data.urls()) {
        const QString suffix = QFileInfo(url.toLocalFile()).suffix().toLower();
        if (url.isLocalFile() && (suffix == QLatin1String("csv") || suffix == QLatin1String("json"))) {
            paths.append(url.toLocalFile());
        }
    }
    return paths;
}

QStringList ExchangeActions::pictures(const QMimeData& data) {
    static const QStringList suffixes{QStringLiteral("png"),  QStringLiteral("jpg"), QStringLiteral("jpeg"),
                                      QStringLiteral("bmp"),  QStringLiteral("tga"), QStringLiteral("tif"),
                                      QStringLiteral("tiff"), QStringLiteral("gif"), QStringLiteral("webp")};
    QStringList paths;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile() && suffixes.contains(QFileInfo(url.toLocalFile()).suffix().toLower())) {
            paths.append(url.toLocalFile());
        }
    }
    return paths;
}

bool ExchangeActions::canTake(const QMimeData& data) {
    return !FileActions::openable(data).isEmpty() || !tables(data).isEmpty() || !pictures(data).isEmpty();
}

void ExchangeActions::take(const QMimeData& data) {
    const QStringList files = FileActions::openable(data);
    if (!files.isEmpty()) {
        m_parts.files.askAndOpen(files);
        return;
    }
    for (const QString& path : tables(data)) {
        // Shots and hits both come as JSON; what is no script says best itself what is wrong with it as hits.
        m_parts.shots.run(path, [this, path] { m_parts.hits.importFrom(path); });
    }
    for (const QString& path : pictures(data)) {
        takePicture(path);
    }
}

void ExchangeActions::takePicture(const QString& path) {
    const QString name = QFileInfo(path).fileName();
    if (const QString camera = QImageReader(path).text(QLatin1String(kCameraNote)); !camera.isEmpty()) {
        if (const Status taken = m_parts.cameras.paste(camera); !taken) {
            Q_EMIT failed({"The camera in this picture is none: " + taken.error().what, path.toStdString(),
                           "Save the picture again."});
        } else {
            Q_EMIT said(tr("Looking through the camera of %1.").arg(name));
        }
    } else if (!m_parts.textures.isAnyMissing()) {
        Q_EMIT failed({"This picture has no camera in it, and no texture is missing.", path.toStdString(),
                       "Drop a picture that Hitscope saved to look through its camera, or one that a mesh's "
                       "file names and that was not there."});
    } else if (const Status used = m_parts.textures.use(path); !used) {
        Q_EMIT failed(used.error());
    }
}

void ExchangeActions::paste() {
    const QMimeData* const data = QGuiApplication::clipboard()->mimeData();
    if (data != nullptr && canTake(*data)) {
        take(*data);
    } else if (data != nullptr && data->hasText()) {
        pasteText(data->text());
    } else if (data != nullptr && data->hasImage()) {
        pastePicture(data->imageData().value<QImage>());
    } else {
        Q_EMIT failed({"There is nothing on the clipboard that Hitscope can take.",
                       {},
                       "Copy files, or the text of a session, a mesh, hits or a camera."});
    }
}

void ExchangeActions::pasteText(const QString& text) {
    const QByteArray bytes = text.toUtf8();
    if (m_parts.cameras.paste(text)) {
        Q_EMIT said(tr("Looking through the camera on the clipboard."));
    } else if (isSessionText(bytes)) {
        pasteSession(bytes);
    } else if (const QString suffix = meshSuffixOf(bytes); !suffix.isEmpty()) {
        pasteMesh(bytes, suffix);
    } else if (const Status imported = m_parts.hits.importText(bytes); !imported) {
        const Error& error = imported.error();
        Q_EMIT failed({"The text on the clipboard is no camera, session or mesh, and no hits: " + error.what,
                       error.where, "Copy hits as CSV or JSON, or the text of one of the others."});
    }
}

void ExchangeActions::pasteSession(const QByteArray& text) {
    Result<SessionDocument> document = readDocument(text);
    if (document) {
        m_parts.files.askAndOpenDocument(std::move(document.value()));
    } else {
        const Error& error = document.error();
        Q_EMIT failed(
            {"The session on the clipboard cannot be read: " + error.what, error.where, error.advice});
    }
}

void ExchangeActions::pasteMesh(const QByteArray& text, const QString& suffix) {
    const Result<QString> path = keepPasted(text, suffix);
    if (path) {
        m_parts.files.askAndOpen(QStringList{path.value()});
    } else {
        Q_EMIT failed(path.error());
    }
}

void ExchangeActions::pastePicture(const QImage& picture) {
    if (!m_parts.textures.isAnyMissing()) {
        Q_EMIT failed(
            {"There is a picture on the clipboard, but no texture is missing.",
             {},
             "A picture takes the place of a texture that a mesh's file names and that was not there."});
        return;
    }
    const Result<QString> path = keepPasted(picture);
    const Status used = path ? m_parts.textures.use(path.value()) : Status(path.error());
    if (!used) {
        Q_EMIT failed(used.error());
    }
}

void ExchangeActions::copyPicture() {
    const Result<Image> drawn = m_parts.viewport.drawShown();
    if (!drawn) {
        Q_EMIT failed(drawn.error());
        return;
    }
    const Image& image = drawn.value();
    QGuiApplication::clipboard()->setImage(
        QImage(image.pixels.data(), image.width, image.height, 4 * image.width, QImage::Format_RGBA8888)
            .copy());
    Q_EMIT said(tr("Picture copied to the clipboard, %1 × %2 pixels.").arg(image.width).arg(image.height));
}

}  // namespace hitscope
