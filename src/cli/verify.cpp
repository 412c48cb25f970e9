// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verify.h"

#include <QCommandLineParser>
#include <QTextStream>

#include "analysis/hit_files.h"
#include "cli/agreement.h"
#include "cli/command_line.h"
#include "cli/load_scene.h"
#include "deform/fingerprint.h"
#include "gl/context.h"

namespace hitscope::cli {

namespace {

QString inHex(std::uint64_t fingerprint) {
    return QString::fromStdString(fingerprintText(fingerprint));
}

/// Of one that runs here: prints its line, and gives how many vertices differ.
Result<std::size_t> verifyPipeline(Session& session, SceneGpu& gpu, PipelineKind kind, QTextStream& out) {
    if (Status used = usePipeline(session, gpu, kind); !used) {
        return used.error();
    }
    const std::optional<ReferenceAgreement> agreement = agreementOfActive(session);
    out << agreementLine(session, agreement) << "; positions " << inHex(positionsFingerprint(session))
        << "\n";
    return agreement ? agreement->different + agreement->differentNormal : std::size_t{0};
}

Status verify(const QString& meshPath, const QString& hitsPath) {
    QTextStream out(stdout);
    Result<std::unique_ptr<gl::OffscreenContext>> context = gl::OffscreenContext::create();
    if (!context) {
        return context.error();
    }
    Session session;
    if (Status loaded = loadScene(session, meshPath, out); !loaded) {
        return loaded;
    }
    Result<std::unique_ptr<SceneGpu>> gpu = SceneGpu::create(session);
    if (!gpu) {
        return gpu.error();
    }
    const Result<HitRecords> hits = readHitFile(hitsPath);
    if (!hits) {
        return hits.error();
    }
    if (Status added = appendRecords(session, hits.value()); !added) {
        return added;
    }
    out << "Renderer: " << QString::fromStdString(gl::rendererInfo().renderer) << "\n"
        << session.hits().history().size() << " hits, fingerprint " << inHex(hitsFingerprint(session))
        << "\n";
    QStringList differing;
    for (const PipelineTraits& traits : allPipelines()) {
        const QString name = QString::fromUtf8(traits.name);
        if (const QString unavailable = session.readBack().whyUnavailable(traits.kind);
            !unavailable.isEmpty()) {
            out << name << ": not here. " << unavailable << "\n";
            continue;
        }
        const Result<std::size_t> different = verifyPipeline(session, *gpu.value(), traits.kind, out);
        if (!different) {
            return different.error();
        }
        if (different.value() > 0) {
            differing << name;
        }
    }
    return differing.isEmpty() ? Status(Done{})
                               : Error{"The hits are applied wrongly by " +
                                           differing.join(QStringLiteral(", ")).toStdString() + ".",
                                       hitsPath.toStdString(), ""};
}

}  // namespace

int verifyCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Applies the hits of a file with every pipeline that runs here, and holds each vertex against the\n"
        "C++ reference. A pipeline that keeps the last hits only is held against these. Prints a line for\n"
        "each; the exit status is 1 where one differs."));
    parser.addHelpOption();
    const QCommandLineOption hits(QStringLiteral("hits"),
                                  QStringLiteral("The hits: CSV or JSON, as the window exports them."),
                                  QStringLiteral("file"));
    parser.addOption(hits);
    parser.addPositionalArgument(QStringLiteral("mesh"),
                                 QStringLiteral("Mesh file they were made on. Default: the paper's scene."),
                                 QStringLiteral("[mesh]"));
    if (const std::optional<int> status = parse(parser, QStringLiteral("verify"), arguments)) {
        return *status;
    }
    if (!parser.isSet(hits)) {
        return wrongUsage(QStringLiteral("verify needs --hits, a file of hits."));
    }
    if (parser.positionalArguments().size() > 1) {
        return wrongUsage(QStringLiteral("verify takes one mesh at most."));
    }
    return finish(verify(parser.positionalArguments().value(0), parser.value(hits)));
}

}  // namespace hitscope::cli
