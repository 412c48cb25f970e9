// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/bench_room.h"

#include <unistd.h>

#include <QFile>
#include <QTextStream>
#include <algorithm>

#include "cli/command_line.h"
#include "pipeline/measure_exactness.h"

namespace hitscope::bench {

namespace {

constexpr double kGiB = 1073741824.0;

}  // namespace

Result<std::unique_ptr<BenchRoom>> BenchRoom::open(int width, int height) {
    Result<std::unique_ptr<gl::OffscreenContext>> context = gl::OffscreenContext::create();
    if (!context) {
        return context.error();
    }
    gl::collectDebugMessages();
    std::unique_ptr<BenchRoom> room(new BenchRoom);
    room->m_context = std::move(context).value();
    room->m_picture.emplace(width, height);
    if (!room->m_picture->isComplete()) {
        return Error{"The driver cannot draw a picture of that size.",
                     std::to_string(width) + "x" + std::to_string(height), "Choose a smaller --size."};
    }
    const Result<Exactness> exactness = measureExactness();
    if (!exactness) {
        return exactness.error();
    }
    room->m_exactness = exactness.value();
    room->m_onTerminal = !cli::isQuiet() && isatty(STDERR_FILENO) == 1;
    return room;
}

PipelineOptions BenchRoom::pipelineOptions() const {
    PipelineOptions options;
    options.deformDefines = definesOf(m_exactness);
    return options;
}

Result<std::unique_ptr<DeformationPipeline>> BenchRoom::makePipeline(PipelineKind kind) const {
    return hitscope::makePipeline(kind, pipelineOptions());
}

void BenchRoom::say(const QString& what) const {
    if (m_onTerminal) {
        constexpr int kLine = 78;
        QTextStream(stderr) << '\r' << what.left(kLine).leftJustified(kLine) << '\r' << Qt::flush;
    }
}

Result<std::vector<Samples>> BenchRoom::measure(const QString& what, const std::vector<Variant>& variants,
                                                const Plan& plan) const {
    const double begun = steadySeconds();
    const double longest = plan.seconds * static_cast<double>(std::max<std::size_t>(variants.size(), 1));
    const auto progress = [&](const Variant& variant, std::size_t kept) {
        const QString name = QString::fromStdString(variant.name);
        if (m_told) {
            const double counted = static_cast<double>(kept) / plan.mostSamples;
            m_told(std::min(std::max(counted, (steadySeconds() - begun) / longest), 1.0),
                   QStringLiteral("%1: %2").arg(what, name));
        }
        say(QStringLiteral("%1: %2, %3").arg(what, name).arg(kept));
    };
    Result<std::vector<Samples>> samples = bench::measure(variants, plan, progress);
    say({});
    if (Status status = noGlErrors(); samples && !status) {
        return status.error();
    }
    return samples;
}

Status noGlErrors() {
    const std::vector<std::string> errors = gl::takeErrors();
    if (errors.empty()) {
        return Done{};
    }
    return Error{"OpenGL reports: " + errors.front(), "", "Please report this with the renderer's name."};
}

std::optional<double> availableMemory() {
    QFile file(QStringLiteral("/proc/meminfo"));
    if (!file.open(QIODevice::ReadOnly)) {
        return std::nullopt;
    }
    const QList<QByteArray> lines = file.readAll().split('\n');
    for (const QByteArray& line : lines) {
        if (line.startsWith("MemAvailable:")) {
            return 1024.0 * line.simplified().split(' ').value(1).toDouble();
        }
    }
    return std::nullopt;
}

QString whyItDoesNotFit(double bytes) {
    constexpr double kShare = 0.8;
    const std::optional<double> available = availableMemory();
    if (!available || bytes <= kShare * *available) {
        return {};
    }
    return QStringLiteral("it would need about %1 GiB of memory, and %2 GiB are free")
        .arg(bytes / kGiB, 0, 'f', 1)
        .arg(*available / kGiB, 0, 'f', 1);
}

}  // namespace hitscope::bench
