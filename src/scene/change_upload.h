// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <map>
#include <optional>
#include <set>

#include "core/ids.h"
#include "deform/vertex_range.h"
#include "pipeline/target_buffers.h"
#include "view/change_options.h"

namespace hitscope {

class ChangeValues;

/// Brings values of change that shaders cannot find to the targets' buffers: what changed since the last
/// time. A context is current for upload().
class ChangeUpload {
public:
    /// Null: there are no values. They outlive this or another call.
    void follow(const ChangeValues* values);
    /// The buffers are new ones, of all targets or of one.
    void forget() { m_current.clear(); }
    void forget(TargetId target) { m_current.erase(target); }
    /// Returns whether the buffers are others now.
    bool upload(TargetId target, TargetBuffers& buffers);

private:
    QObject m_receiver;
    const ChangeValues* m_values = nullptr;
    std::optional<ChangeQuantity> m_quantity;
    std::set<TargetId> m_current;  ///< targets whose buffers have this quantity, but for m_changed
    std::map<TargetId, ChangedRanges> m_changed;
};

}  // namespace hitscope
