// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/handles/hit_handles.h"

#include <QKeyEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "deform/dent_shape.h"
#include "viewport/handles/handle_geometry.h"
#include "viewport/handles/handle_grip.h"
#include "viewport/inspect_tool.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kRingSides = 64;
constexpr int kRingPlaces = 8;     // where its grip may be
constexpr double kApart = 24.0;    // logical pixels, at least, from the point to a grip
constexpr double kEdge = 12.0;     // and from a grip to the edge of the picture
constexpr double kHeadSize = 6.0;  // logical pixels
constexpr int kDraggedDigits = 3;
/// Gestures of the handles, apart from those of the panel.
enum HandlePart : int { SizePart = 100, DepthPart, DirectionPart };

/// To three digits, as one would type it.
float roundedTo(const ParameterDescriptor& range, float value) {
    const double number = QString::number(static_cast<double>(value), 'g', kDraggedDigits).toDouble();
    return static_cast<float>(std::clamp(number, range.minimum, range.maximum));
}

/// What is seen of a sphere: a circle.
struct SphereOutline {
    glm::vec3 centre;
    glm::vec3 right;  ///< from the centre, as long as the radius
    glm::vec3 up;
};

SphereOutline outlineOf(const glm::vec3& centre, float radius, const Camera& camera) {
    const glm::vec3 away = centre - camera.eye();
    const float distance = glm::length(away);
    const bool isAround = camera.isOrthographic() || distance <= radius;
    const glm::vec3 forward = isAround ? camera.forward() : away / distance;
    const float share = isAround ? 0.0f : radius / distance;
    const glm::vec3 right = glm::normalize(
        glm::cross(forward, std::abs(forward.y) > 0.99f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)));
    const float seen = radius * std::sqrt(1.0f - share * share);
    return {centre - radius * share * forward, seen * right, seen * glm::cross(right, forward)};
}

}  // namespace

