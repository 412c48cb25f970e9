// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/hit_size.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "cli/bench/sphere.h"
#include "cli/bench_gl/paper_feedback.h"
#include "gl/context.h"

namespace hitscope::bench {

namespace {

using Method = HitFigure::Method;

constexpr TargetId kTarget{1};
constexpr int kHitsASample = 100;  // a single hit is too short for the clock
constexpr int kCopiesASample = 2000;
constexpr int kSmallMesh = 100000;  // vertices; above, one hit the paper's way is long enough

// Measured with 4,000,000 vertices, and a little more: the mesh with the yardsticks; a pipeline's buffers and
// state.
constexpr double kMeshBytes = 300.0;
constexpr double kPipelineBytes = 120.0;

/// A pipeline with the sphere as its only target.
struct Entrant {
    PipelineKind kind;
    std::unique_ptr<TargetBuffers> buffers;
    std::unique_ptr<DeformationPipeline> pipeline;  // below the buffers it is given, so that it goes first
    bool keepsFew = false;

    void pollReadBack() const {
        pipeline->pollReadBack([](TargetId, std::uint32_t, std::span<const DynamicVertex>) {});
    }
    void readBack() const {
        pipeline->readBack([](TargetId, std::uint32_t, std::span<const DynamicVertex>) {});
    }
    void restore() const {
        pipeline->reset({});
        readBack();
        gl::finish();
    }
};

/// What one variant has for itself.
struct Run {
    HitFigure figure;
    int frames = 1;  ///< a sample
    RandomHits random;
    std::vector<Hit> hits;                 ///< of the sample to come
    std::vector<std::uint32_t> addresses;  ///< for Method::Copy: first vertices
};

}  // namespace

struct HitSizeBench::Private {
    RenderMesh mesh;
    DeformationConstants constants;
    HitOptions options;
    QStringList notes;
    std::vector<std::unique_ptr<Entrant>> entrants;
    std::optional<PaperFeedback> paper;
    std::vector<DynamicVertex> copy;
    std::vector<std::unique_ptr<Run>> runs;

