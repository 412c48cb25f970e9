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
        flagOption("json", QStringLiteral("Print the report as JSON instead of tables.")),
        outputOption("report",
                     QStringLiteral("Write the report as JSON to a file, completely or not at all.")),
        outputOption("csv", QStringLiteral("Write the records of the report as CSV to a file.")),
        outputOption("html", QStringLiteral("Write the report with diagrams as a self-contained HTML page.")),
        flagOption(
            "quiet",
            QStringLiteral("Print errors only: no progress, and with a file for the report no tables."))};
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
               valueOption(
                   "seconds", "NUMBER",
                   QStringLiteral("Time for each variant; a slow variant gets at least three samples."),
                   QStringLiteral("2")),
               valueOption("frames", "N", QStringLiteral("Maximum number of samples of each variant."),
                           QStringLiteral("100")),
               flagOption("quick",
                          QStringLiteral("Take only a few samples, to test the command, not to measure."))} +
           destinationOptions();
}

CommonOptions takeMeasuringOptions(Invocation& given) {
    CommonOptions options;
    options.plan = takePlan(given);
    options.destinations = takeDestinations(given);
    return options;
}

UsageOption sizeOption() {
    return valueOption("size", "WIDTHxHEIGHT", QStringLiteral("Size of the picture in pixels."),
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
               valueOption("seed", "N", QStringLiteral("Seed of the random hits."), QStringLiteral("1"))} +
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
    return flagOption("strict", QStringLiteral("Exit with 1 if %1 is not kept.").arg(what));
}

}  // namespace hitscope::bench
