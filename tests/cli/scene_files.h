// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>
#include <cmath>

namespace hitscope::test {

inline QString writeBytes(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
        qFatal("%s: %s", qPrintable(path), qPrintable(file.errorString()));
    }
    return path;
}

/// A ball of radius 1 about the origin as OBJ, its poles on the y axis.
inline QByteArray ballObj(int rings = 16, int segments = 24) {
    constexpr double kPi = 3.14159265358979;
    QByteArray text = "v 0 1 0\nv 0 -1 0\n";
    for (int ring = 1; ring < rings; ++ring) {
        for (int segment = 0; segment < segments; ++segment) {
            const double down = kPi * ring / rings;
            const double around = 2.0 * kPi * segment / segments;
            text += "v " + QByteArray::number(std::sin(down) * std::cos(around)) + ' ' +
                    QByteArray::number(std::cos(down)) + ' ' +
                    QByteArray::number(std::sin(down) * std::sin(around)) + '\n';
        }
    }
    const auto vertex = [&](int ring, int segment) {
        return QByteArray::number(3 + (ring - 1) * segments + segment % segments) + ' ';
    };
    for (int segment = 0; segment < segments; ++segment) {
        text += "f 1 " + vertex(1, segment + 1) + vertex(1, segment) + "\nf 2 " + vertex(rings - 1, segment) +
                vertex(rings - 1, segment + 1) + '\n';
        for (int ring = 1; ring + 1 < rings; ++ring) {
            text += "f " + vertex(ring, segment) + vertex(ring, segment + 1) + vertex(ring + 1, segment + 1) +
                    vertex(ring + 1, segment) + '\n';
        }
    }
    return text;
}

}  // namespace hitscope::test
