// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/dent_measurement.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace hitscope {

struct DentMeasurement::Order {
    QString target;
    std::shared_ptr<const RenderMesh> render;
    std::vector<glm::vec3> after;
    std::optional<std::uint32_t> vertex;  ///< else the dent nearest to:
    Hit hit;
    float angle = 0.0f;
};

/// What is made once for a mesh, and how it is used.
class DentMeasurement::Worker {
public:
    Report measure(const Order& order) {
        prepare(order);
        Report report;
        report.target = order.target;
        const std::span<const glm::vec3> before = m_before->positions();
        const std::optional<std::uint32_t> seed = order.vertex ? order.vertex : nearestMoved(order);
        const std::vector<std::uint32_t> vertices =
            seed ? dentAround(*seed, m_before->triangles(), before, order.after)
                 : std::vector<std::uint32_t>();
        report.dent = measureDent(vertices, m_before->triangles(), before, order.after);
        if (!report.dent) {
            report.why = order.vertex ? DentMeasurement::tr("No hit has moved the picked vertex.")
                                      : DentMeasurement::tr("The selected hit's dent is not there any more.");
            return report;
        }
        const glm::vec3 deepest = before[report.dent->deepest];
        const Plane plane = profilePlane(*report.dent, deepest, order.angle);
        report.before = profile(*m_before, plane, *report.dent, deepest);
        report.after = profile(*m_after, plane, *report.dent, deepest);
        return report;
    }

private:
    void prepare(const Order& order) {
        if (m_render != order.render) {
            m_render = order.render;
            m_before = std::make_unique<MeshSections>(*m_render);
            m_after = std::make_unique<MeshSections>(*m_before);
        }
        m_after->setPositions(order.after);
    }

    [[nodiscard]] std::optional<std::uint32_t> nearestMoved(const Order& order) const {
        const std::span<const glm::vec3> before = m_before->positions();
        std::optional<std::uint32_t> nearest;
        float least = 2.0f * order.hit.constants.maxDistance;
        for (std::uint32_t vertex = 0; vertex < before.size(); ++vertex) {
            const float distance = glm::distance(before[vertex], order.hit.point);
            if (distance < least && before[vertex] != order.after[vertex]) {
                least = distance;
                nearest = vertex;
            }
        }
        return nearest;
    }

    /// As far as the dent and half as much again on either side.
    static Profile profile(const MeshSections& mesh, const Plane& plane, const DentMeasures& dent,
                           const glm::vec3& deepest) {
        const double reach = std::max(0.75 * dent.rimDiameter, 1.0e-6);
        const double depth = 2.0 * reach + 2.0 * dent.depth;
        Profile lines;
        for (const SectionCurve& curve : mesh.cut(plane)) {
            std::vector<glm::vec3> points = curve.points;
            if (curve.closed && !points.empty()) {
                points.push_back(points.front());
            }
            std::vector<ProfilePoint> line;
            const auto finish = [&lines, &line] {
                if (line.size() > 1) {
                    lines.push_back(line);
                }
                line.clear();
            };
            for (const glm::vec3& point : points) {
                const ProfilePoint at = toProfile(plane, dent, deepest, point);
                if (std::abs(at.along) <= reach && std::abs(at.height) <= depth) {
                    line.push_back(at);
                } else {
                    finish();
                }
            }
            finish();
        }
        return lines;
    }

    std::shared_ptr<const RenderMesh> m_render;
    std::unique_ptr<MeshSections> m_before;
    std::unique_ptr<MeshSections> m_after;
};

DentMeasurement::DentMeasurement(Session& session, QObject* parent)
    : QObject(parent), m_session(session), m_worker(std::make_shared<Worker>()) {
    m_pool.setMaxThreadCount(1);
    connect(&session.selection(), &VertexSelection::pickedChanged, this, &DentMeasurement::followPick);
    connect(&session, &Session::hitSelected, this, &DentMeasurement::followHit);
    connect(&session, &Session::meshChanged, this, &DentMeasurement::followMesh);
    connect(&session, &Session::sceneReplaced, this, &DentMeasurement::forget);
    connect(&session, &Session::targetRemoved, this, &DentMeasurement::forget);
    forget();
}

DentMeasurement::~DentMeasurement() = default;

void DentMeasurement::followPick() {
    const std::optional<VertexRef>& picked = m_session.selection().picked();
    if (!picked) {
        return;
    }
    if (m_picked[1] != picked) {
        m_picked = {m_picked[1], picked};
        Q_EMIT distanceChanged();
    }
    m_source = Source::Vertex;
    request();
}

void DentMeasurement::followHit() {
    if (m_session.selectedHit()) {
        m_source = Source::Hit;
        request();
    }
}

void DentMeasurement::followMesh(TargetId changed) {
    if (target() == changed) {
        request();
    }
    if (m_picked[0] && (m_picked[0]->target == changed || m_picked[1]->target == changed)) {
        Q_EMIT distanceChanged();
    }
}

