// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "core/image.h"
#include "session/session.h"

class QActionGroup;
class QMenu;

namespace hitscope {

/// Menu to choose what targets are covered with: their own materials, or worn panels in one of the paper's
/// three sizes. Large pictures are made on another thread.
class TextureChooser : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this.
    explicit TextureChooser(Session& session, QObject* parent = nullptr);

    void fill(QMenu& menu);  ///< once
    /// Pixels each way, one of those in the menu; 0: the targets' own. Others are passed over.
    void choose(int size);
    void restore(int size);  ///< likewise, and nothing to undo: as it was when the program ended
    /// The session's picture is the one that is chosen; one that is still being made is not wanted any more.
    void follow();
    [[nodiscard]] int chosen() const { return m_chosen; }

private:
    /// What gives the targets their picture, or takes it.
    using Take = void (SessionSettings::*)(std::shared_ptr<const Image>);
    void choose(int size, Take take);

    Session& m_session;
    QActionGroup* m_actions = nullptr;
    int m_chosen = 0;   ///< pixels each way; 0: the targets' own
    int m_request = 0;  ///< number of the choice in force: pictures made for others come too late
};

}  // namespace hitscope
