// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <memory>

#include "core/result.h"

class QAction;
class QMainWindow;
class QMenu;

namespace hitscope {

class Session;
class TaskProgress;
class TextWindow;
class Viewport;

/// The Help menu: all keys, what is said of this machine (the graphics driver, and the paper's tables
/// measured on it), and of the program.
class HelpActions : public QObject {
    Q_OBJECT
public:
    /// All outlive this; what it shows belongs to `window`.
    HelpActions(Session& session, Viewport& viewport, QMainWindow& window);
    ~HelpActions() override;

    void fill(QMenu& menu);

    /// As `hitscope-cli info --renderer` prints it.
    void showGraphics();
    /// Runs `hitscope-cli bench paper` with these arguments beside what else the window does; its tables open
    /// in a window when they are there. Nothing while it runs already.
    void measurePaper(const QStringList& arguments = {});

Q_SIGNALS:
    void failed(const hitscope::Error& error);

private:
    void showKeys();
    void showAboutProgram();
    TextWindow* showText(const QString& name, const QString& title, const QString& text);
    void takeProgress();
    void takeTables(int status, QProcess::ExitStatus how);
    void end();
    void follow();

    Session& m_session;
    Viewport& m_viewport;
    QMainWindow& m_window;
    QAction* m_measure = nullptr;
    std::unique_ptr<QProcess> m_process;
    std::unique_ptr<TaskProgress> m_task;
    QByteArray m_said;   ///< on the standard error, but for lines of progress
    QByteArray m_begun;  ///< a line that is not there in full
    bool m_cancelled = false;
};

/// Where hitscope-cli is: HITSCOPE_CLI in the environment, beside the running program or in ../bin; empty
/// when it is in none of them.
[[nodiscard]] QString commandLineProgram();

}  // namespace hitscope
