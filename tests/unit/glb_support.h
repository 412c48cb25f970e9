// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "io_support.h"

namespace hitscope::test {

/// The parts of a GLB.
struct Glb {
    QJsonObject json;
    std::string buffer;

    explicit Glb(const QString& path) {
        const std::string bytes = readFile(path);
        const auto number = [&bytes](std::size_t at) {
            std::uint32_t value = 0;
            std::memcpy(&value, bytes.data() + at, sizeof value);
            return value;
        };
        if (bytes.size() < 28 || number(8) != bytes.size() || number(12) % 4 != 0) {
            return;
        }
        json = QJsonDocument::fromJson(QByteArray(bytes.data() + 20, number(12))).object();
        const std::size_t at = 20 + number(12);
        if (bytes.substr(at + 4, 4) == std::string("BIN\0", 4) && at + 8 + number(at) == bytes.size()) {
            buffer = bytes.substr(at + 8);
        }
    }
    [[nodiscard]] QJsonObject item(const char* list, qsizetype i) const {
        return json[QLatin1String(list)].toArray().at(i).toObject();
    }
};

/// What the specification asks of accessors and views; empty: all is well.
inline QString brokenRule(const Glb& glb) {
    const QJsonArray views = glb.json[QStringLiteral("bufferViews")].toArray();
    qint64 end = 0;
    for (const QJsonValue& value : views) {
        const QJsonObject view = value.toObject();
        const qint64 offset = view[QStringLiteral("byteOffset")].toInteger();
        const qint64 length = view[QStringLiteral("byteLength")].toInteger();
        if (offset % 4 != 0 || offset < end || length < 1) {
            return QStringLiteral("a view at %1 of %2 bytes").arg(offset).arg(length);
        }
        end = offset + length;
    }
    if (end > static_cast<qint64>(glb.buffer.size()) ||
        glb.json[QStringLiteral("buffers")]
                .toArray()[0]
                .toObject()[QStringLiteral("byteLength")]
                .toInteger() != static_cast<qint64>(glb.buffer.size())) {
        return QStringLiteral("the buffer's length");
    }
    for (const QJsonValue& value : glb.json[QStringLiteral("meshes")].toArray()) {
        for (const QJsonValue& each : value.toObject()[QStringLiteral("primitives")].toArray()) {
            const QJsonObject primitive = each.toObject();
            QJsonArray sets = primitive[QStringLiteral("targets")].toArray();
            sets.append(primitive[QStringLiteral("attributes")]);
            for (const QJsonValue& set : sets) {
                const QJsonObject position =
                    glb.item("accessors", set.toObject()[QStringLiteral("POSITION")].toInt(-1));
                if (position[QStringLiteral("min")].toArray().size() != 3 ||
                    position[QStringLiteral("max")].toArray().size() != 3) {
                    return QStringLiteral("a POSITION without limits");
                }
            }
            const QJsonObject indices = glb.item("accessors", primitive[QStringLiteral("indices")].toInt(-1));
            const QJsonObject view = glb.item("bufferViews", indices[QStringLiteral("bufferView")].toInt(-1));
            if (view[QStringLiteral("target")].toInt() != 34963) {
                return QStringLiteral("indices' target");
            }
        }
    }
    return {};
}

template <class Number>
std::vector<Number> numbersIn(const Glb& glb, const QJsonObject& place) {
    const QJsonObject view = glb.item("bufferViews", place[QStringLiteral("bufferView")].toInt(-1));
    std::vector<Number> numbers(static_cast<std::size_t>(view[QStringLiteral("byteLength")].toInt()) /
                                sizeof(Number));
    std::memcpy(numbers.data(), glb.buffer.data() + view[QStringLiteral("byteOffset")].toInt(),
                numbers.size() * sizeof(Number));
    return numbers;
}

/// Of an accessor, sparse or not, of 1 or 3 components.
inline std::vector<float> floatsOf(const Glb& glb, int accessor) {
    const QJsonObject object = glb.item("accessors", accessor);
    if (!object.contains(QStringLiteral("sparse"))) {
        return numbersIn<float>(glb, object);
    }
    const QJsonObject sparse = object[QStringLiteral("sparse")].toObject();
    const auto places = numbersIn<std::uint32_t>(glb, sparse[QStringLiteral("indices")].toObject());
    const auto values = numbersIn<float>(glb, sparse[QStringLiteral("values")].toObject());
    std::vector<float> numbers(3 * static_cast<std::size_t>(object[QStringLiteral("count")].toInt()));
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i] >= numbers.size() / 3 || (i > 0 && places[i] <= places[i - 1])) {
            return {};  // they must rise
        }
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                    numbers.begin() + static_cast<std::ptrdiff_t>(3 * places[i]));
    }
    return numbers;
}

}  // namespace hitscope::test
