// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/gltf_document.h"

namespace hitscope {
namespace {

constexpr std::uint64_t kAlignment = 4;

std::uint64_t padding(std::uint64_t size) {
    return (kAlignment - size % kAlignment) % kAlignment;
}

}  // namespace

int GltfDocument::addView(std::size_t count, std::size_t bytes, int target, PutElement put) {
    const std::uint64_t size = std::uint64_t{count} * bytes;
    QJsonObject view{{QStringLiteral("buffer"), 0},
                     {QStringLiteral("byteOffset"), static_cast<qint64>(m_size)},
                     {QStringLiteral("byteLength"), static_cast<qint64>(size)}};
    if (target != gltf::kNeither) {
        view[QStringLiteral("target")] = target;
    }
    m_views.append(view);
    m_content.push_back({count, bytes, std::move(put)});
    m_size += size + padding(size);
    m_elements += count;
    return static_cast<int>(m_views.size() - 1);
}

int GltfDocument::addAccessor(int view, int component, const char* type, std::size_t count,
                              QJsonObject more) {
    if (view >= 0) {
        more[QStringLiteral("bufferView")] = view;
    }
    more[QStringLiteral("componentType")] = component;
    more[QStringLiteral("type")] = QString::fromLatin1(type);
    more[QStringLiteral("count")] = static_cast<qint64>(count);
    m_accessors.append(more);
    return static_cast<int>(m_accessors.size() - 1);
}

void GltfDocument::write(PieceWriter& out) const {
    std::uint64_t done = 0;
    for (const View& view : m_content) {
        for (std::size_t i = 0; i < view.count && out.goesOn(done, m_elements); ++i, ++done) {
            view.put(out, i);
        }
        out.text().append(padding(std::uint64_t{view.count} * view.bytes), '\0');
    }
}

}  // namespace hitscope
