// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QJsonObject>
#include <QString>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hitscope {

/// Thrown by what looks at a glTF file, and caught by prepareGltf().
struct BadGltf : std::runtime_error {
    explicit BadGltf(const std::string& what, std::string whatToDo = {})
        : std::runtime_error(what), advice(std::move(whatToDo)) {}
    std::string advice;  ///< what to do, if there is something better than trying another program
};

struct GltfParts {
    std::string_view json;
    std::string_view rest;     ///< of a binary file: what follows its JSON
    std::string_view numbers;  ///< the first buffer of a binary file of version 2
};

/// The parts of a binary file; all of a text is JSON. BadGltf: it ends too early.
[[nodiscard]] GltfParts gltfParts(std::string_view file);

/// A number of the file's own, for messages: "accessor 3".
[[nodiscard]] std::string nthOfGltf(const char* what, std::size_t index);

/// Things of one kind: a list in version 2, named by their numbers; in version 1 they have names.
class GltfThings {
public:
    GltfThings(const QJsonObject& root, const char* key, const char* what);
    [[nodiscard]] std::size_t size() const { return m_things.size(); }
    [[nodiscard]] bool areNamed() const { return !m_names.isEmpty(); }
    [[nodiscard]] const QJsonObject& operator[](std::size_t index) const { return m_things[index]; }
    /// BadGltf: there is no such thing.
    [[nodiscard]] std::size_t find(const QJsonValue& reference) const;

private:
    const char* m_what;
    std::vector<QJsonObject> m_things;
    QHash<QString, std::size_t> m_names;
};

/// A whole number, not negative; `otherwise` where there is none. BadGltf: it is something else.
[[nodiscard]] std::uint64_t gltfNumber(const QJsonObject& object, const char* key,
                                       std::uint64_t otherwise = 0);

/// Of an accessor.
[[nodiscard]] std::uint64_t gltfComponentBytes(const QJsonObject& accessor);
/// Of an accessor: 3 for "VEC3". BadGltf: of an unknown type.
[[nodiscard]] std::uint64_t gltfComponentCount(const QJsonObject& accessor);

}  // namespace hitscope
