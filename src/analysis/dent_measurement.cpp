// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/dent_measurement.h"

#include <algorithm>
#include <utility>

#include "analysis/dent_hits.h"
#include "mesh/dent_profile.h"
#include "session/shown_number.h"

namespace hitscope {

struct DentMeasurement::Order {
    QString target;
    std::shared_ptr<const RenderMesh> render;
    std::vector<glm::vec3> after;
    std::vector<Hit> hits;                ///< those applied to the target
    std::vector<std::size_t> rows;        ///< of the history, where they are
    std::optional<std::uint32_t> vertex;  ///< else the dent of:
    std::size_t hit = 0;                  ///< an index into `hits`
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
        const std::optional<std::uint32_t> seed = order.vertex ? order.vertex : m_hits.deepestOf(order.hit);
        const std::vector<std::uint32_t> vertices =
            seed ? dentAround(*seed, m_before->triangles(), before, order.after)
                 : std::vector<std::uint32_t>();
        report.dent = measureDent(vertices, m_before->triangles(), before, order.after);
        if (!report.dent) {
            report.why = order.vertex ? DentMeasurement::tr("No hit has moved the picked vertex.")
                         : seed       ? DentMeasurement::tr("The selected hit's dent is not there any more.")
                                      : DentMeasurement::tr("The selected hit has moved no vertex.");
            return report;
        }
        nameHits(report, order, vertices);
        const glm::vec3 deepest = before[report.dent->deepest];
        const Plane plane = profilePlane(*report.dent, deepest, order.angle);
        const ProfileFrame frame = profileFrame(*report.dent, plane, vertices, before, order.after);
        const auto profile = [&](const MeshSections& mesh) {
            const glm::vec3 at = mesh.positions()[report.dent->deepest];
            std::vector<ProfilePoint> line =
                profileLine(mesh.cut(plane), plane, *report.dent, deepest, frame, at);
            return line.empty() ? Profile() : Profile{std::move(line)};
        };
        report.before = profile(*m_before);
        report.after = profile(*m_after);
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
        m_hits.follow(order.render, order.hits);
    }

    void nameHits(Report& report, const Order& order, std::span<const std::uint32_t> vertices) const {
        Bounds box;
        for (const std::uint32_t vertex : vertices) {
            box.add(m_before->positions()[vertex]);
            box.add(order.after[vertex]);
        }
        const std::vector<std::size_t> all = m_hits.madeBy(vertices, box);
        if (all.size() < 2) {
            return;
        }
        std::vector<std::size_t> named;
        for (const std::size_t hit : all) {
            report.mergedHits.push_back(order.rows[hit]);
            if (order.vertex || hit != order.hit) {
                named.push_back(order.rows[hit]);
            }
        }
        report.merged =
            (order.vertex ? DentMeasurement::tr("Merged dent of %1") : DentMeasurement::tr("Merged with %1"))
                .arg(hitNumbersText(named));
    }

    std::shared_ptr<const RenderMesh> m_render;
    std::unique_ptr<MeshSections> m_before;
    std::unique_ptr<MeshSections> m_after;
    DentHits m_hits;
};

DentMeasurement::DentMeasurement(Session& session, QObject* parent)
    : QObject(parent), m_session(session), m_worker(std::make_shared<Worker>()) {
    m_pool.setMaxThreadCount(1);
    connect(&session.selection(), &VertexSelection::pickedChanged, this, &DentMeasurement::followPick);
    connect(&session, &Session::hitSelected, this, &DentMeasurement::followHit);
    connect(&session, &Session::meshChanged, this, &DentMeasurement::followMesh);
    connect(&session, &Session::hitsChanged, this, &DentMeasurement::request);
    connect(&session, &Session::hitsRearranged, this, &DentMeasurement::request);
    connect(&session, &Session::shownHitsChanged, this, &DentMeasurement::request);
    connect(&session, &Session::capacityChanged, this, &DentMeasurement::request);
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
    }
    if (m_source == Source::Hit) {
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
    refuse(tr("Select a hit, or right-click a dent in the viewport."));
    Q_EMIT distanceChanged();
}

void DentMeasurement::refuse(const QString& why) {
    m_isDue = false;
    m_isVoid = m_isBusy;
    m_report = {};
    m_report.why = why;
    Q_EMIT reportChanged();
}

/// Empty: nothing stands against it.
QString DentMeasurement::whyNotMeasured() const {
    if (m_source != Source::Hit) {
        return {};
    }
    const std::optional<std::size_t> row = m_session.selectedHit();
    if (!row) {
        return tr("Select a hit, or right-click a dent in the viewport.");
    }
    const QString number = shownCount(*row + 1);
    if (!m_session.history().hits()[*row].enabled) {
        return tr("Hit %1 is disabled, so it has no dent to measure.").arg(number);
    }
    if (*row >= m_session.shownHits().size()) {
        return tr("Hit %1 comes after the hits that are shown, so it has no dent to measure.").arg(number);
    }
    return m_session.isApplied(*row)
               ? QString()
               : tr("The pipeline has dropped hit %1, so it has no dent to measure.").arg(number);
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
    if (const QString why = whyNotMeasured(); !why.isEmpty()) {
        refuse(why);
        return;
    }
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
    const std::span<const Hit> hits = m_session.shownHits();
    for (std::size_t row = 0; row < hits.size(); ++row) {
        if (hits[row].target == *id && m_session.isApplied(row)) {
            order->hits.push_back(hits[row]);
            order->rows.push_back(row);
        }
    }
    if (m_source == Source::Vertex) {
        order->vertex = m_picked[1]->vertex;
    } else {
        order->hit = static_cast<std::size_t>(
            std::lower_bound(order->rows.begin(), order->rows.end(), *m_session.selectedHit()) -
            order->rows.begin());
    }
    m_pool.start([this, order, worker = m_worker] {
        Report report = worker->measure(*order);
        QMetaObject::invokeMethod(this, [this, report] { take(report); });
    });
}

void DentMeasurement::take(Report report) {
    m_isBusy = false;
    if (!std::exchange(m_isVoid, false) && m_source != Source::None) {
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

/// For what is copied or saved: all of them.
QString DentMeasurement::mergedNumbers() const {
    QStringList numbers;
    for (const std::size_t row : m_report.mergedHits) {
        numbers.append(QString::number(row + 1));
    }
    return numbers.join(QStringLiteral(", "));
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
        if (!m_report.mergedHits.empty()) {
            lines.append(tr("Merged dent of hits") + u'\t' + mergedNumbers());
        }
    }
    if (const std::optional<Distance> between = distance()) {
        add(tr("Distance, original"), between->before, QStringLiteral("m"));
        add(tr("Distance, deformed"), between->after, QStringLiteral("m"));
    }
    return lines.join(u'\n');
}

QByteArray DentMeasurement::profileCsv() const {
    QByteArray csv;
    if (!m_report.mergedHits.empty()) {
        csv += "# merged dent of hits " + mergedNumbers().toUtf8() + '\n';
    }
    csv += "state,line,along_m,height_m\n";
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
