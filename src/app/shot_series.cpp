// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/shot_series.h"

#include <QSettings>
#include <algorithm>
#include <glm/trigonometric.hpp>

#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr QPointF kMiddle(0.5, 0.5);
constexpr double kSequenceInterval = 0.1;  // seconds

QString keyOf(ShotSeries::Pattern pattern, const char* name) {
    const char* const patterns[] = {"burst", "line", "circle"};
    return QStringLiteral("shots/%1/%2")
        .arg(QLatin1String(patterns[static_cast<int>(pattern)]), QLatin1String(name));
}

/// A number within [least, most], or `fallback`.
double read(const QSettings& settings, const QString& key, double least, double most, double fallback) {
    bool isNumber = false;
    const double value = settings.value(key).toDouble(&isNumber);
    return isNumber && value >= least && value <= most ? value : fallback;
}

std::vector<TimedShot> shotsOf(const ShotSeries& series, const Viewport& viewport, const Ray& axis) {
    const auto angle = static_cast<float>(glm::radians(series.angle));
    switch (series.pattern) {
        case ShotSeries::Pattern::Line:
            return sweep(viewport.rayThrough(series.from), viewport.rayThrough(series.to), series.count,
                         series.interval);
        case ShotSeries::Pattern::Circle:
            return circle(viewport.rayThrough(kMiddle), viewport.camera().up(), angle, series.count,
                          series.interval);
        case ShotSeries::Pattern::Burst:
            break;
    }
    return burst(axis, series.count, angle, series.seed, series.interval);
}

}  // namespace

ShotScript makeScript(const ShotSeries& series, const Viewport& viewport) {
    const Ray middle = viewport.rayThrough(kMiddle);
    ShotScript script;
    script.projectile = viewport.aiming().projectileFor(middle);
    script.projectile.form = viewport.session().settings().constantsSetting().form;
    script.projectile.mostAlive = std::max(script.projectile.mostAlive, series.count);
    script.isInstant = series.isInstant || viewport.session().settings().flightMode() == FlightMode::Instant;
    // A burst is raised as one: the cone keeps its shape, and its middle lands where it is aimed at.
    script.shots = shotsOf(series, viewport,
                           script.isInstant ? middle : viewport.aiming().launched(middle, script.projectile));
    if (!script.isInstant && series.pattern != ShotSeries::Pattern::Burst) {
        for (TimedShot& shot : script.shots) {
            shot.ray = viewport.aiming().launched(shot.ray, script.projectile);
        }
    }
    return script;
}

ShotSeries loadShotSeries(const QSettings& settings, ShotSeries::Pattern pattern) {
    ShotSeries series;
    series.pattern = pattern;
    series.interval = pattern == ShotSeries::Pattern::Burst ? 0.0 : kSequenceInterval;
    const auto number = [&](const char* name, double least, double most, double fallback) {
        return read(settings, keyOf(pattern, name), least, most, fallback);
    };
    series.count = static_cast<int>(number("count", 1.0, ShotSeries::kMostShots, series.count));
    series.interval = number("interval", 0.0, ShotSeries::kLongestInterval, series.interval);
    series.angle = number("angle", 0.0, ShotSeries::kWidest, series.angle);
    series.seed = static_cast<std::uint32_t>(number("seed", 0.0, 2147483647.0, series.seed));
    series.from = {number("fromX", 0.0, 1.0, series.from.x()), number("fromY", 0.0, 1.0, series.from.y())};
    series.to = {number("toX", 0.0, 1.0, series.to.x()), number("toY", 0.0, 1.0, series.to.y())};
    series.isInstant = settings.value(keyOf(pattern, "instant"), false).toBool();
    return series;
}

void saveShotSeries(QSettings& settings, const ShotSeries& series) {
    const auto write = [&](const char* name, const QVariant& value) {
        settings.setValue(keyOf(series.pattern, name), value);
    };
    write("count", series.count);
    write("interval", series.interval);
    write("angle", series.angle);
    write("seed", series.seed);
    write("fromX", series.from.x());
    write("fromY", series.from.y());
    write("toX", series.to.x());
    write("toY", series.to.y());
    write("instant", series.isInstant);
}

}  // namespace hitscope
