// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

#include "core/result.h"
#include "session/sample_scenes.h"

class QAction;
class QMenu;
class QMimeData;
class QWidget;

namespace hitscope {

struct AppSettings;
class DiscardGuard;
class NoticeBar;
class SceneFiles;
class Session;
class TextureLocator;

/// What replaces the scene or adds to it: files, the scenes there are, and where a mesh stands. Asks before
/// hits are discarded.
class FileActions : public QObject {
    Q_OBJECT
public:
    /// What these commands work with; all of them outlive this. Dialogs belong to `window`.
    struct Parts {
        Session& session;
        AppSettings& settings;
        SceneFiles& files;
        DiscardGuard& guard;
        TextureLocator& textures;
        NoticeBar& notice;
        QWidget& window;
    };
    explicit FileActions(const Parts& parts);

    void fill(QMenu& menu);      ///< up to the scenes; once
    void fillMesh(QMenu& menu);  ///< placing; once
    [[nodiscard]] QAction* open() const { return m_open; }
    [[nodiscard]] QMenu* scenes() const { return m_scenes; }

    /// Files that can be opened among what is dropped.
    [[nodiscard]] static QStringList openable(const QMimeData& data);
    /// After a question where hits would be lost.
    void askAndOpen(const QStringList& paths);
    void chooseAddition();
    /// Reloads the scene's only mesh with its centre at the origin and its largest extent `extent` metres,
    /// or, for extent 0, in its file's own coordinates. Hits are lost.
    void place(double extent);

Q_SIGNALS:
    void said(const QString& text);
    void opened();  ///< the settings know of it
    /// Keys that people press by habit say what will be there.
    void notYet(const QString& text);

private:
    void choose();
    QStringList chooseMeshes(const QString& title);
    void choosePlacement();
    void loadSample(SampleScene scene);
    void fillScenes(QMenu& menu);
    void showRecent();
    void takeOpened(const QStringList& paths, const QStringList& notes);
    void sayOpened(const QStringList& notes);
    void follow();

    Parts m_parts;
    QMenu* m_recent = nullptr;
    QMenu* m_scenes = nullptr;
    QAction* m_open = nullptr;
    QAction* m_placeMesh = nullptr;
    QAction* m_fileCoordinates = nullptr;
};

}  // namespace hitscope
