// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_picker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "render/pick_pass.h"
#include "scene/picture_part.h"
#include "scene/screen_space.h"
#include "session/session.h"

namespace hitscope {

namespace {

constexpr float kOnSurface = 1.0f;  // pixels' widths: what lies no deeper than that is seen
constexpr double kSmall = 64.0;     // square pixels, twice the area
constexpr double kEdgeOn = 1.0e-6;  // square pixels: smaller triangles have no plane to speak of

glm::ivec2 pixelOf(const glm::vec2& at) {
    return {static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y))};
}

/// The pixel that GL counts from below.
PixelArea areaAround(const SceneGpu::View& view, const glm::ivec2& pixel, int reach) {
    const int size = 2 * reach + 1;
    return {pixel.x - reach, view.height - 1 - pixel.y - reach, size, size};
}

/// What was asked for, to make sense of the answer.
struct Question {
    SceneGpu::View view;  ///< of the part of the picture
    glm::vec2 at{0.0f};   ///< within that
    PixelArea area;
    PickElements elements = PickElements::Triangles;
};

/// Of that, what lies within the part; at least a column.
PixelArea within(const PicturePart& part, PixelArea area) {
    const int right = std::min(area.x + area.width, part.to);
    area.x = std::max(area.x, part.from);
    area.width = std::max(1, right - area.x);
    return area;
}

Question questionAt(const SceneGpu::View& whole, const glm::vec2& at) {
    const std::vector<PicturePart> parts = partsOf(whole);
    const int column = pixelOf(at).x;
    const auto after = std::find_if(parts.begin(), parts.end(), [column](const PicturePart& part) {
        return column < part.left + part.to;
    });
    const PicturePart& part = after == parts.end() ? parts.back() : *after;
    Question question{
        part.view, at - glm::vec2(static_cast<float>(part.left), 0.0f), {}, PickElements::Triangles};
    int reach = 0;
    if (part.view.options.wireframe == WireframeMode::Only) {
        question.elements = PickElements::Points;
        reach = static_cast<int>(std::lround(ScenePicker::kReach * part.view.pixelRatio));
        question.area = within(part, areaAround(part.view, pixelOf(question.at), reach));
    } else {
        question.area = areaAround(part.view, pixelOf(question.at), reach);
    }
    return question;
}

std::optional<VertexRef> nearestCorner(const Session& session, const Question& question,
                                       const PickedElement& picked) {
    const Target* target = session.targets().find(picked.target);
    if (target == nullptr || 3 * std::size_t{picked.element} >= target->deformed.render().triangles.size()) {
        return std::nullopt;
    }
    const RenderMesh& mesh = target->deformed.render();
    const ScreenSpace screen(question.view, target->transform);
    std::optional<VertexRef> nearest;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t vertex = mesh.fileVertices[mesh.triangles[3 * picked.element + corner]];
        const auto point = screen.project(drawnPlace(question.view, *target, vertex));
        const float distance =
            point ? glm::distance(point->at, question.at) : std::numeric_limits<float>::max();
        // Of a triangle that the cutting plane cuts, only what is left can be meant.
        if (distance < least && shownBy(question.view, *target, vertex) >= 0.0f) {
            least = distance;
            nearest = VertexRef{target->id, vertex};
        }
    }
    return nearest;
}

std::optional<VertexRef> nearestPoint(const Session& session, const Question& question,
                                      std::span<const PickedElement> picked) {
    std::optional<VertexRef> nearest;
    float least = std::pow(ScenePicker::kReach * question.view.pixelRatio, 2.0f);
    for (std::size_t i = 0; i < picked.size(); ++i) {
        const Target* target = session.targets().find(picked[i].target);
        if (target == nullptr || picked[i].element >= target->deformed.render().fileVertices.size()) {
            continue;
        }
        const auto width = static_cast<std::size_t>(question.area.width);
        const int column = question.area.x + static_cast<int>(i % width);
        const int row = question.view.height - 1 - question.area.y - static_cast<int>(i / width);
        const glm::vec2 off =
            glm::vec2(static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f) - question.at;
        if (glm::dot(off, off) < least) {
            least = glm::dot(off, off);
            nearest = VertexRef{target->id, target->deformed.render().fileVertices[picked[i].element]};
        }
    }
    return nearest;
}

std::optional<VertexRef> answer(const Session& session, const Question& question,
                                std::span<const PickedElement> picked) {
    return question.elements == PickElements::Points ? nearestPoint(session, question, picked)
                                                     : nearestCorner(session, question, picked.front());
}

/// What the pixels of an area show, as triangles in the picture.
class SeenTriangles {
public:
    SeenTriangles(const Session& session, const SceneGpu::View& view, const PixelArea& area,
                  std::vector<PickedElement> picked)
        : m_session(session), m_view(view), m_area(area), m_picked(std::move(picked)) {
        for (const std::unique_ptr<Target>& target : session.targets()) {
            m_screens.emplace(target->id, ScreenSpace(view, target->transform));
        }
    }

