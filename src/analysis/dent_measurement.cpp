// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/dent_measurement.h"

#include <algorithm>
#include <utility>

#include "analysis/dent_job.h"
#include "io/csv_writer.h"
#include "session/shown_number.h"

namespace hitscope {

DentMeasurement::DentMeasurement(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    m_timer.setSingleShot(true);
    m_job.showIn(session.tasks(), tr("Measuring the dent"));
    connect(&m_timer, &QTimer::timeout, this, &DentMeasurement::gather);
    connect(&session.selection(), &VertexSelection::pickedChanged, this, &DentMeasurement::followPick);
    connect(&session.hits(), &SessionHits::selectedChanged, this, &DentMeasurement::followHit);
    connect(&session.readBack(), &ReadBack::meshChanged, this, &DentMeasurement::followMesh);
    connect(&session.readBack(), &ReadBack::verticesMoved, this,
            [this](TargetId id, const std::vector<std::uint32_t>& vertices) {
                if (const Target* moved = m_session.targets().find(id)) {
                    m_copies.note(*moved, vertices);
                }
            });
    connect(&session.hits(), &SessionHits::changed, this, &DentMeasurement::request);
    connect(&session.hits(), &SessionHits::rearranged, this, &DentMeasurement::request);
    connect(&session.hits(), &SessionHits::shownChanged, this, &DentMeasurement::request);
    connect(&session.readBack(), &ReadBack::capacityChanged, this, &DentMeasurement::request);
    connect(&session, &Session::sceneReplaced, this, &DentMeasurement::forget);
    connect(&session.targets(), &SessionTargets::removed, this, &DentMeasurement::forget);
    connect(&session.targets(), &SessionTargets::changed, this, &DentMeasurement::followPlace);
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
    if (m_session.hits().selected()) {
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
    followPlace(changed);
}

/// The target may have been moved.
void DentMeasurement::followPlace(TargetId changed) {
    if (m_picked[0] && (m_picked[0]->target == changed || m_picked[1]->target == changed)) {
        Q_EMIT distanceChanged();
    }
}

/// They may be in use: a job that has them is given up with them.
void DentMeasurement::dropCopies() {
    m_timer.stop();
    m_job.cancel();
    m_history.startOver();
    m_copies.clear();
}

void DentMeasurement::forget() {
    dropCopies();
    m_source = Source::None;
    m_picked = {};
    refuse(tr("Select a hit, or right-click a dent in the viewport."));
    Q_EMIT distanceChanged();
}

void DentMeasurement::refuse(const QString& why) {
    m_isDue = false;
    m_isVoid = true;
    m_report = {};
    m_report.why = why;
    Q_EMIT reportChanged();
}

/// Empty: nothing stands against it.
QString DentMeasurement::whyNotMeasured() const {
    if (m_source != Source::Hit) {
        return {};
    }
    const std::optional<std::size_t> row = m_session.hits().selected();
    if (!row) {
        return tr("Select a hit, or right-click a dent in the viewport.");
    }
    const QString number = shownCount(*row + 1);
    if (!m_session.hits().history().hits()[*row].enabled) {
        return tr("Hit %1 is disabled, so it has no dent to measure.").arg(number);
    }
    if (*row >= m_session.hits().shown().size()) {
        return tr("Hit %1 comes after the hits that are shown, so it has no dent to measure.").arg(number);
    }
    return m_session.hits().isApplied(*row)
               ? QString()
               : tr("The pipeline has dropped hit %1, so it has no dent to measure.").arg(number);
}

std::optional<TargetId> DentMeasurement::target() const {
    if (m_source == Source::Vertex && m_picked[1]) {
        return m_picked[1]->target;
    }
    if (m_source == Source::Hit && m_session.hits().selected()) {
        return m_session.hits().history().hits()[*m_session.hits().selected()].target;
    }
    return std::nullopt;
}

void DentMeasurement::setAngle(double angle) {
    if (angle != m_angle) {
        m_angle = angle;
        request();
    }
}

void DentMeasurement::setTellsApart(bool on) {
    if (on != m_tellsApart) {
        m_tellsApart = on;
        request();
    }
}

void DentMeasurement::setActive(bool active) {
    if (active == m_isActive) {
        return;
    }
    m_isActive = active;
    if (active) {
        request();
    } else {
        dropCopies();
    }
}

/// Not right here: moved vertices are reported in the middle of drawing a frame.
void DentMeasurement::request() {
    if (const QString why = whyNotMeasured(); !why.isEmpty()) {
        refuse(why);
        return;
    }
    m_isDue = target().has_value();
    if (m_isDue && m_isActive && !isBusy()) {
        m_timer.start(0);
    }
}

/// Carries over what has moved, over several turns of the event loop if it is much; then starts.
void DentMeasurement::gather() {
    const std::optional<TargetId> id = target();
    const Target* of = id ? m_session.targets().find(*id) : nullptr;
    if (of == nullptr || !m_isDue) {
        return;
    }
    if (!m_copies.contains(*id)) {
        m_copies.clear();
    }
    auto room = m_copies.kATurn;
    if (m_copies.gather(*of, room,
                        [of] { return std::make_shared<DentCopy>(of->deformed.sharedRender()); })) {
        start(*of);
    } else {
        m_timer.start(0);
    }
}

void DentMeasurement::start(const Target& target) {
    m_isDue = false;
    m_isVoid = false;
    auto job = std::make_shared<DentJob>();
    job->target = target.id;
    job->name = target.name;
    job->part = m_copies.take(target.id);
    job->update = m_history.update(m_session.hits().history(), m_session.hits().applied());
    job->history = m_history.copy();
    job->angle = static_cast<float>(m_angle);
    job->tellsApart = m_tellsApart;
    if (m_source == Source::Vertex) {
        job->vertex = m_picked[1]->vertex;
    } else {
        job->row = *m_session.hits().selected();
    }
    m_job.start(*this, job, &DentMeasurement::take);
}

void DentMeasurement::take(DentJob& job, bool done) {
    if (!done) {
        dropCopies();
        refuse(tr("There is not enough memory to measure this dent."));
        return;
    }
    if (!m_isVoid && m_source != Source::None) {
        m_report = std::move(job.report);
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
    const Target* from = m_session.targets().find(m_picked[0]->target);
    const Target* to = m_session.targets().find(m_picked[1]->target);
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
QString DentMeasurement::numbersOf(const std::vector<std::size_t>& rows) {
    QStringList numbers;
    for (const std::size_t row : rows) {
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
            lines.append(tr("Merged dent of hits") + u'\t' + numbersOf(m_report.mergedHits));
        }
        if (!m_report.partHits.empty()) {
            lines.append(tr("Part moved most by hits") + u'\t' + numbersOf(m_report.partHits));
        }
    }
    if (const std::optional<Distance> between = distance()) {
        add(tr("Distance, original"), between->before, QStringLiteral("m"));
        add(tr("Distance, deformed"), between->after, QStringLiteral("m"));
    }
    return lines.join(u'\n');
}

QByteArray DentMeasurement::profileCsv() const {
    constexpr int kDigits = 9;
    CsvWriter csv;
    if (!m_report.mergedHits.empty()) {
        csv.comment("merged dent of hits " + numbersOf(m_report.mergedHits).toStdString());
    }
    if (!m_report.partHits.empty()) {
        csv.comment("part moved most by hits " + numbersOf(m_report.partHits).toStdString());
    }
    csv.row({"state", "line", "along_m", "height_m"});
    const auto add = [&csv](const char* state, const Profile& lines) {
        for (std::size_t line = 0; line < lines.size(); ++line) {
            for (const ProfilePoint& point : lines[line]) {
                csv.text(state).count(line).general(point.along, kDigits).general(point.height, kDigits);
                csv.endRow();
            }
        }
    };
    add("original", m_report.before);
    add("deformed", m_report.after);
    return QByteArray::fromStdString(csv.take());
}

}  // namespace hitscope