void DentMeasurement::forget() {
    m_source = Source::None;
    m_picked = {};
    m_isDue = false;
    m_report = {};
    m_report.why = tr("Select a hit, or right-click a dent in the viewport.");
    Q_EMIT reportChanged();
    Q_EMIT distanceChanged();
}

std::optional<TargetId> DentMeasurement::target() const {
    if (m_source == Source::Vertex && m_picked[1]) {
        return m_picked[1]->target;
    }
    if (m_source == Source::Hit && m_session.selectedHit()) {
        return m_session.history().hits()[*m_session.selectedHit()].target;
    }
    return std::nullopt;
}

void DentMeasurement::setAngle(double angle) {
    if (angle != m_angle) {
        m_angle = angle;
        request();
    }
}

void DentMeasurement::setActive(bool active) {
    m_isActive = active;
    if (active && m_isDue) {
        request();
    }
}

void DentMeasurement::request() {
    const std::optional<TargetId> id = target();
    const Target* of = id ? m_session.target(*id) : nullptr;
    m_isDue = of != nullptr;
    if (of == nullptr || m_isBusy || !m_isActive) {
        return;
    }
    m_isDue = false;
    m_isBusy = true;
    const std::span<const glm::vec3> after = of->deformed.positions();
    auto order = std::make_shared<Order>();
    order->target = of->name;
    order->render = of->deformed.sharedRender();
    order->after.assign(after.begin(), after.end());
    order->angle = static_cast<float>(m_angle);
    if (m_source == Source::Vertex) {
        order->vertex = m_picked[1]->vertex;
    } else {
        order->hit = m_session.history().hits()[*m_session.selectedHit()];
    }
    m_pool.start([this, order, worker = m_worker] {
        Report report = worker->measure(*order);
        QMetaObject::invokeMethod(this, [this, report] { take(report); });
    });
}

void DentMeasurement::take(Report report) {
    m_isBusy = false;
    if (m_source != Source::None) {
        m_report = std::move(report);
        Q_EMIT reportChanged();
    }
    if (m_isDue) {
        request();
    }
}

std::optional<DentMeasurement::Distance> DentMeasurement::distance() const {
    if (!m_picked[0] || !m_picked[1]) {
        return std::nullopt;
    }
    const Target* from = m_session.target(m_picked[0]->target);
    const Target* to = m_session.target(m_picked[1]->target);
    if (from == nullptr || to == nullptr) {
        return std::nullopt;
    }
    const auto world = [](const Target& target, const glm::vec3& point) {
        return glm::dvec3(target.transform.toWorld(point));
    };
    const std::uint32_t a = m_picked[0]->vertex;
    const std::uint32_t b = m_picked[1]->vertex;
    return Distance{
        *m_picked[0], *m_picked[1],
        glm::distance(world(*from, from->deformed.original().positions[a]),
                      world(*to, to->deformed.original().positions[b])),
        glm::distance(world(*from, from->deformed.positions()[a]), world(*to, to->deformed.positions()[b]))};
}

QString DentMeasurement::text() const {
    QStringList lines;
    const auto add = [&lines](const QString& name, double value, const QString& unit) {
        lines.append(QStringLiteral("%1\t%2\t%3").arg(name, QString::number(value, 'g', 6), unit));
    };
    if (const auto& dent = m_report.dent) {
        lines.append(tr("Target") + u'\t' + m_report.target);
        add(tr("Vertices moved"), static_cast<double>(dent->vertices), {});
        add(tr("Depth"), dent->depth, QStringLiteral("m"));
        add(tr("Rim diameter"), dent->rimDiameter, QStringLiteral("m"));
        add(tr("Affected area"), dent->affectedArea, QStringLiteral("m²"));
        add(tr("Displaced volume"), dent->displacedVolume, QStringLiteral("m³"));
    }
    if (const std::optional<Distance> between = distance()) {
        add(tr("Distance, original"), between->before, QStringLiteral("m"));
        add(tr("Distance, deformed"), between->after, QStringLiteral("m"));
    }
    return lines.join(u'\n');
}

QByteArray DentMeasurement::profileCsv() const {
    QByteArray csv = "state,line,along_m,height_m\n";
    const auto add = [&csv](const char* state, const Profile& lines) {
        for (std::size_t line = 0; line < lines.size(); ++line) {
            for (const ProfilePoint& point : lines[line]) {
                csv += QByteArray(state) + ',' + QByteArray::number(static_cast<qulonglong>(line)) + ',' +
                       QByteArray::number(point.along, 'g', 9) + ',' +
                       QByteArray::number(point.height, 'g', 9) + '\n';
            }
        }
    };
    add("original", m_report.before);
    add("deformed", m_report.after);
    return csv;
}

}  // namespace hitscope
