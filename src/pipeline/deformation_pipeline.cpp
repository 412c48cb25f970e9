// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/deformation_pipeline.h"

namespace hitscope {

void DeformationPipeline::reset(std::span<const Hit> history) {
    m_historySize = history.size();
    startOver(history);
}

void DeformationPipeline::edit(const HistoryEdit& edit) {
    m_historySize = m_historySize - edit.before.size() + edit.after.size();
    follow(edit);
}

void DeformationPipeline::append(std::span<const Hit> hits) {
    if (!hits.empty()) {
        edit({m_historySize, {}, {hits.begin(), hits.end()}});
    }
}

}  // namespace hitscope
