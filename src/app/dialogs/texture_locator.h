// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <map>
#include <vector>

#include "core/ids.h"
#include "core/result.h"
#include "session/once_a_turn.h"

class QAction;
class QMenu;
class QWidget;

namespace hitscope {

class Session;

/// Finds the pictures that a mesh's file names and that were not there: asks for one, takes the others that
/// lie beside it under their own names, and remembers them while the program runs.
class TextureLocator : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this.
    TextureLocator(Session& session, QWidget* parent);

    void fill(QMenu& menu);
    [[nodiscard]] bool isAnyMissing() const;
    /// Asks for the first that is missing.
    void locate();
    /// Uses the picture at `path` for the missing one of its name, or the first, and its neighbours for the
    /// others. One step to undo for each. Fails when it is no picture.
    [[nodiscard]] Status use(const QString& path);
    /// Uses those located earlier, for a file that was opened again. Returns their names in the file.
    QStringList useRemembered();

Q_SIGNALS:
    void said(const QString& text);
    void failed(const hitscope::Error& error);

private:
    struct Missing {
        std::vector<TargetId> targets;  ///< that have the same mesh
        QString file;                   ///< the mesh's
        std::string name;               ///< as the file has it
    };
    [[nodiscard]] std::vector<Missing> missing() const;
    [[nodiscard]] Status use(const Missing& what, const QString& path);
    void follow();

    Session& m_session;
    QWidget* m_parent;
    QAction* m_action = nullptr;
    QString m_folder;
    std::map<std::pair<QString, std::string>, QString> m_located;  ///< by mesh file and name
    OnceATurn m_following{[this] { follow(); }};
};

}  // namespace hitscope
