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
            .all =
                {.name = QStringLiteral("hitscope-cli"),
                 .files = QStringLiteral("VERB"),
                 .about = QStringLiteral("shoot meshes and inspect sessions without a display"),
                 .description = QStringLiteral(
                     "Provides the functions of the hitscope window without a display: shoots at meshes, "
                     "opens, compares and measures sessions, draws pictures. Writes data to the standard "
                     "output and messages to the standard error. A file named - is the standard input, for "
                     "sessions and hits, or the standard output, for data, sessions and exported meshes. "
                     "Lengths are in metres, angles in degrees."),
                 .options = {flagOption("version", QStringLiteral("Print the version."))},
                 .examples = {},
                 .mostFiles = 0},
            .verbs = {},
            .statuses =
                {{kGood, QStringLiteral("Good.")},
                 {kDiffers, QStringLiteral("A comparison found a difference, or a promise was not kept.")},
                 {kWrongUsage, QStringLiteral("The command line is wrong.")},
                 {kBadInput, QStringLiteral("A file cannot be read or written, or has invalid content.")},
                 {kCannotDraw, QStringLiteral("Drawing is not possible: OpenGL is missing, it does not "
                                              "support the pipeline, or ffmpeg is missing.")},
                 {kSignalled, QStringLiteral("plus n: terminated by signal n, such as 130 for Ctrl+C, 141 "
                                             "for a closed output pipe. No partial files remain.")}},
            .environment = {{QStringLiteral("Folder for temporary files; default: /tmp."),
                             QStringLiteral("TMPDIR")},
                            {QStringLiteral("If set to 1, Mesa draws in software."),
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
