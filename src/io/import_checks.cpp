// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/import_checks.h"

#include <QFileInfo>
#include <array>

#include "io/import.h"

namespace hitscope {
namespace {

struct Format {
    const char* name;
    const char* suffixes;  ///< separated by spaces
};

constexpr std::array kFormats{
    Format{"Wavefront OBJ", "obj"}, Format{"Stanford PLY", "ply"}, Format{"STL", "stl"},
    Format{"glTF", "gltf glb"},     Format{"OFF", "off"},          Format{"FBX", "fbx"},
    Format{"3D Studio", "3ds"},     Format{"COLLADA", "dae"},
};

std::string suffixAdvice() {
    return "Hitscope opens ." + importSuffixes().join(QStringLiteral(", .")).toStdString() + ".";
}

}  // namespace

QStringList importSuffixes() {
    QStringList suffixes;
    for (const Format& format : kFormats) {
        suffixes += QString::fromLatin1(format.suffixes).split(QLatin1Char(' '));
    }
    return suffixes;
}

QStringList importNameFilters() {
    QStringList filters;
    QStringList all;
    for (const Format& format : kFormats) {
        QStringList patterns;
        for (const QString& suffix : QString::fromLatin1(format.suffixes).split(QLatin1Char(' '))) {
            // Dialogs compare with case on Linux; files from elsewhere shout.
            patterns += QStringLiteral("*.") + suffix;
            patterns += QStringLiteral("*.") + suffix.toUpper();
        }
        all += patterns;
        filters +=
            QStringLiteral("%1 (%2)").arg(QString::fromLatin1(format.name), patterns.join(QLatin1Char(' ')));
    }
    filters.prepend(QStringLiteral("Meshes (%1)").arg(all.join(QLatin1Char(' '))));
    return filters;
}

Status checkImportable(const QString& path) {
    const std::string where = path.toStdString();
    const QFileInfo info(path);
    if (!info.exists()) {
        return info.isSymLink() ? Error{"The link leads to a file that does not exist.", where,
                                        "Open the file itself, or mend the link."}
               : path.contains(QChar::ReplacementCharacter)
                   ? Error{"The file's name is not UTF-8, and cannot be opened.", where, "Rename the file."}
                   : Error{"There is no such file.", where, "Check the path for a mistyped name."};
    }
    if (info.isDir()) {
        return Error{"This is a folder, not a mesh file.", where, "Open one of the files in it."};
    }
    if (!info.isFile()) {
        return Error{"This is a pipe or a device, not a file.", where,
                     "Save what it gives to a file first, and open that."};
    }
    if (!info.isReadable()) {
        return Error{"You are not allowed to read this file.", where,
                     "Change its permissions, or ask its owner."};
    }
    if (info.size() == 0) {
        return Error{"The file is empty.", where, "Save or download it again."};
    }
    if (!importSuffixes().contains(info.suffix().toLower())) {
        return Error{info.suffix().isEmpty()
                         ? std::string("The file's name has no suffix that tells its format.")
                         : "Hitscope does not know the format ." + info.suffix().toStdString() + ".",
                     where, suffixAdvice() + " Convert the file to one of these."};
    }
    return Done{};
}

}  // namespace hitscope
