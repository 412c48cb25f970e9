// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/source_obj.h"

#include <fcntl.h>

#include <QFile>
#include <cerrno>
#include <memory>
#include <utility>

#include "core/parallel.h"
#include "io/descriptor.h"
#include "io/writers/obj_index_cache.h"
#include "io/writers/obj_patcher.h"

namespace hitscope {
namespace {

constexpr double kIndexShare = 0.4;  // of the progress

Error givenUp(const QString& path) {
    return {"The export was cancelled.", path.toStdString(), "The file is as it was."};
}

bool fits(const ObjIndex& index, const MeshData& mesh) {
    std::size_t vertices = 0;
    std::size_t normals = 0;
    std::size_t faces = 0;
    std::size_t libraries = 0;
    for (const SourcePart& part : index.parts) {
        vertices += part.vertices;
        normals += part.normals;
        faces += part.faces;
        libraries += part.libraries;
    }
    return index.hash == mesh.sourceHash && vertices == mesh.positions.size() &&
           normals == mesh.normals.size() && faces == mesh.faceCount() &&
           libraries == mesh.materialLibraries.size();
}

class SourceWriter {
public:
    SourceWriter(const ObjExport& what, const ObjIndex& index, const ObjPatcher& patcher, int source)
        : m_what(what), m_index(index), m_patcher(patcher), m_source(source) {}

    /// Writes all of it; false with errno where it fails.
    bool write(int to);
    [[nodiscard]] bool couldNotRead() const { return m_couldNotRead; }

private:
    static constexpr std::size_t kBuffer = 4 << 20;  // bytes

    bool flush(int to) {
        const bool good = writeAll(to, m_out.data(), m_out.size());
        m_out.clear();
        return good;
    }
    bool copyUntil(std::uint64_t end, int to) {
        const std::uint64_t start = m_done;
        m_done = end;
        return start == end || (flush(to) && copyRange(m_source, start, end - start, to));
    }
    bool rewrite(const std::vector<std::size_t>& parts, int to);

    const ObjExport& m_what;
    const ObjIndex& m_index;
    const ObjPatcher& m_patcher;
    int m_source;
    std::string m_out;
    std::uint64_t m_done = 0;  // bytes of the source
    bool m_couldNotRead = false;
};

/// The parts at once, and then in their order.
bool SourceWriter::rewrite(const std::vector<std::size_t>& parts, int to) {
    std::vector<std::string> texts(parts.size());
    std::vector<std::uint8_t> isRead(parts.size());
    inParts(parts.size(), 1, [&](std::size_t first, std::size_t end) {
        std::string own;
        for (std::size_t i = first; i < end; ++i) {
            const SourcePart& part = m_index.parts[parts[i]];
            own.resize(part.size);
            isRead[i] = readAt(m_source, part.start, own.data(), own.size()) ? 1 : 0;
            if (isRead[i] != 0) {
                m_patcher.rewrite(parts[i], own, texts[i]);
            }
        }
    });
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const SourcePart& part = m_index.parts[parts[i]];
        m_couldNotRead = m_couldNotRead || isRead[i] == 0;
        if (m_couldNotRead || !copyUntil(part.start, to)) {
            return false;
        }
        m_out += texts[i];
        m_done = part.start + part.size;
        if (m_out.size() >= kBuffer && !flush(to)) {
            return false;
        }
    }
    return true;
}

bool SourceWriter::write(int to) {
    const std::size_t atOnce = 2 * usefulThreads();
    std::vector<std::size_t> waiting;
    for (std::size_t p = 0; p < m_index.parts.size(); ++p) {
        if (m_patcher.changes(p)) {
            waiting.push_back(p);
        }
        const bool isLast = p + 1 == m_index.parts.size();
        if ((waiting.size() >= atOnce || isLast) && !rewrite(std::exchange(waiting, {}), to)) {
            return false;
        }
        const double share = static_cast<double>(p + 1) / static_cast<double>(m_index.parts.size());
        if (m_what.goOn && !m_what.goOn(kIndexShare + (1.0 - kIndexShare) * share)) {
            errno = ECANCELED;
            return false;
        }
    }
    return copyUntil(m_index.size, to) && flush(to);
}

}  // namespace

Result<SourceCopy> copyWithChanges(const ObjExport& what, const QString& path, MaterialFiles& materials,
                                   StagedFiles& staged) {
    bool isGivenUp = false;
    const auto goOn = [&what, &isGivenUp](double share) {
        isGivenUp = isGivenUp || (what.goOn && !what.goOn(share));
        return !isGivenUp;
    };
    // Not blocking: a pipe that took the file's place must not hold us for ever.
    const Descriptor source(
        ::open(QFile::encodeName(what.sourcePath).constData(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (!source.isOpen()) {
        return SourceCopy::NotThere;
    }
    const FileStamp before(source.get());
    const auto within = [&goOn](double share) { return goOn(kIndexShare * share); };
    ObjFaces faces = ObjFaces::AllLines;
    std::shared_ptr<const ObjIndex> index = indexedObj(source.get(), faces, within);
    if (index && index->hash == what.mesh->sourceHash && !fits(*index, *what.mesh)) {
        faces = ObjFaces::OfThreeCorners;  // the reader left some out
        index = indexedObj(source.get(), faces, within);
    }
    if (isGivenUp) {
        return givenUp(path);
    }
    if (!index || !fits(*index, *what.mesh)) {
        return index ? SourceCopy::Changed : SourceCopy::NotThere;
    }
    const Result<std::map<std::size_t, std::string>> libraries = materials.placeLibraryLines();
    if (!libraries) {
        return libraries.error();
    }
    const NormalPlan normals = planNormals(*what.mesh, what.positions, what.normals, what.allNormals);
    const ObjChanges changes{*what.mesh, what.positions, normals, libraries.value()};
    const ObjPatcher patcher(changes, *index, faces);
    ObjExport watched = what;
    watched.goOn = goOn;
    SourceWriter writer(watched, *index, patcher, source.get());
    const Status added = staged.add(path, [&writer](int to) { return writer.write(to); });
    if (isGivenUp) {
        return givenUp(path);
    }
    if (writer.couldNotRead() || !(FileStamp(source.get()) == before)) {
        return SourceCopy::Changed;  // while it was copied
    }
    return added ? Result<SourceCopy>(SourceCopy::Written) : Result<SourceCopy>(added.error());
}

}  // namespace hitscope
