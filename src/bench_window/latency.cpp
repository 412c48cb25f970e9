// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_window/latency.h"

#include <QJsonArray>
#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "app/scene_files.h"
#include "bench_window/latency_run.h"
#include "session/target.h"
#include "viewport/viewport.h"

namespace hitscope::bench {

namespace {

constexpr int kTurnsClose = 24;         // of the wheel, to look at a dent from close by
constexpr int kLeastFrames = 5;         // in one drag
constexpr int kMostFrames = 20;         // likewise
constexpr double kNanosecond = 1.0e-9;  // seconds

double secondsSince(std::int64_t begin) {
    return kNanosecond * static_cast<double>(nowInNanoseconds() - begin);
}

}  // namespace

/// With another row where fewer triangles came first.
void LatencyRun::take(Row row) {
    if (row.seconds.empty()) {
        return;
    }
    Row inFull{row.measured + QStringLiteral(", in full")};
    bool isOther = false;
    for (std::size_t i = 0; i < row.full.size(); ++i) {
        isOther = isOther || row.full[i].seconds > row.seconds[i];
        inFull.add(row.full[i]);
    }
    m_rows.push_back(std::move(row));
    if (isOther) {
        m_rows.push_back(std::move(inFull));
    }
}

void LatencyRun::repeat(const std::function<bool()>& once) {
    const std::int64_t begin = nowInNanoseconds();
    for (int done = 0; done < m_repeats.most; ++done) {
        if (done >= m_repeats.least && secondsSince(begin) > m_repeats.seconds) {
            return;
        }
        if (!m_window.settle() || !once() || !isGood()) {
            return;
        }
    }
}

bool LatencyRun::openOnce(const QString& mesh, Row& coarse, Row& full) {
    std::optional<double> seen;
    double seenBlocked = 0.0;
    double seenProcessor = 0.0;
    const double spent = processorTime();
    bool isSeen = false;
    bool isOpened = false;
    QObject listener;
    QObject::connect(&m_window.files(), &SceneFiles::seen, &listener, [&] { isSeen = true; });
    QObject::connect(&m_window.files(), &SceneFiles::opened, &listener, [&] { isOpened = true; });
    const std::int64_t begin = nowInNanoseconds();
    // The coarse picture lies over the viewport: it is on the screen with the first swap after it.
    QObject::connect(&m_window.viewport(), &Viewport::windowPainted, &listener, [&] {
        if (isSeen && !isOpened && !seen) {
            seen = secondsSince(begin);
            seenBlocked = m_window.watch().longest();
            seenProcessor = processorTime() - spent;
        }
    });
    const auto shown = m_window.untilShown(
        QStringLiteral("the picture of the opened file"), [&] { m_window.drop(mesh); },
        [&] { return isOpened; });
    if (!shown) {
        return false;
    }
    if (seen) {
        coarse.add(*seen, seenBlocked, seenProcessor);
    }
    full.add(*shown);
    return true;
}

/// Of the scene that the window starts with: its dent is undone and done again, and the camera turned.
void LatencyRun::refinements() {
    m_window.settle();
    // A window's first picture is refined before anybody clicks, and makes what later ones use again.
    static_cast<void>(m_window.untilRefined([this] { m_window.setRefines(true); }));
    refine(QStringLiteral("teapot, rest to refined picture"), [&](bool isOdd) {
        m_window.key(Qt::Key_Z, isOdd ? Qt::ControlModifier | Qt::ShiftModifier : Qt::ControlModifier);
    });
    refine(QStringLiteral("teapot, turned, rest to refined picture"), [&](bool isOdd) {
        // There, and back the next time: a drag that ends where it began may show no other picture.
        m_window.press(isOdd ? 0.15 : 0.05, 0.1);
        m_window.moveTo(0.1, 0.1);
        m_window.moveTo(isOdd ? 0.05 : 0.15, 0.1);
        m_window.release(isOdd ? 0.05 : 0.15, 0.1);
    });
    m_window.setRefines(false);
}

void LatencyRun::refine(const QString& what, const std::function<void(bool isOdd)>& act) {
    Row row{what};
    bool isOdd = false;
    repeat([&] {
        const auto refined = m_window.untilRefined([&] { act(isOdd); });
        isOdd = !isOdd;
        if (refined) {
            row.add(*refined);
        }
        return refined.has_value();
    });
    take(row);
}

void LatencyRun::openings(const QString& mesh) {
    Row coarse{QStringLiteral("open to coarse picture")};
    Row full{QStringLiteral("open to picture")};
    repeat([&] { return openOnce(mesh, coarse, full); });
    take(coarse);
    take(full);
}

std::size_t LatencyRun::movedVertices() {
    const Target& target = *m_window.session().targets().front();
    const std::span<const glm::vec3> now = target.deformed.positions();
    const PageVector<glm::vec3>& before = target.deformed.original().positions;
    std::size_t moved = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        moved += now[i] != before[i] ? 1 : 0;
    }
    return moved;
}

bool LatencyRun::stepBack(bool redo, Row& row) {
    const std::size_t before = hits();
    const auto step = m_window.untilShown(
        redo ? QStringLiteral("the picture after redo") : QStringLiteral("the picture after undo"),
        [&] {
            m_window.key(Qt::Key_Z, redo ? Qt::ControlModifier | Qt::ShiftModifier : Qt::ControlModifier);
        },
        [&] { return hits() != before && (hits() + 1 == before || before + 1 == hits() || isAllApplied()); });
    if (!step) {
        return false;
    }
    row.add(*step);
    return m_window.settle();
}

