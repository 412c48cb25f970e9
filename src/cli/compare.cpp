// SPDX-License-Identifier: GPL-3.0-or-later
// How far apart two meshes, two sessions, or two pipelines' results of one are.
#include <QFontDatabase>
#include <algorithm>
#include <map>

#include "analysis/change_values.h"
#include "cli/common_options.h"
#include "cli/mesh_comparison.h"
#include "cli/opened_scene.h"
#include "cli/pipeline_argument.h"
#include "cli/verbs.h"
#include "io/save_image.h"
#include "scene/picture.h"

namespace hitscope::cli {

namespace {

/// The other side, B, as A's targets would have it.
class OtherVertices {
public:
    OtherVertices(const Session& session, const std::vector<TargetShape>& other) {
        for (std::size_t i = 0; i < session.targets().size(); ++i) {
            const Target& target = *session.targets()[i];
            const std::span<const DynamicVertex> now = target.deformed.vertices();
            std::vector<DynamicVertex>& made = m_vertices[target.id];
            made.assign(now.begin(), now.end());
            for (std::size_t v = 0; v < made.size(); ++v) {
                made[v].position = placedAs(target, other[i], target.deformed.render().fileVertices[v]);
            }
        }
    }
    [[nodiscard]] std::span<const DynamicVertex> of(TargetId target) const {
        const auto found = m_vertices.find(target);
        return found == m_vertices.end() ? std::span<const DynamicVertex>() : found->second;
    }

private:
    static glm::vec3 placedAs(const Target& target, const TargetShape& other, std::size_t vertex) {
        const Placement& placement = target.deformed.original().placement;
        return placement == other.mesh->placement ? other.positions[vertex]
                                                  : glm::vec3(placement.toLocal(inFile(other, vertex)));
    }

