// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_view.h"

#include <algorithm>

#include "app/actions/camera_actions.h"
#include "app/actions/change_actions.h"
#include "app/actions/display_actions.h"
#include "app/window/window_actions.h"
#include "view/camera_text.h"
#include "viewport/viewport.h"

namespace hitscope {

CapturedView WindowView::capture() const {
    CapturedView view;
    view.cameras.current = m_actions.cameras->currentCamera().toStdString();
    for (const QString& bookmark : m_actions.cameras->bookmarks()) {
        view.cameras.kept.push_back(bookmark.toStdString());
    }
    view.display = m_viewport.options();
    return view;
}

void WindowView::restore(const SessionDocument& document) {
    DisplayOptions display = document.display;
    display.theme = m_viewport.options().theme;
    display.transparent = m_viewport.options().transparent;
    display.refine = m_viewport.options().refine;
    display.reduceInMotion = m_viewport.options().reduceInMotion;
    m_viewport.setOptions(display);
    m_actions.display->follow();
    m_actions.change->follow();
    CameraActions::Bookmarks bookmarks;
    const std::size_t kept = std::min(bookmarks.size(), document.cameras.kept.size());
    for (std::size_t i = 0; i < kept; ++i) {
        bookmarks[i] = QString::fromStdString(document.cameras.kept[i]);
    }
    m_actions.cameras->setBookmarks(bookmarks);
    if (const Result<Camera> camera = parseCamera(document.cameras.current, m_viewport.camera())) {
        m_viewport.navigation().setCamera(camera.value(), Navigation::Arrival::AtOnce);
    }
}

SessionFiles::View WindowView::functions() {
    return {[this] { return capture(); }, [this](const SessionDocument& document) { restore(document); }};
}

}  // namespace hitscope
