// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/change_upload.h"

#include "analysis/change_values.h"

namespace hitscope {

void ChangeUpload::follow(const ChangeValues* values) {
    if (values != m_values) {
        if (m_values != nullptr) {
            QObject::disconnect(m_values, nullptr, &m_receiver, nullptr);
        }
        m_values = values;
        m_current.clear();
        if (values != nullptr) {
            QObject::connect(values, &ChangeValues::valuesChanged, &m_receiver,
                             [this](TargetId target, std::span<const VertexRange> ranges) {
                                 m_changed[target].add(ranges);
                             });
            QObject::connect(values, &QObject::destroyed, &m_receiver, [this] { m_values = nullptr; });
        }
    }
    const std::optional<ChangeQuantity> quantity = values != nullptr ? values->quantity() : std::nullopt;
    if (quantity != m_quantity) {
        m_quantity = quantity;
        m_current.clear();
    }
}

bool ChangeUpload::upload(TargetId target, TargetBuffers& buffers) {
    if (!m_quantity || changeTraits(*m_quantity).inShader) {
        return false;
    }
    ChangedRanges& changed = m_changed[target];
    const std::span<const float> values = m_values->values(target);
    if (values.size() != buffers.vertexCount()) {
        // Nothing has changed there, and what an earlier quantity left is not this one's.
        if (m_current.insert(target).second) {
            buffers.clearChangeValues();
            return true;
        }
        return false;
    }
    std::vector<VertexRange> ranges = changed.take();
    if (m_current.insert(target).second) {
        ranges = {{0, buffers.vertexCount()}};
    }
    for (const VertexRange& range : ranges) {
        buffers.writeChangeValues(range.first, values.subspan(range.first, range.count));
    }
    return !ranges.empty();
}

}  // namespace hitscope
