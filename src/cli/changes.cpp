// SPDX-License-Identifier: GPL-3.0-or-later
// The table of changed vertices, and why a vertex is where it is.
#include <algorithm>
#include <array>
#include <glm/trigonometric.hpp>

#include "analysis/hit_effects.h"
#include "cli/agreement.h"
#include "cli/common_options.h"
#include "cli/opened_scene.h"
#include "cli/placement_report.h"
#include "cli/progress_line.h"
#include "cli/scene_options.h"
#include "cli/standard_streams.h"
#include "cli/target_argument.h"
#include "cli/verbs.h"
#include "deform/attribution.h"
#include "io/csv_writer.h"
#include "io/placement_text.h"
#include "io/writers/file_positions.h"
#include "models/vertex_facts.h"

namespace hitscope::cli {

namespace {

std::vector<std::uint32_t> changedVertices(const Target& target) {
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t vertex : target.deformed.onceChanged()) {
        if (target.deformed.isChanged(vertex)) {
            vertices.push_back(vertex);
        }
    }
    std::sort(vertices.begin(), vertices.end());
    return vertices;
}

/// A line a vertex, of all targets.
class ChangesTable {
public:
    ChangesTable() {
        m_csv.row({"target", "vertex", "original_x", "original_y", "original_z", "current_x", "current_y",
                   "current_z", "displacement_x", "displacement_y", "displacement_z", "length",
                   "normal_turned_deg", "hits", "new"});
        m_report.beginArray("targets");
    }

    void add(const Target& target, std::span<const std::uint32_t> hits) {
        m_report.beginObject().text("name", target.name).beginArray("vertices");
        const FilePositions positions(target.deformed.original(), target.deformed.positions());
        const bool areFloats = positions.fitFloatsMoved();  // as an export has them
        for (const std::uint32_t vertex : changedVertices(target)) {
            const std::uint32_t reached = hits.empty() ? 0 : hits[vertex];
            areFloats ? add<glm::vec3>(target, vertex, reached, positions)
                      : add<glm::dvec3>(target, vertex, reached, positions);
        }
        m_report.endArray().endObject();
    }

    [[nodiscard]] Status give(const Invocation& given) {
        m_report.endArray();
        return giveReport(given, m_report, QString::fromStdString(m_csv.take()));
    }

private:
    /// Vectors in the file's coordinates, of floats where these hold all of them.
    template <typename Vector>
    void add(const Target& target, std::uint32_t vertex, std::uint32_t hits, const FilePositions& positions) {
        const VertexFacts facts = vertexFacts(target.deformed, vertex);
        const std::array vectors{Vector(positions.original(vertex)), Vector(positions.now(vertex)),
                                 Vector(positions.displacement(vertex))};
        const double turned = glm::degrees(facts.turned);
        const double length = facts.length / target.deformed.original().placement.scale;
        m_csv.text(target.name.toStdString()).count(std::uint64_t{vertex} + 1);
        for (const Vector& vector : vectors) {
            m_csv.exact(vector.x).exact(vector.y).exact(vector.z);
        }
        const bool isNew = target.deformed.original().isNew(vertex);
        m_csv.exact(length).exact(turned).count(hits).count(isNew ? 1 : 0);
        m_csv.endRow();
        m_report.beginObject().count("vertex", std::uint64_t{vertex} + 1).vector("original_m", vectors[0]);
        m_report.vector("current_m", vectors[1]).vector("displacement_m", vectors[2]);
        m_report.number("length_m", length)
            .number("normal_turned_deg", turned)
            .count("hits", hits)
            .truth("new", isNew)
            .endObject();
    }

    CsvWriter m_csv;
    JsonReport m_report{"changes"};
};

Outcome changes(Invocation& given, const SceneWish& wish) {
    OpenedScene scene;
    if (Outcome opened = scene.open(wish); !opened) {
        return opened;
    }
    scene.noteDiffering();
    const Result<std::vector<const Target*>> targets = targetsNamed(scene.session(), given.text("target"));
    if (!targets) {
        return targets.error();
    }
    HitEffects effects(scene.session());
    {
        const WaitingLine waiting(QStringLiteral("Measuring changes"));
        effects.finish();
    }
    ChangesTable table;
    for (const Target* target : targets.value()) {
        table.add(*target, effects.counts(target->id));
    }
    return table.give(given);
}

/// Hits that reached a vertex, with the part of each.
Attribution attributionOf(const Session& session, const Target& target, std::uint32_t vertex) {
    const RenderMesh& render = target.deformed.render();
    Attribution attribution(render.vertices[render.renderVerticesOf(vertex).front()]);
    const std::span<const Hit> hits = session.hits().shown();
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].target == target.id && session.hits().isApplied(i)) {
            attribution.add(i, hits[i]);
        }
    }
    return attribution;
}

QString placeOf(const glm::vec3& at) {
    return QStringLiteral("%1 %2 %3").arg(at.x, 0, 'g', 7).arg(at.y, 0, 'g', 7).arg(at.z, 0, 'g', 7);
}

