// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the README's pictures from the window itself, by mouse and key: screenshots FOLDER.
// packaging/screenshots builds and runs it.
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <cstdio>

#include "app/main_window.h"
#include "app/theme.h"
#include "session/welcome.h"
#include "viewport/viewport.h"

using namespace hitscope;

namespace {

constexpr int kLands = 1500;    // milliseconds after which a shot has become a dent
constexpr int kSettles = 2500;  // likewise, until all numbers are up to date and nothing is drawn any more

class Photographer {
public:
    explicit Photographer(const QString& folder) : m_folder(folder) {
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
        loadWelcomeScene(m_session);
        m_window = std::make_unique<MainWindow>(m_session);
        m_window->resize(1280, 800);
        m_window->show();
        m_window->showFirstSteps();
        m_window->activateWindow();  // keys go to a window that is active
        if (!QTest::qWaitForWindowActive(m_window.get())) {
            std::fputs("The window did not become active.\n", stderr);
            m_failed = true;
        }
        settle();
    }

    /// In fractions of the viewport's size.
    void click(double x, double y) {
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, place(x, y));
        QTest::qWait(kLands);
    }
    void rest(double x, double y) { QTest::mouseMove(&viewport(), place(x, y)); }
    /// At a place; a notch a step.
    void zoom(double x, double y, int notches) {
        constexpr int kNotch = 120;  // eighths of a degree
        for (int i = 0; i < notches; ++i) {
            const QPointF at = place(x, y);
            QWheelEvent wheel(at, viewport().mapToGlobal(at), {}, {0, kNotch}, Qt::NoButton, Qt::NoModifier,
                              Qt::NoScrollPhase, false);
            QApplication::sendEvent(&viewport(), &wheel);
        }
        settle();
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&viewport(), key, modifiers);
        settle();
    }
    void save(const char* name) {
        rest(0.02, 0.98);
        settle();
        const QString path = m_folder.filePath(QLatin1String(name));
        if (!m_window->grab().save(path)) {
            std::fprintf(stderr, "%s could not be written.\n", qPrintable(path));
            m_failed = true;
        }
    }
    void saveViewport(const char* name) {
        settle();
        const QString path = m_folder.filePath(QLatin1String(name));
        if (Status saved = m_window->savePictureTo(path); !saved) {
            std::fprintf(stderr, "%s\n", saved.error().message().c_str());
            m_failed = true;
        }
    }
    [[nodiscard]] bool hasFailed() const { return m_failed; }

private:
    Viewport& viewport() { return m_window->viewport(); }
    QPoint place(double x, double y) {
        return {qRound(x * viewport().width()), qRound(y * viewport().height())};
    }
    static void settle() { QTest::qWait(kSettles); }

    QTemporaryDir m_settings;
    QDir m_folder;
    Session m_session;
    std::unique_ptr<MainWindow> m_window;
    bool m_failed = false;
};

}  // namespace

int main(int argc, char** argv) {
    QCoreApplication::setOrganizationName(QStringLiteral("Hitscope"));
    QCoreApplication::setApplicationName(QStringLiteral("hitscope-screenshots"));
    MainWindow::setSurfaceFormat();
    const QApplication application(argc, argv);
    QApplication::setApplicationDisplayName(QStringLiteral("Hitscope"));
    QApplication::setStyle(makeStyle());
    if (argc != 2) {
        std::fputs("Usage: screenshots FOLDER\n", stderr);
        return 2;
    }
    Photographer window(QString::fromLocal8Bit(argv[1]));
    for (const QPointF& shot : {QPointF(0.57, 0.52), QPointF(0.50, 0.75), QPointF(0.66, 0.52)}) {
        window.click(shot.x(), shot.y());
    }
    window.save("teapot.png");
    window.press(Qt::Key_V);
    window.saveViewport("colour_map.png");
    window.press(Qt::Key_V);
    window.press(Qt::Key_X);
    window.saveViewport("before_after.png");
    window.press(Qt::Key_X);
    window.press(Qt::Key_L);
    window.zoom(0.47, 0.55, 7);
    window.saveViewport("wireframe.png");
    return window.hasFailed() ? 1 : 0;
}
