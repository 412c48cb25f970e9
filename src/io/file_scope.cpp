// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/file_scope.h"

#include <QDir>
#include <QFileInfo>

namespace hitscope {

QString resolveInside(const QString& folder, const QString& name) {
    const QString root = QFileInfo(folder).canonicalFilePath();
    if (root.isEmpty() || name.isEmpty() || name.contains(QChar::Null)) {
        return {};
    }
    QString local = name;
    local.replace(QLatin1Char('\\'), QLatin1Char('/'));
    const QString found = QFileInfo(QDir(root).filePath(local)).canonicalFilePath();
    const QString prefix = root.endsWith(QLatin1Char('/')) ? root : root + QLatin1Char('/');
    const QFileInfo info(found);
    return found.startsWith(prefix) && info.isFile() && info.isReadable() ? found : QString();
}

}  // namespace hitscope
