// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/hit_planner.h"

#include <algorithm>
#include <set>
#include <utility>

#include "analysis/dent_ghosts.h"
#include "session/usual_dent.h"
#include "session/vertex_selection.h"

namespace hitscope {

namespace {

constexpr int kPlanSettles = 60;  // milliseconds without a change before it is worked out

}  // namespace

/// A target on the other thread, as it is.
class PlannedCopy {
public:
    PlannedCopy(std::shared_ptr<const MeshData> mesh, std::shared_ptr<const RenderMesh> render)
        : m_mesh(std::move(mesh)), m_render(std::move(render)) {}

    void follow(std::span<const MovedVertex> moved) {
        if (m_positions.size() == 0) {
            m_positions = PageCopy(m_mesh->positions);
        }
        for (const MovedVertex& vertex : moved) {
            m_positions[vertex.vertex] = vertex.position;
        }
    }
    [[nodiscard]] const RenderMesh& render() const { return *m_render; }
    [[nodiscard]] std::span<const glm::vec3> positions() const { return m_positions.all(); }

private:
    std::shared_ptr<const MeshData> m_mesh;
    std::shared_ptr<const RenderMesh> m_render;
    PageCopy<glm::vec3> m_positions;
};

struct PlanJob {
    struct Part {
        TargetId target;
        RigidTransform transform;
        CopiedTargets<PlannedCopy>::Part copied;
    };
    std::vector<Part> parts;
    std::vector<Hit> hits;
    std::optional<ScatterPlan> scatter;  ///< over the first part
    Hit model;
    std::vector<std::uint32_t> selected;
    HitPlanner::Plan plan;

    void run(const std::stop_token& stop) {
        for (Part& part : parts) {
            part.copied.copy->follow(part.copied.moved);
        }
        if (scatter) {
            scatterHits(stop);
        }
        for (const Hit& hit : hits) {
            if (const Result<Hit> checked = checkedHit(hit)) {
                plan.hits.push_back(checked.value());
            } else {
                plan.why = QString::fromStdString(checked.error().message());
            }
        }
        if (plan.why.isEmpty() && !stop.stop_requested()) {
            makeGhosts(stop);
        } else {
            plan.hits.clear();
        }
    }

private:
    void scatterHits(const std::stop_token& stop) {
        const PlannedCopy& copy = *parts.front().copied.copy;
        Result<ScatteredHits> scattered =
            scatteredHits({copy.render(), copy.positions(), selected}, *scatter, model,
                          [&stop](double) { return !stop.stop_requested(); });
        if (!scattered) {
            plan.why = QString::fromStdString(scattered.error().message());
            return;
        }
        hits = std::move(scattered.value().hits);
        plan.area = scattered.value().area;
    }

