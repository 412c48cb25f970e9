// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "cli/bench/bench_options.h"
#include "deform/exactness.h"
#include "gl/context.h"
#include "gl/render_target.h"
#include "pipeline/deformation_pipeline.h"

namespace hitscope::bench {

/// What a benchmark is made in: a context without a window, the picture, and how it tells how far it is.
class BenchRoom {
public:
    /// width, height: of the picture, pixels.
    [[nodiscard]] static Result<std::unique_ptr<BenchRoom>> open(int width, int height);

    [[nodiscard]] const gl::RenderTarget& picture() const { return *m_picture; }
    /// For pipelines, as the window makes them.
    [[nodiscard]] PipelineOptions pipelineOptions() const;
    /// As the window makes it. The error says why it cannot run here.
    [[nodiscard]] Result<std::unique_ptr<DeformationPipeline>> makePipeline(PipelineKind kind) const;

    /// Measures; OpenGL errors on the way are errors. `what` is told on a terminal while it lasts.
    [[nodiscard]] Result<std::vector<Samples>> measure(const QString& what,
                                                       const std::vector<Variant>& variants,
                                                       const Plan& plan) const;
    /// Told while measure() lasts: how far it is, [0, 1], and at what. By default a terminal is.
    using Told = std::function<void(double part, const QString& what)>;
    void setTold(Told told) { m_told = std::move(told); }
    /// Says on a terminal what is being done; empty: clears the line. Not a terminal: nothing.
    void say(const QString& what) const;

private:
    BenchRoom() = default;
    std::unique_ptr<gl::OffscreenContext> m_context;
    std::optional<gl::RenderTarget> m_picture;
    Exactness m_exactness;
    Told m_told;
    bool m_onTerminal = false;
};

/// An error if OpenGL has reported one since the last time.
[[nodiscard]] Status noGlErrors();

/// Bytes of memory that the system could give; nothing where it does not say.
[[nodiscard]] std::optional<double> availableMemory();
/// Why something that needs so many bytes is not tried; empty: it fits.
[[nodiscard]] QString whyItDoesNotFit(double bytes);

}  // namespace hitscope::bench
