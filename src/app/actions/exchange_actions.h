// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>
#include <functional>

#include "core/result.h"

class QDropEvent;
class QImage;
class QMenu;
class QMimeData;
class QWidget;

namespace hitscope {

class CameraActions;
class ExportActions;
class FileActions;
class HitActions;
class OutgoingFiles;
class ShotActions;
class TextureLocator;
class Viewport;
struct SessionDocument;

/// What goes between the window and other programs: dropped files, and the clipboard. Meshes and sessions are
/// opened, files and text of hits imported, shot scripts run, text of a camera looked through. A picture that
/// Hitscope saved brings its camera, another one takes the place of a missing texture. Out go pictures, files
/// and text (OutgoingFiles), and what the tables copy themselves.
class ExchangeActions : public QObject {
    Q_OBJECT
public:
    struct Parts {
        Viewport& viewport;
        FileActions& files;
        HitActions& hits;
        ShotActions& shots;
        CameraActions& cameras;
        ExportActions& exports;
        TextureLocator& textures;
        std::function<SessionDocument()> capture;  ///< the session as it is now
    };
    /// All of them outlive this. Takes what is dropped on `window`.
    ExchangeActions(const Parts& parts, QWidget& window);

    void fill(QMenu& menu);  ///< once
    [[nodiscard]] OutgoingFiles& outgoing() { return *m_outgoing; }

    /// Whether files can be dropped: what take() does something with.
    [[nodiscard]] static bool canTake(const QMimeData& data);
    /// Opens, imports or runs what the files are, as if from the menus.
    void take(const QMimeData& data);
    void paste();
    void copyPicture();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    void said(const QString& text);
    void failed(const hitscope::Error& error);

private:
    [[nodiscard]] static QStringList tables(const QMimeData& data);
    [[nodiscard]] static QStringList pictures(const QMimeData& data);
    void takeDrop(QDropEvent& event);
    void takePicture(const QString& path);
    void pastePicture(const QImage& picture);
    void pasteText(const QString& text);
    void pasteSession(const QByteArray& text);
    void pasteMesh(const QByteArray& text, const QString& suffix);

    Parts m_parts;
    QWidget& m_window;
    OutgoingFiles* m_outgoing;
};

}  // namespace hitscope
