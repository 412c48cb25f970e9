// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFileInfo>
#include <QTextStream>

#include "cli/bench/report.h"
#include "cli/bench/reports/html_report.h"
#include "io/staged_files.h"

namespace hitscope::bench {

namespace {

const QString kStandardOutput = QStringLiteral("-");

bool isFile(const QString& destination) {
    return !destination.isEmpty() && destination != kStandardOutput;
}

Error cannotWrite(const QString& path, const QString& why) {
    return Error{"The report cannot be written: " + why.toStdString() + ".",
                 QDir::toNativeSeparators(path).toStdString(), "Choose a file in a folder you may write to."};
}

Status checkFile(const QString& path) {
    if (!isFile(path)) {
        return Done{};
    }
    const QFileInfo file(path);
    const QFileInfo folder(file.absolutePath());
    if (!folder.isDir()) {
        return cannotWrite(path, QStringLiteral("its folder does not exist"));
    }
    if (file.isDir() || !folder.isWritable() || (file.exists() && !file.isWritable())) {
        return cannotWrite(path, QStringLiteral("it is not a file that you may write"));
    }
    return Done{};
}

Status write(const QString& destination, const QByteArray& bytes) {
    if (!isFile(destination)) {
        if (!destination.isEmpty()) {
            QTextStream(stdout) << QString::fromUtf8(bytes);
        }
        return Done{};
    }
    return writeWhole(destination, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}  // namespace

int Destinations::toStandardOutput() const {
    int count = json ? 1 : 0;
    for (const QString& destination : {report, csv, html}) {
        count += destination == kStandardOutput ? 1 : 0;
    }
    return count;
}

bool Destinations::wantsText() const {
    const bool hasFile = isFile(report) || isFile(csv) || isFile(html);
    return toStandardOutput() == 0 && !(quiet && hasFile);
}

Status checkDestinations(const Destinations& destinations) {
    for (const QString& file : {destinations.report, destinations.csv, destinations.html}) {
        if (Status status = checkFile(file); !status) {
            return status;
        }
    }
    return Done{};
}

Status writeReport(const Report& report, const Destinations& destinations) {
    if (destinations.wantsText()) {
        QTextStream(stdout) << toText(report);
    }
    Status json = write(destinations.report, toJson(report));
    if (json && destinations.json) {
        json = write(kStandardOutput, toJson(report));
    }
    Status csv = json ? write(destinations.csv, toCsv(report)) : json;
    return csv && !destinations.html.isEmpty() ? write(destinations.html, toHtml(report)) : csv;
}

}  // namespace hitscope::bench
