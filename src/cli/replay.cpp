// SPDX-License-Identifier: GPL-3.0-or-later
// Opens a session without a window, and says whether its hits make of its meshes what they made when it was
// saved.
#include <QDir>

#include "cli/agreement.h"
#include "cli/common_options.h"
#include "cli/opened_scene.h"
#include "cli/scene_options.h"
#include "cli/verbs.h"

namespace hitscope::cli {

namespace {

/// Of positions that are not those that were saved.
Outcome othersThanSaved(const OpenedScene& scene, const std::vector<TargetId>& differing,
                        const QString& path) {
    const Session& session = scene.session();
    const PipelineVerdict* verdict = session.readBack().verdict().of(session.settings().pipeline());
    return differs(
        {"The positions are not those that were saved, on " + scene.namesOf(differing).toStdString() + ".",
         path.toStdString(),
         verdict != nullptr && !verdict->isExact()
             ? "This pipeline is not exact on this renderer; try --pipeline reference."
             : "The meshes have changed, or another renderer made the saved positions."});
}

Outcome replay(Invocation& given, const SceneWish& wish, const QString& out) {
    OpenedScene scene;
    if (Outcome opened = scene.open(wish); !opened) {
        return opened;
    }
    const Session& session = scene.session();
    const SessionDocument& document = *scene.document();
    const std::size_t shown = session.hits().shown().size();
    QString text =
        QStringLiteral("%1 of %2 on %3\n%4")
            .arg(QString::number(shown), counted(document.hits.size(), "hit", "hits"),
                 counted(session.targets().size(), "target", "targets"), fingerprintLines(session));
    JsonReport report("replay");
    report.text("session", wish.path).count("hits", document.hits.size()).count("shown", shown);
    report.text("pipeline", QString::fromUtf8(pipelineTraits(session.settings().pipeline()).key));
    addFingerprints(report, session);
    addTargets(report, session);
    if (!out.isEmpty() && !session.targets().empty()) {
        const Target& exported = mostChangedTarget(session);
        if (Status status = exportNamed(session, exported, out, NormalMode::True); !status) {
            return status;
        }
        text += QStringLiteral("In %1: %2\n").arg(QDir::toNativeSeparators(out), exported.name);
    }
    const std::optional<std::vector<TargetId>> compared = scene.differing();
    const std::vector<TargetId> differing = compared.value_or(std::vector<TargetId>());
    if (!compared) {
        text += QStringLiteral("the session has no positions of these hits to compare with\n");
        report.nothing("as_saved");
    } else {
        report.truth("as_saved", differing.empty());
        text += differing.empty() ? QStringLiteral("the positions are those that were saved\n") : QString();
    }
    const Status said = giveReport(given, report, text);
    if (!said) {
        return said;
    }
    return differing.empty() ? Outcome(Done{}) : othersThanSaved(scene, differing, wish.path);
}

int runReplay(Invocation& given) {
    const SceneWish wish = givenScene(given, given.file(0));
    if (!namesSession(wish.path)) {
        given.complain(QStringLiteral("replay takes a session (.hitscope, or - for the standard input)."));
    }
    const QString out = givenMeshFile(given);
    return given.error().isEmpty() ? finish(replay(given, wish, out)) : kWrongUsage;
}

}  // namespace

Verb replayVerb() {
    return {
        {.name = QStringLiteral("replay"),
         .files = QStringLiteral("SESSION"),
         .about =
             QStringLiteral("apply a session's hits again and compare the positions with the saved ones"),
         .description = QStringLiteral(
             "Opens a session and applies its hits again, without a display. Prints fingerprints of the hits "
             "and of the positions. Exits with 1 if the positions differ from the saved ones."),
         .options =
             QList<UsageOption>{
                 pipelineOption(QStringLiteral("the session's")), untilOption(),
                 outputOption(
                     "out",
                     QStringLiteral("Write the target that changed most, in the format of the suffix."))} +
             reportOptions(),
         .examples = {{QStringLiteral("Check with the reference that the hits still have the same result."),
                       QStringLiteral("hitscope-cli replay --pipeline reference dents.hitscope")}},
         .leastFiles = 1,
         .mostFiles = 1},
        runReplay};
}

}  // namespace hitscope::cli
