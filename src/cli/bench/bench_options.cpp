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

Plan takePlan(Invocation& given) {
    Plan plan;
    plan.mostSamples = takeCount(given, "frames", 1, 1000000);
    plan.leastSamples = std::min(plan.leastSamples, plan.mostSamples);
    plan.seconds = given.number("seconds", 0.01, 3600.0);
    return given.isSet("quick") ? kQuickPlan : plan;
}

}  // namespace

QList<UsageOption> destinationOptions() {
    return {
        flagOption("json", QStringLiteral("Print the report as JSON in place of the tables.")),
        fileOption("report", QStringLiteral("Write the report as JSON into a file, whole or not at all.")),
        fileOption("csv", QStringLiteral("Write its records as CSV into a file.")),
        fileOption("html",
                   QStringLiteral("Write it with diagrams as a page of HTML that needs no other file.")),
        flagOption("quiet",
                   QStringLiteral("No progress, and with a file for the report no tables; errors are "
                                  "still said."))};
}

Destinations takeDestinations(Invocation& given) {
    Destinations destinations{.json = given.isSet("json"),
                              .report = given.text("report"),
                              .html = given.text("html"),
                              .csv = given.text("csv"),
                              .quiet = given.isSet("quiet")};
    if (destinations.toStandardOutput() > 1) {
        given.complain(
            QStringLiteral("only one of --json, --report -, --csv - and --html - can go to the standard "
                           "output. Give the others a "
                           "file."));
    }
    return destinations;
}

QList<UsageOption> measuringOptions() {
    return QList<UsageOption>{
               valueOption("seconds", "NUMBER",
                           QStringLiteral("Time for each variant; a slow one is still sampled three times."),
                           QStringLiteral("2")),
               valueOption("frames", "N", QStringLiteral("Most samples of each variant."),
                           QStringLiteral("100")),
               flagOption("quick",
                          QStringLiteral("A few samples each: to see that it runs, not to measure."))} +
           destinationOptions();
}

CommonOptions takeMeasuringOptions(Invocation& given) {
    CommonOptions options;
    options.plan = takePlan(given);
    options.destinations = takeDestinations(given);
    return options;
}

UsageOption sizeOption() {
    return valueOption("size", "WIDTHxHEIGHT", QStringLiteral("The picture in pixels."),
                       QStringLiteral("1280x720"));
}

void takeSizeInto(CommonOptions& options, Invocation& given) {
    const Size size = takeSize(given, "size");
    options.width = size.width;
    options.height = size.height;
}

QList<UsageOption> commonOptions() {
    return QList<UsageOption>{
               wordsOption("pipelines", pipelineKeys(), QStringLiteral("Pipelines to measure.")),
               valueOption("seed", "N", QStringLiteral("Another seed gives other hits."),
                           QStringLiteral("1"))} +
           measuringOptions();
}

CommonOptions takeCommonOptions(Invocation& given) {
    CommonOptions options = takeMeasuringOptions(given);
    const QStringList wanted = takeWords(given, "pipelines");
    for (const PipelineTraits& traits : allPipelines()) {
        if (wanted.contains(pipelineKey(traits.kind))) {
            options.pipelines.push_back(traits.kind);
        }
    }
    options.seed = given.seed("seed");
    return options;
}

UsageOption strictOption(const QString& what) {
    return flagOption("strict", QStringLiteral("End with 1 if %1 is not kept.").arg(what));
}

}  // namespace hitscope::bench
