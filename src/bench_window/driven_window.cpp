// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_window/driven_window.h"

#include <sys/resource.h>

#include <QAction>
#include <QCoreApplication>
#include <QDropEvent>
#include <QEventLoop>
#include <QMimeData>
#include <QScopeGuard>
#include <QSettings>
#include <QTest>
#include <QUrl>
#include <QWheelEvent>
#include <QWindow>
#include <memory>
#include <utility>

#include "app/scene_files.h"
#include "scene/picture.h"
#include "session/task_list.h"
#include "session/welcome.h"
#include "viewport/viewport.h"

namespace hitscope::bench {

namespace {

constexpr std::int64_t kPatience = 300'000'000'000;  // nanoseconds
constexpr std::int64_t kQuiet = 250'000'000;  // nanoseconds in which nothing was drawn, then nothing follows
constexpr double kNanoseconds = 1.0e-9;       // seconds
constexpr double kMicrosecond = 1.0e-6;       // seconds

}  // namespace

double processorTime() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + kMicrosecond * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

DrivenWindow::DrivenWindow(QSize size) : m_watch([this] { seeLoop(); }) {
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
    qputenv("XDG_STATE_HOME", m_folder.filePath(QStringLiteral("state")).toLocal8Bit());
    loadWelcomeScene(m_session);
    m_window = std::make_unique<MainWindow>(m_session);
    setRefines(false);
    QObject::connect(&viewport().pictures(), &PictureFlow::framePainted, &m_watch,
                     [this] { m_lastPainted = nowInNanoseconds(); });
    QObject::connect(&viewport().pictures(), &PictureFlow::drawn, &m_watch, [this] { ++m_drawnFrames; });
    QObject::connect(&viewport().pictures(), &PictureFlow::shown, &m_watch, [this] {
        ++m_frames;
        m_drawnWithShown = m_drawnFrames;
        m_lastFrame = nowInNanoseconds();
    });
    m_window->resize(size);
    m_window->show();
    m_window->activateWindow();
    viewport().setFocus();
    wait(QStringLiteral("an active window"), [this] { return m_window->isActiveWindow(); });
    wait(QStringLiteral("a first picture"), [this] { return !viewport().scene().rendererName().isEmpty(); });
}

DrivenWindow::~DrivenWindow() {
    m_window.reset();
}

SceneFiles& DrivenWindow::files() {
    return *m_window->findChild<SceneFiles*>();
}

void DrivenWindow::seeLoop() {
    if (m_loop != nullptr && m_done()) {
        m_loop->quit();
    }
}

bool DrivenWindow::wait(const QString& what, const std::function<bool()>& done) {
    const std::int64_t begin = nowInNanoseconds();
    bool came = false;
    m_done = [&] {
        came = done();
        return came || nowInNanoseconds() - begin > kPatience;
    };
    QEventLoop loop;
    m_loop = &loop;
    loop.exec();
    m_loop = nullptr;
    if (!came && m_error.isEmpty()) {
        m_error = QStringLiteral("The window was used, but %1 did not come.").arg(what);
    }
    return came;
}

bool DrivenWindow::isQuiet() {
    return !m_session.simulation().isMoving() && m_session.tasks().current() == nullptr &&
           m_session.readBack().isUpToDate() && nowInNanoseconds() - m_lastPainted > kQuiet;
}

bool DrivenWindow::settle() {
    const std::int64_t begin = nowInNanoseconds();
    return wait(QStringLiteral("rest"),
                [this, begin] { return nowInNanoseconds() - begin > kQuiet && isQuiet(); });
}

std::optional<DrivenWindow::Taken> DrivenWindow::untilShown(const QString& what,
                                                            const std::function<void()>& act,
                                                            const std::function<bool()>& isThere) {
    Taken taken;
    bool drawn = false;  // since it was there
    std::int64_t begin = 0;
    double spent = 0.0;
    QObject listener;
    bool isComing = false;  // the picture to be shown next was drawn then
    // What drawing brought along is in its picture.
    QObject::connect(&viewport().pictures(), &PictureFlow::drawn, &listener, [&] { isComing = isThere(); });
    m_isBesidePainted = false;
    QObject::connect(&viewport().pictures(), &PictureFlow::shown, &listener,
                     [&] { drawn = drawn || isComing; });
    const auto look = [&] {
        drawn = drawn || (std::exchange(m_isBesidePainted, false) && isThere());
        if (!drawn) {
            return;
        }
        const double passed = kNanoseconds * static_cast<double>(nowInNanoseconds() - begin);
        const Moment now{passed, m_watch.longest(), processorTime() - spent};
        if (taken.seen.seconds == 0.0) {
            taken.seen = now;
        }
        if (taken.full.seconds == 0.0 && viewport().pictures().motion().lastDetail().isFull()) {
            taken.full = now;
        }
        if (taken.ready == 0.0 && m_session.readBack().isUpToDate()) {
            taken.ready = passed;
        }
    };
    QObject::connect(&viewport(), &Viewport::windowPainted, &listener, look);
    m_besidePainted = look;
    const auto forget = qScopeGuard([this] { m_besidePainted = nullptr; });
    m_watch.restart();
    spent = processorTime();
    begin = nowInNanoseconds();
    act();
    const bool came = wait(what, [&] { return taken.ready > 0.0 && taken.full.seconds > 0.0; });
    return came ? std::optional(taken) : std::nullopt;
}

std::optional<DrivenWindow::Moment> DrivenWindow::untilRefined(const std::function<void()>& act) {
    Moment refined;
    std::int64_t begin = 0;
    double spent = 0.0;
    QObject listener;
    QObject::connect(&viewport().pictures(), &PictureFlow::shown, &listener, [&] {
        const PictureRefiner& refiner = viewport().pictures().refiner();
        if (!refiner.wasShown()) {  // the last of these: what follows the hit comes in another frame
            m_watch.restart();
            spent = processorTime();
            begin = nowInNanoseconds();
        } else if (begin != 0 && refined.seconds == 0.0 && refiner.samples() == kShownSamples) {
            refined = {kNanoseconds * static_cast<double>(nowInNanoseconds() - begin), m_watch.longest(),
                       processorTime() - spent};
        }
    });
    act();
    const bool came = wait(QStringLiteral("the refined picture"), [&] {
        return refined.seconds > 0.0 || !viewport().pictures().refiner().whyNot().isEmpty();
    });
    return came && refined.seconds > 0.0 ? std::optional(refined) : std::nullopt;
}

void DrivenWindow::setRefines(bool on) {
    DisplayOptions options = viewport().options();
    options.refine = on;
    viewport().setOptions(options);
}

bool DrivenWindow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Paint) {
        m_isBesidePainted = true;
        if (viewport().surface().keepsPictures()) {  // else the window is composed, and says so then
            QMetaObject::invokeMethod(
                this,
                [this] {
                    if (m_besidePainted) {
                        m_besidePainted();
                    }
                },
                Qt::QueuedConnection);
        }
    }
    return QObject::eventFilter(watched, event);
}