HitHandles::HitHandles(Viewport& viewport, Session& session, HitEditing& editing)
    : QWidget(&viewport),
      m_viewport(viewport),
      m_session(session),
      m_editing(editing),
      m_size(
          new HandleGrip(viewport, QStringLiteral("hitSize"), tr("Drag to change the dent's max distance"))),
      m_depth(new HandleGrip(viewport, QStringLiteral("hitDepth"),
                             tr("Drag to change the dent's max magnitude"))),
      m_direction(
          new HandleGrip(viewport, QStringLiteral("hitDirection"), tr("Drag to turn the hit's direction"))) {
    setObjectName(QStringLiteral("hitHandles"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    hide();
    connectGrip(*m_size, &HitHandles::dragSize);
    connectGrip(*m_depth, &HitHandles::dragDepth);
    connectGrip(*m_direction, &HitHandles::dragDirection);
    viewport.installEventFilter(this);
    connect(&viewport.navigation(), &Navigation::cameraChanged, this, &HitHandles::follow);
    connect(&viewport.pictures(), &PictureFlow::framePainted, this, &HitHandles::follow);
    connect(&editing, &HitEditing::edited, this, &HitHandles::follow);
    connect(&viewport.inspectTool(), &InspectTool::toolChanged, this, &HitHandles::follow);
    connect(&session.targets(), &SessionTargets::changed, this, &HitHandles::follow);
}

void HitHandles::connectGrip(HandleGrip& grip, void (HitHandles::*drag)(const QPointF&)) {
    connect(&grip, &HandleGrip::taken, this, [this, &grip] {
        m_editing.endGesture();
        m_before = shape().value_or(Shape{});
        m_from = grip.centre();
        const QPointF way = m_places ? m_places->head - m_places->point : QPointF();
        m_arrow = lengthOf(way) > 0.0 ? way / lengthOf(way) : QPointF(0.0, 1.0);
    });
    connect(&grip, &HandleGrip::draggedTo, this, drag);
    connect(&grip, &HandleGrip::released, &m_editing, &HitEditing::endGesture);
    connect(&grip, &HandleGrip::cancelled, &m_editing, &HitEditing::cancelGesture);
}

std::optional<HitHandles::Shape> HitHandles::shape() const {
    const Hit* hit = m_editing.current();
    const Target* target = hit != nullptr ? m_session.targets().find(hit->target) : nullptr;
    const bool isTargets = m_viewport.inspectTool().tool() == Tool::Move;  // whose handles are there
    if (target == nullptr || !target->visible || isTargets) {
        return std::nullopt;
    }
    return Shape{target->transform.toWorld(hit->point), target->transform.directionToWorld(pushOf(*hit)),
                 hit->form.presses() ? hit->form.radius : hit->constants.maxDistance,
                 hit->constants.maxMagnitude};
}

std::optional<HitHandles::Places> HitHandles::placesOf(const Shape& shape) const {
    const SphereOutline outline = outlineOf(shape.point, shape.reach, m_viewport.camera());
    Places places;
    const auto onRing = [&](int side) {
        const float angle = glm::two_pi<float>() * static_cast<float>(side) / kRingSides;
        return placeInPicture(
            m_viewport, outline.centre + std::cos(angle) * outline.right + std::sin(angle) * outline.up);
    };
    for (int side = 0; side <= kRingSides; ++side) {
        const std::optional<QPointF> place = onRing(side);
        if (!place) {
            return std::nullopt;
        }
        places.ring.append(*place);
    }
    const auto point = placeInPicture(m_viewport, shape.point);
    const auto head = placeInPicture(m_viewport, shape.point + shape.depth * shape.direction);
    const auto tail = placeInPicture(m_viewport, shape.point - shape.reach * shape.direction);
    if (!point || !head || !tail) {
        return std::nullopt;
    }
    places.point = *point;
    // Looking along it, the arrow has no length in the picture: its grips keep apart all the same.
    const QPointF way = *head - *tail;
    const QPointF unit = lengthOf(way) > 1.0 ? way / lengthOf(way) : QPointF(0.0, 1.0);
    places.head = *point + std::max(lengthOf(*head - *point), kApart) * unit;
    places.tail = *point - std::max(lengthOf(*tail - *point), kApart) * unit;
    places.size = sizeGripOf(places, QRectF(m_viewport.rect()).adjusted(kEdge, kEdge, -kEdge, -kEdge));
    return places;
}

/// The first place on the ring, from the right upwards, that is in the picture and clear of the other grips.
QPointF HitHandles::sizeGripOf(const Places& places, const QRectF& inside) {
    const auto at = [&places](int place) {
        const QPointF outward = places.ring[place * kRingSides / kRingPlaces] - places.point;
        const double length = std::max(lengthOf(outward), 1.0);
        return places.point + outward / length * std::max(length, kApart);
    };
    for (int place = 0; place < kRingPlaces; ++place) {
        const QPointF grip = at(place);
        if (inside.contains(grip) && lengthOf(grip - places.head) > kApart &&
            lengthOf(grip - places.tail) > kApart) {
            return grip;
        }
    }
    return at(0);
}

void HitHandles::follow() {
    const std::optional<Shape> now = shape();
    const std::optional<Places> places = now ? placesOf(*now) : std::nullopt;
    if (places == m_places && (places.has_value() == isVisible())) {
        return;
    }
    m_places = places;
    for (HandleGrip* grip : {m_size, m_depth, m_direction}) {
        grip->setVisible(places.has_value());
    }
    setVisible(places.has_value());
    if (!places) {
        if (isDragging()) {  // a grip that is hidden hears of no release
            letGo();
            m_editing.endGesture();
        }
        return;
    }
    m_size->place(places->size);
    m_depth->place(places->head);
    m_direction->place(places->tail);
    QPolygonF all = places->ring;
    all << places->head << places->tail;
    const QRectF around = all.boundingRect().adjusted(-kHeadSize, -kHeadSize, kHeadSize, kHeadSize);
    setGeometry(around.intersected(QRectF(m_viewport.rect())).toAlignedRect());
    update();
}

void HitHandles::paintEvent(QPaintEvent*) {
    if (!m_places) {
        return;
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(-pos());
    const QPointF way = m_places->head - m_places->tail;
    const QPointF unit = way / std::max(lengthOf(way), 1.0);
    const QPointF across(-unit.y(), unit.x());
    const QPointF end = m_places->head - 9.0 * unit;
    const QPolygonF head({end, end - kHeadSize * unit + 0.6 * kHeadSize * across,
                          end - kHeadSize * unit - 0.6 * kHeadSize * across});
    // Seen before any surface: dark below light.
    for (const auto& [role, width] :
         {std::pair(QPalette::Window, 3.5), std::pair(QPalette::Highlight, 1.6)}) {
        painter.setPen(QPen(palette().color(role), width));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolyline(m_places->ring);
        painter.drawLine(m_places->tail, end);
        painter.setBrush(palette().color(role));
        painter.drawPolygon(head);
    }
}

bool HitHandles::isDragging() const {
    return m_size->isHeld() || m_depth->isHeld() || m_direction->isHeld();
}

void HitHandles::letGo() {
    for (HandleGrip* grip : {m_size, m_depth, m_direction}) {
        grip->letGo();
    }
}

bool HitHandles::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::Resize) {
        follow();
    }
    if (event->type() == QEvent::KeyPress && isDragging() &&
        static_cast<const QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        letGo();
        m_editing.cancelGesture();
        return true;
    }
    return false;
}

// Dragging

/// From the hit's point, in the plane through it across the line of sight.
float HitHandles::distanceInPlane(const QPointF& place) const {
    const Ray ray = m_viewport.navigation().rayInFirst(place);
    const glm::vec3 forward = m_viewport.camera().forward();
    const float way = glm::dot(m_before.point - ray.origin, forward) / glm::dot(ray.direction, forward);
    return glm::distance(ray.origin + way * ray.direction, m_before.point);
}

void HitHandles::dragSize(const QPointF& to) {
    const float reach = m_before.reach * (distanceInPlane(to) / distanceInPlane(m_from));
    const float distance = roundedTo(hitParameters()[kMaxDistance], std::max(reach, 0.01f * m_before.reach));
    m_editing.change(SizePart, [distance](Hit& hit) {
        (hit.form.presses() ? hit.form.radius : hit.constants.maxDistance) = distance;
    });
}

float HitHandles::alongArrow(const QPointF& place) const {
    if (std::abs(glm::dot(m_before.direction, m_viewport.camera().forward())) > kAlongSight) {
        return static_cast<float>(QPointF::dotProduct(place, m_arrow)) * pixelAt(m_viewport, m_before.point);
    }
    return nearestAlong(m_viewport.navigation().rayInFirst(place), m_before.point, m_before.direction);
}

void HitHandles::dragDepth(const QPointF& to) {
    const float depth = m_before.depth + alongArrow(to) - alongArrow(m_from);
    if (std::isfinite(depth)) {
        const float magnitude = roundedTo(hitParameters()[kMaxMagnitude], std::max(depth, 0.0f));
        m_editing.change(DepthPart, [magnitude](Hit& hit) { hit.constants.maxMagnitude = magnitude; });
    }
}

/// The unit vector from the hit's point to where the ray meets the sphere that the arrow's tail is on, or
/// passes it.
glm::vec3 HitHandles::onSphere(const QPointF& place) const {
    const Ray ray = m_viewport.navigation().rayInFirst(place);
    const float radius = std::max(m_before.reach, glm::distance(m_before.point, ray.origin) * 1.0e-4f);
    const float middle = glm::dot(m_before.point - ray.origin, ray.direction);
    const glm::vec3 nearest = ray.origin + middle * ray.direction - m_before.point;
    const float inside = radius * radius - glm::dot(nearest, nearest);
    const bool isBehind = glm::dot(m_before.direction, m_viewport.camera().forward()) < 0.0f;
    const float half = inside > 0.0f ? std::sqrt(inside) : 0.0f;
    return glm::normalize(nearest + (isBehind ? half : -half) * ray.direction);
}

void HitHandles::dragDirection(const QPointF& to) {
    // Where the grip stands off the sphere, it is moved onto it first.
    const std::optional<QPointF> tail =
        placeInPicture(m_viewport, m_before.point - m_before.reach * m_before.direction);
    const QPointF offset = tail ? *tail - m_from : QPointF();
    const Hit* hit = m_editing.current();
    const Target* target = hit != nullptr ? m_session.targets().find(hit->target) : nullptr;
    if (target == nullptr) {
        return;
    }
    const glm::vec3 direction = target->transform.directionToLocal(-onSphere(to + offset));
    m_editing.change(DirectionPart, [direction](Hit& edited) {
        edited.flight = edited.flight != glm::vec3(0.0f) ? edited.flight : edited.direction;
        edited.direction = direction;
        if (edited.form.direction == DentDirection::IntoSurface) {
            edited.form.direction = DentDirection::Projectile;
        }
    });
}

}  // namespace hitscope
