// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QPolygonF>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/ids.h"
#include "core/result.h"
#include "session/vertex_selection.h"

namespace hitscope {

class ScenePicker;
class Viewport;

/// Which vertices the viewport shows where. Positions are logical pixels of the widget; what is found is as
/// the picture would show it now. Finds nothing while there is no scene on the GPU.
class ViewportPicking {
public:
    explicit ViewportPicking(Viewport& viewport);  ///< `viewport` owns it
    ~ViewportPicking();

    [[nodiscard]] std::optional<VertexRef> vertexAt(const QPointF& position);
    /// Likewise, without waiting for the GPU: requestedVertex() has it some milliseconds later, once. False:
    /// it never will.
    bool requestVertexAt(const QPointF& position);
    [[nodiscard]] std::optional<std::optional<VertexRef>> requestedVertex();
    /// The changed vertices within an outline, of each visible target that has some there.
    [[nodiscard]] std::map<TargetId, std::vector<std::uint32_t>> changedWithin(const QPolygonF& outline,
                                                                               bool hiddenToo);
    /// Of the scene there is now; null: there is none. The context is current.
    void setPicker(std::unique_ptr<ScenePicker> picker);

private:
    void report(const Error& error);
    /// With the context current; an error is reported.
    bool isAsked(const std::function<Status()>& ask);

    Viewport& m_viewport;
    std::unique_ptr<ScenePicker> m_picker;
    std::string m_told;  ///< the error that was said last
};

}  // namespace hitscope
