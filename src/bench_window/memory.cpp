// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_window/memory.h"

#include <QAbstractItemView>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QJsonArray>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "analysis/freed_memory.h"
#include "analysis/hit_planner.h"
#include "app/scene_files.h"
#include "bench_window/worker_watch.h"
#include "core/process_memory.h"
#include "deform/scattered_hits.h"
#include "models/mesh_statistics_model.h"
#include "session/target.h"
#include "session/welcome.h"

namespace hitscope::bench {

namespace {

constexpr double kReached = 80.0;  // vertices of a hit, as one of the paper's has

/// Hits scattered evenly over the mesh, of which each reaches about kReached vertices.
Result<std::vector<Hit>> smallHits(const Session& session, int count) {
    const Target& target = *session.targets().front();
    ScatterPlan plan;
    plan.count = static_cast<std::uint32_t>(count);
    Result<ScatteredHits> made = scatteredHits({target.deformed.render(), target.deformed.positions(), {}},
                                               plan, HitPlanner::modelOn(session, target));
    if (!made) {
        return made.error();
    }
    const auto vertices = static_cast<double>(target.deformed.positions().size());
    const double reach = std::sqrt(kReached * made.value().area / (vertices * std::numbers::pi));
    std::vector<Hit> hits = std::move(made.value().hits);
    for (Hit& hit : hits) {
        hit.constants = resized(hit.constants, reach / static_cast<double>(hit.constants.maxDistance));
    }
    return hits;
}

class MemoryRun {
public:
    explicit MemoryRun(DrivenWindow& window) : m_window(window) {}

    /// What is there once all has come to rest; the mesh is measured some seconds after a change of it, and
    /// what was freed goes to the system after that.
    void note(const QString& measured) {
        constexpr int kRest = FreedMemory::kLater + FreedMemory::kSoon;  // milliseconds
        if (!m_window.settle() ||
            !m_window.wait(QStringLiteral("the measured mesh"), [this] { return isMeasured(); })) {
            return;
        }
        QElapsedTimer rest;
        rest.start();
        if (!m_window.wait(QStringLiteral("rest"), [&rest] { return rest.hasExpired(kRest); })) {
            return;
        }
        const ProcessMemory memory = memoryOf(QCoreApplication::applicationPid());
        m_rows.append(QJsonObject{{QStringLiteral("measured"), measured},
                                  {QStringLiteral("share"), memory.share},
                                  {QStringLiteral("resident"), memory.resident}});
    }
    bool open(const QString& mesh) {
        bool isOpened = false;
        QObject listener;
        QObject::connect(&m_window.files(), &SceneFiles::opened, &listener, [&] { isOpened = true; });
        return m_window
            .untilShown(
                QStringLiteral("the picture of the opened file"), [&] { m_window.drop(mesh); },
                [&] { return isOpened; })
            .has_value();
    }
    /// Each with a frame of its own.
    Status shoot(std::span<const Hit> hits) {
        for (const Hit& hit : hits) {
            Status added = Done{};
            const std::uint64_t before = m_window.frames();
            added = m_window.session().hits().add(hit);
            if (!added) {
                return added;
            }
            m_window.wait(QStringLiteral("a frame"), [&] { return m_window.frames() > before; });
        }
        return Done{};
    }
    void undoAll() {
        for (std::size_t left = hitsThere(); left > 0; left = hitsThere()) {
            m_window.session().undo();
            if (hitsThere() == left) {
                return;
            }
        }
    }
    [[nodiscard]] const QJsonArray& rows() const { return m_rows; }

private:
    [[nodiscard]] bool isMeasured() {
        const auto views = m_window.window().findChildren<QAbstractItemView*>();
        return std::all_of(views.begin(), views.end(), [](const QAbstractItemView* view) {
            const auto* model = qobject_cast<const MeshStatisticsModel*>(view->model());
            return model == nullptr || !view->isVisible() || model->measuring().isUpToDate();
        });
    }
    [[nodiscard]] std::size_t hitsThere() const { return m_window.session().hits().history().size(); }

    DrivenWindow& m_window;
    QJsonArray m_rows;
};

}  // namespace

QJsonObject measureMemory(DrivenWindow& window, const QString& mesh, int hits) {
    MemoryRun run(window);
    run.note(QStringLiteral("start"));
    double worker = 0.0;
    {
        const WorkerWatch watch;
        if (!run.open(mesh)) {
            return {};
        }
        worker = watch.most();
    }
    run.note(QStringLiteral("opened"));
    const std::size_t vertices = window.session().targets().front()->deformed.positions().size();
    if (Result<std::vector<Hit>> made = smallHits(window.session(), hits); made && !made.value().empty()) {
        const auto all = std::span<const Hit>(made.value());
        if (const Status shot = run.shoot(all.first(1)); shot) {
            run.note(QStringLiteral("first"));
        }
        if (const Status shot = run.shoot(all.subspan(1)); shot) {
            run.note(QStringLiteral("hits"));
            run.undoAll();
            run.note(QStringLiteral("undone"));
        }
    }
    loadWelcomeScene(window.session());
    run.note(QStringLiteral("closed"));
    return {{QStringLiteral("vertices"), static_cast<qint64>(vertices)},
            {QStringLiteral("hits"), hits},
            {QStringLiteral("worker"), worker},
            {QStringLiteral("rows"), run.rows()}};
}

}  // namespace hitscope::bench