Outcome explainVertex(Invocation& given, const Session& session, const Target& target, std::uint32_t vertex) {
    const Attribution attribution = attributionOf(session, target, vertex);
    const glm::vec3 original = target.deformed.original().positions[vertex];
    const glm::vec3 current = target.deformed.positions()[vertex];
    const bool isSame = current == attribution.vertex().position;
    JsonReport report("explain");
    report.text("target", target.name)
        .count("vertex", std::uint64_t{vertex} + 1)
        .vector("original_m", original);
    const Placement& placement = target.deformed.original().placement;
    addPlacement(report, placement);
    report.vector("current_m", current).vector("attributed_m", attribution.vertex().position);
    report.truth("exact", isSame).beginArray("hits");
    QString text = QStringLiteral("%1, vertex %2\n").arg(target.name).arg(vertex + 1);
    text += placement.isIdentity() ? QString() : placementText(placement) + u'\n';
    text += QStringLiteral("original  %1\n").arg(placeOf(original));
    for (const VertexContribution& part : attribution.contributions()) {
        const Contribution& by = part.contribution;
        report.beginObject().count("hit", part.hit + 1).number("distance_m", by.distance);
        report.number("magnitude_m", by.magnitude).truth("capped", by.isCapped);
        report.vector("displacement_m", by.displacement).vector("position_m", part.position).endObject();
        text += QStringLiteral("hit %1  r %2 m  m %3 m%4  moves by %5  to %6\n")
                    .arg(part.hit + 1)
                    .arg(by.distance, 0, 'g', 6)
                    .arg(by.magnitude, 0, 'g', 6)
                    .arg(by.isCapped ? QStringLiteral(" (capped)") : QString(), placeOf(by.displacement),
                         placeOf(part.position));
    }
    report.endArray();
    text += QStringLiteral("now       %1, %2\n")
                .arg(placeOf(current), isSame ? QStringLiteral("which is their sum in every bit")
                                              : QStringLiteral("which is not their sum, ") +
                                                    placeOf(attribution.vertex().position));
    if (Status said = giveReport(given, report, text); !said) {
        return said;
    }
    return isSame ? Outcome(Done{})
                  : differs({"The vertex is not where its hits would bring it.", given.file(0).toStdString(),
                             "The pipeline is not exact on this renderer; try --pipeline reference."});
}

Outcome explain(Invocation& given, const SceneWish& wish, std::uint32_t vertex) {
    OpenedScene scene;
    if (Outcome opened = scene.open(wish); !opened) {
        return opened;
    }
    const Session& session = scene.session();
    if (session.targets().empty()) {
        return Error{"The session has no targets.", given.file(0).toStdString(), ""};
    }
    const Target* target = &mostChangedTarget(session);
    if (given.isSet("target")) {
        const Result<const Target*> named = targetNamed(session, given.text("target"));
        if (!named) {
            return named.error();
        }
        target = named.value();
    }
    const std::size_t count = target->deformed.original().vertexCount();
    if (vertex > count) {
        return Error{"It has only " + std::to_string(count) + " vertices.", target->name.toStdString(),
                     "Choose a --vertex from 1 to that."};
    }
    return explainVertex(given, session, *target, vertex - 1);
}

bool isOfSession(Invocation& given) {
    if (!namesSession(given.file(0))) {
        given.complain(QStringLiteral("%1 takes a session (.hitscope, or - for the standard input).")
                           .arg(given.usage().name));
    }
    return given.error().isEmpty();
}

int runChanges(Invocation& given) {
    const SceneWish wish = givenScene(given, given.file(0));
    return isOfSession(given) ? finish(changes(given, wish)) : kWrongUsage;
}

int runExplain(Invocation& given) {
    if (!given.isSet("vertex")) {
        given.complain(QStringLiteral("explain needs --vertex, the number of a vertex, from 1."));
    }
    const int vertex = given.wholeNumber("vertex", 1, 2147483647);
    const SceneWish wish = givenScene(given, given.file(0));
    return isOfSession(given) ? finish(explain(given, wish, static_cast<std::uint32_t>(vertex)))
                              : kWrongUsage;
}

}  // namespace

Verb changesVerb() {
    return {{.name = QStringLiteral("changes"),
             .files = QStringLiteral("SESSION"),
             .about = QStringLiteral("print the table of changed vertices"),
             .description = QStringLiteral(
                 "Prints a line for each changed vertex as CSV, or with --json as JSON. Counts vertices from "
                 "1, as in the file, and gives the file's coordinates; \"new\" says which ones refining "
                 "added. Numbers read back to the same bits."),
             .options = QList<UsageOption>{targetOption(QStringLiteral("all")), untilOption(),
                                           pipelineOption(QStringLiteral("the session's"))} +
                        reportOptions(),
             .examples = {{QStringLiteral("Write the changes to a table."),
                           QStringLiteral("hitscope-cli changes dents.hitscope > changes.csv")}},
             .leastFiles = 1,
             .mostFiles = 1},
            runChanges};
}

Verb explainVerb() {
    return {
        {.name = QStringLiteral("explain"),
         .files = QStringLiteral("SESSION"),
         .about = QStringLiteral("list the hits that moved a vertex, with the contribution of each"),
         .description = QStringLiteral("Follows one vertex through the hits: prints the distance of each hit "
                                       "(r), its contribution (m), and the position after it. Exits with 1 "
                                       "if the last position differs in any bit from the pipeline's."),
         .options =
             QList<UsageOption>{
                 valueOption("vertex", "N", QStringLiteral("Number of the vertex in the file, from 1.")),
                 targetOption(QStringLiteral("the one with the most changed vertices")), untilOption(),
                 pipelineOption(QStringLiteral("the session's"))} +
             reportOptions(),
         .examples = {{QStringLiteral("Explain the position of a vertex."),
                       QStringLiteral("hitscope-cli explain --vertex 12 dents.hitscope")}},
         .leastFiles = 1,
         .mostFiles = 1},
        runExplain};
}

}  // namespace hitscope::cli
