// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <QTimer>
#include <cstdint>
#include <optional>
#include <vector>

#include "session/session.h"

class QLabel;

namespace hitscope {

class Viewport;

/// While the cursor rests on a target: the dent that a click there would make, as a ghost, and how many
/// vertices it would affect how deeply, beside the cursor. Nothing is worked out while the mouse moves.
class AimPreview : public QObject {
    Q_OBJECT
public:
    /// `session` outlives this; a child of the viewport.
    AimPreview(Session& session, Viewport& viewport);

    [[nodiscard]] bool isEnabled() const { return m_enabled; }
    void setEnabled(bool on);
    /// Whether a click shoots at all; off while another tool has the mouse.
    void setClicksShoot(bool on);

    /// Where the hit would be that the preview shows.
    struct Aim {
        TargetId target;
        glm::vec3 point{0.0f};  ///< metres, local frame
        float reach = 0.0f;     ///< metres
    };
    [[nodiscard]] const std::optional<Aim>& aim() const { return m_aim; }  ///< nothing: it rested on none
    /// A dent of fewer vertices is hardly one: the preview offers to refine the mesh there.
    static constexpr std::size_t kFewVertices = 10;

    static constexpr int kRest = 150;  ///< milliseconds without a move
    /// More vertices in reach than this would hold the window up: they are not counted.
    static constexpr std::size_t kMostVertices = 30'000;

Q_SIGNALS:
    void shown();  ///< the cursor rested, and aim() is another

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void clear();
    void wait();  ///< shows it anew once the cursor has rested
    void show();
    void showText(const QString& text);
    std::span<const Bounds> clusterBoxes(const Target& target);

    Session& m_session;
    Viewport& m_viewport;
    QLabel* m_label = nullptr;
    QTimer m_rest;
    QPointF m_at;  ///< of the cursor, logical pixels
    bool m_enabled = true;
    bool m_clicksShoot = true;
    bool m_isOver = false;  ///< the cursor is over the viewport, no button pressed
    std::optional<Aim> m_aim;
    TargetId m_boxesOf;
    std::uint64_t m_boxesRevision = 0;
    std::vector<Bounds> m_boxes;
};

}  // namespace hitscope
