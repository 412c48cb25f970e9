// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/change_settings.h"

#include <QSettings>
#include <algorithm>
#include <cmath>

namespace hitscope {

namespace {

QString keyOf(const ChangeTraits& traits, const char* what) {
    return QStringLiteral("change/%1/%2").arg(QString::fromUtf8(traits.key), QLatin1String(what));
}

int number(const QSettings& settings, const QString& key, int count, int fallback) {
    bool isNumber = false;
    const int value = settings.value(key).toInt(&isNumber);
    return isNumber && value >= 0 && value < count ? value : fallback;
}

void loadStyle(const QSettings& settings, const ChangeTraits& traits, QuantityStyle& style) {
    style.map = static_cast<ColourMap>(
        number(settings, keyOf(traits, "map"), kColourMaps, static_cast<int>(style.map)));
    style.automatic = settings.value(keyOf(traits, "automatic"), style.automatic).toBool();
    bool isLow = false;
    bool isHigh = false;
    const float low = settings.value(keyOf(traits, "low")).toFloat(&isLow);
    const float high = settings.value(keyOf(traits, "high")).toFloat(&isHigh);
    if (isLow && isHigh && std::isfinite(low) && std::isfinite(high) && low < high) {
        style.fixed = {low, high};
    }
}

}  // namespace

void loadChangeSettings(const QSettings& settings, DisplayOptions& display) {
    ChangeMapOptions& map = display.change;
    map.isolines = settings.value(QStringLiteral("change/isolines"), map.isolines).toBool();
    const QString quantity = settings.value(QStringLiteral("change/quantity")).toString();
    for (const ChangeTraits& traits : allChangeQuantities()) {
        if (quantity == QString::fromUtf8(traits.key)) {
            map.quantity = traits.quantity;
        }
        loadStyle(settings, traits, map.styles[static_cast<std::size_t>(traits.quantity)]);
    }
    BeforeAfterOptions& before = display.beforeAfter;
    before.ghost = static_cast<GhostMode>(
        number(settings, QStringLiteral("change/ghost"), 3, static_cast<int>(before.ghost)));
}

void saveChangeSettings(QSettings& settings, const DisplayOptions& display) {
    const ChangeMapOptions& map = display.change;
    settings.setValue(QStringLiteral("change/isolines"), map.isolines);
    for (const ChangeTraits& traits : allChangeQuantities()) {
        const QuantityStyle& style = map.styles[static_cast<std::size_t>(traits.quantity)];
        if (traits.quantity == map.quantity) {
            settings.setValue(QStringLiteral("change/quantity"), QString::fromUtf8(traits.key));
        }
        settings.setValue(keyOf(traits, "map"), static_cast<int>(style.map));
        settings.setValue(keyOf(traits, "automatic"), style.automatic);
        settings.setValue(keyOf(traits, "low"),
                          QString::number(static_cast<double>(style.fixed.low), 'g', 9));
        settings.setValue(keyOf(traits, "high"),
                          QString::number(static_cast<double>(style.fixed.high), 'g', 9));
    }
    settings.setValue(QStringLiteral("change/ghost"), static_cast<int>(display.beforeAfter.ghost));
}

}  // namespace hitscope
