// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/pasted_text.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QStandardPaths>

#include "document/document_json.h"
#include "io/staged_files.h"

namespace hitscope {

namespace {

constexpr qsizetype kLooked = 1 << 20;  // bytes of a text that tell its format

QByteArray firstWord(const QByteArray& line) {
    return line.simplified().split(' ').first();
}

/// A vertex, before a face: what an OBJ cannot be without.
bool isObj(const QByteArray& text) {
    bool hasVertex = false;
    for (const QByteArray& line : text.split('\n')) {
        const QList<QByteArray> words = line.simplified().split(' ');
        const auto isNumber = [&words](qsizetype i) {
            bool is = false;
            words.value(i).toDouble(&is);
            return is;
        };
        hasVertex = hasVertex || (words.first() == "v" && isNumber(1) && isNumber(2) && isNumber(3));
        if (hasVertex && words.first() == "f" && words.size() >= 4) {
            return true;
        }
    }
    // The first face of a large mesh comes late.
    return hasVertex && text.size() == kLooked;
}

}  // namespace

bool isSessionText(const QByteArray& text) {
    const QByteArray start = text.left(kLooked).simplified().left(200);
    return start.startsWith('{') && start.contains("\"format\"") &&
           start.contains('"' + QByteArray::fromStdString(std::string(kSessionFormat)) + '"');
}

QString meshSuffixOf(const QByteArray& text) {
    const QByteArray start = text.left(kLooked);
    const QByteArray line = start.left(start.indexOf('\n')).trimmed();
    if (line == "ply") {
        return QStringLiteral("ply");
    }
    if (line == "OFF" || firstWord(line).endsWith("OFF")) {
        return QStringLiteral("off");
    }
    if (firstWord(line) == "solid" && start.contains("facet")) {
        return QStringLiteral("stl");
    }
    return isObj(start) ? QStringLiteral("obj") : QString();
}

Result<QString> keepPasted(const QByteArray& content, const QString& suffix) {
    const QString folder =
        QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/pasted");
    const QByteArray hash = QCryptographicHash::hash(content, QCryptographicHash::Sha256).toHex().left(8);
    const QString path = folder + QStringLiteral("/pasted_") + QString::fromLatin1(hash) + u'.' + suffix;
    QFile known(path);
    if (known.size() == content.size() && known.open(QIODevice::ReadOnly) && known.readAll() == content) {
        return path;
    }
    QDir().mkpath(folder);  // where that fails, so does writing
    const Status written = writeWhole(path, {content.constData(), static_cast<std::size_t>(content.size())});
    return written ? Result<QString>(path) : Result<QString>(written.error());
}

Result<QString> keepPasted(const QImage& picture) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly) || !picture.save(&buffer, "png")) {
        return Error{"The picture on the clipboard cannot be read.", {}, "Save it to a file, and drop that."};
    }
    return keepPasted(bytes, QStringLiteral("png"));
}

}  // namespace hitscope
