// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/worker_location.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStringList>

#include "io/import.h"

namespace hitscope {
namespace {

QString& chosenPath() {
    static QString path;
    return path;
}

bool isProgram(const QString& path) {
    const QFileInfo info(path);
    return info.isFile() && info.isExecutable();
}

}  // namespace

void setImportWorkerPath(const QString& path) {
    chosenPath() = path;
}

QString importWorkerPath() {
    const QDir here(QCoreApplication::applicationDirPath());
    const QStringList candidates{
        chosenPath(),
        qEnvironmentVariable("HITSCOPE_IMPORT_WORKER"),
        here.filePath(QStringLiteral("hitscope-import")),
        here.filePath(QStringLiteral("../libexec/hitscope/hitscope-import")),
        here.filePath(QStringLiteral("../bin/hitscope-import")),
    };
    for (const QString& candidate : candidates) {
        if (isProgram(candidate)) {
            return candidate;
        }
    }
    return {};
}

}  // namespace hitscope
