// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/shots/shot_script_file.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "deform/dent_form_text.h"
#include "io/staged_files.h"

namespace hitscope {

namespace {

constexpr int kVersion = 1;
constexpr qint64 kLargestFile = qint64{64} << 20;  // bytes
constexpr double kFarthest = 1.0e7;                // metres: beyond that nothing is simulated
constexpr double kLongest = 86400.0;               // seconds
// Of projectileParameters(): how the session shoots by hand, and how it makes hits, is not the script's.
constexpr std::array<std::string_view, 6> kProjectileKeys{"speed",    "radius",     "mass",
                                                          "lifetime", "most_alive", "gravity"};

/// `where`: the member; `what`: "has to be ...".
Error wrong(const QString& where, const QString& what) {
    return Error{QStringLiteral("It %1.").arg(what).toStdString(), where.toStdString(),
                 "Compare it with a shot script that Hitscope saved."};
}

QJsonArray toJson(const glm::vec3& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

Status onlyMembers(const QJsonObject& object, const QStringList& known, const QString& where) {
    for (const QString& key : object.keys()) {
        if (!known.contains(key)) {
            return wrong(where, QStringLiteral("has a member \"%1\", which is unknown").arg(key));
        }
    }
    return Done{};
}

Result<glm::vec3> vectorOf(const QJsonValue& value, const QString& where) {
    const QJsonArray parts = value.toArray();
    glm::vec3 vector(0.0f);
    bool usable = value.isArray() && parts.size() == 3;
    for (int i = 0; usable && i < 3; ++i) {
        usable = parts[i].isDouble() && std::abs(parts[i].toDouble()) <= kFarthest;
        vector[i] = static_cast<float>(parts[i].toDouble());
    }
    if (!usable) {
        return wrong(where, QStringLiteral("has to be three numbers within 10,000 km"));
    }
    return vector;
}

Result<TimedShot> shotOf(const QJsonValue& value, double earliest, const QString& where) {
    if (!value.isObject()) {
        return wrong(where, QStringLiteral("has to be an object"));
    }
    const QJsonObject object = value.toObject();
    const QString time = QStringLiteral("time");
    const QString from = QStringLiteral("from");
    const QString direction = QStringLiteral("direction");
    if (Status status = onlyMembers(object, {time, from, direction}, where); !status) {
        return status.error();
    }
    const double seconds = object[time].toDouble(-1.0);
    if (!(seconds >= 0.0 && seconds <= kLongest)) {
        return wrong(where + QStringLiteral(".time"), QStringLiteral("has to be 0 to 86400 seconds"));
    }
    if (seconds < earliest) {
        return wrong(where + QStringLiteral(".time"), QStringLiteral("is before that of the shot above it"));
    }
    const Result<glm::vec3> origin = vectorOf(object[from], where + QStringLiteral(".from"));
    if (!origin) {
        return origin.error();
    }
    const Result<glm::vec3> towards = vectorOf(object[direction], where + QStringLiteral(".direction"));
    if (!towards) {
        return towards.error();
    }
    const glm::dvec3 whole(towards.value());
    const double length = glm::length(whole);
    if (!(length > 1.0e-6)) {
        return wrong(where + QStringLiteral(".direction"), QStringLiteral("has no length"));
    }
    // What is unit already stays as it is, in every bit.
    const bool isUnit = std::abs(length - 1.0) < 1.0e-6;
    return TimedShot{seconds, {origin.value(), isUnit ? towards.value() : glm::vec3(whole / length)}};
}

Result<ProjectileSettings> projectileOf(const QJsonValue& value) {
    const QString where = QStringLiteral("projectile");
    ProjectileSettings settings;
    if (value.isUndefined()) {
        return settings;
    }
    if (!value.isObject()) {
        return wrong(where, QStringLiteral("has to be an object"));
    }
    const QJsonObject object = value.toObject();
    const QString bounces = QStringLiteral("bounces_count");
    const QString passes = QStringLiteral("passes_others");
    QStringList known{bounces, passes};
    for (const std::string_view key : kProjectileKeys) {
        known << QString::fromUtf8(key);
    }
    if (Status status = onlyMembers(object, known, where); !status) {
        return status.error();
    }
    const auto& parameters = projectileParameters();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const QJsonValue number = object[QString::fromUtf8(parameters[i].key)];
        if (number.isUndefined()) {
            continue;
        }
        if (!number.isDouble() || !parameters[i].accepts(number.toDouble())) {
            return wrong(where + u'.' + QString::fromUtf8(parameters[i].key),
                         QStringLiteral("has to be a number from %1 to %2")
                             .arg(parameters[i].minimum)
                             .arg(parameters[i].maximum));
        }
        setParameterValue(settings, i, number.toDouble());
    }
    for (const QString& key : {bounces, passes}) {
        if (object.contains(key) && !object[key].isBool()) {
            return wrong(where + u'.' + key, QStringLiteral("has to be true or false"));
        }
    }
    settings.bouncesCount = object[bounces].toBool(settings.bouncesCount);
    settings.passesOthers = object[passes].toBool(settings.passesOthers);
    return settings;
}

QJsonObject toJson(const DentForm& form) {
    const auto text = [](std::string_view key) {
        return QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size()));
    };
    QJsonObject object{{QStringLiteral("profile"), text(keyOf(form.profile))},
                       {QStringLiteral("direction"), text(keyOf(form.direction))}};
    if (form.profile == DentProfile::Curve) {
        QJsonArray curve;
        for (const float ordinate : form.curve) {
            curve.append(static_cast<double>(ordinate));
        }
        object[QStringLiteral("curve")] = curve;
    }
    return object;
}

