// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/worker_protocol.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <cmath>

namespace hitscope {
namespace {

constexpr qsizetype kProgressWords = 9;  // "progress "
constexpr qsizetype kNoteWords = 5;      // "note "
constexpr qsizetype kErrorWords = 6;     // "error "

WorkerMessage parseProgress(const QByteArray& rest) {
    const qsizetype space = rest.indexOf(' ');
    bool isNumber = false;
    const double fraction = rest.left(space).toDouble(&isNumber);
    if (!isNumber || !std::isfinite(fraction)) {
        return {};
    }
    const QByteArray doing = space < 0 ? QByteArray() : rest.mid(space + 1);
    return WorkerProgress{std::min(fraction, 1.0), QString::fromUtf8(doing)};
}

WorkerMessage parseError(const QByteArray& rest) {
    const QJsonArray parts = QJsonDocument::fromJson(rest).array();
    const Error error{parts.at(0).toString().toStdString(), parts.at(1).toString().toStdString(),
                      parts.at(2).toString().toStdString()};
    if (error.what.empty()) {
        return {};
    }
    return error;
}

}  // namespace

QByteArray formatWorkerLine(const WorkerMessage& message) {
    if (const auto* progress = std::get_if<WorkerProgress>(&message)) {
        return "progress " + QByteArray::number(progress->fraction, 'f', 4) + ' ' + progress->doing.toUtf8() +
               '\n';
    }
    if (const auto* note = std::get_if<WorkerNote>(&message)) {
        return "note " + note->text.simplified().toUtf8() + '\n';
    }
    if (const auto* error = std::get_if<Error>(&message)) {
        const QJsonArray parts{QString::fromStdString(error->what), QString::fromStdString(error->where),
                               QString::fromStdString(error->advice)};
        return "error " + QJsonDocument(parts).toJson(QJsonDocument::Compact) + '\n';
    }
    return {};
}

WorkerMessage parseWorkerLine(const QByteArray& line) {
    if (line.startsWith("progress ")) {
        return parseProgress(line.mid(kProgressWords));
    }
    if (line.startsWith("note ")) {
        return WorkerNote{QString::fromUtf8(line.mid(kNoteWords))};
    }
    if (line.startsWith("error ")) {
        return parseError(line.mid(kErrorWords));
    }
    return {};
}

}  // namespace hitscope
