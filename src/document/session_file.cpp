// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/session_file.h"

#include <QFile>
#include <QFileInfo>
#include <utility>

#include "document/capture.h"
#include "document/document_json.h"
#include "io/staged_files.h"

namespace hitscope {

namespace {

Error at(const QString& path, const Error& error) {
    const std::string file = path.toStdString();
    return {error.what, error.where.empty() ? file : file + ", " + error.where, error.advice};
}

}  // namespace

Result<SessionDocument> readSessionFile(const QString& path) {
    QFile file(path);
    const QFileInfo facts(path);
    if (!facts.exists()) {
        return at(path, {"There is no such file.", "", "Choose a session that Hitscope saved."});
    }
    if (!facts.isFile()) {
        return at(path, {"This is no file.", "", "Choose a session that Hitscope saved."});
    }
    if (static_cast<std::size_t>(facts.size()) > SessionDocument::kMostBytes) {
        return at(path, {"The file is too large.", "", "Choose a session that Hitscope saved."});
    }
    if (!file.open(QIODevice::ReadOnly)) {
        return at(path, {"The file cannot be read: " + file.errorString().toStdString() + ".", "",
                         "See that you may read it."});
    }
    const QByteArray bytes = file.readAll();
    if (file.error() != QFileDevice::NoError) {
        return at(path, {"The file cannot be read: " + file.errorString().toStdString() + ".", "",
                         "See that its disk is there."});
    }
    Result<SessionDocument> document = readDocument(bytes);
    if (!document) {
        return at(path, document.error());
    }
    for (std::string& place : document.value().notKnown) {
        place = path.toStdString() + ", " + place;
    }
    return document;
}

Status writeSessionFile(SessionDocument document, const QString& path) {
    nameFilesFrom(QFileInfo(path).absolutePath(), document);
    numberTargets(1, document);  // whatever was opened before it: the same session is the same file
    const QByteArray bytes = writeDocument(document);
    return writeWhole(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}  // namespace hitscope
