// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verbs.h"

#include "cli/bench/bench_command.h"
#include "cli/command_line.h"

namespace hitscope::cli {

/// Its benchmarks read their own options, so that `bench frame --help` is theirs.
Verb benchVerb() {
    return {{.name = QStringLiteral("bench"),
             .files = QStringLiteral("WHAT"),
             .about = QStringLiteral("measure the pipelines: frames, hits, the paper's tables"),
             .description = QStringLiteral(
                 "Measures on this machine. WHAT is paper, frame, modes, hit, physics, session, io or check; "
                 "hitscope-cli bench WHAT --help tells the options of each. bench check --strict ends with 1 "
                 "where a "
                 "promise about speed is not kept."),
             .options = {},
             .examples = {{QStringLiteral("A hit against the size of the mesh, a few samples each."),
                           QStringLiteral("hitscope-cli bench hit --quick --vertices 8K --json -")}},
             .leastFiles = 1,
             .mostFiles = 1},
            {}};
}

const std::vector<Verb>& verbs() {
    static const std::vector<Verb> all{
        infoVerb(),     shootVerb(),   replayVerb(),  verifyVerb(), exportVerb(),  convertVerb(),
        compareVerb(),  changesVerb(), explainVerb(), dentsVerb(),  sectionVerb(), pictureVerb(),
        sequenceVerb(), sweepVerb(),   collectVerb(), demoVerb(),   benchVerb(),   helpVerb()};
    return all;
}

const ProgramUsage& programUsage() {
    static const ProgramUsage program = [] {
        ProgramUsage made{
            .all = {.name = QStringLiteral("hitscope-cli"),
                    .files = QStringLiteral("VERB"),
                    .about = QStringLiteral("shoot meshes and look into sessions with no display"),
                    .description = QStringLiteral(
                        "Does without a display what the window of hitscope does: shoots at meshes, opens, "
                        "compares and measures sessions, draws pictures. Data goes to the standard output, "
                        "words about "
                        "it to the standard error. A file named - is the standard input or output. Lengths "
                        "are in "
                        "metres, angles in degrees."),
                    .options = {flagOption("version", QStringLiteral("Print the version."))},
                    .examples = {},
                    .mostFiles = 0},
            .verbs = {},
            .statuses =
                {{kGood, QStringLiteral("Good.")},
                 {kDiffers, QStringLiteral("What was compared differs, or a promise was not kept.")},
                 {kWrongUsage, QStringLiteral("The command line is wrong.")},
                 {kBadInput, QStringLiteral("A file cannot be read or written, or holds what it must not.")},
                 {kCannotDraw, QStringLiteral("Something cannot be drawn here: there is no OpenGL, the "
                                              "pipeline does not run on it, or ffmpeg is missing.")},
                 {kSignalled, QStringLiteral("and a number n more: signal n ended it, 130 for Ctrl+C, 141 "
                                             "where nobody read its output. Nothing half written is left.")}},
            .environment = {{QStringLiteral("Where temporary files go; default: /tmp."),
                             QStringLiteral("TMPDIR")},
                            {QStringLiteral("Set to 1, Mesa draws in software."),
                             QStringLiteral("LIBGL_ALWAYS_SOFTWARE")}},
            .seeAlso = {QStringLiteral("hitscope(1)")}};
        for (const Verb& verb : verbs()) {
            made.verbs << verb.usage;
        }
        return made;
    }();
    return program;
}

}  // namespace hitscope::cli
