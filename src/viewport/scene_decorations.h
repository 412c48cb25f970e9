// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <utility>
#include <vector>

namespace hitscope {

struct SectionLines;

/// What tools and docks have drawn with the scene: ghosts of dents to come, the lines of a section, the
/// cutting plane as a pane.
class SceneDecorations {
public:
    using Ghost = std::shared_ptr<const std::vector<glm::vec3>>;  ///< as in SceneGpu::View; null: none
    using Lines = std::shared_ptr<const SectionLines>;            ///< null: none are drawn

    /// Calls `changed` whenever another picture is needed.
    explicit SceneDecorations(std::function<void()> changed) : m_changed(std::move(changed)) {}

    /// A surface to draw over the picture.
    void setGhost(Ghost ghost) { set(m_ghost, std::move(ghost)); }
    /// Likewise, of hits that are planned; in its place while there is one.
    void setPlannedGhosts(Ghost ghosts) { set(m_plannedGhosts, std::move(ghosts)); }
    [[nodiscard]] const Ghost& ghost() const { return m_plannedGhosts ? m_plannedGhosts : m_ghost; }

    /// Lines where the cutting plane cuts the targets, and those of the second of two pipelines.
    void setSection(Lines lines) { set(m_section, std::move(lines)); }
    void setOtherSection(Lines lines) { set(m_otherSection, std::move(lines)); }
    [[nodiscard]] const Lines& section() const { return m_section; }
    [[nodiscard]] const Lines& otherSection() const { return m_otherSection; }

    /// Whether the cutting plane is drawn as a pane.
    void setShowsCutPlane(bool on) { set(m_showsCutPlane, on); }
    [[nodiscard]] bool showsCutPlane() const { return m_showsCutPlane; }

private:
    template <class Value>
    void set(Value& now, Value value) {
        if (value != now) {
            now = std::move(value);
            m_changed();
        }
    }

    std::function<void()> m_changed;
    Ghost m_ghost;
    Ghost m_plannedGhosts;
    Lines m_section;
    Lines m_otherSection;
    bool m_showsCutPlane = false;
};

}  // namespace hitscope
