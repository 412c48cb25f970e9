// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>

#include "cli/run_cli.h"

namespace hitscope::test {

// hitscope-cli bench, and the records of its reports.

inline CliRun runBench(const QString& arguments) {
    return runCli(QStringList{QStringLiteral("bench")} +
                  arguments.split(QLatin1Char(' '), Qt::SkipEmptyParts));
}

/// bench compare of a report with a copy beside it: it has to be one that can be compared.
inline CliRun compareWithCopy(const QString& report) {
    const QString copy = report + QStringLiteral(".copy");
    QFile::copy(report, copy);
    return runCli({QStringLiteral("bench"), QStringLiteral("compare"), report, copy});
}

inline QJsonArray recordsOf(const QString& json) {
    return QJsonDocument::fromJson(json.toUtf8()).object()[QStringLiteral("records")].toArray();
}

inline double number(const QJsonValue& record, const char* field) {
    return record.toObject()[QLatin1String(field)].toDouble(-1.0);
}

inline QString text(const QJsonValue& record, const char* field) {
    return record.toObject()[QLatin1String(field)].toString();
}

}  // namespace hitscope::test
