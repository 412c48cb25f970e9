// SPDX-License-Identifier: GPL-3.0-or-later
// Where a plane cuts a scene: a table, a drawing, a summary.
#include <algorithm>

#include "analysis/scene_section.h"
#include "cli/common_options.h"
#include "cli/cut_argument.h"
#include "cli/opened_scene.h"
#include "cli/placement_report.h"
#include "cli/scene_options.h"
#include "cli/section_drawing.h"
#include "cli/standard_streams.h"
#include "cli/target_argument.h"
#include "cli/verbs.h"
#include "io/placement_text.h"
#include "models/section_report.h"

namespace hitscope::cli {

namespace {

SceneSection cutAll(const std::vector<const Target*>& targets, const CuttingPlane& cut) {
    SceneSection section;
    section.cut = cut;
    for (const Target* target : targets) {
        std::vector<MovedVertex> moved;
        for (const std::uint32_t vertex : target->deformed.onceChanged()) {
            moved.push_back({vertex, target->deformed.positions()[vertex]});
        }
        SectionedTarget sectioned(target->deformed.sharedRender());
        sectioned.follow(moved);
        TargetSection made = sectioned.cut({cut.normal, cut.offset}, target->transform);
        made.target = target->id;
        made.name = target->name;
        if (!made.original.empty() || !made.deformed.empty()) {
            section.targets.push_back(std::move(made));
        }
    }
    return section;
}

void addCurves(JsonReport& report, const char* key, const std::vector<SectionCurve>& curves) {
    report.beginArray(key);
    for (const SectionCurve& curve : curves) {
        report.beginObject().truth("closed", curve.closed).beginArray("points_m");
        for (const glm::vec3& point : curve.points) {
            report.vector({}, point);
        }
        report.endArray().endObject();
    }
    report.endArray();
}

JsonReport reportOf(const Session& session, const SceneSection& section) {
    JsonReport report("section");
    report.vector("normal", section.cut.normal).number("offset_m", section.cut.offset).beginArray("targets");
    for (const TargetSection& target : section.targets) {
        report.beginObject().text("name", target.name).number("greatest_depth_m", target.depths.greatest);
        addPlacement(report, session.targets().find(target.target)->deformed.original().placement);
        addCurves(report, "original", target.original);
        addCurves(report, "deformed", target.deformed);
        report.endObject();
    }
    report.endArray();
    return report;
}

Outcome section(Invocation& given, const SceneWish& wish, const CuttingPlane& cut) {
    OpenedScene scene;
    if (Outcome opened = scene.open(wish); !opened) {
        return opened;
    }
    const Result<std::vector<const Target*>> targets = targetsNamed(scene.session(), given.text("target"));
    if (!targets) {
        return targets.error();
    }
    const SceneSection made = cutAll(targets.value(), cut);
    if (made.targets.empty()) {
        note(QStringLiteral("The plane cuts no target."));
    }
    const std::string csv = sectionCsv(made, {}).toStdString();
    for (const auto& [option, bytes] :
         {std::pair<const char*, std::string>{"csv", csv}, {"svg", sectionSvg(made)}}) {
        if (Status written = given.isSet(option) ? writeAllTo(given.text(option), bytes) : Status(Done{});
            !written) {
            return written;
        }
    }
    JsonReport report = reportOf(scene.session(), made);
    QString text = sectionText(made, {}) + u'\n';
    for (const TargetSection& target : made.targets) {
        const Target& whole = *scene.session().targets().find(target.target);
        const Placement& placement = whole.deformed.original().placement;
        text += placement.isIdentity() ? QString()
                                       : whole.name + QStringLiteral(": ") + placementText(placement) + u'\n';
    }
    return giveReport(given, report, text);
}

int runSection(Invocation& given) {
    const std::optional<CuttingPlane> cut = parseCut(given.text("plane"));
    if (!cut) {
        given.complain(
            given.isSet("plane")
                ? QStringLiteral(
                      "--plane takes an axis or a direction, and metres, as in x=0.1 or 1,1,0=0.5.")
                : QStringLiteral("section needs --plane, as in x=0.1."));
        return kWrongUsage;
    }
    SceneWish wish = givenScene(given, given.file(0));
    wish.isMeshAlone = true;
    return given.error().isEmpty() ? finish(section(given, wish, *cut)) : kWrongUsage;
}

}  // namespace

Verb sectionVerb() {
    return {
        {.name = QStringLiteral("section"),
         .files = QStringLiteral("SESSION|MESH"),
         .about = QStringLiteral("cut a scene with a plane; the profile as CSV, SVG or JSON"),
         .description =
             QStringLiteral("Cuts the original and the deformed targets with a plane, and prints the length "
                            "of the profile and the greatest depth. The depth at a corner is the distance to "
                            "the nearest point of the original's profile. Coordinates and the plane are "
                            "the scene's; of a mesh that was moved or scaled there, the report says how."),
         .options =
             QList<UsageOption>{
                 valueOption(
                     "plane", "PLANE",
                     QStringLiteral("Plane: x=0.1 is perpendicular to x at 0.1 m; -x=0.1, as --cut of "
                                    "picture takes it, is the same plane; 1,1,0=0.5 is "
                                    "perpendicular to that direction, 0.5 m along it.")),
                 outputOption("csv", QStringLiteral("Write a line for each corner; - for the "
                                                    "standard output.")),
                 outputOption(
                     "svg",
                     QStringLiteral(
                         "Write a drawing to scale, in millimetres on paper; - for the standard output.")),
                 targetOption(QStringLiteral("all")), untilOption(),
                 pipelineOption(QStringLiteral("the session's"))} +
             reportOptions(),
         .examples = {{QStringLiteral("Write a profile as a drawing and a table."),
                       QStringLiteral("hitscope-cli section --plane z=0 --svg profile.svg --csv profile.csv "
                                      "dents.hitscope")}},
         .leastFiles = 1,
         .mostFiles = 1},
        runSection};
}

}  // namespace hitscope::cli