Result<CurveOrdinates> curveOf(const QJsonValue& value) {
    const QJsonArray parts = value.toArray();
    CurveOrdinates curve{};
    bool usable = parts.size() == static_cast<qsizetype>(curve.size());
    for (qsizetype i = 0; usable && i < parts.size(); ++i) {
        usable = parts[i].isDouble() && std::abs(parts[i].toDouble()) <= 1.0;
        curve[static_cast<std::size_t>(i)] = static_cast<float>(parts[i].toDouble());
    }
    if (!usable) {
        return wrong(QStringLiteral("dent.curve"), QStringLiteral("has to be eight numbers from -1 to 1"));
    }
    return curve;
}

Result<std::optional<DentForm>> formOf(const QJsonValue& value) {
    if (value.isUndefined()) {
        return std::optional<DentForm>();
    }
    const QString where = QStringLiteral("dent");
    if (!value.isObject()) {
        return wrong(where, QStringLiteral("has to be an object"));
    }
    const QJsonObject object = value.toObject();
    const QString profile = QStringLiteral("profile");
    const QString direction = QStringLiteral("direction");
    const QString curve = QStringLiteral("curve");
    if (Status status = onlyMembers(object, {profile, direction, curve}, where); !status) {
        return status.error();
    }
    DentForm form;
    const auto named = profileNamed(object[profile].toString(QStringLiteral("paper")).toStdString());
    const auto way = directionNamed(object[direction].toString(QStringLiteral("projectile")).toStdString());
    if (!named || !way) {
        return wrong(where + u'.' + (named ? direction : profile), QStringLiteral("is not known"));
    }
    form.profile = *named;
    form.direction = *way;
    if (object.contains(curve)) {
        const Result<CurveOrdinates> ordinates = curveOf(object[curve]);
        if (!ordinates) {
            return ordinates.error();
        }
        form.curve = ordinates.value();
    }
    return std::optional(form);
}

Result<std::vector<TimedShot>> shotsOf(const QJsonValue& value) {
    if (!value.isArray()) {
        return wrong(QStringLiteral("shots"), QStringLiteral("has to be a list"));
    }
    const QJsonArray list = value.toArray();
    if (list.size() > ShotScript::kMostShots) {
        return wrong(QStringLiteral("shots"),
                     QStringLiteral("has more than %1 entries").arg(ShotScript::kMostShots));
    }
    std::vector<TimedShot> shots;
    shots.reserve(static_cast<std::size_t>(list.size()));
    for (qsizetype i = 0; i < list.size(); ++i) {
        const double earliest = shots.empty() ? 0.0 : shots.back().time;
        Result<TimedShot> shot = shotOf(list[i], earliest, QStringLiteral("shots[%1]").arg(i));
        if (!shot) {
            return shot.error();
        }
        shots.push_back(shot.value());
    }
    return shots;
}

}  // namespace

