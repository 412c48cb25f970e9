// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/app_settings.h"

#include <QSettings>
#include <cmath>

#include "app/actions/shading_actions.h"
#include "app/settings/change_settings.h"
#include "app/settings/cut_settings.h"
#include "app/settings/form_settings.h"
#include "app/settings/light_settings.h"

namespace hitscope {

namespace {

/// An enum kept as a number; `count` values.
template <class Enum>
Enum readEnum(const QSettings& settings, const QString& key, int count, Enum fallback) {
    bool isNumber = false;
    const int value = settings.value(key).toInt(&isNumber);
    return isNumber && value >= 0 && value < count ? static_cast<Enum>(value) : fallback;
}

void readColour(const QSettings& settings, const QString& key, glm::vec3& colour) {
    const QStringList parts = settings.value(key).toStringList();
    if (parts.size() != 3) {
        return;
    }
    glm::vec3 read;
    for (int i = 0; i < 3; ++i) {
        read[i] = parts[i].toFloat();
        if (!std::isfinite(read[i]) || read[i] < 0.0f || read[i] > 10.0f) {
            return;
        }
    }
    colour = read;
}

void writeColour(QSettings& settings, const QString& key, const glm::vec3& colour) {
    const auto number = [](float part) { return QString::number(static_cast<double>(part), 'g', 9); };
    settings.setValue(key, QStringList{number(colour.r), number(colour.g), number(colour.b)});
}

/// A number within [lowest, highest], or what it was.
void readNumber(const QSettings& settings, const QString& key, float lowest, float highest, float& value) {
    bool isNumber = false;
    const float read = settings.value(key).toFloat(&isNumber);
    if (isNumber && read >= lowest && read <= highest) {
        value = read;
    }
}

void loadProjectile(const QSettings& settings, Session& session) {
    ProjectileSettings projectile = session.settings().projectile();
    const auto& parameters = projectileParameters();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        auto value = static_cast<float>(parameterValue(projectile, i));
        readNumber(settings, QStringLiteral("projectile/") + QString::fromUtf8(parameters[i].key),
                   static_cast<float>(parameters[i].minimum), static_cast<float>(parameters[i].maximum),
                   value);
        setParameterValue(projectile, i, static_cast<double>(value));
    }
    projectile.bouncesCount =
        settings.value(QStringLiteral("projectile/bouncesCount"), projectile.bouncesCount).toBool();
    projectile.powerFollowsImpulse =
        settings.value(QStringLiteral("projectile/powerFollowsImpulse"), projectile.powerFollowsImpulse)
            .toBool();
    readColour(settings, QStringLiteral("projectile/colour"), projectile.colour);
    session.settings().restoreProjectile(projectile, session.settings().flightMode());
    bool isNumber = false;
    const double step = settings.value(QStringLiteral("physicsStep")).toDouble(&isNumber);
    if (isNumber && stepParameter().accepts(step)) {
        session.simulation().setStep(step);
    }
}

}  // namespace

void AppSettings::addRecentFile(const QString& path) {
    recentFiles.removeAll(path);
    recentFiles.prepend(path);
    recentFiles = recentFiles.mid(0, kMostRecentFiles);
}

QStringList mergedRecentFiles(const QStringList& mine, const QStringList& before, const QStringList& theirs) {
    QStringList all = mine;
    all.removeIf([&before](const QString& path) { return before.contains(path); });
    for (const QString& path : theirs) {
        if (!before.contains(path)) {
            all << path;
        }
    }
    for (const QString& path : mine) {
        if (before.contains(path) && theirs.contains(path)) {
            all << path;
        }
    }
    all.removeDuplicates();
    return all.mid(0, AppSettings::kMostRecentFiles);
}

AppSettings loadAppSettings(const QSettings& settings) {
    AppSettings values;
    values.theme = readEnum(settings, QStringLiteral("theme"), 3, values.theme);
    if (settings.contains(QStringLiteral("viewportTheme"))) {
        values.viewportTheme = readEnum(settings, QStringLiteral("viewportTheme"), 2, Theme::Dark);
    }
    DisplayOptions& display = values.display;
    display.wireframe = readEnum(settings, QStringLiteral("display/wireframe"), 3, display.wireframe);
    display.normals = readEnum(settings, QStringLiteral("display/normals"), 2, display.normals);
    display.look = readEnum(settings, QStringLiteral("display/material"), kSurfaceLooks, display.look);
    display.floor = settings.value(QStringLiteral("display/floor"), display.floor).toBool();
    display.textures = settings.value(QStringLiteral("display/textures"), display.textures).toBool();
    display.crosshair = settings.value(QStringLiteral("display/crosshair"), display.crosshair).toBool();
    loadChangeSettings(settings, display);
    loadCutSettings(settings, display.cut);
    for (const ShadingSwitch& shading : shadingSwitches()) {
        display.*shading.option =
            settings.value(QStringLiteral("display/") + QString::fromUtf8(shading.key), shading.first)
                .toBool();
    }
    if (settings.contains(QStringLiteral("exportNormals"))) {
        values.exportNormals = readEnum(settings, QStringLiteral("exportNormals"), 2, NormalMode::True);
    }
    values.coverTexture = settings.value(QStringLiteral("display/coverTexture"), 0).toInt();
    bool isNumber = false;
    const double stretch = settings.value(QStringLiteral("statistics/stretchLimit")).toDouble(&isNumber);
    if (isNumber && stretch >= 1.05 && stretch <= 100.0) {
        values.stretchLimit = stretch;
    }
    values.recentFiles =
        settings.value(QLatin1String(kRecentFilesKey)).toStringList().mid(0, AppSettings::kMostRecentFiles);
    values.folder = settings.value(QStringLiteral("folder")).toString();
    return values;
}

