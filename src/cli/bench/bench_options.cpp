// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/bench_options.h"

#include <algorithm>

namespace hitscope::bench {

namespace {

QStringList pipelineKeys() {
    QStringList keys;
    for (const PipelineTraits& traits : allPipelines()) {
        keys << pipelineKey(traits.kind);
    }
    return keys;
}

/// Enough to see that it runs.
constexpr Plan kQuickPlan{.warmUp = 1, .leastSamples = 2, .mostSamples = 3, .seconds = 0.1};

Plan takePlan(Arguments& arguments) {
    if (arguments.isSet(QStringLiteral("quick"))) {
        return kQuickPlan;
    }
    Plan plan;
    plan.mostSamples = arguments.wholeNumber(QStringLiteral("frames"), 1, 1000000);
    plan.leastSamples = std::min(plan.leastSamples, plan.mostSamples);
    plan.seconds = arguments.number(QStringLiteral("seconds"), 0.01, 3600.0);
    return plan;
}

}  // namespace

void addMeasuringOptions(Arguments& arguments) {
    arguments.addOption(QStringLiteral("seconds"),
                        QStringLiteral("Time for each variant; a slow one is still sampled three times."),
                        QStringLiteral("number"), QStringLiteral("2"));
    arguments.addOption(QStringLiteral("frames"), QStringLiteral("Most samples of each variant."),
                        QStringLiteral("number"), QStringLiteral("100"));
    arguments.addFlag(QStringLiteral("quick"),
                      QStringLiteral("A few samples each: to see that it runs, not to measure."));
    arguments.addOption(QStringLiteral("json"),
                        QStringLiteral("Also as JSON; without a file, or to \"-\": instead of the tables."),
                        QStringLiteral("file"));
    arguments.addOption(QStringLiteral("csv"), QStringLiteral("Likewise as CSV."), QStringLiteral("file"));
}

CommonOptions takeMeasuringOptions(Arguments& arguments) {
    CommonOptions options;
    options.plan = takePlan(arguments);
    options.destinations = {arguments.text(QStringLiteral("json")), arguments.text(QStringLiteral("csv"))};
    return options;
}

void addCommonOptions(Arguments& arguments, bool withPicture) {
    if (withPicture) {
        arguments.addOption(QStringLiteral("size"), QStringLiteral("Picture in pixels."),
                            QStringLiteral("WIDTHxHEIGHT"), QStringLiteral("1280x720"));
    }
    const QStringList keys = pipelineKeys();
    arguments.addOption(QStringLiteral("pipelines"),
                        QStringLiteral("Which to measure, of %1.").arg(keys.join(QStringLiteral(", "))),
                        QStringLiteral("list"), keys.join(QLatin1Char(',')));
    arguments.addOption(QStringLiteral("seed"), QStringLiteral("Another seed gives other hits."),
                        QStringLiteral("number"), QStringLiteral("1"));
    addMeasuringOptions(arguments);
}

CommonOptions takeCommonOptions(Arguments& arguments, bool withPicture) {
    CommonOptions options = takeMeasuringOptions(arguments);
    if (withPicture) {
        const Arguments::Size size = arguments.size(QStringLiteral("size"));
        options.width = size.width;
        options.height = size.height;
    }
    const QStringList wanted = arguments.list(QStringLiteral("pipelines"), pipelineKeys());
    for (const PipelineTraits& traits : allPipelines()) {
        if (wanted.contains(pipelineKey(traits.kind))) {
            options.pipelines.push_back(traits.kind);
        }
    }
    options.seed = static_cast<std::uint32_t>(arguments.wholeNumber(QStringLiteral("seed"), 0, 2147483647));
    return options;
}

void parseBenchArguments(Arguments& arguments, const QStringList& list) {
    arguments.parse(list, {QStringLiteral("--json"), QStringLiteral("--csv")});
}

}  // namespace hitscope::bench
