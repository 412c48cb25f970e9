// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <functional>

#include "io/writers/export_step.h"

namespace hitscope {

struct SceneExport;

/// How far an export is over all its steps, each of which has a share by what it usually takes. It never goes
/// back.
class ExportProgress {
public:
    /// share: of all, [0, 1]; doing: "Writing teapot.obj". False gives the export up.
    using Told = std::function<bool(double share, const QString& doing)>;

    /// `told` outlives it; empty: nobody listens.
    ExportProgress(const SceneExport& what, const QString& path, const Told& told);
    ExportProgress(const ExportProgress&) = delete;
    ExportProgress& operator=(const ExportProgress&) = delete;

    /// For whoever does a part; this outlives it. Empty where nobody listens.
    [[nodiscard]] ExportGoOn goOn();
    /// Asks without anything new to tell.
    [[nodiscard]] bool isWanted() const;

private:
    bool tell(ExportStep step, double share);

    const Told& m_told;
    std::array<QString, kExportSteps> m_doing;
    std::array<double, kExportSteps> m_ends{};  ///< share of all at the end of each step
    double m_share = 0.0;
    std::size_t m_step = 0;
};

}  // namespace hitscope
