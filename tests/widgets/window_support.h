// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "app/main_window.h"
#include "io/export_obj.h"
#include "session/session.h"
#include "viewport/viewport.h"

namespace hitscope {

constexpr int kPatience = 30'000;  // milliseconds; software GL on a busy machine

/// Settings of the tests' own, thrown away afterwards.
class TestSettings {
public:
    TestSettings() {
        QCoreApplication::setOrganizationName(QStringLiteral("Hitscope"));
        QCoreApplication::setApplicationName(QStringLiteral("hitscope-test"));
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
    }

private:
    QTemporaryDir m_folder;
};

/// Waits until the window takes keys. There is no window manager on the tests' display, so after a dialog
/// nothing is active: Qt notices some 400 ms later, and a shortcut pressed then is lost.
inline void makeActive(QWidget& window) {
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window, kPatience));
}

/// Shows the window at a size that leaves the viewport room, and waits until it can take clicks.
inline void showReady(MainWindow& window) {
    window.resize(1280, 800);
    window.show();
    makeActive(window);
    window.viewport().setFocus();
    QTRY_VERIFY_WITH_TIMEOUT(!window.viewport().rendererName().isEmpty(), kPatience);
}

inline void writeObj(const MeshData& mesh, const QString& path) {
    ObjExport what;
    what.mesh = &mesh;
    what.positions = mesh.positions;
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(formatObj(what, {})));
}

}  // namespace hitscope