    void enter(const BenchRoom& room, PipelineKind kind);
    Run& addRun(Method method, PipelineKind kind, int hitsAFrame, int frames);
    Variant pipelineVariant(Entrant& entrant, int hitsAFrame, Method method);
    Variant paperVariant();
    Variant copyVariant();
};

HitSizeBench::HitSizeBench() : d(std::make_unique<Private>()) {}
HitSizeBench::~HitSizeBench() = default;

std::size_t HitSizeBench::vertexCount() const {
    return d->mesh.vertices.size();
}
const DeformationConstants& HitSizeBench::constants() const {
    return d->constants;
}
const QStringList& HitSizeBench::notes() const {
    return d->notes;
}

Result<std::unique_ptr<HitSizeBench>> HitSizeBench::create(const BenchRoom& room, int vertices,
                                                           const HitOptions& options) {
    const double bytes =
        vertices * (kMeshBytes + kPipelineBytes * static_cast<double>(options.pipelines.size()));
    if (const QString why = whyItDoesNotFit(bytes); !why.isEmpty()) {
        return Error{"This size is left out: " + why.toStdString() + ".",
                     grouped(static_cast<qulonglong>(vertices)).toStdString() + " vertices",
                     "Name fewer --pipelines."};
    }
    std::unique_ptr<HitSizeBench> bench(new HitSizeBench);
    Private& d = *bench->d;
    d.options = options;
    d.mesh = buildRenderMesh(makeSphere(vertices));
    const auto made = static_cast<double>(d.mesh.vertices.size());
    d.constants = constantsReaching(options.affected, made, static_cast<double>(kSphereRadius));
    for (const PipelineKind kind : options.pipelines) {
        d.enter(room, kind);
    }
    if (options.yardsticks) {
        Result<PaperFeedback> paper =
            PaperFeedback::create(d.mesh.vertices, room.pipelineOptions().deformDefines);
        if (!paper) {
            return paper.error();
        }
        d.paper = std::move(paper).value();
        d.copy.assign(d.mesh.vertices.begin(), d.mesh.vertices.end());
    }
    if (Status status = noGlErrors(); !status) {
        return status.error();
    }
    return bench;
}

void HitSizeBench::Private::enter(const BenchRoom& room, PipelineKind kind) {
    Result<std::unique_ptr<DeformationPipeline>> made = room.makePipeline(kind);
    if (!made) {
        notes << QStringLiteral("%1 cannot run here: %2")
                     .arg(pipelineName(kind), QString::fromStdString(made.error().message()));
        return;
    }
    auto entrant = std::make_unique<Entrant>();
    entrant->kind = kind;
    entrant->buffers = std::make_unique<TargetBuffers>(mesh);
    entrant->pipeline = std::move(made).value();
    entrant->keepsFew = entrant->pipeline->capacity().capacity.has_value();
    entrant->pipeline->addTarget(kTarget, *entrant->buffers);
    entrants.push_back(std::move(entrant));
}

Run& HitSizeBench::Private::addRun(Method method, PipelineKind kind, int hitsAFrame, int frames) {
    RandomHits random({{kTarget, &mesh}}, constants, options.seed);
    HitFigure figure;
    figure.method = method;
    figure.pipeline = kind;
    figure.hitsAFrame = hitsAFrame;
    RandomHits first = random;
    figure.affected = countAffected(mesh, first.next(static_cast<std::size_t>(hitsAFrame * frames)));
    runs.push_back(std::make_unique<Run>(Run{std::move(figure), frames, std::move(random), {}, {}}));
    return *runs.back();
}

Variant HitSizeBench::Private::pipelineVariant(Entrant& entrant, int hitsAFrame, Method method) {
    const int frames = std::max(1, kHitsASample / hitsAFrame);
    Run* run = &addRun(method, entrant.kind, hitsAFrame, frames);
    Entrant* entry = &entrant;
    Variant variant;
    variant.name = pipelineTraits(entrant.kind).name;
    variant.units = static_cast<double>(frames) * hitsAFrame;
    variant.prepare = [run, entry, hitsAFrame, besideForm = options.besideForm]() -> Status {
        entry->restore();
        run->hits = run->random.next(static_cast<std::size_t>(run->frames * hitsAFrame));
        for (std::size_t i = 0; besideForm && i < run->hits.size(); ++i) {
            if ((i + 1) % static_cast<std::size_t>(hitsAFrame) == 0) {
                run->hits[i].form.profile = DentProfile::Wendland;
            }
        }
        return Done{};
    };
    variant.run = [run, entry, hitsAFrame, method]() -> Status {
        const auto count = static_cast<std::size_t>(hitsAFrame);
        for (std::size_t frame = 0; frame < static_cast<std::size_t>(run->frames); ++frame) {
            entry->pipeline->append(std::span<const Hit>(run->hits).subspan(frame * count, count));
            if (method == Method::WithReadBack) {
                entry->pollReadBack();
            }
        }
        if (method == Method::WithReadBack) {
            entry->readBack();  // a poll asks for so many vertices at most, and takes only what has arrived
        }
        gl::finish();
        return Done{};
    };
    return variant;
}

Variant HitSizeBench::Private::paperVariant() {
    const int hits = mesh.vertices.size() < kSmallMesh ? 10 : 1;
    Run* run = &addRun(Method::PaperFeedback, PipelineKind::TransformFeedback, 1, hits);
    Variant variant;
    variant.name = "the paper's own way";
    variant.units = hits;
    variant.prepare = [this, run]() -> Status {
        paper->restore(mesh.vertices);
        gl::finish();
        run->hits = run->random.next(static_cast<std::size_t>(run->frames));
        return Done{};
    };
    variant.run = [this, run]() -> Status {
        for (const Hit& hit : run->hits) {
            paper->apply(hit);
        }
        gl::finish();
        return Done{};
    };
    return variant;
}

Variant HitSizeBench::Private::copyVariant() {
    Run* run = &addRun(Method::Copy, PipelineKind::TransformFeedback, 1, kHitsASample);
    const auto count = static_cast<std::size_t>(run->figure.affected + 0.5);
    Variant variant;
    variant.name = "memcpy";
    variant.units = kCopiesASample;
    variant.prepare = [this, run, count]() -> Status {
        std::mt19937 random(options.seed + static_cast<std::uint32_t>(run->addresses.size()));
        const auto last =
            static_cast<std::uint32_t>(mesh.vertices.size() - std::min(count, mesh.vertices.size()));
        run->addresses.resize(kCopiesASample);
        for (std::uint32_t& address : run->addresses) {
            address = static_cast<std::uint32_t>(random()) % (last + 1);
        }
        return Done{};
    };
    variant.run = [this, run, count]() -> Status {
        for (const std::uint32_t address : run->addresses) {
            std::memcpy(static_cast<void*>(copy.data() + address), mesh.vertices.data() + address,
                        count * sizeof(DynamicVertex));
        }
        return Done{};
    };
    return variant;
}

bool HitSizeBench::isReadBackPending() const {
    return std::any_of(d->entrants.begin(), d->entrants.end(), [](const std::unique_ptr<Entrant>& entrant) {
        return entrant->pipeline->isReadBackPending();
    });
}

// A uniform array is read back by computing every vertex anew, as it is drawn: that is a frame's cost, not a
// hit's.
std::vector<Variant> HitSizeBench::variants() {
    d->runs.clear();
    std::vector<Variant> variants;
    for (const std::unique_ptr<Entrant>& entrant : d->entrants) {
        for (const int hitsAFrame : d->options.hitsAFrame) {
            variants.push_back(d->pipelineVariant(*entrant, hitsAFrame, Method::Pipeline));
            if (d->options.readBack && !entrant->keepsFew) {
                variants.push_back(d->pipelineVariant(*entrant, hitsAFrame, Method::WithReadBack));
            }
        }
    }
    if (d->options.yardsticks) {
        variants.push_back(d->paperVariant());
        variants.push_back(d->copyVariant());
    }
    return variants;
}

std::vector<HitFigure> HitSizeBench::figures(std::span<const Samples> samples) const {
    std::vector<HitFigure> figures;
    for (std::size_t i = 0; i < d->runs.size(); ++i) {
        figures.push_back(d->runs[i]->figure);
        figures.back().hits = samples[i];
    }
    return figures;
}

const HitFigure* findFigure(const std::vector<HitFigure>& figures, HitFigure::Method method,
                            PipelineKind pipeline, int hitsAFrame) {
    const bool ofPipeline = method == Method::Pipeline || method == Method::WithReadBack;
    const auto found = std::find_if(figures.begin(), figures.end(), [&](const HitFigure& figure) {
        return figure.method == method &&
               (!ofPipeline || (figure.pipeline == pipeline && figure.hitsAFrame == hitsAFrame));
    });
    return found == figures.end() ? nullptr : &*found;
}

}  // namespace hitscope::bench
