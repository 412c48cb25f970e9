// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/agreement.h"

#include <algorithm>

#include "cli/progress_line.h"
#include "deform/fingerprint.h"

namespace hitscope::cli {

namespace {

/// Vertices times hits; about a quarter of a minute.
constexpr double kMostSteps = 4.0e9;

double stepsEverywhere(const Session& session) {
    double steps = 0.0;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        steps += static_cast<double>(target->deformed.vertices().size()) *
                 static_cast<double>(session.hits().history().hitsOn(target->id).size());
    }
    return steps;
}

QString nameOfActive(const Session& session) {
    return QString::fromUtf8(pipelineTraits(session.settings().pipeline()).name);
}

/// "870 of 4966 vertices differ from the reference, by 3.3 m at most".
QString differenceText(const ReferenceAgreement& agreement) {
    const auto countText = [&agreement](std::uint64_t different) {
        return QStringLiteral("%1 of %2 vertices %3 from the reference")
            .arg(different)
            .arg(agreement.vertices)
            .arg(different == 1 ? QStringLiteral("differs") : QStringLiteral("differ"));
    };
    if (agreement.different == 0) {
        return countText(agreement.differentNormal) + QStringLiteral(", in the paper's normal alone");
    }
    QString text = countText(agreement.different) +
                   QStringLiteral(", by %1 m at most").arg(QString::number(agreement.largest, 'g', 3));
    if (agreement.differentNormal > 0) {
        text += QStringLiteral(", and %1 in the paper's normal alone").arg(agreement.differentNormal);
    }
    return text;
}

}  // namespace

Status usePipeline(Session& session, SceneGpu& gpu, PipelineKind kind) {
    if (const QString unavailable = session.readBack().whyUnavailable(kind); !unavailable.isEmpty()) {
        return Error{unavailable.toStdString(), "", "Choose another --pipeline."};
    }
    session.settings().setPipeline(kind);
    return gpu.sync();
}

Status useAskedPipeline(Session& session, SceneGpu& gpu, std::optional<PipelineKind> asked) {
    const PipelineKind wanted = asked.value_or(PipelineKind::TransformFeedback);
    if (Status used = usePipeline(session, gpu, wanted); !used) {
        return used;
    }
    const PipelineVerdict* verdict = session.readBack().verdict().of(wanted);
    if (verdict == nullptr || verdict->isExact()) {
        return Done{};
    }
    const QString known = QString::fromStdString(describe(session.readBack().verdict(), wanted));
    const std::optional<PipelineKind> better = session.readBack().verdict().insteadOf(wanted);
    if (asked || !better) {
        note(known);
        return Done{};
    }
    note(known + QStringLiteral("; using %1 instead").arg(QString::fromUtf8(pipelineTraits(*better).name)));
    return usePipeline(session, gpu, *better);
}

std::optional<ReferenceAgreement> agreementOfActive(const Session& session) {
    const WaitingLine waiting(QStringLiteral("Comparing with the reference"));
    if (session.settings().pipeline() != PipelineKind::Reference) {
        return agreementWithReference(session, ReferenceMethod::Clusters);
    }
    if (stepsEverywhere(session) > kMostSteps) {
        return std::nullopt;
    }
    return agreementWithReference(session, ReferenceMethod::Everywhere);
}

QString agreementLine(const Session& session, const std::optional<ReferenceAgreement>& agreement) {
    QString text = nameOfActive(session) + QStringLiteral(": ");
    if (!agreement) {
        text += QStringLiteral("what the others are compared with");
    } else if (!agreement->isExact()) {
        text += differenceText(*agreement);
    } else if (session.settings().pipeline() == PipelineKind::Reference) {
        text += QStringLiteral("as every hit at every vertex, in every bit");
    } else {
        text += QStringLiteral("as the reference in every bit");
    }
    if (session.readBack().droppedHits() > 0) {
        text +=
            QStringLiteral("; it keeps the last %1 hits%2")
                .arg(session.readBack().capacity().used)
                .arg(session.readBack().capacity().perTarget ? QStringLiteral(" on a target") : QString());
    }
    return text;
}

