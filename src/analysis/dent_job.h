// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "analysis/copied_targets.h"
#include "analysis/dent_hits.h"
#include "analysis/dent_measurement.h"
#include "analysis/history_copy.h"
#include "mesh/section.h"

namespace hitscope {

/// A target on the other thread: as it was and as it is.
class DentCopy {
public:
    explicit DentCopy(std::shared_ptr<const RenderMesh> render) : m_render(std::move(render)) {}

    void follow(std::span<const MovedVertex> moved, std::span<const Hit> hits);
    [[nodiscard]] const MeshSections& before() const { return *m_before; }
    [[nodiscard]] const MeshSections& after() const { return *m_after; }
    [[nodiscard]] const DentHits& hits() const { return m_hits; }

private:
    std::shared_ptr<const RenderMesh> m_render;
    std::unique_ptr<MeshSections> m_before;
    std::unique_ptr<MeshSections> m_after;
    DentHits m_hits;
};

/// Measures a dent, on another thread.
struct DentJob {
    TargetId target;
    QString name;
    CopiedTargets<DentCopy>::Part part;
    HistoryCopy::Update update;
    std::shared_ptr<HistoryCopy> history;
    std::optional<std::uint32_t> vertex;  ///< else the dent of:
    std::size_t row = 0;                  ///< of the history
    float angle = 0.0f;
    bool tellsApart = true;
    DentMeasurement::Report report;

    void run(const std::stop_token& stop);

private:
    void measure(const std::stop_token& stop);
    [[nodiscard]] std::vector<std::uint32_t> nameHits(std::span<const std::uint32_t> whole,
                                                      const std::stop_token& stop);
    [[nodiscard]] std::vector<std::uint32_t> partOf(std::span<const std::uint32_t> whole,
                                                    std::span<const std::size_t> all,
                                                    const std::stop_token& stop);
    void namePart(bool isThere, std::span<const std::size_t> all, std::span<const std::uint32_t> dents,
                  std::uint32_t dent);

    std::vector<std::size_t> m_rows;  ///< of the history: the hits applied to the target
    std::size_t m_hit = 0;            ///< an index into them
};

}  // namespace hitscope
