// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

#include "app/file_watch.h"
#include "app/scene_files.h"
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
class Session;
struct SessionDocument;
class SessionFiles;
class TextureLocator;

/// What opens and saves: sessions, meshes, the scenes there are, and where a mesh stands. Asks before work is
/// lost.
class FileActions : public QObject {
    Q_OBJECT
public:
    /// What these commands work with; all of them outlive this. Dialogs belong to `window`.
    struct Parts {
        Session& session;
        AppSettings& settings;
        SceneFiles& files;
        SessionFiles& sessions;
        DiscardGuard& guard;
        TextureLocator& textures;
        NoticeBar& notice;
        QWidget& window;
    };
    explicit FileActions(const Parts& parts);

    void fill(QMenu& menu);      ///< up to the scenes; once
    void fillMesh(QMenu& menu);  ///< placing; once
    [[nodiscard]] QAction* open() const { return m_open; }
    [[nodiscard]] QAction* saveSession() const { return m_save; }
    [[nodiscard]] QMenu* scenes() const { return m_scenes; }

    /// Files that can be opened among what is dropped.
    [[nodiscard]] static QStringList openable(const QMimeData& data);
    /// A session, or meshes as one scene.
    void open(const QStringList& paths);
    /// Likewise after a question where work would be lost.
    void askAndOpen(const QStringList& paths);
    void askAndOpenDocument(SessionDocument document);  ///< likewise one that is in no file
    /// To the session's file, or to one that is asked for. False: the person decided otherwise.
    bool save();
    bool saveAs();  ///< likewise
    void chooseAddition();
    /// Reloads the scene's only mesh with its centre at the origin and its largest extent `extent` metres,
    /// or, for extent 0, in its file's own coordinates. Hits are lost.
    void place(double extent);

Q_SIGNALS:
    void said(const QString& text);
    void opened();      ///< the settings know of it
    void startedNew();  ///< a new session

private:
    [[nodiscard]] static QString sessionsFilter();
    bool askAndReplace();
    void choose();
    void giveUpOpening();
    void startNew();
    void askAndRevert();
    void offerElsewhere(const Error& error);
    QStringList chooseMeshes(const QString& title, const QString& first);
    void remember(const QString& path);
    void takeSession(const QString& path, const QStringList& notes);
    void sayNotes(const QStringList& lines);  ///< with a way to locate textures that are missing
    void choosePlacement();
    void loadSample(SampleScene scene);
    void fillScenes(QMenu& menu);
    void showRecent();
    void takeOpened(const QStringList& paths, const QStringList& notes, SceneFiles::Into into);
    void sayOpened(const QStringList& notes);
    [[nodiscard]] QString sizeQuestion() const;  ///< empty: the mesh's size asks for nothing
    void withdrawScaling();                      ///< where the size asks for something else by now
    void follow();
    void followFile();

    void watchFile();
    void tellChanged();

    Parts m_parts;
    FileWatch m_watch{this};  ///< of the session's file
    QMenu* m_recent = nullptr;
    QMenu* m_scenes = nullptr;
    QAction* m_open = nullptr;
    QAction* m_save = nullptr;
    QAction* m_revert = nullptr;
    QAction* m_placeMesh = nullptr;
    QAction* m_fileCoordinates = nullptr;
    int m_sizeNotice = 0;  ///< the notice that offers to scale the mesh; 0: none did
    QString m_sizeQuestion;
    QStringList m_sizeNotes;  ///< what it says beside that
};

}  // namespace hitscope
