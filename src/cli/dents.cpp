// SPDX-License-Identifier: GPL-3.0-or-later
// What each dent of a session measures.
#include <algorithm>
#include <map>

#include "analysis/dent_hits.h"
#include "cli/common_options.h"
#include "cli/opened_scene.h"
#include "cli/progress_line.h"
#include "cli/scene_options.h"
#include "cli/standard_streams.h"
#include "cli/target_argument.h"
#include "cli/verbs.h"
#include "deform/dent_owners.h"
#include "io/csv_writer.h"
#include "mesh/dent.h"
#include "mesh/surface/disjoint_sets.h"
#include "mesh/surface/sewn_vertices.h"

namespace hitscope::cli {

namespace {

/// One connected piece of moved surface.
struct Dent {
    std::vector<std::uint32_t> vertices;  ///< of the file, ascending
    DentMeasures measures;
    std::vector<std::size_t> hits;  ///< rows of the history
};

/// 3 a triangle, the file's vertices.
std::vector<std::uint32_t> fileTriangles(const RenderMesh& mesh) {
    std::vector<std::uint32_t> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const std::uint32_t vertex : mesh.triangles) {
        triangles.push_back(mesh.fileVertices[vertex]);
    }
    return triangles;
}

/// The moved vertices, those together that edges of triangles join, or that stand for one another where the
/// file split the surface; by their lowest.
std::vector<std::vector<std::uint32_t>> movedPieces(const DeformedMesh& mesh,
                                                    std::span<const std::uint32_t> triangles) {
    DisjointSets sets(mesh.positions().size());
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t a = triangles[i + corner];
            const std::uint32_t b = triangles[i + (corner + 1) % 3];
            if (mesh.isChanged(a) && mesh.isChanged(b)) {
                sets.join(a, b);
            }
        }
    }
    const std::vector<std::uint32_t> sewn = sewnVertices(mesh.original().positions, triangles);
    for (std::uint32_t vertex = 0; vertex < sewn.size(); ++vertex) {
        sets.join(vertex, sewn[vertex]);
    }
    std::map<std::uint32_t, std::vector<std::uint32_t>> byRoot;
    for (const std::uint32_t vertex : mesh.onceChanged()) {
        if (mesh.isChanged(vertex)) {
            byRoot[sets.find(vertex).root].push_back(vertex);
        }
    }
    std::vector<std::vector<std::uint32_t>> pieces;
    for (auto& [root, vertices] : byRoot) {
        std::sort(vertices.begin(), vertices.end());
        pieces.push_back(std::move(vertices));
    }
    return pieces;
}

/// The vertices of one connected piece by the dents that overlap in it, and the hits of each, as indices into
/// `hits`; `made`: those that moved some of them.
struct DentPart {
    std::vector<std::uint32_t> vertices;
    std::vector<std::size_t> hits;
};
std::vector<DentPart> toldApart(const RenderMesh& mesh, const std::vector<std::uint32_t>& vertices,
                                std::span<const Hit> hits, const std::vector<std::size_t>& made) {
    std::vector<Hit> own;
    std::transform(made.begin(), made.end(), std::back_inserter(own),
                   [hits](std::size_t hit) { return hits[hit]; });
    const std::vector<std::uint32_t> dents = dentsOfHits(own);
    const std::vector<std::uint32_t> owners = dentOwners(mesh, vertices, own, dents);
    std::map<std::uint32_t, DentPart> parts;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        parts[owners[i]].vertices.push_back(vertices[i]);
    }
    for (std::size_t i = 0; i < dents.size(); ++i) {
        if (const auto part = parts.find(dents[i]); part != parts.end()) {
            part->second.hits.push_back(made[i]);
        }
    }
    std::vector<DentPart> all;
    for (auto& [owner, part] : parts) {
        all.push_back(std::move(part));
    }
    return all;
}

std::vector<Dent> dentsOf(const Session& session, const Target& target, bool tellsApart) {
    const WaitingLine waiting(QStringLiteral("Measuring dents"));
    const std::vector<std::uint32_t> triangles = fileTriangles(target.deformed.render());
    const std::span<const glm::vec3> before = target.deformed.original().positions;
    const std::span<const glm::vec3> after = target.deformed.positions();
    std::vector<Hit> hits;
    std::vector<std::size_t> rows;
    const std::span<const Hit> shown = session.hits().shown();
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (shown[i].target == target.id && session.hits().isApplied(i)) {
            hits.push_back(shown[i]);
            rows.push_back(i);
        }
    }
    DentHits who;
    who.follow(target.deformed.sharedRender(), hits);
    std::vector<Dent> dents;
    const auto add = [&](DentPart part, std::span<const std::uint32_t> whole = {}) {
        const std::optional<DentMeasures> measures =
            measureDent(part.vertices, triangles, before, after, whole);
        if (!measures) {
            return;  // vertices of no triangle
        }
        Dent dent{std::move(part.vertices), *measures, {}};
        for (const std::size_t hit : part.hits) {
            dent.hits.push_back(rows[hit]);
        }
        dents.push_back(std::move(dent));
    };
    for (std::vector<std::uint32_t>& vertices : movedPieces(target.deformed, triangles)) {
        Bounds box;
        for (const std::uint32_t vertex : vertices) {
            box.add(before[vertex]);
            box.add(after[vertex]);
        }
        std::vector<std::size_t> made = who.madeBy(vertices, box);
        if (tellsApart && made.size() > 1) {
            for (DentPart& part : toldApart(target.deformed.render(), vertices, hits, made)) {
                add(std::move(part), vertices);
            }
        } else {
            add({std::move(vertices), std::move(made)});
        }
    }
    return dents;
}

