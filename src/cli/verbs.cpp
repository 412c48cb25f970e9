// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verbs.h"

#include "cli/command_line.h"

namespace hitscope::cli {

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