bool LatencyRun::clickOnce(Row& click, Row& undo, Row& redo) {
    const std::size_t before = hits();
    const auto shot = m_window.untilShown(
        QStringLiteral("the dent of a click"), [&] { m_window.click(0.5, 0.5); },
        [&] { return hits() > before; });
    if (!shot || !m_window.settle()) {
        return false;
    }
    click.add(*shot);
    m_moved = m_moved == 0 ? movedVertices() : m_moved;
    return stepBack(false, undo) && stepBack(true, redo) && stepBack(false, undo);
}

/// Each dent is undone, done again and undone, so that all meet the same mesh.
void LatencyRun::clicks(FlightMode mode, const QString& what) {
    m_window.session().settings().setFlightMode(mode);
    Row click{what};
    Row undo{QStringLiteral("undo key to picture")};
    Row redo{QStringLiteral("redo key to picture")};
    repeat([&] { return clickOnce(click, undo, redo); });
    take(click);
    if (mode == FlightMode::Instant) {
        take(undo);
        take(redo);
    }
}

void LatencyRun::frames() {
    Row rest{QStringLiteral("frame at rest")};
    const int frames = std::clamp(m_repeats.most, kLeastFrames, kMostFrames);
    m_window.settle();
    m_window.viewport().setDrawsContinuously(true);
    for (int i = 0; i < frames && isGood(); ++i) {
        const std::int64_t last = m_window.lastFrame();
        const std::uint64_t before = m_window.frames();
        const double spent = processorTime();
        m_window.watch().restart();
        m_window.wait(QStringLiteral("a frame"), [&] { return m_window.frames() > before; });
        // More than one may have come before the wait ended.
        const auto shown = static_cast<double>(m_window.frames() - before);
        rest.add(kNanosecond * static_cast<double>(m_window.lastFrame() - last) / shown,
                 m_window.watch().longest(), (processorTime() - spent) / shown);
    }
    m_window.viewport().setDrawsContinuously(false);
    m_window.settle();
    take(rest);
    take(moving(QStringLiteral("frame in motion, full size"), PictureDetail(), frames));
    take(moving(QStringLiteral("frame in motion"), std::nullopt, frames));
}

void LatencyRun::framesCloseUp() {
    m_window.wheel(0.5, 0.5, kTurnsClose);
    m_window.settle();
    take(moving(QStringLiteral("frame in motion, close up"), std::nullopt, kLeastFrames));
}

/// Frames of a drag. detail: of the picture; nothing: as the window chooses, after the frames that it takes
/// to choose.
Row LatencyRun::moving(const QString& what, std::optional<PictureDetail> detail, int frames) {
    constexpr int kChoosing = 15;  // frames
    Row row{what};
    const Camera camera = m_window.viewport().camera();
    m_window.viewport().pictures().motion().hold(detail);
    m_window.press(0.3, 0.5);
    m_window.moveTo(0.33, 0.5);  // now it is a drag
    for (int i = 0; i < kChoosing + frames && isGood(); ++i) {
        const std::uint64_t before = m_window.drawnFrames();
        const std::int64_t begin = nowInNanoseconds();
        const double spent = processorTime();
        m_window.watch().restart();
        m_window.moveTo(0.33 + 0.01 * (i % 40 + 1), 0.5);
        m_window.wait(QStringLiteral("a frame"), [&] { return m_window.drawnWithShown() > before; });
        if (i >= kChoosing) {
            row.add(kNanosecond * static_cast<double>(m_window.lastFrame() - begin),
                    m_window.watch().longest(), processorTime() - spent);
        }
    }
    m_window.release(0.3, 0.5);
    // What follows sees the mesh as before. The way back may be another: an orbit keeps the scene in sight.
    m_window.viewport().navigation().setCamera(camera, Navigation::Arrival::AtOnce);
    m_window.viewport().pictures().motion().hold(std::nullopt);
    m_window.settle();
    return row;
}

QJsonObject LatencyRun::result() const {
    QJsonArray rows;
    for (const Row& row : m_rows) {
        rows.append(row.json());
    }
    const Session& session = m_window.session();
    const Viewport& viewport = m_window.viewport();
    const std::size_t vertices =
        session.targets().empty() ? 0 : session.targets().front()->deformed.positions().size();
    return {{QStringLiteral("vertices"), static_cast<qint64>(vertices)},
            {QStringLiteral("moved"), static_cast<qint64>(m_moved)},
            {QStringLiteral("viewport"), QJsonArray{viewport.width(), viewport.height()}},
            {QStringLiteral("rows"), rows}};
}

QJsonObject measureLatency(DrivenWindow& window, const QString& mesh, const Repeats& repeats) {
    LatencyRun run(window, repeats);
    run.refinements();
    run.openings(mesh);
    run.clicks(FlightMode::Quick, QStringLiteral("click to dent"));
    run.clicks(FlightMode::Instant, QStringLiteral("click to dent, instant"));
    run.frames();
    run.aims();
    run.exports();
    run.scatter();
    run.framesCloseUp();
    return run.result();
}

}  // namespace hitscope::bench
