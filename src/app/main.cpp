// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QSurfaceFormat>

#include "app/main_window.h"
#include "app/theme.h"
#include "session/session.h"

int main(int argc, char** argv) {
    // Before the application: Qt makes its shared context with the default format.
    hitscope::MainWindow::setSurfaceFormat();
    QApplication::setOrganizationName(QStringLiteral("Hitscope"));
    QApplication::setApplicationName(QStringLiteral("hitscope"));
    QApplication::setApplicationDisplayName(QStringLiteral("Hitscope"));
    QApplication::setApplicationVersion(QStringLiteral(HITSCOPE_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("hitscope"));
    QApplication application(argc, argv);
    QApplication::setStyle(hitscope::makeStyle());
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/hitscope.svg")));

    QCommandLineParser parser;
    parser.setApplicationDescription(
        QApplication::translate("main", "Shoot a mesh, see exactly what moved, save the result."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(
        QStringLiteral("mesh"),
        QApplication::translate("main", "Mesh file to open: OBJ, PLY, STL, glTF, GLB, OFF, FBX, 3DS or DAE."),
        QStringLiteral("[mesh]"));
    parser.process(application);

    hitscope::Session session;
    session.loadPaperRow(hitscope::kDefaultPaperRow);
    hitscope::MainWindow window(session);
    window.show();
    window.openFiles(parser.positionalArguments());
    return QApplication::exec();
}