void addDent(JsonReport& report, QString& text, std::size_t number, const Dent& dent, const Target& target) {
    const DentMeasures& m = dent.measures;
    const glm::vec3 at = target.deformed.original().positions[m.deepest];
    report.beginObject().count("dent", number).count("vertices", m.vertices).number("depth_m", m.depth);
    report.number("rim_diameter_m", m.rimDiameter).number("affected_area_m2", m.affectedArea);
    report.number("displaced_volume_m3", m.displacedVolume)
        .count("deepest_vertex", std::uint64_t{m.deepest} + 1);
    report.vector("deepest_was_at_m", at).vector("axis", m.axis).beginArray("hits");
    for (const std::size_t hit : dent.hits) {
        report.count({}, hit + 1);
    }
    report.endArray().endObject();
    text +=
        QStringLiteral("dent %1, %2: depth %3 m, rim %4 m, area %5 m², volume %6 m³, %7 moved, deepest %8\n")
            .arg(number)
            .arg(dent.hits.empty() ? QStringLiteral("no hit of the history") : hitNumbersText(dent.hits))
            .arg(m.depth, 0, 'g', 6)
            .arg(m.rimDiameter, 0, 'g', 6)
            .arg(m.affectedArea, 0, 'g', 6)
            .arg(m.displacedVolume, 0, 'g', 6)
            .arg(counted(m.vertices, "vertex", "vertices"))
            .arg(m.deepest + 1);
}

/// A line for each dent.
class DentTable {
public:
    DentTable() {
        m_csv.row({"target", "dent", "hits", "depth_m", "rim_diameter_m", "affected_area_m2",
                   "displaced_volume_m3", "vertices", "deepest_vertex", "deepest_was_at_x",
                   "deepest_was_at_y", "deepest_was_at_z"});
    }

    void add(const Target& target, std::size_t number, const Dent& dent) {
        const DentMeasures& m = dent.measures;
        const glm::vec3 at = target.deformed.original().positions[m.deepest];
        m_csv.text(target.name.toStdString()).count(number);
        m_csv.text(hitNumbers(dent.hits));
        m_csv.exact(m.depth).exact(m.rimDiameter).exact(m.affectedArea).exact(m.displacedVolume);
        m_csv.count(m.vertices).count(std::uint64_t{m.deepest} + 1);
        m_csv.exact(at.x).exact(at.y).exact(at.z).endRow();
    }

    [[nodiscard]] std::string take() { return m_csv.take(); }

private:
    /// "3 4 9"
    static std::string hitNumbers(const std::vector<std::size_t>& hits) {
        std::string text;
        for (const std::size_t hit : hits) {
            text += (text.empty() ? "" : " ") + std::to_string(hit + 1);
        }
        return text;
    }

    CsvWriter m_csv;
};

Outcome dents(Invocation& given, const SceneWish& wish) {
    OpenedScene scene;
    if (Outcome opened = scene.open(wish); !opened) {
        return opened;
    }
    const Result<std::vector<const Target*>> targets = targetsNamed(scene.session(), given.text("target"));
    if (!targets) {
        return targets.error();
    }
    JsonReport report("dents");
    DentTable table;
    QString text;
    report.beginArray("targets");
    for (const Target* target : targets.value()) {
        const std::vector<Dent> found = dentsOf(scene.session(), *target, !given.isSet("merged"));
        text += found.empty() ? QString() : target->name + u'\n';
        report.beginObject().text("name", target->name).beginArray("dents");
        for (std::size_t i = 0; i < found.size(); ++i) {
            addDent(report, text, i + 1, found[i], *target);
            table.add(*target, i + 1, found[i]);
        }
        report.endArray().endObject();
    }
    report.endArray();
    if (given.isSet("csv")) {
        if (Status written = writeAllTo(given.text("csv"), table.take()); !written) {
            return written;
        }
    }
    return giveReport(given, report, text.isEmpty() ? QStringLiteral("There are no dents.\n") : text);
}

int runDents(Invocation& given) {
    if (!namesSession(given.file(0))) {
        given.complain(QStringLiteral("dents takes a session (.hitscope, or - for the standard input)."));
    }
    const SceneWish wish = givenScene(given, given.file(0));
    return given.error().isEmpty() ? finish(dents(given, wish)) : kWrongUsage;
}

}  // namespace

Verb dentsVerb() {
    return {{.name = QStringLiteral("dents"),
             .files = QStringLiteral("SESSION"),
             .about = QStringLiteral("measure each dent: depth, rim, area, volume"),
             .description = QStringLiteral(
                 "Measures each connected part of the surface that hits moved: depth along "
                 "its axis, diameter of the rim, original area, volume between original and "
                 "deformed surface, and its hits. Where dents overlap, each is the part that its hit "
                 "moved most."),
             .options =
                 QList<UsageOption>{
                     targetOption(QStringLiteral("all")),
                     flagOption("merged", QStringLiteral("Measure overlapping dents as "
                                                         "one.")),
                     outputOption("csv",
                                  QStringLiteral("Write a line for each dent; - for the standard output.")),
                     untilOption(), pipelineOption(QStringLiteral("the session's"))} +
                 reportOptions(),
             .examples = {{QStringLiteral("Measure every dent of a session."),
                           QStringLiteral("hitscope-cli dents dents.hitscope")}},
             .leastFiles = 1,
             .mostFiles = 1},
            runDents};
}

}  // namespace hitscope::cli