    /// Whether some triangle seen about the vertex's pixel covers the very place where it falls, and lies
    /// before it. Where triangles are smaller than pixels, those that do may not be seen at all; then it is
    /// the one at its pixel, continued to that place, that tells.
    [[nodiscard]] bool hides(const VertexRef& vertex, const ScreenSpace::Point& point) const {
        const glm::ivec2 pixel = pixelOf(point.at);
        if (!contains(pixel)) {
            return true;  // out of the picture
        }
        if (at(pixel).isFilling()) {
            return true;
        }
        const float behind = point.depth - kOnSurface * point.pixelDepth;
        bool covered = false;
        for (int i = 0; i < 9; ++i) {
            const glm::ivec2 beside = pixel + glm::ivec2(i % 3 - 1, i / 3 - 1);
            const Target* target = contains(beside) ? m_session.targets().find(at(beside).target) : nullptr;
            if (target == nullptr || isCorner(*target, at(beside), vertex)) {
                continue;
            }
            const Surface there = surfaceAt(*target, at(beside).element, point.at);
            if (there.covers && there.depth < behind) {
                return true;
            }
            covered = covered || there.covers;
        }
        const Target* target = m_session.targets().find(at(pixel).target);
        return !covered && target != nullptr && isSmall(*target, at(pixel).element) &&
               !isCorner(*target, at(pixel), vertex) &&
               surfaceAt(*target, at(pixel).element, point.at).depth < behind;
    }

private:
    static bool isCorner(const Target& target, const PickedElement& seen, const VertexRef& vertex) {
        if (target.id != vertex.target) {
            return false;
        }
        const RenderMesh& mesh = target.deformed.render();
        const auto first = mesh.triangles.begin() + 3 * static_cast<std::ptrdiff_t>(seen.element);
        return std::any_of(first, first + 3,
                           [&](std::uint32_t corner) { return mesh.fileVertices[corner] == vertex.vertex; });
    }

    [[nodiscard]] bool contains(const glm::ivec2& pixel) const {
        const glm::ivec2 off(pixel.x - m_area.x, m_view.height - 1 - pixel.y - m_area.y);
        return off.x >= 0 && off.y >= 0 && off.x < m_area.width && off.y < m_area.height;
    }

    [[nodiscard]] const PickedElement& at(const glm::ivec2& pixel) const {
        const int row = m_view.height - 1 - pixel.y - m_area.y;
        return m_picked[static_cast<std::size_t>(row) * static_cast<std::size_t>(m_area.width) +
                        static_cast<std::size_t>(pixel.x - m_area.x)];
    }

    /// x, y in pixels; depth and what tells whether it is cut away, which are linear in them.
    using Corners = std::array<glm::dvec4, 3>;
    /// Nothing: it reaches behind the eye.
    [[nodiscard]] std::optional<Corners> cornersOf(const Target& target, std::uint32_t triangle) const {
        const RenderMesh& mesh = target.deformed.render();
        const ScreenSpace& screen = m_screens.at(target.id);
        Corners corners;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = mesh.fileVertices[mesh.triangles[3 * triangle + corner]];
            const auto point = screen.project(drawnPlace(m_view, target, vertex));
            if (!point) {
                return std::nullopt;
            }
            const float shown = m_view.options.cut.on ? shownBy(m_view, target, vertex) / point->w : 1.0f;
            corners[corner] = glm::dvec4(point->at, point->depth, shown);
        }
        return corners;
    }

    [[nodiscard]] bool isSmall(const Target& target, std::uint32_t triangle) const {
        const auto corners = cornersOf(target, triangle);
        return corners && std::abs(twiceArea((*corners)[0], (*corners)[1], (*corners)[2])) < kSmall;
    }

    static double twiceArea(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    }

    struct Surface {
        bool covers = false;  ///< that place
        float depth = 1.0f;   ///< of its plane there
    };
    [[nodiscard]] Surface surfaceAt(const Target& target, std::uint32_t triangle, const glm::vec2& at) const {
        const auto corners = cornersOf(target, triangle);
        if (!corners) {
            return {true, -1.0f};  // right before us
        }
        const auto& [a, b, c] = *corners;
        const double area = twiceArea(a, b, c);
        if (std::abs(area) < kEdgeOn) {
            return {};
        }
        const glm::dvec4 p(at, 0.0, 0.0);
        const double u = twiceArea(b, c, p) / area;
        const double v = twiceArea(c, a, p) / area;
        const double w = 1.0 - u - v;
        const bool isCutAway = u * a.w + v * b.w + w * c.w < 0.0;
        return {u >= 0.0 && v >= 0.0 && w >= 0.0 && !isCutAway,
                static_cast<float>(u * a.z + v * b.z + w * c.z)};
    }

    const Session& m_session;
    SceneGpu::View m_view;
    PixelArea m_area;
    std::map<TargetId, ScreenSpace> m_screens;
    std::vector<PickedElement> m_picked;
};

