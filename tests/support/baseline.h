// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QImage>
#include <QString>
#include <algorithm>
#include <climits>
#include <cstdlib>

namespace hitscope::test {

/// The largest difference of a channel, [0, 255].
[[nodiscard]] inline int levels(QRgb a, QRgb b) {
    return std::max(
        {std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
}

/// Of two pictures, neither of which may be missing, pixels can be compared.
[[nodiscard]] inline bool areComparable(const QImage& a, const QImage& b) {
    return !a.isNull() && a.size() == b.size();
}

/// The mean over all pixels of levels(); as large as it can be where they are not comparable.
[[nodiscard]] inline double meanDifference(const QImage& a, const QImage& b) {
    if (!areComparable(a, b)) {
        return 255.0;
    }
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            sum += levels(a.pixel(x, y), b.pixel(x, y));
        }
    }
    return sum / (a.width() * a.height());
}

/// Pixels of two pictures that differ by more than `tolerance` levels in some channel; INT_MAX where they are
/// not comparable.
[[nodiscard]] inline int differing(const QImage& a, const QImage& b, int tolerance = 0) {
    if (!areComparable(a, b)) {
        return INT_MAX;
    }
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            count += levels(a.pixel(x, y), b.pixel(x, y)) > tolerance ? 1 : 0;
        }
    }
    return count;
}

/// Pixels of `a` that are so like none of `b` within `reach` pixels of there.
[[nodiscard]] inline int differingNearby(const QImage& a, const QImage& b, int tolerance, int reach) {
    const auto isThere = [&](int x, int y) {
        for (int v = std::max(0, y - reach); v <= std::min(b.height() - 1, y + reach); ++v) {
            for (int u = std::max(0, x - reach); u <= std::min(b.width() - 1, x + reach); ++u) {
                if (levels(a.pixel(x, y), b.pixel(u, v)) <= tolerance) {
                    return true;
                }
            }
        }
        return false;
    };
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            count += isThere(x, y) ? 0 : 1;
        }
    }
    return count;
}

// Renderers differ along outlines and lines, by where samples lie: a pixel counts as different beyond so many
// levels, and a small part of them is let through: less than half of what tells any two ways to draw apart
// (tests/render/modes_test.cpp).
inline constexpr int kDifferentLevels = 24;
inline constexpr double kMostDifferent = 0.005;  // of a picture's pixels

/// Where the picture of that name is.
[[nodiscard]] inline QString baselinePath(const QString& name) {
    return QDir(QStringLiteral(HITSCOPE_BASELINES)).filePath(name + QStringLiteral(".png"));
}

/// Holds a picture against the one that was looked at: tests/render/baselines. With
/// HITSCOPE_WRITE_BASELINES=1 in the environment that is written anew. Empty: they look alike; else what is
/// different. `reach`: pixels that a thing may be beside its place, either way; Mesa 22 and 25 put points
/// half a pixel apart.
[[nodiscard]] inline QString differenceFromBaseline(const QImage& shown, const QString& name, int reach = 0) {
    const QString path = baselinePath(name);
    if (qEnvironmentVariableIsSet("HITSCOPE_WRITE_BASELINES") &&
        !shown.convertToFormat(QImage::Format_RGB888).save(path)) {
        return QStringLiteral("cannot write %1").arg(path);
    }
    const QImage baseline(path);
    if (!areComparable(baseline, shown)) {
        return QStringLiteral("no picture of this size in %1").arg(path);
    }
    const int different = std::max(differingNearby(shown, baseline, kDifferentLevels, reach),
                                   differingNearby(baseline, shown, kDifferentLevels, reach));
    if (different <= kMostDifferent * shown.width() * shown.height()) {
        return {};
    }
    const QString saved = QDir::temp().filePath(QStringLiteral("hitscope-%1.png").arg(name));
    shown.save(saved);
    return QStringLiteral("%1 pixels differ; see %2").arg(different).arg(saved);
}

}  // namespace hitscope::test
