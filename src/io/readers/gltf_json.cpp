// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/gltf_json.h"

#include <QJsonArray>
#include <cmath>
#include <cstring>

namespace hitscope {

GltfParts gltfParts(std::string_view file) {
    if (!file.starts_with("glTF")) {
        return {file, {}, {}};
    }
    // Both versions: four letters, version, length of all; version 1: length of the JSON and its kind, the
    // JSON; version 2 the same, as the first of several such chunks.
    constexpr std::size_t kHeader = 20;
    constexpr std::size_t kLengthAt = 12;
    constexpr std::size_t kChunkHeader = 8;
    std::uint32_t length = 0;
    if (file.size() < kHeader) {
        throw BadGltf("it ends inside its header");
    }
    std::memcpy(&length, file.data() + kLengthAt, sizeof length);
    if (length > file.size() - kHeader) {
        throw BadGltf("it ends inside its JSON");
    }
    GltfParts parts{file.substr(kHeader, length), file.substr(kHeader + length), {}};
    if (parts.rest.size() > kChunkHeader) {
        std::memcpy(&length, parts.rest.data(), sizeof length);
        parts.numbers = parts.rest.substr(kChunkHeader, length);
    }
    return parts;
}

std::string nthOfGltf(const char* what, std::size_t index) {
    return std::string(what) + " " + std::to_string(index);
}

GltfThings::GltfThings(const QJsonObject& root, const char* key, const char* what) : m_what(what) {
    const QJsonValue value = root.value(QLatin1String(key));
    for (const QJsonValue& each : value.toArray()) {
        m_things.push_back(each.toObject());
    }
    const QJsonObject named = value.toObject();
    for (auto it = named.begin(); it != named.end(); ++it) {
        m_names.insert(it.key(), m_things.size());
        m_things.push_back(it.value().toObject());
    }
}

std::size_t GltfThings::find(const QJsonValue& reference) const {
    if (reference.isString() && m_names.contains(reference.toString())) {
        return m_names.value(reference.toString());
    }
    const double number = reference.toDouble(-1.0);
    if (number >= 0.0 && number < static_cast<double>(m_things.size()) && m_names.isEmpty()) {
        return static_cast<std::size_t>(number);
    }
    throw BadGltf("it refers to " + std::string(m_what) + " that it does not have");
}

std::uint64_t gltfNumber(const QJsonObject& object, const char* key, std::uint64_t otherwise) {
    constexpr double kMost = 1e15;  // what follows multiplies and adds; all of it stays far from 2^64
    const QJsonValue value = object.value(QLatin1String(key));
    if (value.isUndefined()) {
        return otherwise;
    }
    const double given = value.toDouble(-1.0);
    if (!(given >= 0.0 && given <= kMost) || given != std::floor(given)) {
        throw BadGltf(std::string("its ") + key + " is no number of things");
    }
    return static_cast<std::uint64_t>(given);
}

std::uint64_t gltfComponentBytes(const QJsonObject& accessor) {
    switch (gltfNumber(accessor, "componentType")) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        default:
            return 4;
    }
}

std::uint64_t gltfComponentCount(const QJsonObject& accessor) {
    const QString type = accessor.value(QLatin1String("type")).toString();
    static const QHash<QString, std::uint64_t> counts{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                      {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    const auto known = counts.find(type);
    if (known == counts.end()) {
        throw BadGltf("it has numbers of an unknown type");
    }
    return *known;
}

}  // namespace hitscope
