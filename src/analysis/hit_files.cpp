// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/hit_files.h"

#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <numeric>

#include "io/staged_files.h"

namespace hitscope {

namespace {

constexpr std::size_t kMostNames = 5;  // that an error lists

Error unknownTargets(const std::vector<std::string>& names) {
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), kMostNames); ++i) {
        list += (i == 0 ? "“" : ", “") + names[i] + "”";
    }
    if (names.size() > kMostNames) {
        list += " and " + std::to_string(names.size() - kMostNames) + " more";
    }
    return {"The scene has no target named " + list + ".", "",
            "Load the scene the hits were made in, or rename its targets."};
}

/// `index`: of the hit in its table.
Status checkTriangle(const Hit& hit, std::size_t index, const Target& target) {
    const std::size_t triangles = target.shape.render->triangles.size() / 3;
    if (hit.triangle == kNoIndex || hit.triangle < triangles) {
        return Done{};
    }
    return Error{"Its triangle is " + std::to_string(hit.triangle) + ", counted from 0, but “" +
                     target.name.toStdString() + "” has only " + std::to_string(triangles) + ".",
                 "hit " + std::to_string(index + 1),
                 "Load the mesh that the hits were made on, or leave their triangles out."};
}

}  // namespace

std::optional<PipelineKind> pipelineOf(const Hit& hit) {
    for (const PipelineTraits& traits : allPipelines()) {
        if (static_cast<std::uint8_t>(traits.kind) == hit.pipeline) {
            return traits.kind;
        }
    }
    return std::nullopt;
}

std::vector<std::string> pipelineKeys() {
    std::vector<std::string> keys;
    for (const PipelineTraits& traits : allPipelines()) {
        const auto at = static_cast<std::size_t>(traits.kind);
        keys.resize(std::max(keys.size(), at + 1));
        keys[at] = traits.key;
    }
    return keys;
}

HitRecords recordsOf(const Session& session, const HitEffects* effects, std::span<const std::size_t> rows) {
    const std::span<const Hit> hits = session.hits().history().hits();
    HitRecords table;
    table.pipelines = pipelineKeys();
    for (const std::unique_ptr<Target>& target : session.targets()) {
        table.targets[target->id] = target->name.toStdString();
    }
    for (const std::size_t row : rows) {
        if (row < hits.size()) {
            table.hits.push_back(hits[row]);
            table.numbers.push_back(row + 1);
            table.effects.push_back(effects != nullptr ? effects->effect(row) : std::nullopt);
        }
    }
    return table;
}

HitRecords recordsOf(const Session& session, const HitEffects* effects) {
    std::vector<std::size_t> rows(session.hits().history().size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    return recordsOf(session, effects, rows);
}

Result<HitRecords> readHitFile(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return Error{"The file could not be read: " + file.errorString().toStdString() + ".",
                     path.toStdString(), ""};
    }
    const QByteArray bytes = file.read(static_cast<qint64>(kMostRecordBytes) + 1);
    Result<HitRecords> table =
        readHitRecords({bytes.data(), static_cast<std::size_t>(bytes.size())}, pipelineKeys());
    if (!table) {
        const Error& error = table.error();
        const std::string name = QFileInfo(path).fileName().toStdString();
        return Error{error.what, error.where.empty() ? name : name + ", " + error.where, error.advice};
    }
    return table;
}

Status writeHitFile(const HitRecords& table, const QString& path) {
    const bool isJson = path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive);
    return writeWhole(path, isJson ? toJson(table) : toCsv(table));
}

QString otherTargetFor(const Session& session, const HitRecords& table) {
    if (table.targets.size() != 1 || session.targets().size() != 1) {
        return {};
    }
    const QString& only = session.targets().front()->name;
    return only != QString::fromStdString(table.targets.begin()->second) ? only : QString();
}

Status appendRecords(Session& session, const HitRecords& table) {
    const QString other = otherTargetFor(session, table);
    std::map<TargetId, TargetId> ids;  // of the table -> of the session
    std::vector<std::string> unknown;
    for (const auto& [id, name] : table.targets) {
        const auto found = std::find_if(session.targets().begin(), session.targets().end(),
                                        [wanted = other.isEmpty() ? QString::fromStdString(name) : other](
                                            const auto& target) { return target->name == wanted; });
        if (found == session.targets().end()) {
            unknown.push_back(name);
        } else {
            ids[id] = (*found)->id;
        }
    }
    if (!unknown.empty()) {
        return unknownTargets(unknown);
    }
    std::vector<Hit> hits = table.hits;
    std::map<std::string, HitGroup> groups;  // by its name in the table: of the session
    std::map<HitGroupKind, HitGroup> next;   // of the session, once these are in it
    for (Hit& hit : hits) {
        hit.target = ids[hit.target];
        hit.triangle = other.isEmpty() ? hit.triangle : kNoIndex;  // the number of one of another mesh
        const auto index = static_cast<std::size_t>(&hit - hits.data());
        if (Status known = checkTriangle(hit, index, *session.targets().find(hit.target)); !known) {
            return known;
        }
        if (hit.group) {
            const HitGroupKind kind = hit.group.kind;
            const auto [group, isNew] = groups.try_emplace(groupText(hit.group));
            if (isNew) {
                HitGroup& unused = next.try_emplace(kind, session.hits().newGroup(kind)).first->second;
                group->second = unused;
                ++unused.number;
            }
            hit.group = group->second;
        }
    }
    return session.hits().add(hits);
}

}  // namespace hitscope
