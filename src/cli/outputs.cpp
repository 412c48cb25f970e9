// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/outputs.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <filesystem>
#include <variant>
#include <vector>

#include "cli/standard_streams.h"
#include "document/mesh_references.h"
#include "io/import.h"
#include "io/save_image.h"
#include "session/session.h"

namespace hitscope::cli {

namespace {

struct NamedFile {
    QString as;  ///< in messages: "--out", "MESH"
    QString path;
    bool isInFolder = false;  ///< of a folder that is named, not itself
};

/// "--out names", or "--out writes" where nobody gave the file's name.
QString outputAsNamed(const NamedFile& output) {
    return output.as + (output.isInFolder ? QStringLiteral(" writes") : QStringLiteral(" names"));
}

/// What has to be another one, so that no other file is replaced.
QString wordForPlace(const NamedFile& output) {
    return output.isInFolder ? QStringLiteral("folder") : QStringLiteral("name");
}

bool isSameFile(const QString& a, const QString& b) {
    const QFileInfo one(a);
    const QFileInfo other(b);
    if (one.exists() != other.exists()) {
        return false;
    }
    if (!one.exists()) {
        return QDir::cleanPath(one.absoluteFilePath()) == QDir::cleanPath(other.absoluteFilePath());
    }
    std::error_code failed;
    return one.isFile() && std::filesystem::equivalent(one.filesystemAbsoluteFilePath(),
                                                       other.filesystemAbsoluteFilePath(), failed);
}

std::vector<NamedFile> filesOf(const Invocation& given, bool written) {
    using Takes = UsageOption::Takes;
    std::vector<NamedFile> files;
    for (const UsageOption& option : given.usage().options) {
        const QString path = given.text(option.name.toLatin1().constData());
        if (option.takes == (written ? Takes::Output : Takes::File) && !path.isEmpty()) {
            files.push_back({QStringLiteral("--") + option.name, path});
        }
        for (const QString& name : written ? option.writes : QStringList()) {
            files.push_back({QStringLiteral("--") + option.name, QDir(path).filePath(name), true});
        }
    }
    for (qsizetype i = 0; i < given.files().size(); ++i) {
        if ((i == given.usage().outputFile) == written) {
            files.push_back({given.usage().fileName(i), given.file(i)});
        }
    }
    return files;
}

/// What stands for a folder and is the standard output, which is none; empty: nothing.
QString streamAsFolder(const Invocation& given) {
    QString what;
    for (const UsageOption& option : given.usage().options) {
        if (option.takes == UsageOption::Takes::Folder &&
            isStandardStream(given.text(option.name.toLatin1().constData()))) {
            what = QStringLiteral("--") + option.name;
        }
    }
    for (qsizetype i = 0; i < given.files().size(); ++i) {
        const QString name = given.usage().fileName(i);
        if (name.startsWith(QLatin1String("FOLDER")) && isStandardStream(given.file(i))) {
            what = name;
        }
    }
    return what;
}

QString suffixOf(const QString& path) {
    return QFileInfo(path).suffix().toLower();
}

/// Files that somebody opens as what their suffix says, and what else may be in them; an option that is not
/// listed writes any of them.
QString wrongSuffix(const NamedFile& output, const Invocation& given) {
    const QString suffix = suffixOf(output.path);
    const QString session = QStringLiteral("hitscope");
    if (output.as == QLatin1String("--session")) {
        return suffix == session || isStandardStream(output.path) || suffix.isEmpty()
                   ? QString()
                   : QStringLiteral("--session writes a session; take the suffix .hitscope, not .%1.")
                         .arg(suffix);
    }
    if (suffix == session) {
        const bool isMesh = output.as == QLatin1String("--out");
        const bool hasOther = given.usage().find(QStringLiteral("session")) != nullptr;
        return QStringLiteral("%1 writes %2, so its suffix cannot be .hitscope.%3")
            .arg(output.as, isMesh ? QStringLiteral("a mesh") : QStringLiteral("no session"),
                 hasOther ? QStringLiteral(" --session writes a session.") : QString());
    }
    const bool isData = output.as == QLatin1String("--report") || output.as == QLatin1String("--csv") ||
                        output.as == QLatin1String("--svg") || output.as == QLatin1String("--hits-out") ||
                        output.as == QLatin1String("--save") || output.as == QLatin1String("--html");
    return isData && (importSuffixes().contains(suffix) || pictureSuffixes().contains(suffix))
               ? QStringLiteral("%1 writes neither a mesh nor a picture, so its suffix cannot be .%2.")
                     .arg(output.as, suffix)
               : QString();
}

std::vector<NamedFile>& keptOutputs() {
    static std::vector<NamedFile> outputs;
    return outputs;
}

bool refusedSoFar = false;

Error refused(Error error) {
    refusedSoFar = true;
    return error;
}

/// Those that replace a file: no other can be one that is read.
std::vector<NamedFile> replacingOutputs() {
    std::vector<NamedFile> replacing;
    for (const NamedFile& output : keptOutputs()) {
        if (!isStandardStream(output.path) && QFileInfo(output.path).isFile()) {
            replacing.push_back(output);
        }
    }
    return replacing;
}

/// Of a file that a target of that name refers to.
Error readAsWell(const NamedFile& output, const QString& target) {
    return refused({QStringLiteral("%1 a file of \"%2\", which is read as well.")
                        .arg(outputAsNamed(output), target)
                        .toStdString(),
                    output.path.toStdString(),
                    "Take another " + wordForPlace(output).toStdString() + " for the output."});
}

/// The second of two would find the standard input empty.
QString streamTwice(const std::vector<NamedFile>& inputs) {
    QString first;
    for (const NamedFile& input : inputs) {
        if (!isStandardStream(input.path)) {
            continue;
        }
        if (!first.isEmpty()) {
            return QStringLiteral("%1 and %2 both read the standard input.").arg(first, input.as);
        }
        first = input.as;
    }
    return {};
}

}  // namespace

QString wrongOutputs(const Invocation& given) {
    if (const QString folder = streamAsFolder(given); !folder.isEmpty()) {
        return QStringLiteral("%1 cannot be the standard output; ./- names a folder called -.").arg(folder);
    }
    const std::vector<NamedFile> inputs = filesOf(given, false);
    if (QString twice = streamTwice(inputs); !twice.isEmpty()) {
        return twice;
    }
    std::vector<NamedFile> before;
    if (given.usage().find(QStringLiteral("json")) != nullptr && given.isSet("json")) {
        before.push_back({QStringLiteral("--json"), QStringLiteral("-")});
    }
    for (const NamedFile& output : filesOf(given, true)) {
        const bool isReport = output.as == QLatin1String("--report");
        for (const NamedFile& other : before) {
            const bool isJsonTwice = isReport && other.as == QLatin1String("--json");
            if (isStandardStream(output.path) && isStandardStream(other.path) && !isJsonTwice) {
                return QStringLiteral("%1 and %2 both write to the standard output.")
                    .arg(other.as, output.as);
            }
            if (!isStandardStream(output.path) && isSameFile(output.path, other.path)) {
                return QStringLiteral("%1 and %2 both name %3.").arg(other.as, output.as, output.path);
            }
        }
        for (const NamedFile& input : inputs) {
            const bool isUpdate =
                output.as == QLatin1String("--session") && suffixOf(input.path) == QLatin1String("hitscope");
            if (!isStandardStream(output.path) && !isUpdate && isSameFile(output.path, input.path)) {
                return QStringLiteral("%1 %2, which is read as well; take another %3 for the output.")
                    .arg(outputAsNamed(output), output.path, wordForPlace(output));
            }
        }
        if (const QString wrong = wrongSuffix(output, given); !wrong.isEmpty()) {
            return wrong;
        }
        before.push_back(output);
    }
    return {};
}

Status checkFolders(const Invocation& given) {
    const QList<UsageOption>& options = given.usage().options;
    if (std::any_of(options.begin(), options.end(),
                    [](const UsageOption& option) { return option.takes == UsageOption::Takes::Folder; })) {
        return Done{};
    }
    for (const NamedFile& output : filesOf(given, true)) {
        const QFileInfo file(output.path);
        if (isStandardStream(output.path) || output.as.startsWith(QLatin1String("FOLDER"))) {
            continue;
        }
        if (file.isDir()) {
            return Error{output.as.toStdString() + " names a folder.", output.path.toStdString(),
                         "Name a file in it."};
        }
        if (!QFileInfo(file.absolutePath()).isDir()) {
            return Error{output.as.toStdString() + " names a file in a folder that is not there.",
                         output.path.toStdString(), "Make the folder, or choose another one."};
        }
    }
    return Done{};
}

void keepOutputs(const Invocation& given) {
    keptOutputs() = filesOf(given, true);
}

void keepOutputs(const QString& as, const QStringList& paths) {
    for (const QString& path : paths) {
        if (QFileInfo(path).isFile()) {  // of others there may be very many
            keptOutputs().push_back({as, path, true});
        }
    }
}

bool areOutputsRefused() {
    return refusedSoFar;
}

Status checkReferences(const QString& name, const QString& path, const MeshData& mesh) {
    const std::vector<NamedFile> outputs = replacingOutputs();
    if (outputs.empty()) {
        return Done{};  // the usual case: the mesh's file is not looked at again
    }
    for (const MeshReference& reference : allReferencesOf(path, mesh)) {
        for (const NamedFile& output : outputs) {
            if (isSameFile(output.path, reference.path)) {
                return readAsWell(output, name);
            }
        }
    }
    return Done{};
}

Status checkSources(const Session& session) {
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const auto* source = std::get_if<MeshFile>(&target->source);
        if (source == nullptr) {
            continue;
        }
        for (const NamedFile& output : keptOutputs()) {
            if (!isStandardStream(output.path) && isSameFile(output.path, source->path)) {
                return refused({"The session's target \"" + target->name.toStdString() +
                                    "\" is read from that file, and its hits would apply to it again.",
                                output.path.toStdString(), "Choose another name for the output."});
            }
            for (const LocatedTexture& texture : target->textures) {
                if (!isStandardStream(output.path) && isSameFile(output.path, texture.path)) {
                    return readAsWell(output, target->name);
                }
            }
        }
        if (Status free = checkReferences(target->name, source->path, target->deformed.original()); !free) {
            return free;
        }
    }
    return Done{};
}

bool isOutputTaken(const Invocation& given) {
    for (const NamedFile& output : filesOf(given, true)) {
        if (isStandardStream(output.path) && output.as != QLatin1String("--report")) {
            return true;
        }
    }
    return false;
}

}  // namespace hitscope::cli
