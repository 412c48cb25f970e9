// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/export/export_progress.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

#include "deform/cluster_reach.h"
#include "io/writers/normal_plan.h"
#include "session/export/export_target.h"

namespace hitscope {

namespace {

// What steps are made of, and nanoseconds that a part of each takes. Only their ratios count, which are much
// the same everywhere.

struct ExportSizes {
    double vertices = 0.0;  ///< and as many faces of four corners
    double moved = 0.0;     ///< vertices
    double visits = 0.0;    ///< of vertices by hits
    double steps = 0.0;     ///< vertices that the animation's steps move
    double source = 0.0;    ///< bytes of the file that is copied; 0: none is
};

constexpr double kGather = 30.0;      // a vertex
constexpr double kMerge = 120.0;      // likewise
constexpr double kVisitCount = 19.0;  // a visit
constexpr double kVisitReplay = 7.0;  // likewise

/// For a vertex and its faces, and more where it moved.
struct FormatCosts {
    double reading = 0.0;  ///< a byte of the source
    double preparing = 0.0;
    double writing = 0.0;
    double writingMoved = 0.0;
    double checking = 0.0;
    double comparing = 0.0;
    double comparingMoved = 0.0;
};

FormatCosts costsOf(ExportFormat format, bool isCopy) {
    switch (format) {
        case ExportFormat::Obj:
            return isCopy ? FormatCosts{0.4, 60, 95, 40, 550, 65, 200}
                          : FormatCosts{0, 60, 330, 550, 600, 65, 200};
        case ExportFormat::Ply:
            return isCopy ? FormatCosts{2.2, 0, 230, 0, 420, 65, 200}
                          : FormatCosts{0, 0, 120, 0, 420, 65, 200};
        case ExportFormat::PlyAscii:
            return {2.2, 0, 850, 0, 720, 65, 200};
        case ExportFormat::Stl:
            return {0, 0, 145, 0, 300, 310, 0};
        case ExportFormat::Glb:
        case ExportFormat::Gltf:
            return {0, 220, 80, 25, 160, 250, 0};
        case ExportFormat::Csv:
            break;
    }
    return {0, 0, 210, 1000, 0, 0, 0};
}
/// Of glTF, for a vertex that a step moves.
constexpr FormatCosts kStepCosts{0, 190, 0, 100, 55, 10, 0};

/// Of a target's enabled hits, by some of them.
double visitsOf(const TargetExport& target, const std::vector<Hit>& hits) {
    constexpr std::size_t kSamples = 64;
    std::vector<const Hit*> own;
    for (const Hit& hit : hits) {
        if (hit.enabled && hit.target == target.id) {
            own.push_back(&hit);
        }
    }
    const ClusterReach reach(*target.render);
    const std::size_t samples = std::min(own.size(), kSamples);
    std::size_t visited = 0;
    std::vector<std::uint32_t> clusters;
    for (std::size_t s = 0; s < samples; ++s) {
        clusters.clear();
        reach.find(*own[s * own.size() / samples], clusters);
        for (const std::uint32_t cluster : clusters) {
            visited += target.render->clusters[cluster].count;
        }
    }
    return samples == 0 ? 0.0
                        : static_cast<double>(visited) * static_cast<double>(own.size()) /
                              static_cast<double>(samples);
}

ExportSizes sizesOf(const SceneExport& what) {
    ExportSizes sizes;
    for (const TargetExport& target : what.targets) {
        const MeshData& mesh = *target.original;
        sizes.vertices += 0.5 * static_cast<double>(mesh.positions.size()) +
                          0.125 * static_cast<double>(mesh.cornerVertices.size());
        const std::vector<std::uint8_t> moved = movedVertices(mesh, target.positions);
        sizes.moved += static_cast<double>(std::count(moved.begin(), moved.end(), 1));
        if (what.needsHits() || what.hasSteps()) {
            sizes.visits += visitsOf(target, what.hits);
        }
    }
    const auto steps = static_cast<double>(std::min(what.options.steps, what.hits.size()));
    sizes.steps = what.hasSteps() ? std::min(sizes.visits, steps * sizes.moved) : 0.0;
    const TargetExport& first = what.targets.front();
    const std::optional<ExportFormat> source = exportFormatOf(first.sourcePath);
    const bool isCopy =
        !what.isMerged() && first.original->isAsRead() && source &&
        QLatin1String(traitsOf(*source).suffix) == QLatin1String(traitsOf(what.options.format).suffix);
    sizes.source = isCopy ? static_cast<double>(QFileInfo(first.sourcePath).size()) : 0.0;
    return sizes;
}

std::array<double, kExportSteps> costsOf(const SceneExport& what) {
    const ExportSizes sizes = sizesOf(what);
    const FormatCosts each = costsOf(what.options.format, sizes.source > 0.0);
    const double gathered = (what.options.format == ExportFormat::Obj ? 0.0 : kGather) +
                            (what.isPlaced() ? kGather + kMerge : 0.0);
    const double read = what.options.readBack ? 1.0 : 0.0;
    std::array<double, kExportSteps> costs{};
    const auto set = [&costs](ExportStep step, double cost) { costs[static_cast<std::size_t>(step)] = cost; };
    set(ExportStep::Counting, what.needsHits() ? kVisitCount * sizes.visits : 0.0);
    set(ExportStep::Replaying, what.hasSteps() ? kVisitReplay * sizes.visits : 0.0);
    set(ExportStep::Gathering, gathered * sizes.vertices);
    set(ExportStep::Reading, each.reading * sizes.source);
    set(ExportStep::Preparing, each.preparing * sizes.vertices + kStepCosts.preparing * sizes.steps);
    // Never nothing: shares are of the sum.
    set(ExportStep::Writing, 1.0 + each.writing * sizes.vertices + each.writingMoved * sizes.moved +
                                 kStepCosts.writingMoved * sizes.steps);
    set(ExportStep::Checking, read * (each.checking * sizes.vertices + kStepCosts.checking * sizes.steps));
    set(ExportStep::Comparing, read * (each.comparing * sizes.vertices + each.comparingMoved * sizes.moved +
                                       kStepCosts.comparing * sizes.steps));
    return costs;
}

QString doingOf(ExportStep step, const QString& file, const QString& source) {
    switch (step) {
        case ExportStep::Counting:
            return QCoreApplication::translate("Export", "Counting hits for %1").arg(file);
        case ExportStep::Replaying:
            return QCoreApplication::translate("Export", "Computing steps for %1").arg(file);
        case ExportStep::Gathering:
        case ExportStep::Preparing:
            return QCoreApplication::translate("Export", "Preparing %1").arg(file);
        case ExportStep::Reading:
            return QCoreApplication::translate("Export", "Reading %1").arg(source);
        case ExportStep::Writing:
            return QCoreApplication::translate("Export", "Writing %1").arg(file);
        case ExportStep::Checking:
        case ExportStep::Comparing:
            break;
    }
    return QCoreApplication::translate("Export", "Checking %1").arg(file);
}

}  // namespace

ExportProgress::ExportProgress(const SceneExport& what, const QString& path, const Told& told)
    : m_told(told) {
    if (!m_told) {
        return;
    }
    const QString file = QFileInfo(path).fileName();
    const QString source = QFileInfo(what.targets.front().sourcePath).fileName();
    m_ends = costsOf(what);
    std::partial_sum(m_ends.begin(), m_ends.end(), m_ends.begin());
    const double all = m_ends.back();
    for (std::size_t step = 0; step < kExportSteps; ++step) {
        m_doing[step] = doingOf(static_cast<ExportStep>(step), file, source);
        m_ends[step] /= all;
    }
    while (m_ends[m_step] == 0.0) {
        ++m_step;  // it does nothing of that kind
    }
}

ExportGoOn ExportProgress::goOn() {
    return m_told ? ExportGoOn([this](ExportStep step, double share) { return tell(step, share); })
                  : ExportGoOn();
}

bool ExportProgress::isWanted() const {
    return !m_told || m_told(m_share, m_doing[m_step]);
}

bool ExportProgress::tell(ExportStep step, double share) {
    m_step = std::max(m_step, static_cast<std::size_t>(step));
    if (m_step == static_cast<std::size_t>(step)) {
        const double from = m_step == 0 ? 0.0 : m_ends[m_step - 1];
        m_share = std::max(m_share, from + (m_ends[m_step] - from) * std::clamp(share, 0.0, 1.0));
    }
    return isWanted();
}

}  // namespace hitscope
