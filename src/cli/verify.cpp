// SPDX-License-Identifier: GPL-3.0-or-later
// Applies hits with every pipeline that runs here and holds each against the reference.
#include <QTextStream>

#include "cli/agreement.h"
#include "cli/common_options.h"
#include "cli/opened_scene.h"
#include "cli/shoot.h"
#include "cli/verbs.h"
#include "deform/fingerprint.h"

namespace hitscope::cli {

namespace {

QString inHex(std::uint64_t fingerprint) {
    return QString::fromStdString(fingerprintText(fingerprint));
}

/// What came of all of them.
struct Verification {
    JsonReport report{"verify"};
    QString text;
    QStringList differing;
};

/// One that runs here.
Outcome verifyPipeline(OpenedScene& scene, PipelineKind kind, Verification& all) {
    if (Outcome used = scene.use(kind); !used) {
        return used;
    }
    const std::optional<ReferenceAgreement> agreement = agreementOfActive(scene.session());
    const QString positions = inHex(positionsFingerprint(scene.session()));
    all.text +=
        QStringLiteral("%1; positions %2\n").arg(agreementLine(scene.session(), agreement), positions);
    addAgreement(all.report, scene.session(), agreement);
    all.report.text("positions_fingerprint", positions);
    if (agreement && !agreement->isExact()) {
        all.differing << QString::fromUtf8(pipelineTraits(kind).name);
    }
    return Done{};
}

Outcome verifyAll(OpenedScene& scene, Verification& all) {
    all.report.beginArray("pipelines");
    for (const PipelineTraits& traits : allPipelines()) {
        all.report.beginObject();
        const QString unavailable = scene.session().readBack().whyUnavailable(traits.kind);
        if (!unavailable.isEmpty()) {
            all.text += QStringLiteral("%1: not here. %2\n").arg(QString::fromUtf8(traits.name), unavailable);
            all.report.text("pipeline", QString::fromUtf8(traits.key)).text("not_here", unavailable);
        } else if (Outcome verified = verifyPipeline(scene, traits.kind, all); !verified) {
            return verified;
        }
        all.report.endObject();
    }
    all.report.endArray();
    return Done{};
}

Outcome verify(Invocation& given) {
    OpenedScene scene;
    if (Outcome opened = scene.open({.path = given.file(0), .isDrawn = true}); !opened) {
        return opened;
    }
    Session& session = scene.session();
    if (given.isSet("hits")) {
        if (Status added = takeHits(session, given.text("hits")); !added) {
            return added;
        }
    }
    Verification all;
    const QString renderer = QString::fromStdString(gl::rendererInfo().renderer);
    all.report.text("renderer", renderer).count("hits", session.hits().history().size());
    all.report.text("hits_fingerprint", inHex(hitsFingerprint(session)));
    all.text = QStringLiteral("Renderer: %1\n%2, fingerprint %3\n")
                   .arg(renderer, counted(session.hits().history().size(), "hit", "hits"),
                        inHex(hitsFingerprint(session)));
    if (Outcome verified = verifyAll(scene, all); !verified) {
        return verified;
    }
    if (const Status said = giveReport(given, all.report, all.text); !said) {
        return said;
    }
    return all.differing.isEmpty()
               ? Outcome(Done{})
               : differs({"The hits are applied wrongly by " +
                              all.differing.join(QStringLiteral(", ")).toStdString() + ".",
                          (given.isSet("hits") ? given.text("hits") : given.file(0)).toStdString(), ""});
}

int runVerify(Invocation& given) {
    if (!given.isSet("hits") && !namesSession(given.file(0))) {
        given.complain(QStringLiteral("verify needs --hits, a file of hits, or a session."));
        return kWrongUsage;
    }
    return finish(verify(given));
}

}  // namespace

Verb verifyVerb() {
    return {
        {.name = QStringLiteral("verify"),
         .files = QStringLiteral("[MESH|SESSION]"),
         .about = QStringLiteral("compare every pipeline with the reference, vertex by vertex"),
         .description =
             QStringLiteral("Applies the hits of a file or a session with every available pipeline and "
                            "compares each vertex with the C++ reference. For a pipeline that keeps only the "
                            "last hits, compares with the result of these. Exits with 1 if a vertex differs. "
                            "Without a mesh, applies the hits to the paper's scene."),
         .options = QList<UsageOption>{fileOption(
                        "hits", QStringLiteral("File of hits, CSV or JSON, as exported by the window."))} +
                    reportOptions(),
         .examples = {{QStringLiteral("Apply the hits of a session with every pipeline."),
                       QStringLiteral("hitscope-cli verify dents.hitscope")},
                      {QStringLiteral("Apply the hits of a table to the mesh they were made on."),
                       QStringLiteral("hitscope-cli verify --hits hits.csv bunny.obj")}},
         .mostFiles = 1},
        runVerify};
}

}  // namespace hitscope::cli
