// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/repeat_options.h"

#include "analysis/hit_planner.h"
#include "cli/progress_line.h"
#include "deform/mirrored_hits.h"
#include "deform/scattered_hits.h"

namespace hitscope::cli {

namespace {

constexpr double kMostDensity = 1.0e12;  // per square metre
constexpr double kMostSpread = 95.0;     // per cent

Status addGroup(Session& session, HitGroupKind kind, const std::vector<Hit>& hits) {
    const Result<HitGroup> group = session.hits().addGroup(kind, hits);
    return group ? Status(Done{}) : Status(group.error());
}

}  // namespace

QList<UsageOption> repeatOptions() {
    const QStringList axes{QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
    return {valueOption("scatter", "N",
                        QStringLiteral("After the shots, scatter 1 to %1 hits evenly over the first target. "
                                       "Shots are fired only if an option about shots is given.")
                            .arg(kMostScattered)),
            valueOption("density", "NUMBER", QStringLiteral("Like --scatter, as a number per square metre.")),
            valueOption("size-spread", "PERCENT",
                        QStringLiteral("Largest variation in size of scattered hits, 0 to 95."),
                        QStringLiteral("0")),
            wordOption(
                "mirror", "AXIS", axes,
                QStringLiteral("Repeat all hits, mirrored along this axis at the centre of their target."))};
}

RepeatWish givenRepeat(Invocation& given) {
    RepeatWish wish;
    if (given.isSet("scatter")) {
        wish.scatter =
            static_cast<std::uint32_t>(given.wholeNumber("scatter", 1, static_cast<int>(kMostScattered)));
    }
    wish.density = given.positiveIfSet("density", kMostDensity, QStringLiteral("a number per square metre"))
                       .value_or(0.0);
    if (given.isSet("density") && given.isSet("scatter")) {
        given.complain(QStringLiteral("--density and --scatter exclude each other."));
    }
    if (given.isSet("size-spread") && !wish.scatters()) {
        given.complain(QStringLiteral("--size-spread goes with --scatter or --density."));
    }
    wish.sizeSpread = given.number("size-spread", 0.0, kMostSpread) / 100.0;
    if (given.isSet("mirror")) {
        wish.mirror = static_cast<int>(given.word("mirror"));
    }
    return wish;
}

Status scatterHits(Session& session, const RepeatWish& wish, std::uint32_t seed) {
    if (!wish.scatters() || session.targets().empty()) {
        return Done{};
    }
    const WaitingLine waiting(QStringLiteral("Scattering hits"));
    const Target& target = *session.targets().front();
    ScatterPlan plan;
    plan.byDensity = wish.density > 0.0;
    plan.density = wish.density;
    plan.count = wish.scatter;
    plan.seed = seed;
    plan.sizeSpread = wish.sizeSpread;
    const Result<ScatteredHits> scattered =
        scatteredHits({target.deformed.render(), target.deformed.positions(), {}}, plan,
                      HitPlanner::modelOn(session, target));
    return scattered ? addGroup(session, HitGroupKind::Scatter, scattered.value().hits)
                     : Status(scattered.error());
}

Status mirrorHits(Session& session, const RepeatWish& wish) {
    if (!wish.mirror) {
        return Done{};
    }
    const int axis = *wish.mirror;
    std::vector<Hit> images;
    for (const Hit& hit : session.hits().history().hits()) {
        const Bounds& box = session.targets().find(hit.target)->deformed.render().bounds;
        Plane plane{glm::vec3(0.0f), 0.5f * box.min[axis] + 0.5f * box.max[axis]};
        plane.normal[axis] = 1.0f;
        const std::vector<Hit> image = mirroredHits({&hit, 1}, plane);
        images.insert(images.end(), image.begin(), image.end());
    }
    return addGroup(session, HitGroupKind::Mirror, images);
}

}  // namespace hitscope::cli