    void makeGhosts(const std::stop_token& stop) {
        auto ghosts = std::make_shared<std::vector<glm::vec3>>();
        for (const Part& part : parts) {
            std::vector<Hit> on;
            std::copy_if(plan.hits.begin(), plan.hits.end(), std::back_inserter(on),
                         [&part](const Hit& hit) { return hit.target == part.target; });
            const DentGhosts dents = dentGhosts(part.copied.copy->render(), part.copied.copy->positions(), on,
                                                [&stop] { return stop.stop_requested(); });
            plan.areDents = plan.areDents && dents.areDents;
            for (const glm::vec3& corner : dents.triangles) {
                ghosts->push_back(part.transform.toWorld(corner));
            }
        }
        plan.ghosts = std::move(ghosts);
    }
};

HitPlanner::HitPlanner(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    m_timer.setSingleShot(true);
    m_job.showIn(session.tasks(), tr("Placing hits"));
    connect(&m_timer, &QTimer::timeout, this, &HitPlanner::gather);
    connect(&session.readBack(), &ReadBack::verticesMoved, this,
            [this](TargetId id, const std::vector<std::uint32_t>& vertices) {
                const Target* moved = m_session.targets().find(id);
                if (moved != nullptr && m_copies.note(*moved, vertices)) {
                    request();
                }
            });
    connect(&session.targets(), &SessionTargets::changed, this, &HitPlanner::request);
    connect(&session.targets(), &SessionTargets::removed, this, &HitPlanner::clear);
    connect(&session, &Session::sceneReplaced, this, &HitPlanner::clear);
    connect(&session.selection(), &VertexSelection::selectionChanged, this, [this] {
        if (m_wish && m_wish->selectedOnly) {
            request();
        }
    });
    connect(&session.settings(), &SessionSettings::constantsChanged, this, [this] {
        if (m_wish && m_wish->scatter) {
            request();
        }
    });
}

HitPlanner::~HitPlanner() = default;

Hit HitPlanner::modelOn(const Session& session, const Target& target) {
    Hit hit;
    hit.target = target.id;
    hit.constants = session.settings().constantsOn(target);
    hit.form = usualForm(session, hit);
    hit.time = session.simulation().physics().clock().time();
    hit.pipeline = static_cast<std::uint8_t>(session.settings().pipeline());
    return hit;
}

void HitPlanner::plan(std::vector<Hit> hits) {
    m_wish = Wish{std::move(hits), {}, {}, false};
    request();
}

void HitPlanner::plan(TargetId target, const ScatterPlan& scatter, bool selectedOnly) {
    m_wish = Wish{{}, scatter, target, selectedOnly};
    request();
}

void HitPlanner::clear() {
    m_wish.reset();
    m_timer.stop();
    m_job.cancel();
    m_copies.clear();
    if (std::exchange(m_plan, std::nullopt)) {
        Q_EMIT planned();
    }
}

void HitPlanner::refuse(const QString& why) {
    m_plan = Plan{};  // Clang knows too little of a class within another for emplace()
    m_plan->why = why;
    Q_EMIT planned();
}

void HitPlanner::request() {
    if (!m_wish) {
        return;
    }
    if (m_job.isRunning()) {
        m_job.cancel();
        m_copies.clear();  // it may still be at work on them
    }
    if (std::exchange(m_plan, std::nullopt)) {
        Q_EMIT planned();
    }
    m_timer.start(kPlanSettles);
}

std::vector<TargetId> HitPlanner::targets() const {
    if (m_wish->scatter) {
        return {m_wish->target};
    }
    std::set<TargetId> on;
    for (const Hit& hit : m_wish->hits) {
        on.insert(hit.target);
    }
    return {on.begin(), on.end()};
}

/// Carries over what has moved, over several turns of the event loop if it is much; then starts.
void HitPlanner::gather() {
    if (!m_wish) {
        return;
    }
    const std::span<const std::uint32_t> chosen = m_session.selection().vertices(m_wish->target);
    if (m_wish->selectedOnly && chosen.empty()) {
        refuse(tr("No vertex of this target is selected. Select some with the Inspect tool."));
        return;
    }
    if (targets().empty()) {
        refuse(tr("There are no hits to repeat."));
        return;
    }
    auto room = m_copies.kATurn;
    for (const TargetId id : targets()) {
        const Target* target = m_session.targets().find(id);
        if (target == nullptr) {
            refuse(tr("Select a target first."));
            return;
        }
        if (!m_copies.gather(*target, room, [target] {
                return std::make_shared<PlannedCopy>(target->deformed.sharedOriginal(),
                                                     target->deformed.sharedRender());
            })) {
            m_timer.start(0);
            return;
        }
    }
    auto job = std::make_shared<PlanJob>();
    for (const TargetId id : targets()) {
        job->parts.push_back({id, m_session.targets().find(id)->transform, m_copies.take(id)});
    }
    job->hits = m_wish->hits;
    job->scatter = m_wish->scatter;
    if (m_wish->scatter) {
        job->model = modelOn(m_session, *m_session.targets().find(m_wish->target));
        if (m_wish->selectedOnly) {
            job->selected.assign(chosen.begin(), chosen.end());
        }
    }
    m_job.start(*this, job, &HitPlanner::take);
}

void HitPlanner::take(PlanJob& job, bool done) {
    if (!done) {
        m_copies.clear();
        refuse(tr("There is not enough memory for so many hits."));
        return;
    }
    m_plan = std::move(job.plan);
    Q_EMIT planned();
}

}  // namespace hitscope
