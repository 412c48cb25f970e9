// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session_files.h"

namespace hitscope {

class Viewport;
struct WindowActions;

/// How the window looks at its session, as session files and journals keep it: cameras and display.
class WindowView {
public:
    /// Both outlive this.
    WindowView(Viewport& viewport, const WindowActions& actions) : m_viewport(viewport), m_actions(actions) {}

    [[nodiscard]] CapturedView capture() const;
    /// The theme, what is transparent and how well pictures are drawn stay the window's.
    void restore(const SessionDocument& document);
    /// These two as functions, for as long as this is there.
    [[nodiscard]] SessionFiles::View functions();

private:
    Viewport& m_viewport;
    const WindowActions& m_actions;
};

}  // namespace hitscope
