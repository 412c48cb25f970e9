// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep_results.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>

#include "cli/json_report.h"
#include "io/csv_writer.h"

namespace hitscope::cli {

namespace {

void addTarget(SweepResult& result, const QJsonObject& target) {
    const auto changed = static_cast<std::uint64_t>(target[QStringLiteral("changed_vertices")].toInteger());
    const auto share = static_cast<double>(changed);
    const double rms = target[QStringLiteral("rms_m")].toDouble();
    result.changedVertices += changed;
    result.largest = std::max(result.largest, target[QStringLiteral("largest_m")].toDouble());
    result.mean += share * target[QStringLiteral("mean_m")].toDouble();
    result.rootMeanSquare += share * rms * rms;
}

}  // namespace

QString reportPathOf(const QString& folder, const SweepJob& job) {
    return folder + QStringLiteral("/jobs/") + job.key + QStringLiteral(".json");
}

std::optional<SweepResult> readResult(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return std::nullopt;
    }
    const QJsonObject report = QJsonDocument::fromJson(file.readAll()).object();
    if (report[QStringLiteral("report")].toString() != QLatin1String("shoot")) {
        return std::nullopt;
    }
    SweepResult result;
    result.shots = static_cast<std::uint64_t>(report[QStringLiteral("shots")].toInteger());
    result.hits = static_cast<std::uint64_t>(report[QStringLiteral("hits")].toInteger());
    const QJsonArray targets = report[QStringLiteral("targets")].toArray();
    for (const QJsonValue& target : targets) {
        addTarget(result, target.toObject());
    }
    if (targets.size() == 1) {  // as it was said, to the last bit
        result.mean = targets[0].toObject()[QStringLiteral("mean_m")].toDouble();
        result.rootMeanSquare = targets[0].toObject()[QStringLiteral("rms_m")].toDouble();
    } else if (result.changedVertices > 0) {
        result.mean /= static_cast<double>(result.changedVertices);
        result.rootMeanSquare =
            std::sqrt(result.rootMeanSquare / static_cast<double>(result.changedVertices));
    }
    const QJsonObject agreement = report[QStringLiteral("agreement")].toObject();
    result.isExact = agreement.isEmpty() || agreement[QStringLiteral("exact")].toBool();
    result.hitsFingerprint = report[QStringLiteral("hits_fingerprint")].toString();
    result.positionsFingerprint = report[QStringLiteral("positions_fingerprint")].toString();
    return result;
}

std::string toCsv(const SweepTable& table) {
    CsvWriter csv;
    csv.text("job").text("scene");
    for (const QString& axis : table.plan.axes) {
        csv.text(axis.toStdString());
    }
    for (const char* column : {"shots", "hits", "changed_vertices", "largest_m", "mean_m", "rms_m", "exact",
                               "hits_fingerprint", "positions_fingerprint"}) {
        csv.text(column);
    }
    csv.endRow();
    for (std::size_t i = 0; i < table.plan.jobs.size(); ++i) {
        const SweepJob& job = table.plan.jobs[i];
        if (!table.results[i]) {
            continue;
        }
        const SweepResult& result = *table.results[i];
        csv.text(job.key.toStdString()).text(job.scene.toStdString());
        for (const QString& value : job.values) {
            csv.text(value.toStdString());
        }
        csv.count(result.shots).count(result.hits).count(result.changedVertices).exact(result.largest);
        csv.exact(result.mean).exact(result.rootMeanSquare).count(result.isExact ? 1 : 0);
        csv.text(result.hitsFingerprint.toStdString()).text(result.positionsFingerprint.toStdString());
        csv.endRow();
    }
    return csv.take();
}

std::string toJson(const SweepTable& table) {
    JsonReport report("sweep");
    report.beginArray("axes");
    for (const QString& axis : table.plan.axes) {
        report.text({}, axis);
    }
    report.endArray().count("jobs", table.plan.jobs.size()).beginArray("results");
    for (std::size_t i = 0; i < table.plan.jobs.size(); ++i) {
        const SweepJob& job = table.plan.jobs[i];
        if (!table.results[i]) {
            continue;
        }
        const SweepResult& result = *table.results[i];
        report.beginObject().text("job", job.key).text("scene", job.scene).beginObject("options");
        for (qsizetype axis = 0; axis < job.values.size(); ++axis) {
            report.text(table.plan.axes[axis].toStdString(), job.values[axis]);
        }
        report.endObject().count("shots", result.shots).count("hits", result.hits);
        report.count("changed_vertices", result.changedVertices).number("largest_m", result.largest);
        report.number("mean_m", result.mean)
            .number("rms_m", result.rootMeanSquare)
            .truth("exact", result.isExact);
        report.text("hits_fingerprint", result.hitsFingerprint);
        report.text("positions_fingerprint", result.positionsFingerprint).endObject();
    }
    report.endArray();
    return report.take();
}

}  // namespace hitscope::cli
