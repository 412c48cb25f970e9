// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/exchange_actions.h"

#include <QAction>
#include <QClipboard>
#include <QDropEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImage>
#include <QMenu>
#include <QMimeData>
#include <QUrl>
#include <QWidget>
#include <memory>

#include "app/actions/camera_actions.h"
#include "app/actions/copy_as_file.h"
#include "app/actions/file_actions.h"
#include "app/actions/hit_actions.h"
#include "app/actions/menu_building.h"
#include "app/actions/shot_actions.h"
#include "document/session_document.h"
#include "session/shots/shot_script_file.h"
#include "viewport/viewport.h"

namespace hitscope {

ExchangeActions::ExchangeActions(const Parts& parts, QWidget& window)
    : QObject(&window), m_parts(parts), m_window(window) {
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
    addAction(menu, tr("Copy Pictu&re"), tr("Ctrl+F12"), this, [this] { copyPicture(); });
    auto* files = new CopyAsFile({m_parts.viewport, m_parts.exports, m_parts.capture}, this);
    connect(files, &CopyAsFile::said, this, &ExchangeActions::said);
    connect(files, &CopyAsFile::failed, this, &ExchangeActions::failed);
    files->fill(menu);
    addAction(menu, tr("&Paste"), QKeySequence::Paste, this, [this] {
        paste();
    })->setToolTip(tr("Files of meshes, sessions, hits and shots; hits and cameras as text"));
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

bool ExchangeActions::canTake(const QMimeData& data) {
    return !FileActions::openable(data).isEmpty() || !tables(data).isEmpty();
}

void ExchangeActions::take(const QMimeData& data) {
    const QStringList files = FileActions::openable(data);
    if (!files.isEmpty()) {
        m_parts.files.askAndOpen(files);
        return;
    }
    for (const QString& path : tables(data)) {
        // Shots and hits both come as JSON; what is no script says best itself what is wrong with it as hits.
        if (readShotScript(path)) {
            m_parts.shots.run(path);
        } else {
            m_parts.hits.importFrom(path);
        }
    }
}

void ExchangeActions::paste() {
    const QMimeData* const data = QGuiApplication::clipboard()->mimeData();
    if (data != nullptr && canTake(*data)) {
        take(*data);
    } else if (data != nullptr && data->hasText()) {
        pasteText(data->text());
    } else {
        Q_EMIT failed({"There is nothing on the clipboard that Hitscope can take.",
                       {},
                       "Copy files, hits as CSV or JSON, or a camera."});
    }
}

void ExchangeActions::pasteText(const QString& text) {
    if (m_parts.cameras.paste(text)) {
        Q_EMIT said(tr("Looking through the camera on the clipboard."));
    } else if (const Status imported = m_parts.hits.importText(text.toUtf8()); !imported) {
        const Error& error = imported.error();
        Q_EMIT failed({"The text on the clipboard is no camera, and no hits: " + error.what, error.where,
                       "Copy hits as CSV or JSON, or a camera."});
    }
}

void ExchangeActions::copyPicture() {
    const Result<Image> drawn = m_parts.viewport.drawPicture(m_parts.viewport.pictureRequest());
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