/// The pixels of the part that an outline covers; empty when it covers none.
PixelArea areaOf(const PicturePart& part, std::span<const glm::vec2> outline) {
    const SceneGpu::View& view = part.view;
    glm::vec2 least(static_cast<float>(view.width), static_cast<float>(view.height));
    glm::vec2 most(0.0f);
    for (const glm::vec2& corner : outline) {
        least = glm::min(least, corner);
        most = glm::max(most, corner);
    }
    const glm::ivec2 first = glm::max(pixelOf(least), glm::ivec2(part.from, 0));
    const glm::ivec2 last = glm::min(pixelOf(most), glm::ivec2(part.to - 1, view.height - 1));
    return {first.x, view.height - 1 - last.y, std::max(0, last.x - first.x + 1),
            std::max(0, last.y - first.y + 1)};
}

using Found = std::map<TargetId, std::vector<std::uint32_t>>;

/// Adds the vertices that fall within the outline in this part of the picture; `seen` null: hidden ones too.
void addWithin(Found& found, const Session& session, const PicturePart& part,
               std::span<const glm::vec2> outline, const SeenTriangles* seen) {
    for (const std::unique_ptr<Target>& target : session.targets()) {
        if (!target->visible) {
            continue;
        }
        const ScreenSpace screen(part.view, target->transform);
        for (const std::uint32_t vertex : target->deformed.onceChanged()) {
            const auto point = screen.project(drawnPlace(part.view, *target, vertex));
            if (point && point->at.x >= static_cast<float>(part.from) &&
                point->at.x < static_cast<float>(part.to) && isWithin(outline, point->at) &&
                target->deformed.isChanged(vertex) && shownBy(part.view, *target, vertex) >= 0.0f &&
                !(seen != nullptr && seen->hides({target->id, vertex}, *point))) {
                found[target->id].push_back(vertex);
            }
        }
    }
}

}  // namespace

struct ScenePicker::Private {
    Private(Session& followed, SceneGpu& drawn) : session(followed), scene(drawn) {}

    Session& session;
    SceneGpu& scene;
    PickPass now;     ///< for answers at once
    PickPass coming;  ///< for those that come later
    std::optional<Question> asked;
};

ScenePicker::ScenePicker(Session& session, SceneGpu& scene) : d(std::make_unique<Private>(session, scene)) {}

ScenePicker::~ScenePicker() = default;

Result<std::optional<VertexRef>> ScenePicker::pick(const SceneGpu::View& view, const glm::vec2& at) {
    const Question question = questionAt(view, at);
    if (Status drawn = d->scene.drawElements(question.view, d->now, question.area, question.elements);
        !drawn) {
        return drawn.error();
    }
    return answer(d->session, question, d->now.read());
}

Status ScenePicker::request(const SceneGpu::View& view, const glm::vec2& at) {
    const Question question = questionAt(view, at);
    if (Status drawn = d->scene.drawElements(question.view, d->coming, question.area, question.elements);
        !drawn) {
        return drawn;
    }
    d->coming.startReading();
    d->asked = question;
    return Done{};
}

bool ScenePicker::isPending() const {
    return d->asked.has_value();
}

std::optional<std::optional<VertexRef>> ScenePicker::arrived() {
    if (!d->asked) {
        return std::nullopt;
    }
    const auto picked = d->coming.takeArrived();
    if (!picked) {
        return std::nullopt;
    }
    const Question question = *std::exchange(d->asked, std::nullopt);
    return answer(d->session, question, *picked);
}

Result<std::map<TargetId, std::vector<std::uint32_t>>> ScenePicker::changedWithin(
    const SceneGpu::View& view, std::span<const glm::vec2> outline, Depth depth) {
    Found found;
    for (const PicturePart& part : partsOf(view)) {
        std::vector<glm::vec2> moved(outline.begin(), outline.end());
        for (glm::vec2& corner : moved) {
            corner.x -= static_cast<float>(part.left);
        }
        const PixelArea area = areaOf(part, moved);
        if (area.width == 0 || area.height == 0) {
            continue;
        }
        std::optional<SeenTriangles> seen;
        if (depth == Depth::Visible && view.options.wireframe != WireframeMode::Only) {
            if (Status drawn = d->scene.drawElements(part.view, d->now, area, PickElements::Triangles);
                !drawn) {
                return drawn.error();
            }
            seen.emplace(d->session, part.view, area, d->now.read());
        }
        addWithin(found, d->session, part, moved, seen ? &*seen : nullptr);
    }
    // Two pictures show a vertex twice.
    for (auto& [target, vertices] : found) {
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }
    return found;
}

}  // namespace hitscope
