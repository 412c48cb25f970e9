// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/paper_row.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "cli/bench/texture.h"
#include "mesh/panel_texture.h"

namespace hitscope::bench {

/// A variant while it is measured.
struct RowBench::Entrant {
    RowFigure figure;
    std::unique_ptr<Scene> scene;
    std::optional<RandomHits> arriving;

    Status drawFrames(int count) {
        for (int frame = 0; frame < count; ++frame) {
            if (frame == 0 && arriving) {
                const Hit hit = arriving->next();
                scene->append({&hit, 1});
            }
            if (Status status = scene->draw(); !status) {
                return status;
            }
        }
        return Done{};
    }
};

RowBench::RowBench(const BenchRoom& room, const RowOptions& options) : m_room(room), m_options(options) {
    std::erase_if(m_options.pipelines, [this](PipelineKind kind) {
        const Result<std::unique_ptr<DeformationPipeline>> pipeline = m_room.makePipeline(kind);
        if (!pipeline) {
            m_unavailable[kind] = pipeline.error().message();
            return true;
        }
        m_keepsFew[kind] = pipeline.value()->capacity().capacity.has_value();
        return false;
    });
}

// Two pipelines in turn on one renderer would overwrite each other's uniform arrays in every frame.
Result<Renderer*> RowBench::rendererOf(PipelineKind pipeline) {
    std::unique_ptr<Renderer>& renderer = m_renderers[pipeline];
    if (!renderer) {
        Result<std::unique_ptr<Renderer>> made = Renderer::create();
        if (!made) {
            return made.error();
        }
        renderer = std::move(made).value();
    }
    return renderer.get();
}

Result<std::shared_ptr<const MaterialSet>> RowBench::makeTextures(int size) {
    Result<Renderer*> renderer = rendererOf(PipelineKind::TransformFeedback);
    if (!renderer) {
        return renderer.error();
    }
    return renderer.value()->makeMaterials(textureCarrier(makePanelTexture(size)));
}

Result<std::vector<std::unique_ptr<RowBench::Entrant>>> RowBench::enter(const RowParts& parts) {
    std::vector<std::unique_ptr<Entrant>> entrants;
    for (const PipelineKind kind : m_options.pipelines) {
        Result<Renderer*> renderer = rendererOf(kind);
        if (!renderer) {
            return renderer.error();
        }
        for (const RowFigure& figure : figuresOf(kind)) {
            Result<std::unique_ptr<Entrant>> entrant = makeEntrant(parts, figure, *renderer.value());
            if (!entrant) {
                return entrant.error();
            }
            entrants.push_back(std::move(entrant).value());
        }
    }
    return entrants;
}

/// What is to be measured of a pipeline.
std::vector<RowFigure> RowBench::figuresOf(PipelineKind kind) const {
    const int hitEvery = m_keepsFew.at(kind) ? 0 : m_options.hitEvery;
    std::vector<RowFigure> figures;
    const auto add = [&](HitsBy by, int every) {
        RowFigure& figure = figures.emplace_back();
        figure.pipeline = kind;
        figure.by = by;
        figure.hitEvery = every;
    };
    if (hitEvery > 0) {
        add(HitsBy::Pipeline, hitEvery);
    }
    if (hitEvery > 0 && m_options.papersWay && kind == PipelineKind::TransformFeedback) {
        add(HitsBy::Paper, hitEvery);
    }
    add(HitsBy::Pipeline, 0);
    return figures;
}

Result<std::unique_ptr<RowBench::Entrant>> RowBench::makeEntrant(const RowParts& parts,
                                                                 const RowFigure& figure,
                                                                 Renderer& renderer) {
    Result<std::unique_ptr<DeformationPipeline>> pipeline = m_room.makePipeline(figure.pipeline);
    if (!pipeline) {
        return pipeline.error();
    }
    Result<std::unique_ptr<Scene>> scene =
        makeEngineScene(parts, std::move(pipeline).value(), renderer, m_room.picture(), figure.by,
                        m_room.pipelineOptions().deformDefines);
    if (!scene) {
        return scene.error();
    }
    auto entrant = std::make_unique<Entrant>();
    entrant->scene = std::move(scene).value();
    RandomHits hits(entrant->scene->hitTargets(), DeformationConstants(), m_options.seed);
    entrant->scene->append(hits.next(kPaperHits));
    entrant->figure = figure;
    if (figure.hitEvery > 0) {
        entrant->arriving = std::move(hits);
    }
    return entrant;
}

Result<std::vector<RowFigure>> RowBench::measure(int row, const std::shared_ptr<const MaterialSet>& materials,
                                                 const QString& what) {
    const RowParts parts{planRow(paperRows()[static_cast<std::size_t>(row)], materials != nullptr),
                         materials};
    Result<std::vector<std::unique_ptr<Entrant>>> entered = enter(parts);
    if (!entered) {
        return entered.error();
    }
    std::vector<Variant> variants;
    for (const std::unique_ptr<Entrant>& entrant : entered.value()) {
        Entrant* entry = entrant.get();
        // Blocks of as many frames as lie between two hits, so that with and without are the same but for the
        // hit.
        const int block = m_keepsFew.at(entry->figure.pipeline) ? 1 : std::max(m_options.hitEvery, 1);
        const std::string_view name = entry->figure.by == HitsBy::Paper
                                          ? "The paper's way"
                                          : pipelineTraits(entry->figure.pipeline).name;
        variants.push_back({std::string(name), static_cast<double>(block), {}, [entry, block] {
                                return entry->drawFrames(block);
                            }});
    }
    Result<std::vector<Samples>> samples = m_room.measure(what, variants, m_options.plan);
    if (!samples) {
        return samples.error();
    }
    std::vector<RowFigure> figures;
    for (std::size_t i = 0; i < variants.size(); ++i) {
        Entrant& entrant = *entered.value()[i];
        entrant.figure.hitsKept = kPaperHits - std::min(kPaperHits, entrant.scene->droppedHits());
        entrant.figure.frames = samples.value()[i];
        figures.push_back(std::move(entrant.figure));
    }
    return figures;
}

const RowFigure* findFigure(const std::vector<RowFigure>& figures, PipelineKind pipeline, bool hitsArrive) {
    const auto found = std::find_if(figures.begin(), figures.end(), [&](const RowFigure& figure) {
        return figure.pipeline == pipeline && figure.by == HitsBy::Pipeline &&
               (figure.hitEvery > 0) == hitsArrive;
    });
    return found == figures.end() ? nullptr : &*found;
}

const RowFigure* findPapersWay(const std::vector<RowFigure>& figures) {
    const auto found = std::find_if(figures.begin(), figures.end(),
                                    [](const RowFigure& figure) { return figure.by == HitsBy::Paper; });
    return found == figures.end() ? nullptr : &*found;
}

const RowFigure* findFigure(const std::vector<RowFigure>& figures, PipelineKind pipeline) {
    const RowFigure* arriving = findFigure(figures, pipeline, true);
    return arriving != nullptr ? arriving : findFigure(figures, pipeline, false);
}

}  // namespace hitscope::bench