QByteArray formatShotScript(const ShotScript& script) {
    QJsonObject projectile;
    const auto& parameters = projectileParameters();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (std::find(kProjectileKeys.begin(), kProjectileKeys.end(), parameters[i].key) !=
            kProjectileKeys.end()) {
            projectile[QString::fromUtf8(parameters[i].key)] = parameterValue(script.projectile, i);
        }
    }
    projectile[QStringLiteral("bounces_count")] = script.projectile.bouncesCount;
    projectile[QStringLiteral("passes_others")] = script.projectile.passesOthers;
    QJsonArray shots;
    for (const TimedShot& shot : script.shots) {
        shots.append(QJsonObject{{QStringLiteral("time"), shot.time},
                                 {QStringLiteral("from"), toJson(shot.ray.origin)},
                                 {QStringLiteral("direction"), toJson(shot.ray.direction)}});
    }
    QJsonObject whole{{QStringLiteral("hitscope-shots"), kVersion},
                      {QStringLiteral("instant"), script.isInstant},
                      {QStringLiteral("projectile"), projectile},
                      {QStringLiteral("shots"), shots}};
    if (script.projectile.form) {
        whole[QStringLiteral("dent")] = toJson(*script.projectile.form);
    }
    return QJsonDocument(whole).toJson();
}

Result<ShotScript> parseShotScript(const QByteArray& json) {
    QJsonParseError trouble;
    const QJsonDocument document = QJsonDocument::fromJson(json, &trouble);
    if (!document.isObject()) {
        const bool isJson = trouble.error == QJsonParseError::NoError;
        return Error{isJson ? "It has to be a JSON object."
                            : "It is not JSON: " + trouble.errorString().toStdString() + '.',
                     "byte " + std::to_string(trouble.offset), "Choose a shot script that Hitscope saved."};
    }
    const QJsonObject object = document.object();
    const QString version = QStringLiteral("hitscope-shots");
    const QString instant = QStringLiteral("instant");
    if (object[version].toDouble() != kVersion) {
        return wrong(version, object.contains(version)
                                  ? QStringLiteral("has to be %1").arg(kVersion)
                                  : QStringLiteral("is missing: this is no shot script"));
    }
    const QStringList known{version, instant, QStringLiteral("projectile"), QStringLiteral("dent"),
                            QStringLiteral("shots")};
    if (Status status = onlyMembers(object, known, QStringLiteral("shot script")); !status) {
        return status.error();
    }
    if (object.contains(instant) && !object[instant].isBool()) {
        return wrong(instant, QStringLiteral("has to be true or false"));
    }
    Result<ProjectileSettings> projectile = projectileOf(object[QStringLiteral("projectile")]);
    if (!projectile) {
        return projectile.error();
    }
    const Result<std::optional<DentForm>> form = formOf(object[QStringLiteral("dent")]);
    if (!form) {
        return form.error();
    }
    projectile.value().form = form.value();
    Result<std::vector<TimedShot>> shots = shotsOf(object[QStringLiteral("shots")]);
    if (!shots) {
        return shots.error();
    }
    return ShotScript{projectile.value(), object[instant].toBool(), std::move(shots).value()};
}

Result<ShotScript> readShotScript(const QString& path) {
    QFile file(path);
    const QFileInfo info(path);
    if (!info.isFile() || !file.open(QIODevice::ReadOnly)) {
        return Error{"The shot script cannot be read.", path.toStdString(), "Choose a file you may read."};
    }
    if (info.size() > kLargestFile) {
        return Error{"The shot script is larger than 64 MiB.", path.toStdString(), "Split it."};
    }
    Result<ShotScript> script = parseShotScript(file.readAll());
    if (!script) {
        Error error = script.error();
        error.where = path.toStdString() + ", " + error.where;
        return error;
    }
    return script;
}

Status writeShotScript(const ShotScript& script, const QString& path) {
    const QByteArray text = formatShotScript(script);
    return writeWhole(path, {text.constData(), static_cast<std::size_t>(text.size())});
}

}  // namespace hitscope
