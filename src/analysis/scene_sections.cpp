// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene_sections.h"

#include <utility>

#include "session/target.h"

namespace hitscope {

namespace {

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
        CopiedTargets<SectionedTarget>::Part target;
        Place place;
    };
    std::vector<Part> parts;
    CuttingPlane cut;
    float exaggeration = 1.0f;
    std::shared_ptr<const SceneSection> made;  ///< null: it was stopped, or there was no memory

    void run(const std::stop_token& stop) {
        auto section = std::make_shared<SceneSection>();
        auto lines = std::make_shared<SectionLines>();
        section->cut = cut;
        for (Part& part : parts) {
            if (stop.stop_requested()) {
                return;  // the copies are thrown away with it
            }
            SectionedTarget& target = *part.target.copy;
            target.follow(part.target.moved);
            if (!part.place.visible) {
                continue;
            }
            TargetSection found = target.cut(cut.plane(), part.place.transform);
            target.addLines(*lines, found, cut.plane(), part.place.transform, exaggeration);
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
    connect(&session.readBack(), &ReadBack::verticesMoved, this, &SceneSections::note);
}

SceneSections::SceneSections(Session& session, Shapes shapes, QObject* parent)
    : QObject(parent), m_session(session), m_shapes(std::move(shapes)) {
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &SceneSections::gather);
    connect(&session, &Session::sceneReplaced, this, &SceneSections::forget);
    connect(&session.targets(), &SessionTargets::removed, this, &SceneSections::forget);
    connect(&session.targets(), &SessionTargets::added, this, &SceneSections::request);
    connect(&session.targets(), &SessionTargets::changed, this, &SceneSections::request);
    connect(&session, &Session::pictureChanged, this, &SceneSections::followPlaces);
}

SceneSections::~SceneSections() = default;

/// A copy may be in use: the job that has it is given up with it.
void SceneSections::forget() {
    m_job.cancel();
    m_due = false;
    m_timer.stop();
    m_copies.clear();
    m_places.clear();
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
    const Target* target = m_session.targets().find(id);
    if (target != nullptr && m_copies.note(*target, vertices)) {
        request();
    }
}

/// Dynamic targets move without saying so each time.
void SceneSections::followPlaces() {
    for (const auto& [id, place] : m_places) {
        const Target* target = m_session.targets().find(id);
        if (target != nullptr && !isSame(target->transform, place.transform)) {
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
    if (!m_job.isRunning() && !m_timer.isActive()) {
        m_timer.start(0);
    }
}

/// Carries over what has moved, over several turns of the event loop if it is much; then starts.
void SceneSections::gather() {
    if (m_job.isRunning() || !m_due) {
        return;
    }
    auto room = m_copies.kATurn;
    bool isAll = true;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        m_places[target->id] = {target->transform, target->visible};
        isAll = m_copies.gather(*target, m_shapes(*target), room, [&] {
            return std::make_shared<SectionedTarget>(target->deformed.sharedRender());
        }) && isAll;
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
        job->parts.push_back({target->id, target->name, m_copies.take(target->id), m_places.at(target->id)});
    }
    m_job.start(*this, job, &SceneSections::take);
}

void SceneSections::take(Job& job, bool done) {
    if (!done) {
        m_copies.clear();  // there is no section; everything else goes on
        m_places.clear();
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
