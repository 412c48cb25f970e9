// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;

namespace hitscope {

class MeshReloader;

/// A bar that says which files of the session's meshes have changed on the disk, and offers to read them
/// again. Hidden where there are none.
class ReloadBar : public QFrame {
    Q_OBJECT
public:
    /// `reloader` outlives this.
    explicit ReloadBar(MeshReloader& reloader, QWidget* parent = nullptr);

private:
    void follow();

    MeshReloader& m_reloader;
    QLabel* m_text = nullptr;
};

}  // namespace hitscope
