// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/pipeline_trial.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <memory>
#include <vector>

#include "deform/reference.h"
#include "pipeline/trial_random.h"

namespace hitscope {
namespace {

constexpr std::size_t kTargets = 2;
constexpr std::uint32_t kSide = 9;       // clusters of the large target, in either direction
constexpr std::uint32_t kSmallSide = 2;  // of the small one
constexpr std::uint32_t kMissing = 30;   // vertices of the last cluster: as in most meshes it is not full
constexpr float kCell = 0.25f;           // metres of a cluster
constexpr std::size_t kHits = 46;
constexpr std::size_t kFirstForm = 18;  // hits before have the paper's function: there are programs for them
constexpr std::size_t kPollEvery = 4;   // steps: uniform arrays apply all hits again at each

using Vertices = std::array<std::vector<DynamicVertex>, kTargets>;

/// An edit of the history, and whether what came of it is looked at.
struct Step {
    HistoryEdit edit;
    bool isLook = false;
};

/// What every pipeline has to do, and what has to come of it.
struct Trial {
    std::array<RenderMesh, kTargets> meshes;
    std::vector<Hit> start;          ///< the history that it is reset to
    std::vector<Step> steps;         ///< from there on
    std::vector<Vertices> expected;  ///< at each look
};

TargetId idOf(std::size_t target) {
    return TargetId{static_cast<std::uint32_t>(target + 1)};
}

/// A bumpy plate, a cluster a cell.
RenderMesh plate(TrialRandom& random, std::uint32_t side) {
    RenderMesh mesh;
    for (std::uint32_t cell = 0; cell < side * side; ++cell) {
        Cluster cluster{cell * kClusterVertices, kClusterVertices, {}};
        cluster.count -= cell + 1 == side * side ? kMissing : 0;
        const glm::vec3 corner(static_cast<float>(cell % side), static_cast<float>(cell / side), 0.0f);
        for (std::uint32_t i = 0; i < cluster.count; ++i) {
            const glm::vec3 within(random.uniform(), random.uniform(), random.uniform());
            mesh.vertices.push_back({kCell * (corner + within), random.direction()});
            cluster.bounds.add(mesh.vertices.back().position);
            mesh.bounds.add(mesh.vertices.back().position);
        }
        mesh.clusters.push_back(cluster);
    }
    mesh.drawnVertices = static_cast<std::uint32_t>(mesh.vertices.size());
    return mesh;
}

/// Makes hits, knowing what those before have done.
class HitMaker {
public:
    HitMaker(TrialRandom& random, const Trial& trial)
        : m_random(random),
          m_done{ReferenceDeformation(trial.meshes[0]), ReferenceDeformation(trial.meshes[1])} {}

    Hit make(std::size_t index) {
        const std::size_t target = index % 6 == 5 ? 1 : 0;
        const std::span<const DynamicVertex> vertices = m_done[target].vertices();
        Hit hit;
        hit.target = idOf(target);
        hit.point = vertices[m_random.below(vertices.size())].position;
        if (index % 8 != 0) {  // else right on a vertex
            hit.point += 0.2f * m_random.uniform() * m_random.direction();
        }
        hit.direction = m_random.direction();
        hit.constants.maxDistance = 0.2f + 0.6f * m_random.uniform();
        hit.constants.power = 0.01f + 0.05f * m_random.uniform();
        hit.constants.maxMagnitude = 0.1f + 0.2f * m_random.uniform();
        if (index % 10 == 3) {  // all of the target, in one run
            hit.constants.maxDistance = 2.0f * kCell * static_cast<float>(kSide);
        } else if (index % 2 == 0) {  // as far as some vertex that lies where it has been pushed to
            rimOnVertex(hit, vertices);
        }
        if (index >= kFirstForm) {
            giveForm(hit, index);
        }
        m_done[target].apply(std::span(&hit, 1));
        return hit;
    }

private:
    /// Every profile and direction in turn, now and then the paper's among them.
    void giveForm(Hit& hit, std::size_t index) {
        constexpr std::size_t kProfiles = kDentProfileKeys.size();
        hit.form.profile = static_cast<DentProfile>(index % kProfiles);
        if (hit.form.profile == DentProfile::Curve) {
            std::generate(hit.form.curve.begin(), hit.form.curve.end(),
                          [this] { return 2.0f * m_random.uniform() - 1.0f; });
        }
        if (index % 4 == 1) {
            hit.form = {.radius = 0.5f * hit.constants.maxDistance, .direction = DentDirection::Press};
        } else if (index % 4 == 2) {
            hit.normal = m_random.direction();
            hit.form.direction = DentDirection::IntoSurface;
        }
        hit.form = plain(hit.form);
    }

    void rimOnVertex(Hit& hit, std::span<const DynamicVertex> vertices) {
        for (int tries = 0; tries < 64; ++tries) {
            const float distance =
                glm::distance(vertices[m_random.below(vertices.size())].position, hit.point);
            if (distance > 0.2f && distance < 0.8f) {
                hit.constants.maxDistance = distance;
                return;
            }
        }
    }

