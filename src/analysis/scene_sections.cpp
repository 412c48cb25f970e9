// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene_sections.h"

#include <stop_token>
#include <utility>

#include "analysis/beside.h"
#include "session/target.h"

namespace hitscope {

namespace {

constexpr std::size_t kMostAtOnce = 40'000;  // vertices carried over in one turn of the event loop

bool isSame(const RigidTransform& a, const RigidTransform& b) {
    return a.position == b.position && a.rotation == b.rotation;
}

/// What lines are drawn changes nothing about the section.
bool isSamePlane(const CuttingPlane& a, const CuttingPlane& b) {
    return a.on == b.on && a.normal == b.normal && a.offset == b.offset && a.flipped == b.flipped;
}

}  // namespace

/// What the other thread works on; it touches nothing else.
struct SceneSections::Job {
    struct Part {
        TargetId id;
        QString name;
        std::shared_ptr<SectionedTarget> target;
        std::vector<MovedVertex> moved;
        RigidTransform transform;
        bool visible = true;
    };
    std::vector<Part> parts;
    CuttingPlane cut;
    float exaggeration = 1.0f;
    std::stop_source source;
    std::shared_ptr<const SceneSection> made;  ///< null: it was stopped, or there was no memory

    void run() {
        auto section = std::make_shared<SceneSection>();
        auto lines = std::make_shared<SectionLines>();
        section->cut = cut;
        for (Part& part : parts) {
            if (source.stop_requested()) {
                return;  // the copies are thrown away with it
            }
            part.target->follow(part.moved);
            if (!part.visible) {
                continue;
            }
            TargetSection found = part.target->cut(cut.plane(), part.transform);
            part.target->addLines(*lines, found, cut.plane(), part.transform, exaggeration);
            if (!found.original.empty() || !found.deformed.empty()) {
                found.target = part.id;
                found.name = part.name;
                section->targets.push_back(std::move(found));
            }
        }
        section->lines = std::move(lines);
        made = std::move(section);
    }
};

SceneSections::SceneSections(Session& session, QObject* parent)
    : SceneSections(
          session, [](const Target& target) { return &target.deformed; }, parent) {
    connect(&session, &Session::verticesMoved, this, &SceneSections::note);
}

SceneSections::SceneSections(Session& session, Shapes shapes, QObject* parent)
    : QObject(parent), m_session(session), m_shapes(std::move(shapes)) {
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &SceneSections::gather);
    connect(&session, &Session::sceneReplaced, this, &SceneSections::forget);
    connect(&session, &Session::targetRemoved, this, &SceneSections::forget);
    connect(&session, &Session::targetAdded, this, &SceneSections::request);
    connect(&session, &Session::targetChanged, this, &SceneSections::request);
    connect(&session, &Session::pictureChanged, this, &SceneSections::followPlaces);
}

SceneSections::~SceneSections() {
    if (m_job) {
        m_job->source.request_stop();
    }
}

/// A copy may be in use: the job that has it is given up with it.
void SceneSections::forget() {
    if (m_job) {
        m_job->source.request_stop();
        m_job.reset();
    }
    m_due = false;
    m_timer.stop();
    m_copies.clear();
    m_gathered.clear();
    m_moved.clear();
    if (m_section) {
        m_section.reset();
        Q_EMIT changed();
    }
    request();
}

void SceneSections::setCut(const CuttingPlane& cut, float exaggeration) {
    const bool isSameCut = isSamePlane(cut, m_cut) && exaggeration == m_exaggeration;
    m_cut = cut;
    m_exaggeration = exaggeration;
    if (!cut.on) {
        if (!m_copies.empty() || m_section || m_due) {
            forget();
        }
    } else if (!isSameCut) {
        request();
    }
}

void SceneSections::note(TargetId id, const std::vector<std::uint32_t>& vertices) {
    const Target* target = m_session.target(id);
    if (target != nullptr && m_copies.contains(id)) {
        m_moved.note(*target, vertices);
        request();
    }
}

/// Dynamic targets move without saying so each time.
void SceneSections::followPlaces() {
    for (const auto& [id, copy] : m_copies) {
        const Target* target = m_session.target(id);
        if (target != nullptr && !isSame(target->transform, copy.transform)) {
            request();
            return;
        }
    }
}

/// Not right here: moved vertices are reported in the middle of drawing a frame.
void SceneSections::request() {
    if (!m_cut.on) {
        return;
    }
    m_due = true;
    if (!m_job && !m_timer.isActive()) {
        m_timer.start(0);
    }
}

/// Carries over what has moved, over several turns of the event loop if it is much; then starts.
void SceneSections::gather() {
    if (m_job || !m_due) {
        return;
    }
    std::size_t room = kMostAtOnce;
    bool isAll = true;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        const DeformedMesh* shape = m_shapes(*target);
        const std::span<const glm::vec3> positions =
            shape != nullptr ? shape->positions() : target->deformed.original().positions;
        Copy& copy = m_copies[target->id];
        if (!copy.target) {
            copy.target = std::make_shared<SectionedTarget>(target->deformed.sharedRender());
            if (shape != nullptr) {
                m_moved.note(*target, shape->everChanged());
            }
        }
        copy.transform = target->transform;
        copy.visible = target->visible;
        isAll = m_moved.take(target->id, positions, room, m_gathered[target->id]) && isAll;
    }
    if (isAll) {
        start();
    } else {
        m_timer.start(0);
    }
}

void SceneSections::start() {
    m_due = false;
    auto job = std::make_shared<Job>();
    job->cut = m_cut;
    job->exaggeration = m_exaggeration;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        const Copy& copy = m_copies.at(target->id);
        job->parts.push_back({target->id, target->name, copy.target,
                              std::exchange(m_gathered[target->id], {}), copy.transform, copy.visible});
    }
    m_job = job;
    workBeside(
        this, [job] { job->run(); }, [job](SceneSections& self, bool done) { self.take(*job, done); });
}

void SceneSections::take(const Job& job, bool done) {
    if (m_job.get() != &job) {
        return;  // given up
    }
    m_job.reset();
    if (!done) {
        m_copies.clear();  // there is no section; everything else goes on
        m_moved.clear();
        m_due = false;
        return;
    }
    m_section = job.made;
    Q_EMIT changed();
    if (m_due) {
        m_timer.start(0);
    }
}

}  // namespace hitscope
