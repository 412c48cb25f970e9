// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QJsonObject>
#include <functional>
#include <vector>

#include "io/writers/piece_writer.h"

namespace hitscope {

/// Numbers that glTF 2.0 gives its types (section 5.1).
namespace gltf {
inline constexpr int kUint16 = 5123;
inline constexpr int kUint32 = 5125;
inline constexpr int kFloat = 5126;
inline constexpr int kVertices = 34962;
inline constexpr int kIndices = 34963;
inline constexpr int kNeither = 0;  ///< a view of neither vertices nor indices
}  // namespace gltf

/// Buffer views and accessors of a glTF file with one buffer, whose bytes are made when they are written.
class GltfDocument {
public:
    /// Puts the bytes of element i.
    using PutElement = std::function<void(PieceWriter& out, std::size_t i)>;

    /// Gives the view's index. bytes > 0, of one element; views begin at multiples of 4.
    int addView(std::size_t count, std::size_t bytes, int target, PutElement put);
    /// Gives the accessor's index. `more`: min, max, sparse.
    int addAccessor(int view, int component, const char* type, std::size_t count, QJsonObject more = {});

    [[nodiscard]] std::uint64_t size() const { return m_size; }  ///< of the buffer, a multiple of 4
    [[nodiscard]] const QJsonArray& views() const { return m_views; }
    [[nodiscard]] const QJsonArray& accessors() const { return m_accessors; }
    void write(PieceWriter& out) const;

private:
    struct View {
        std::size_t count;
        std::size_t bytes;
        PutElement put;
    };
    std::vector<View> m_content;
    QJsonArray m_views;
    QJsonArray m_accessors;
    std::uint64_t m_size = 0;
    std::uint64_t m_elements = 0;
};

[[nodiscard]] inline QJsonArray jsonOf(const glm::vec3& vector) {
    return {static_cast<double>(vector.x), static_cast<double>(vector.y), static_cast<double>(vector.z)};
}

}  // namespace hitscope