Status exportNamed(const Session& session, const Target& target, const QString& path, NormalMode normals) {
    ExportOptions options;
    options.format = exportFormatOf(path).value_or(ExportFormat::Obj);
    options.normals = normals;
    const WaitingLine waiting(QStringLiteral("Writing"));
    const Result<ExportReport> written = exportTarget(session, target, path, options);
    if (!written) {
        return written.error();
    }
    for (const QString& said : written.value().notes) {
        note(said);
    }
    return Done{};
}

Outcome exportAgrees(const Session& session, const std::optional<ReferenceAgreement>& agreement,
                     const QString& path) {
    if (!agreement || agreement->isExact()) {
        return Done{};
    }
    return differs({(QStringLiteral("The mesh is not what the reference makes of the hits: by %1, %2.")
                         .arg(nameOfActive(session), differenceText(*agreement)))
                        .toStdString(),
                    path.toStdString(),
                    session.settings().pipeline() == PipelineKind::Reference
                        ? "Please report this with the mesh."
                        : "It was written; --pipeline reference writes the right one."});
}

void addAgreement(JsonReport& report, const Session& session,
                  const std::optional<ReferenceAgreement>& agreement) {
    report.text("pipeline", QString::fromUtf8(pipelineTraits(session.settings().pipeline()).key));
    report.count("dropped_hits", session.readBack().droppedHits());
    if (!agreement) {
        report.nothing("agreement");
        return;
    }
    report.beginObject("agreement").truth("exact", agreement->isExact());
    report.count("vertices", agreement->vertices).count("different", agreement->different);
    report.count("different_normals", agreement->differentNormal).number("largest_m", agreement->largest);
    report.endObject();
}

void addFingerprints(JsonReport& report, const Session& session) {
    report.text("hits_fingerprint", QString::fromStdString(fingerprintText(hitsFingerprint(session))));
    report.text("positions_fingerprint",
                QString::fromStdString(fingerprintText(positionsFingerprint(session))));
}

void addTargets(JsonReport& report, const Session& session) {
    report.beginArray("targets");
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const DisplacementStatistics statistics = target->deformed.statistics();
        report.beginObject().text("name", target->name);
        report.count("vertices", target->deformed.original().vertexCount());
        report.count("hits", session.hits().history().hitsOn(target->id).size());
        report.count("changed_vertices", statistics.changedVertices).number("largest_m", statistics.maximum);
        report.number("mean_m", statistics.mean).number("rms_m", statistics.rms).endObject();
    }
    report.endArray();
}

QString shotsAndHits(std::size_t shots, std::size_t shotHits, const Session& session) {
    const std::size_t all = session.hits().history().size();
    const std::size_t hits = shots > 0 ? shotHits : all;
    const QString text =
        counted(shots, "shot", "shots") + QStringLiteral(", ") + counted(hits, "hit", "hits");
    return hits == all ? text : text + QStringLiteral("; %1 in all").arg(counted(all, "hit", "hits"));
}

QString fingerprintLines(const Session& session) {
    const auto text = [](std::uint64_t print) { return QString::fromStdString(fingerprintText(print)); };
    return QStringLiteral("fingerprint %1 of the hits\nfingerprint %2 of the positions, by %3\n")
        .arg(text(hitsFingerprint(session)), text(positionsFingerprint(session)), nameOfActive(session));
}

const Target& mostChangedTarget(const Session& session) {
    const auto changed = [](const std::unique_ptr<Target>& target) {
        return target->deformed.statistics().changedVertices;
    };
    return **std::max_element(session.targets().begin(), session.targets().end(),
                              [&](const auto& a, const auto& b) { return changed(a) < changed(b); });
}

}  // namespace hitscope::cli