void saveAppSettings(QSettings& settings, const AppSettings& values) {
    settings.setValue(QStringLiteral("theme"), static_cast<int>(values.theme));
    if (values.viewportTheme) {
        settings.setValue(QStringLiteral("viewportTheme"), static_cast<int>(*values.viewportTheme));
    } else {
        settings.remove(QStringLiteral("viewportTheme"));
    }
    const DisplayOptions& display = values.display;
    settings.setValue(QStringLiteral("display/wireframe"), static_cast<int>(display.wireframe));
    settings.setValue(QStringLiteral("display/normals"), static_cast<int>(display.normals));
    settings.setValue(QStringLiteral("display/material"), static_cast<int>(display.look));
    settings.setValue(QStringLiteral("display/floor"), display.floor);
    settings.setValue(QStringLiteral("display/textures"), display.textures);
    settings.setValue(QStringLiteral("display/crosshair"), display.crosshair);
    saveChangeSettings(settings, display);
    saveCutSettings(settings, display.cut);
    for (const ShadingSwitch& shading : shadingSwitches()) {
        settings.setValue(QStringLiteral("display/") + QString::fromUtf8(shading.key),
                          display.*shading.option);
    }
    if (values.exportNormals) {
        settings.setValue(QStringLiteral("exportNormals"), static_cast<int>(*values.exportNormals));
    } else {
        settings.remove(QStringLiteral("exportNormals"));
    }
    settings.setValue(QStringLiteral("display/coverTexture"), values.coverTexture);
    settings.setValue(QStringLiteral("statistics/stretchLimit"), values.stretchLimit);
    settings.setValue(QLatin1String(kRecentFilesKey), values.recentFiles);
    settings.setValue(QStringLiteral("folder"), values.folder);
}

void loadSessionSettings(const QSettings& settings, Session& session) {
    const QString pipeline = settings.value(QStringLiteral("pipeline")).toString();
    for (const PipelineTraits& traits : allPipelines()) {
        if (QString::fromUtf8(traits.key) == pipeline) {
            session.settings().setPipeline(traits.kind);
        }
    }
    loadLights(settings, session);

    DeformationConstants constants;
    const auto& parameters = deformationParameters();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        bool isNumber = false;
        const double value =
            settings.value(QStringLiteral("constants/") + QString::fromUtf8(parameters[i].key))
                .toDouble(&isNumber);
        if (isNumber && parameters[i].accepts(value)) {
            setParameterValue(constants, i, value);
        }
    }
    // Each value was checked against the same ranges, so this is not refused.
    const bool relative =
        settings.value(QStringLiteral("constants/relative"), ConstantsSetting{}.relative).toBool();
    static_cast<void>(
        session.settings().restoreConstants(ConstantsSetting{constants, relative, loadForm(settings)}));
    loadProjectile(settings, session);
}

void saveSessionSettings(QSettings& settings, const Session& session) {
    for (const PipelineTraits& traits : allPipelines()) {
        if (traits.kind == session.settings().pipeline()) {
            settings.setValue(QStringLiteral("pipeline"), QString::fromUtf8(traits.key));
        }
    }
    saveLights(settings, session);
    const auto& parameters = deformationParameters();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        settings.setValue(QStringLiteral("constants/") + QString::fromUtf8(parameters[i].key),
                          QString::number(parameterValue(session.settings().constants(), i), 'g', 9));
    }
    settings.setValue(QStringLiteral("constants/relative"), session.settings().constantsSetting().relative);
    saveForm(settings, session.settings().constantsSetting().form);
    const ProjectileSettings& projectile = session.settings().projectile();
    const auto& shot = projectileParameters();
    for (std::size_t i = 0; i < shot.size(); ++i) {
        settings.setValue(QStringLiteral("projectile/") + QString::fromUtf8(shot[i].key),
                          QString::number(parameterValue(projectile, i), 'g', 9));
    }
    settings.setValue(QStringLiteral("projectile/bouncesCount"), projectile.bouncesCount);
    settings.setValue(QStringLiteral("projectile/powerFollowsImpulse"), projectile.powerFollowsImpulse);
    writeColour(settings, QStringLiteral("projectile/colour"), projectile.colour);
    settings.setValue(QStringLiteral("physicsStep"),
                      QString::number(session.simulation().physics().clock().step(), 'g', 17));
}

}  // namespace hitscope
