// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/texture_chooser.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <algorithm>
#include <memory>

#include "analysis/beside.h"
#include "mesh/panel_texture.h"

namespace hitscope {

TextureChooser::TextureChooser(Session& session, QObject* parent)
    : QObject(parent), m_session(session), m_actions(new QActionGroup(this)) {
    connect(&session.settings(), &SessionSettings::coverTextureChanged, this, &TextureChooser::follow);
}

void TextureChooser::fill(QMenu& menu) {
    menu.setToolTipsVisible(true);
    for (const int size : {0, 1024, 2048, 4096}) {
        QAction* action =
            menu.addAction(size == 0 ? tr("Each Target's &Own") : tr("Worn Panels, &%1K").arg(size / 1024));
        action->setCheckable(true);
        action->setChecked(size == m_chosen);
        action->setData(size);
        if (size > 0) {
            action->setToolTip(tr("%1 × %1 pixels, on all targets that have texture coordinates").arg(size));
        }
        m_actions->addAction(action);
        connect(action, &QAction::triggered, this, [this, size] { choose(size); });
    }
}

void TextureChooser::choose(int size) {
    choose(size, &SessionSettings::setCoverTexture);
}

void TextureChooser::restore(int size) {
    choose(size, &SessionSettings::restoreCoverTexture);
}

/// What was chosen last wins, whichever picture is ready first.
void TextureChooser::choose(int size, Take take) {
    const QList<QAction*> offered = m_actions->actions();
    const auto wanted = std::find_if(offered.begin(), offered.end(), [size](const QAction* action) {
        return action->data().toInt() == size;
    });
    if (wanted == offered.end()) {
        return;
    }
    (*wanted)->setChecked(true);
    m_chosen = size;
    const int request = ++m_request;
    if (size == 0) {
        (m_session.settings().*take)(nullptr);
        return;
    }
    auto image = std::make_shared<Image>();
    workBeside(
        this, [image, size] { *image = makePanelTexture(size); },
        [image, request, take](TextureChooser& self, bool done) {
            if (done && request == self.m_request) {  // else the targets stay as they are
                (self.m_session.settings().*take)(image);
            }
        });
}

/// Undone, say, or another session.
void TextureChooser::follow() {
    ++m_request;
    const std::shared_ptr<const Image>& cover = m_session.settings().coverTexture();
    m_chosen = cover ? cover->width : 0;
    for (QAction* action : m_actions->actions()) {
        action->setChecked(action->data().toInt() == m_chosen);
    }
}

}  // namespace hitscope
