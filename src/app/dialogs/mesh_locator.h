// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace hitscope {

class SessionFiles;

/// Asks about meshes of a session that are missing, or are not what they were: where they are, whether to go
/// on. One question at a time; a file that is found leads to those beside it.
class MeshLocator : public QObject {
    Q_OBJECT
public:
    /// `files` outlives this; the questions belong to `window`.
    MeshLocator(SessionFiles& files, QWidget& window);

private:
    void ask();
    void locate(const QString& missing);

    SessionFiles& m_files;
    QWidget& m_window;
};

}  // namespace hitscope
