// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/dent_job.h"

#include <algorithm>
#include <utility>

#include "deform/dent_owners.h"
#include "mesh/dent_profile.h"

namespace hitscope {

void DentCopy::follow(std::span<const MovedVertex> moved, std::span<const Hit> hits) {
    if (!m_before) {
        m_before = std::make_unique<MeshSections>(*m_render);
        m_after = std::make_unique<MeshSections>(*m_before);
    }
    m_after->move(moved);
    m_hits.follow(m_render, hits);
}

void DentJob::run(const std::stop_token& stop) {
    history->apply(update);
    std::vector<Hit> hits;
    for (std::size_t i = 0; i < history->hits().size(); ++i) {
        const Hit& hit = history->hits()[i];
        if (hit.target == target && hit.enabled) {
            hits.push_back(hit);
            m_rows.push_back(i);
        }
    }
    m_hit = static_cast<std::size_t>(std::lower_bound(m_rows.begin(), m_rows.end(), row) - m_rows.begin());
    part.copy->follow(part.moved, hits);
    if (!stop.stop_requested()) {
        measure(stop);
    }
}

void DentJob::measure(const std::stop_token& stop) {
    report.target = name;
    const MeshSections& mesh = part.copy->before();
    const std::span<const glm::vec3> before = mesh.positions();
    const std::span<const glm::vec3> after = part.copy->after().positions();
    const bool isApplied = m_hit < m_rows.size() && m_rows[m_hit] == row;
    const std::optional<std::uint32_t> seed =
        vertex || !isApplied ? vertex : part.copy->hits().deepestOf(m_hit, mesh.triangles(), before, after);
    const std::vector<std::uint32_t> whole =
        seed ? dentAround(*seed, mesh.triangles(), before, after, mesh.sewn()) : std::vector<std::uint32_t>();
    const std::vector<std::uint32_t> own = whole.empty() ? whole : nameHits(whole, stop);
    const std::vector<std::uint32_t>& vertices = own.empty() ? whole : own;
    report.dent = measureDent(vertices, mesh.triangles(), before, after, whole);
    if (!report.dent) {
        report.why = vertex ? DentMeasurement::tr("No hit has moved the picked vertex.")
                     : seed ? DentMeasurement::tr("The selected hit's dent is not there any more.")
                            : DentMeasurement::tr("The selected hit has moved no vertex of a face.");
        return;
    }
    const glm::vec3 deepest = before[report.dent->deepest];
    const Plane plane = profilePlane(*report.dent, deepest, angle);
    const ProfileFrame frame = profileFrame(*report.dent, plane, vertices, before, after);
    const auto profile = [&](const MeshSections& cut) {
        const glm::vec3 at = cut.positions()[report.dent->deepest];
        std::vector<ProfilePoint> line = profileLine(cut.cut(plane), plane, *report.dent, deepest, frame, at);
        return line.empty() ? DentMeasurement::Profile() : DentMeasurement::Profile{std::move(line)};
    };
    report.before = profile(part.copy->before());
    report.after = profile(part.copy->after());
}

/// Returns the vertices that this dent is measured by, where that is a part of the whole; else none.
std::vector<std::uint32_t> DentJob::nameHits(std::span<const std::uint32_t> whole,
                                             const std::stop_token& stop) {
    Bounds box;
    for (const std::uint32_t moved : whole) {
        box.add(part.copy->before().positions()[moved]);
        box.add(part.copy->after().positions()[moved]);
    }
    const std::vector<std::size_t> all = part.copy->hits().madeBy(whole, box);
    if (all.size() < 2) {
        return {};
    }
    std::vector<std::size_t> named;
    for (const std::size_t hit : all) {
        report.mergedHits.push_back(m_rows[hit]);
        if (vertex || hit != m_hit) {
            named.push_back(m_rows[hit]);
        }
    }
    report.merged =
        (vertex ? DentMeasurement::tr("Merged dent of %1") : DentMeasurement::tr("Merged with %1"))
            .arg(hitNumbersText(named));
    return tellsApart ? partOf(whole, all, stop) : std::vector<std::uint32_t>();
}

std::vector<std::uint32_t> DentJob::partOf(std::span<const std::uint32_t> whole,
                                           std::span<const std::size_t> all, const std::stop_token& stop) {
    const std::vector<Hit> made = part.copy->hits().hitsAt(all);
    const std::vector<std::uint32_t> dents = dentsOfHits(made);
    const std::vector<std::uint32_t> owners =
        dentOwners(part.copy->hits().mesh(), whole, made, dents, [&stop] { return stop.stop_requested(); });
    const auto at = [](const auto& list, auto value) {
        return static_cast<std::size_t>(std::lower_bound(list.begin(), list.end(), value) - list.begin());
    };
    const std::size_t place = vertex ? at(whole, *vertex) : at(all, m_hit);
    if (owners.empty() || place >= (vertex ? whole.size() : all.size())) {
        return {};
    }
    const std::uint32_t dent = vertex ? owners[place] : dents[place];
    std::vector<std::uint32_t> own;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        if (owners[i] == dent) {
            own.push_back(whole[i]);
        }
    }
    if (own.size() == whole.size()) {
        return {};
    }
    namePart(!own.empty(), all, dents, dent);
    return own;
}

void DentJob::namePart(bool isThere, std::span<const std::size_t> all, std::span<const std::uint32_t> dents,
                       std::uint32_t dent) {
    std::vector<std::size_t> makers;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (dents[i] == dent) {
            makers.push_back(m_rows[all[i]]);
        }
    }
    const QString text = isThere ? DentMeasurement::tr("%1; this is the part that %2 moved most")
                                 : DentMeasurement::tr("%1; other hits moved every vertex of it farther");
    report.merged = isThere ? text.arg(report.merged, hitNumbersText(makers)) : text.arg(report.merged);
    report.partHits = isThere ? makers : std::vector<std::size_t>();
}

}  // namespace hitscope