QPoint DrivenWindow::place(double x, double y) {
    return viewport().mapTo(m_window.get(), QPoint(static_cast<int>(x * viewport().width()),
                                                   static_cast<int>(y * viewport().height())));
}

void DrivenWindow::click(double x, double y) {
    QTest::mouseClick(m_window->windowHandle(), Qt::LeftButton, {}, place(x, y));
}

void DrivenWindow::press(double x, double y) {
    QTest::mousePress(m_window->windowHandle(), Qt::LeftButton, {}, place(x, y));
}

void DrivenWindow::moveTo(double x, double y) {
    QTest::mouseMove(m_window->windowHandle(), place(x, y));
}

void DrivenWindow::release(double x, double y) {
    QTest::mouseRelease(m_window->windowHandle(), Qt::LeftButton, {}, place(x, y));
}

void DrivenWindow::wheel(double x, double y, int turns) {
    constexpr int kTurn = 120;  // in the unit of QWheelEvent
    for (int i = 0; i < turns; ++i) {
        const QPointF at = place(x, y);
        QWheelEvent turn(at, m_window->mapToGlobal(at), {}, {0, kTurn}, Qt::NoButton, Qt::NoModifier,
                         Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(m_window->windowHandle(), &turn);
    }
}

void DrivenWindow::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    QTest::keyClick(m_window->windowHandle(), key, modifiers);
}

void DrivenWindow::drop(const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    const QPoint at = place(0.5, 0.5);
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_window.get(), &enter);
    QDropEvent drop(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(m_window.get(), &drop);
}

bool DrivenWindow::choose(const QString& text) {
    for (QAction* action : m_window->findChildren<QAction*>()) {
        if (action->text().remove(u'&').remove(u'…') == text) {
            action->trigger();
            return true;
        }
    }
    m_error = QStringLiteral("The window has no menu entry \"%1\".").arg(text);
    return false;
}

}  // namespace hitscope::bench