    TrialRandom& m_random;
    std::array<ReferenceDeformation, kTargets> m_done;
};

/// From scratch: as if nothing had been there before.
Vertices referenceAfter(const Trial& trial, std::span<const Hit> history) {
    Vertices result;
    for (std::size_t target = 0; target < kTargets; ++target) {
        std::vector<Hit> hits;
        std::copy_if(history.begin(), history.end(), std::back_inserter(hits),
                     [target](const Hit& hit) { return hit.target == idOf(target); });
        ReferenceDeformation reference(trial.meshes[target]);
        reference.apply(hits);
        result[target].assign(reference.vertices().begin(), reference.vertices().end());
    }
    return result;
}

/// Writes the steps down and follows them with the reference.
class Script {
public:
    Script(Trial& trial, std::vector<Hit> start) : m_trial(trial), m_history(std::move(start)) {
        m_trial.start = m_history;
    }

    void append(std::span<const Hit> hits) { edit(m_history.size(), 0, {hits.begin(), hits.end()}); }
    void remove(std::size_t index) { edit(index, 1, {}); }
    void insert(std::size_t index, const Hit& hit) { edit(index, 0, {hit}); }
    void makeWeaker(std::size_t index) {
        Hit hit = m_history[index];
        hit.constants.power *= 0.5f;
        edit(index, 1, {hit});
    }
    void look() {
        m_trial.steps.back().isLook = true;
        m_trial.expected.push_back(referenceAfter(m_trial, m_history));
    }

private:
    void edit(std::size_t first, std::size_t removed, std::vector<Hit> after) {
        const auto begin = m_history.begin() + static_cast<std::ptrdiff_t>(first);
        const auto end = begin + static_cast<std::ptrdiff_t>(removed);
        m_trial.steps.push_back({{first, {begin, end}, after}});
        m_history.insert(m_history.erase(begin, end), after.begin(), after.end());
    }

    Trial& m_trial;
    std::vector<Hit> m_history;
};

Trial makeTrial() {
    TrialRandom random(7);
    Trial trial;
    trial.meshes = {plate(random, kSide), plate(random, kSmallSide)};
    std::vector<Hit> hits;
    HitMaker maker(random, trial);
    for (std::size_t i = 0; i < kHits; ++i) {
        hits.push_back(maker.make(i));
    }
    const std::span<const Hit> all(hits);
    Script script(trial, {hits.begin(), hits.begin() + 12});
    for (std::size_t i = 12; i < 18; ++i) {  // as they arrive
        script.append(all.subspan(i, 1));
    }
    script.look();
    script.append(all.subspan(18, 16));  // all at once
    script.look();
    script.remove(30);  // among the last: taken back and done again
    script.insert(30, hits[30]);
    script.remove(4);  // long past: its clusters start over
    script.look();
    script.insert(4, hits[4]);
    script.makeWeaker(8);
    script.append(all.subspan(34));
    script.look();
    return trial;
}

const Trial& theTrial() {
    static const Trial kTrial = makeTrial();
    return kTrial;
}

/// What a receiver of read-backs has.
class Receiver {
public:
    explicit Receiver(const Trial& trial) {
        for (std::size_t target = 0; target < kTargets; ++target) {
            const auto& vertices = trial.meshes[target].vertices;
            m_vertices[target].assign(vertices.begin(), vertices.end());
        }
    }
    [[nodiscard]] ReadBackSink sink() {
        return [this](TargetId id, std::uint32_t first, std::span<const DynamicVertex> vertices) {
            std::copy(vertices.begin(), vertices.end(),
                      m_vertices.at(id.value - 1).begin() + static_cast<std::ptrdiff_t>(first));
        };
    }
    [[nodiscard]] const Vertices& vertices() const { return m_vertices; }

private:
    Vertices m_vertices;
};

}  // namespace

PipelineVerdict tryPipeline(PipelineKind kind, const PipelineOptions& options) {
    PipelineVerdict verdict;
    const Trial& trial = theTrial();
    std::vector<TargetBuffers> buffers;
    buffers.reserve(kTargets);
    PipelineOptions late = options;
    late.startsBuffersLate = true;
    Result<std::unique_ptr<DeformationPipeline>> made = makePipeline(kind, late);
    if (!made) {
        verdict.whyNot = made.error().what;
        return verdict;
    }
    DeformationPipeline& pipeline = *made.value();
    for (std::size_t target = 0; target < kTargets; ++target) {
        pipeline.addTarget(idOf(target), buffers.emplace_back(trial.meshes[target]));
    }
    Receiver receiver(trial);
    pipeline.reset(trial.start);
    auto expected = trial.expected.begin();
    for (std::size_t i = 0; i < trial.steps.size(); ++i) {
        pipeline.edit(trial.steps[i].edit);
        if (!trial.steps[i].isLook) {
            if (i % kPollEvery == 0) {
                pipeline.pollReadBack(receiver.sink());
            }
            continue;
        }
        pipeline.readBack(receiver.sink());
        for (std::size_t target = 0; target < kTargets; ++target) {
            verdict.compared.add(receiver.vertices()[target], (*expected)[target]);
        }
        ++expected;
    }
    return verdict;
}

}  // namespace hitscope
