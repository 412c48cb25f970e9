// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/file_scope.h"

#include <QDir>
#include <QFileInfo>
#include <QStringDecoder>
#include <QStringList>
#include <QUrl>

namespace hitscope {

QString fileNameText(const std::string& bytes) {
    const QByteArrayView view(bytes.data(), static_cast<qsizetype>(bytes.size()));
    QStringDecoder utf8(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    const QString text = utf8.decode(view);
    return utf8.hasError() ? QString::fromLatin1(view) : text;
}

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

QString resolveUri(const QString& folder, const QString& uri) {
    const QString direct = resolveInside(folder, uri);
    return direct.isEmpty() ? resolveInside(folder, QUrl::fromPercentEncoding(uri.toUtf8())) : direct;
}

QString resolveTexture(const QString& folder, const QString& name) {
    QString direct = resolveInside(folder, name);
    if (!direct.isEmpty()) {
        return direct;
    }
    QString local = name;
    local.replace(QLatin1Char('\\'), QLatin1Char('/'));
    return resolveInside(folder, QFileInfo(local).fileName());
}

QString textureOfUri(const QString& folder, const QString& uri) {
    const QString decoded = QUrl::fromPercentEncoding(uri.toUtf8());
    const bool isMeant = resolveTexture(folder, uri).isEmpty() && !resolveTexture(folder, decoded).isEmpty();
    return isMeant ? decoded : uri;
}

std::string textureOfLibrary(const QString& folder, const QString& library, const std::string& name) {
    QString path = library;
    path.replace(QLatin1Char('\\'), QLatin1Char('/'));
    path = QFileInfo(path).path();
    const QString text = fileNameText(name);
    if (name.empty() || path == QLatin1String(".") || !resolveTexture(folder, text).isEmpty()) {
        return name;
    }
    const QString beside = path + QLatin1Char('/') + text;
    return resolveInside(folder, beside).isEmpty() ? name : beside.toStdString();
}

QStringList librariesOnLine(const QString& folder, const QString& line) {
    if (!resolveInside(folder, line).isEmpty()) {
        return {line};
    }
    return line.split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

}  // namespace hitscope
