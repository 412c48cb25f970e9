// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/pipeline_agreement.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stop_token>
#include <utility>

#include "deform/reference.h"

namespace hitscope {

namespace {

constexpr qint64 kBetweenComparisons = 500;  // milliseconds

}  // namespace

/// One target on the other thread: what the pipeline made, and what the reference makes of the same hits.
class PipelineAgreement::Copy {
public:
    explicit Copy(const Target& target)
        : m_id(target.id),
          m_mesh(target.deformed.sharedOriginal()),
          m_render(target.deformed.sharedRender()),
          m_positions(m_mesh->positions) {}

    void follow(std::span<const MovedVertex> moved) {
        for (const MovedVertex& vertex : moved) {
            m_positions[vertex.vertex] = vertex.position;
        }
    }

    /// More hits are applied to what there is; any other change starts over.
    void apply(std::vector<Hit> hits) {
        const bool continues = m_reference && hits.size() >= m_applied.size() &&
                               std::equal(m_applied.begin(), m_applied.end(), hits.begin());
        if (!continues) {
            m_reference = std::make_unique<ReferenceDeformation>(*m_render);
            m_applied.clear();
        }
        m_reference->apply(std::span<const Hit>(hits).subspan(m_applied.size()));
        m_applied = std::move(hits);
    }

    /// Adds to the report; its rootMeanSquare is the sum of squares until all are in.
    void compare(AgreementReport& report) const {
        for (std::uint32_t v = 0; v < m_positions.size(); ++v) {
            ++report.vertices;
            const glm::vec3& should = m_reference->vertices()[m_render->renderVerticesOf(v).front()].position;
            if (m_positions[v] == should) {
                continue;
            }
            ++report.different;
            const double distance = glm::length(glm::dvec3(m_positions[v]) - glm::dvec3(should));
            report.rootMeanSquare += distance * distance;
            if (!report.worst || distance > report.largest) {
                report.largest = distance;
                report.worst = VertexRef{m_id, v};
            }
        }
        report.hits += m_applied.size();
    }

    [[nodiscard]] TargetId id() const { return m_id; }

private:
    TargetId m_id;
    std::shared_ptr<const MeshData> m_mesh;
    std::shared_ptr<const RenderMesh> m_render;
    PageCopy<glm::vec3> m_positions;
    std::unique_ptr<ReferenceDeformation> m_reference;
    std::vector<Hit> m_applied;
};

struct PipelineAgreement::Job {
    std::vector<CopiedTargets<Copy>::Part> parts;
    HistoryCopy::Update update;
    std::shared_ptr<HistoryCopy> history;
    AgreementReport report;

    void run(const std::stop_token& stop) {
        history->apply(update);
        std::map<TargetId, std::vector<Hit>> hits;
        for (const Hit& hit : history->hits()) {
            if (hit.enabled) {
                hits[hit.target].push_back(hit);
            }
        }
        for (const auto& part : parts) {
            if (stop.stop_requested()) {
                return;
            }
            part.copy->follow(part.moved);
            part.copy->apply(std::move(hits[part.copy->id()]));
            part.copy->compare(report);
        }
        const double vertices = static_cast<double>(std::max<std::size_t>(report.vertices, 1));
        report.rootMeanSquare = std::sqrt(report.rootMeanSquare / vertices);
    }
};

PipelineAgreement::PipelineAgreement(Session& session, QObject* parent)
    : QObject(parent), m_session(session) {
    m_job.showIn(session.tasks(), tr("Comparing with the reference"));
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &PipelineAgreement::gather);
    connect(&session, &Session::sceneReplaced, this, &PipelineAgreement::startOver);
    connect(&session.targets(), &SessionTargets::removed, this, &PipelineAgreement::startOver);
    connect(&session.targets(), &SessionTargets::added, this, &PipelineAgreement::noteChange);
    connect(&session.hits(), &SessionHits::appended, this, &PipelineAgreement::noteChange);
    connect(&session.hits(), &SessionHits::reset, this, &PipelineAgreement::noteChange);
    connect(&session.settings(), &SessionSettings::pipelineChanged, this, &PipelineAgreement::noteChange);
    connect(&session.hits(), &SessionHits::shownChanged, this, &PipelineAgreement::noteChange);
    connect(&session.readBack(), &ReadBack::verticesMoved, this,
            [this](TargetId id, const std::vector<std::uint32_t>& vertices) {
                const Target* target = m_session.targets().find(id);
                if (target != nullptr) {
                    m_copies.note(*target, vertices);
                }
                noteChange();
            });
}

PipelineAgreement::~PipelineAgreement() = default;

/// The copies may be in use: a job that has them is given up with them.
void PipelineAgreement::stop() {
    m_timer.stop();
    m_job.cancel();
    m_history.startOver();
    m_copies.clear();
    m_isGathering = false;
}

void PipelineAgreement::startOver() {
    const bool wasComparing = isComparing();
    stop();
    m_report.reset();
    Q_EMIT reported();
    if (wasComparing) {
        compare();
    } else {
        noteChange();
    }
}

void PipelineAgreement::noteChange() {
    const bool wasOutOfDate = isOutOfDate();
    m_hasChanged = true;
    m_isReportOld = true;
    m_isGathering = false;  // what was taken is of another state: it is brought up to date
    if (m_continuous && !isComparing()) {
        m_timer.start(m_job.pause(kBetweenComparisons));
    }
    if (isOutOfDate() != wasOutOfDate) {
        Q_EMIT reported();
    }
}

void PipelineAgreement::setContinuous(bool on) {
    if (on != m_continuous) {
        m_continuous = on;
        if (on) {
            compare();
        }
    }
}

void PipelineAgreement::compare() {
    if (!isComparing()) {
        m_timer.start(0);
        Q_EMIT reported();
    }
}

/// Carries over what has moved, over several turns of the event loop if it is much, and all of it in one
/// state of the session; then starts.
void PipelineAgreement::gather() {
    if (!m_isGathering) {
        if (m_sync && !m_sync()) {
            Q_EMIT reported();
            return;
        }
        m_isGathering = true;
    }
    auto room = m_copies.kATurn;
    bool isAll = true;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        isAll = m_copies.gather(*target, room, [&] { return std::make_shared<Copy>(*target); }) && isAll;
    }
    if (isAll) {
        start();
    } else {
        m_timer.start(0);
    }
}

void PipelineAgreement::start() {
    m_isGathering = false;
    // What m_sync() brought is in this comparison: it is no reason for another beside it.
    m_timer.stop();
    m_hasChanged = false;
    auto job = std::make_shared<Job>();
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        job->parts.push_back(m_copies.take(target->id));
    }
    job->update = m_history.update(m_session.hits().history(), m_session.hits().applied());
    job->history = m_history.copy();
    job->report.dropped = m_session.readBack().droppedHits();
    job->report.later = m_session.hits().history().size() - m_session.hits().shown().size();
    job->report.pipeline = m_session.settings().pipeline();
    m_job.start(*this, job, &PipelineAgreement::take);
}

void PipelineAgreement::take(Job& job, bool done) {
    if (done) {
        m_report = job.report;
        m_isReportOld = m_hasChanged;
    } else {
        stop();  // there was no memory
    }
    if (m_hasChanged && done) {
        noteChange();
    }
    Q_EMIT reported();
}

}  // namespace hitscope