    std::map<TargetId, std::vector<DynamicVertex>> m_vertices;
};

/// A, coloured by how far B is from it.
Outcome drawMap(OpenedScene& scene, const std::vector<TargetShape>& other, const QString& path) {
    if (Outcome synced = scene.sync(); !synced) {
        return synced;
    }
    const OtherVertices vertices(scene.session(), other);
    ChangeValues values(scene.session());
    values.setOtherVertices([&vertices](TargetId target) { return vertices.of(target); });
    values.setQuantity(ChangeQuantity::Difference);
    values.finish();
    PictureRequest request;
    request.camera.frame(scene.session().targets().bounds(),
                         static_cast<float>(request.width) / static_cast<float>(request.height));
    request.options.change.on = true;
    request.options.change.quantity = ChangeQuantity::Difference;
    request.changeValues = &values;
    request.labels = !QFontDatabase::families().isEmpty();  // what the colours mean
    const Result<Image> image = drawPicture(scene.gpu(), request);
    return image ? Outcome(savePicture(image.value(), path)) : cannotDraw(image.error());
}

/// B's shapes, and A opened.
struct Sides {
    OpenedScene first;
    std::vector<TargetShape> other;
    QString otherName;
};

Outcome open(Sides& sides, Invocation& given) {
    const std::optional<PipelineKind> pipeline = givenPipeline(given);
    const bool isDrawn = given.isSet("map") || given.isSet("with");
    if (given.files().size() == 2) {
        OpenedScene second;  // goes before the first comes: one context at a time
        if (Outcome opened = second.open({.path = given.file(1), .pipeline = pipeline, .isMeshAlone = true});
            !opened) {
            return opened;
        }
        sides.other = shapesOf(second.session());
        sides.otherName = given.file(1);
    }
    if (Outcome opened = sides.first.open(
            {.path = given.file(0), .pipeline = pipeline, .isMeshAlone = !isDrawn, .isDrawn = isDrawn});
        !opened) {
        return opened;
    }
    if (given.files().size() == 2) {
        return Done{};
    }
    const PipelineKind own = sides.first.session().settings().pipeline();
    if (Outcome used = sides.first.use(allPipelines()[given.word("with")].kind); !used) {
        return used;
    }
    sides.other = shapesOf(sides.first.session());
    sides.otherName = given.text("with");
    return sides.first.use(own);
}

/// Floats as they are, unless the mesh was placed.
void addPlace(JsonReport& report, const char* key, const TargetShape& shape, std::size_t vertex) {
    if (shape.mesh->placement.isIdentity()) {
        report.vector(key, shape.positions[vertex]);
    } else {
        report.vector(key, inFile(shape, vertex));
    }
}

void addDifference(JsonReport& report, QString& text, const TargetShape& a, const TargetShape& b,
                   const ShapeDifference& difference) {
    report.beginObject().text("name", a.name).count("vertices", difference.vertices);
    report.count("different", difference.different).number("largest_m", difference.largest);
    report.number("rms_m", difference.rootMeanSquare);
    text += QStringLiteral("%1: %2 of %3 vertices %4")
                .arg(a.name)
                .arg(difference.different)
                .arg(difference.vertices)
                .arg(difference.different == 1 ? QStringLiteral("differs") : QStringLiteral("differ"));
    if (difference.different > 0) {
        const glm::dvec3 at = inFile(a, difference.vertex);
        report.count("vertex", std::uint64_t{difference.vertex} + 1);
        addPlace(report, "at_m", a, difference.vertex);
        addPlace(report, "other_at_m", b, difference.vertex);
        text += QStringLiteral(", by %1 m at most, at vertex %2 (%3, %4, %5), RMS %6 m")
                    .arg(difference.largest, 0, 'g', 6)
                    .arg(difference.vertex + 1)
                    .arg(at.x, 0, 'g', 6)
                    .arg(at.y, 0, 'g', 6)
                    .arg(at.z, 0, 'g', 6)
                    .arg(difference.rootMeanSquare, 0, 'g', 6);
    }
    report.endObject();
    text += u'\n';
}

/// Nothing: they have to be equal in every bit.
Outcome compare(Invocation& given, const std::optional<double>& tolerance) {
    Sides sides;
    if (Outcome opened = open(sides, given); !opened) {
        return opened;
    }
    const std::vector<TargetShape> shapes = shapesOf(sides.first.session());
    if (shapes.size() != sides.other.size()) {
        return Error{"The sessions have " + std::to_string(shapes.size()) + " and " +
                         std::to_string(sides.other.size()) + " targets.",
                     given.files().join(QStringLiteral(", ")).toStdString(), "Compare the same scene."};
    }
    JsonReport report("compare");
    report.text("first", given.file(0))
        .text("other", sides.otherName)
        .number("tolerance_m", tolerance.value_or(0.0));
    report.beginArray("targets");
    QString text;
    double largest = 0.0;
    std::size_t different = 0;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const Result<ShapeDifference> difference = differenceOf(shapes[i], sides.other[i]);
        if (!difference) {
            return difference.error();
        }
        addDifference(report, text, shapes[i], sides.other[i], difference.value());
        largest = std::max(largest, difference.value().largest);
        different += difference.value().different;
    }
    const bool isWithin = tolerance ? largest <= *tolerance : different == 0;
    report.endArray().truth("within", isWithin);
    if (given.isSet("map")) {
        if (Outcome drawn = drawMap(sides.first, sides.other, given.text("map")); !drawn) {
            return drawn;
        }
    }
    if (Status said = giveReport(given, report, text); !said) {
        return said;
    }
    return isWithin
               ? Outcome(Done{})
               : differs({tolerance
                              ? QStringLiteral("They differ by more than %1 m.").arg(*tolerance).toStdString()
                          : largest > 0.0 ? "They differ."
                                          : "They differ in some bits, by no distance.",
                          given.file(0).toStdString() + ", " + sides.otherName.toStdString(), ""});
}

int runCompare(Invocation& given) {
    const std::optional<double> tolerance = given.numberIfSet("tolerance", 0.0, 1.0e30);
    if ((given.files().size() == 2) == given.isSet("with")) {
        given.complain(QStringLiteral("compare takes two files, or a session and --with, another pipeline."));
    }
    if (given.isSet("with")) {
        static_cast<void>(given.word("with"));
    }
    if (given.isSet("map")) {
        if (Status known = checkPictureName(given.text("map")); !known) {
            given.complain(QString::fromStdString(known.error().message()));  // before the work
        }
    }
    return given.error().isEmpty() ? finish(compare(given, tolerance)) : kWrongUsage;
}

}  // namespace

Verb compareVerb() {
    return {
        {.name = QStringLiteral("compare"),
         .files = QStringLiteral("A [B]"),
         .about = QStringLiteral("compare two meshes, two sessions, or two pipelines, vertex by vertex"),
         .description = QStringLiteral(
             "Compares the vertices of two meshes of the same topology, of the targets of two sessions, or "
             "of the results of two pipelines for one session. Prints the number of different vertices, the "
             "largest distance with its place, and the root mean square over all vertices, in the "
             "coordinates of the files. Exits with 1 if the largest distance exceeds the tolerance or, "
             "without a tolerance, if any bit differs."),
         .options =
             QList<UsageOption>{
                 valueOption("tolerance", "METRES", QStringLiteral("Largest distance that counts as equal.")),
                 wordOption("with", "NAME", pipelineWords(),
                            QStringLiteral("Compare with the result of this pipeline for A.")),
                 pipelineOption(QStringLiteral("the session's")),
                 outputOption("map", QStringLiteral("Write a picture of A, coloured by the "
                                                    "distance."))} +
             reportOptions(),
         .examples = {{QStringLiteral("Check that a mesh is unchanged to within a micrometre."),
                       QStringLiteral("hitscope-cli compare --tolerance 1e-6 bunny.obj bunny.ply")},
                      {QStringLiteral("Compare two pipelines on a session, with a map."),
                       QStringLiteral("hitscope-cli compare --with reference --map map.png dents.hitscope")}},
         .leastFiles = 1,
         .mostFiles = 2},
        runCompare,
        true};
}

}  // namespace hitscope::cli
