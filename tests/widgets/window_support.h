// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QAction>
#include <QFile>
#include <QMessageBox>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <functional>
#include <memory>
#include <string>

#include "app/file_watch.h"
#include "app/main_window.h"
#include "io/export_obj.h"
#include "mesh/primitives.h"
#include "session/session.h"
#include "support/test_program.h"
#include "viewport/viewport.h"

namespace hitscope {

/// Settings of the tests' own, thrown away afterwards.
class TestSettings {
public:
    TestSettings() {
        QCoreApplication::setOrganizationName(QStringLiteral("Hitscope"));
        QCoreApplication::setApplicationName(QStringLiteral("hitscope-test"));
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
        // Pictures that are compared are drawn once: how far a refined one has come depends on the time.
        QSettings().setValue(QStringLiteral("display/refine"), false);
        QSettings().setValue(QStringLiteral("display/reduceInMotion"), false);              // likewise
        qputenv("XDG_DATA_HOME", m_folder.filePath(QStringLiteral("data")).toLocal8Bit());  // what is pasted
        qputenv("XDG_STATE_HOME", m_folder.filePath(QStringLiteral("state")).toLocal8Bit());  // journals
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
    QTRY_VERIFY_WITH_TIMEOUT(!window.viewport().scene().rendererName().isEmpty(), kPatience);
}

/// In the menu, as a person does: the window leaves one that nobody asked for where it is not exact.
inline void choosePipeline(MainWindow& window, PipelineKind kind) {
    const QString name = QString::fromUtf8(pipelineTraits(kind).name);
    for (QAction* action : window.findChildren<QAction*>()) {
        if (action->isCheckable() && action->text() == name) {
            action->trigger();
            return;
        }
    }
    QFAIL("no such pipeline in the menu");
}

/// The question whether hits may be discarded; null: it is not asked.
inline QMessageBox* discardQuestion(const MainWindow& window) {
    for (QMessageBox* box : window.findChildren<QMessageBox*>(QStringLiteral("discardHits"))) {
        if (box->isVisible()) {
            return box;
        }
    }
    return nullptr;
}

/// Answers it by a click.
inline void answerQuestion(MainWindow& window, QMessageBox::ButtonRole role) {
    QMessageBox* box = discardQuestion(window);
    QVERIFY(box != nullptr);
    for (QAbstractButton* button : box->buttons()) {
        if (box->buttonRole(button) == role) {
            QTest::mouseClick(button, Qt::LeftButton);
            return;
        }
    }
    QFAIL("no such button");
}

/// Closes the window as a person who wants none of its hits.
inline void closeAndDiscard(MainWindow& window) {
    window.close();
    if (discardQuestion(window) != nullptr) {
        answerQuestion(window, QMessageBox::DestructiveRole);
    }
    QVERIFY(!window.isVisible());
}

/// What the window knows of a file that it watches: the sha256 of its content; empty: nothing so far.
inline std::string knownContentOf(const MainWindow& window, const QString& path) {
    for (const FileWatch* watch : window.findChildren<FileWatch*>()) {
        if (std::string content = watch->contentOf(path); !content.empty()) {
            return content;
        }
    }
    return {};
}

/// For classes of tests that want a window for each test, with a session and settings of its own.
class WindowFixture {
protected:
    /// In init(), or again, with the settings as they have become. `load` gives the session its scene.
    void makeWindow(const std::function<void(Session&)>& load = loadSphere) {
        m_window.reset();
        if (!m_settings) {
            m_settings = std::make_unique<TestSettings>();
        }
        m_session = std::make_unique<Session>();
        load(*m_session);
        m_window = std::make_unique<MainWindow>(*m_session);
        showReady(*m_window);
    }
    /// In cleanup().
    void dropWindow() {
        m_window.reset();
        m_session.reset();
        m_settings.reset();
    }
    static void loadSphere(Session& session) { loadMesh(session, makeHighPolySphere(2.5f)); }

    std::unique_ptr<TestSettings> m_settings;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<MainWindow> m_window;
};

inline void writeObj(const MeshData& mesh, const QString& path) {
    ObjExport what;
    what.mesh = &mesh;
    what.positions = mesh.positions;
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(formatObj(what, {})));
}

}  // namespace hitscope
