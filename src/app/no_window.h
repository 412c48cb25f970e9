// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace hitscope {

/// Says on the standard error why `program` ends; returns the status to end with.
[[nodiscard]] int saysNo(const char* program, const QString& why);

/// While this lives, a QApplication that cannot connect to the display ends the program with that status and
/// a line that says so. By itself Qt ends it by a signal, after a page of advice. One object at a time.
class DisplayRefusal {
public:
    /// `advice`: a sentence, what to do about it. `program` outlives this.
    DisplayRefusal(const char* program, const QString& advice);
    ~DisplayRefusal();
    DisplayRefusal(const DisplayRefusal&) = delete;
    DisplayRefusal& operator=(const DisplayRefusal&) = delete;
};

/// Why Qt's platform is of no use, and what to do; empty: it has windows that OpenGL draws into. A
/// QOpenGLWidget crashes where there are none. Needs a QGuiApplication.
[[nodiscard]] QString whyNoWindows();

}  // namespace hitscope
