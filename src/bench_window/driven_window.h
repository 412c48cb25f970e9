// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPoint>
#include <QSize>
#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "app/main_window.h"
#include "bench_window/loop_watch.h"
#include "bench_window/passing_folder.h"
#include "core/result.h"
#include "session/session.h"

class QEventLoop;

namespace hitscope {
class SceneFiles;
}

namespace hitscope::bench {

/// Of all threads of this process, seconds.
[[nodiscard]] double processorTime();

/// The window with a session and settings of its own, used by events, and what it takes until what they ask
/// for is on the screen. A frame is on the screen when Qt has swapped its buffers.
class DrivenWindow : public QObject {
public:
    /// Shows it, `size` pixels large, with the scene that the program starts with. Pictures at rest are not
    /// refined until setRefines() asks for it: on a slow renderer that takes seconds, and what is measured
    /// would meet another part of it each time.
    explicit DrivenWindow(QSize size);
    ~DrivenWindow() override;
    /// Why it is of no use; empty: it is. Each wait() that ended without what it waited for is a reason.
    [[nodiscard]] const QString& error() const { return m_error; }

    [[nodiscard]] MainWindow& window() { return *m_window; }
    [[nodiscard]] Viewport& viewport() { return m_window->viewport(); }
    [[nodiscard]] Session& session() { return m_session; }
    [[nodiscard]] SceneFiles& files();

    /// Runs the event loop until `done`, which is asked about once a millisecond; false: not within
    /// five minutes, and error() says that `what` did not come.
    bool wait(const QString& what, const std::function<bool()>& done);
    /// Until nothing moves, nothing is worked out and the viewport does not draw.
    bool settle();

    struct Moment {
        double seconds = 0.0;    ///< until something was on the screen; 0: it is not yet
        double blocked = 0.0;    ///< seconds that an event waited at most until then
        double processor = 0.0;  ///< seconds of all threads until then
    };
    struct Taken {
        Moment seen;         ///< with fewer triangles, perhaps
        Moment full;         ///< with all
        double ready = 0.0;  ///< seconds until normals and read-back had followed too
    };
    /// Does `act` and waits until a frame has been shown in full that was drawn when `isThere` held.
    std::optional<Taken> untilShown(const QString& what, const std::function<void()>& act,
                                    const std::function<bool()>& isThere);
    /// Does `act`, which changes the picture at once and sets nothing in motion, and waits until the refined
    /// picture of what came of it is shown. The times run from the first frame of that. Nothing: it is not
    /// refined here.
    std::optional<Moment> untilRefined(const std::function<void()>& act);
    /// Whether pictures are refined at rest.
    void setRefines(bool on);
    /// Frames that have been shown so far, and when the last one was, nanoseconds.
    [[nodiscard]] std::uint64_t frames() const { return m_frames; }
    [[nodiscard]] std::int64_t lastFrame() const { return m_lastFrame; }
    /// Frames that have been drawn so far; the last one may not be shown yet.
    [[nodiscard]] std::uint64_t drawnFrames() const { return m_drawnFrames; }
    /// How many were when the one that is shown had been drawn.
    [[nodiscard]] std::uint64_t drawnWithShown() const { return m_drawnWithShown; }
    [[nodiscard]] LoopWatch& watch() { return m_watch; }

    // By events, as from mouse and keyboard. Places are fractions of the viewport's size.
    void click(double x, double y);
    void press(double x, double y);
    void moveTo(double x, double y);
    void release(double x, double y);
    void wheel(double x, double y, int turns);  ///< towards the mesh
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {});
    void drop(const QString& file);
    /// The entry of a menu whose text, without & and …, is `text`; false: there is none.
    bool choose(const QString& text);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] QPoint place(double x, double y);
    [[nodiscard]] bool isQuiet();
    void seeLoop();

    PassingFolder m_folder;  ///< of settings and journals
    Session m_session;
    std::unique_ptr<MainWindow> m_window;
    QString m_error;
    QEventLoop* m_loop = nullptr;  ///< the one that wait() runs
    std::function<bool()> m_done;
    bool m_isBesidePainted = false;  ///< what lies over the viewport, and has this as its event filter
    std::function<void()> m_besidePainted;
    std::uint64_t m_frames = 0;
    std::uint64_t m_drawnFrames = 0;
    std::uint64_t m_drawnWithShown = 0;
    std::int64_t m_lastFrame = 0;
    std::int64_t m_lastPainted = 0;  ///< when the viewport drew; panels around it swap frames too
    LoopWatch m_watch;
};

}  // namespace hitscope::bench
