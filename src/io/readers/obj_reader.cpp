// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/obj_reader.h"

#include <algorithm>
#include <atomic>
#include <unordered_map>
#include <utility>

#include "core/memory.h"
#include "core/parallel.h"
#include "io/readers/obj_parser.h"
#include "io/readers/tidy.h"

namespace hitscope {
namespace {

constexpr std::size_t kLeastPart = 4 << 20;  // bytes; shorter ones are read sooner than a thread is started

std::string_view withoutBlanks(std::string_view line) {
    while (!line.empty() && TextCursor::isBlank(line.back())) {
        line.remove_suffix(1);
    }
    return line;
}

/// Where a line starts, at `wanted` or soon after it, that does not continue the one before.
std::size_t lineStartAfter(std::string_view text, std::size_t wanted) {
    for (std::size_t end = text.find('\n', wanted); end != text.npos; end = text.find('\n', end + 1)) {
        const std::size_t before = end == 0 ? text.npos : text.rfind('\n', end - 1);
        const std::size_t start = before == text.npos ? 0 : before + 1;
        if (!withoutBlanks(text.substr(start, end - start)).ends_with('\\')) {
            return end + 1;
        }
    }
    return text.size();
}

/// Puts parts behind one another.
class ObjJoiner {
public:
    /// How many entries there will be of each is known: arrays that grow take twice the room.
    explicit ObjJoiner(const std::vector<ObjPart>& parts);

    void add(ObjPart part);
    Result<ImportedMesh> finish();

private:
    template <class T>
    static void append(std::vector<T>& to, std::vector<T>& from);
    void addFaces(ObjPart& part);
    void addVertices(ObjPart& part);
    void addMaterials(ObjPart& part);
    void addNotes();

    ImportedMesh m_imported;
    MeshData& m_mesh = m_imported.mesh;
    std::vector<glm::dvec3> m_positions;
    std::vector<glm::vec3> m_colours;
    std::unordered_map<std::string, std::uint32_t> m_materials;
    std::uint32_t m_material = kNoIndex;
    std::uint32_t m_smoothing = 0;
    bool m_anySmoothing = false;
    LargestIndex m_largest;
    std::size_t m_smallFaces = 0;
    std::size_t m_smallLines = 0;
    std::size_t m_freeForm = 0;
};

template <class T>
void ObjJoiner::append(std::vector<T>& to, std::vector<T>& from) {
    if (to.empty() && to.capacity() == 0) {
        to = std::move(from);
    } else {
        to.insert(to.end(), from.begin(), from.end());
    }
    freeAll(from);
}

ObjJoiner::ObjJoiner(const std::vector<ObjPart>& parts) {
    m_mesh.faceStarts.push_back(0);
    if (parts.size() == 1) {
        return;  // its arrays are taken as they are
    }
    const auto reserve = [&parts](auto& array, const auto& sizeOf) {
        std::size_t size = 0;
        for (const ObjPart& part : parts) {
            size += sizeOf(part);
        }
        array.reserve(size);
    };
    const auto corners = [](const ObjPart& part) { return part.mesh.cornerVertices.size(); };
    const auto faces = [](const ObjPart& part) { return part.faceCount(); };
    reserve(m_positions, [](const ObjPart& part) { return part.positions.size(); });
    reserve(m_mesh.normals, [](const ObjPart& part) { return part.mesh.normals.size(); });
    reserve(m_mesh.texcoords, [](const ObjPart& part) { return part.mesh.texcoords.size(); });
    reserve(m_mesh.cornerVertices, corners);
    reserve(m_mesh.cornerTexcoords, corners);
    reserve(m_mesh.cornerNormals, corners);
    reserve(m_mesh.faceStarts, [](const ObjPart& part) { return part.faceCount() + 1; });
    reserve(m_mesh.faceMaterials, faces);
    reserve(m_mesh.faceSmoothing, faces);
}

void ObjJoiner::addVertices(ObjPart& part) {
    const std::size_t before = m_positions.size();
    if (!part.colours.empty()) {
        m_colours.resize(before, glm::vec3(1.0f));
        append(m_colours, part.colours);
    }
    append(m_positions, part.positions);
    append(m_mesh.normals, part.mesh.normals);
    append(m_mesh.texcoords, part.mesh.texcoords);
}

void ObjJoiner::addMaterials(ObjPart& part) {
    std::vector<std::uint32_t> numbers;
    for (Material& material : part.mesh.materials) {
        const auto [known, isNew] =
            m_materials.try_emplace(material.name, static_cast<std::uint32_t>(m_mesh.materials.size()));
        if (isNew) {
            m_mesh.materials.push_back(std::move(material));
        }
        numbers.push_back(known->second);
    }
    std::vector<std::uint32_t>& faces = part.mesh.faceMaterials;
    const auto own = faces.begin() + static_cast<std::ptrdiff_t>(part.facesBeforeMaterial);
    std::fill(faces.begin(), own, m_material);
    const auto number = [&numbers](std::uint32_t local) {
        return local == kNoIndex ? kNoIndex : numbers[local];
    };
    std::transform(own, faces.end(), own, number);
    m_material = part.material ? number(*part.material) : m_material;
}

void ObjJoiner::addFaces(ObjPart& part) {
    MeshData& mesh = part.mesh;
    const auto corners = static_cast<std::uint32_t>(m_mesh.cornerVertices.size());
    const auto faces = static_cast<std::uint32_t>(m_mesh.faceStarts.size() - 1);
    for (std::size_t f = 1; f < mesh.faceStarts.size(); ++f) {
        m_mesh.faceStarts.push_back(corners + mesh.faceStarts[f]);
    }
    for (FaceGroup& group : mesh.groups) {
        group.firstFace += faces;
        m_mesh.groups.push_back(std::move(group));
    }
    std::fill_n(mesh.faceSmoothing.begin(), part.facesBeforeSmoothing, m_smoothing);
    m_smoothing = part.smoothing.value_or(m_smoothing);
    m_anySmoothing = m_anySmoothing || part.smoothing;
    append(m_mesh.cornerVertices, mesh.cornerVertices);
    append(m_mesh.cornerTexcoords, mesh.cornerTexcoords);
    append(m_mesh.cornerNormals, mesh.cornerNormals);
    append(m_mesh.faceMaterials, mesh.faceMaterials);
    append(m_mesh.faceSmoothing, mesh.faceSmoothing);
}

void ObjJoiner::add(ObjPart part) {
    addMaterials(part);
    addVertices(part);
    addFaces(part);
    append(m_mesh.points, part.mesh.points);
    std::move(part.mesh.lines.begin(), part.mesh.lines.end(), std::back_inserter(m_mesh.lines));
    std::move(part.mesh.materialLibraries.begin(), part.mesh.materialLibraries.end(),
              std::back_inserter(m_mesh.materialLibraries));
    if (part.largest.index > m_largest.index) {
        m_largest = part.largest;
    }
    m_smallFaces += part.smallFaces;
    m_smallLines += part.smallLines;
    m_freeForm += part.freeForm;
}

void ObjJoiner::addNotes() {
    if (m_smallFaces > 0) {
        m_imported.notes += counted(m_smallFaces, "face with fewer than three corners was left out.",
                                    "faces with fewer than three corners were left out.");
    }
    if (m_smallLines > 0) {
        m_imported.notes += counted(m_smallLines, "line with fewer than two vertices was left out.",
                                    "lines with fewer than two vertices were left out.");
    }
    if (m_freeForm > 0) {
        m_imported.notes += counted(m_freeForm, "free-form curve or surface was left out.",
                                    "free-form curves and surfaces were left out.");
    }
}

Result<ImportedMesh> ObjJoiner::finish() {
    if (m_largest.index > static_cast<long long>(m_positions.size())) {
        return ObjParser::errorAt("The face refers to vertex " + std::to_string(m_largest.index) +
                                      ", but the file has only " + std::to_string(m_positions.size()) + ".",
                                  m_largest.line);
    }
    if (Status set = setPositions(m_mesh, std::exchange(m_positions, {})); !set) {
        return set.error();
    }
    if (!m_anySmoothing) {
        m_mesh.faceSmoothing = {};
    }
    if (m_mesh.faceStarts.size() == 1) {
        m_mesh.faceStarts.clear();
    }
    if (!m_colours.empty()) {
        m_colours.resize(m_mesh.positions.size(), glm::vec3(1.0f));
        setColours(m_mesh, std::move(m_colours));
    }
    addNotes();
    tidy(m_imported);
    return std::move(m_imported);
}

/// Tells how far all parts are together, from the thread that made it alone.
class PartsProgress {
public:
    PartsProgress(std::size_t size, const ProgressSink& sink)
        : m_size(size), m_sink(sink), m_thread(std::this_thread::get_id()) {}

    void read(std::size_t bytes) {
        const std::size_t done = m_done += bytes;
        if (m_sink && std::this_thread::get_id() == m_thread) {
            m_sink(static_cast<double>(done) / static_cast<double>(m_size), "Reading OBJ");
        }
    }

private:
    std::size_t m_size;
    const ProgressSink& m_sink;
    std::thread::id m_thread;
    std::atomic<std::size_t> m_done = 0;
};

Result<ImportedMesh> join(std::vector<ObjPart> parts) {
    ObjJoiner joiner(parts);
    for (ObjPart& part : parts) {
        joiner.add(std::exchange(part, {}));
    }
    return joiner.finish();
}

/// In parts at once, as far as a part can be read without those before it; nothing where it cannot, or a line
/// is wrong.
std::optional<ImportedMesh> parseInParts(std::string_view text, std::size_t count, const ProgressSink& sink) {
    std::vector<std::size_t> starts{0};
    for (std::size_t part = 1; part < count; ++part) {
        starts.push_back(std::max(starts.back(), lineStartAfter(text, text.size() * part / count)));
    }
    starts.push_back(text.size());
    std::vector<ObjPart> parts(count);
    PartsProgress progress(text.size(), sink);
    const ObjParser::Told told = [&progress](std::size_t bytes) { progress.read(bytes); };
    forEachAtOnce(count, [&](std::size_t part) {
        const std::string_view piece = text.substr(starts[part], starts[part + 1] - starts[part]);
        parts[part] = ObjParser(piece, ObjParser::Whole::No, told).parse();
    });
    std::uint64_t corners = 0;
    for (const ObjPart& part : parts) {
        corners += part.mesh.cornerVertices.size();
        if (part.error || corners >= kNoIndex) {
            return std::nullopt;
        }
    }
    Result<ImportedMesh> joined = join(std::move(parts));
    return joined ? std::optional(std::move(joined).value()) : std::nullopt;
}

/// All lines end with a line feed, and a carriage return before it or not.
std::string withLineFeeds(std::string_view text) {
    std::string plain(text);
    for (std::size_t at = plain.find('\r'); at != plain.npos; at = plain.find('\r', at + 1)) {
        if (at + 1 == plain.size() || plain[at + 1] != '\n') {
            plain[at] = '\n';
        }
    }
    return plain;
}

/// Nothing where lines end in other ways, too.
std::optional<Result<ImportedMesh>> parseText(std::string_view text, std::size_t parts,
                                              const ProgressSink& sink) {
    if (parts > 1) {
        if (std::optional<ImportedMesh> mesh = parseInParts(text, parts, sink)) {
            return Result<ImportedMesh>(*std::move(mesh));
        }
    }
    PartsProgress progress(text.size(), sink);
    const ObjParser::Told told = [&progress](std::size_t bytes) { progress.read(bytes); };
    std::vector<ObjPart> whole;
    whole.push_back(ObjParser(text, ObjParser::Whole::Yes, told).parse());
    if (whole.front().hidesLine) {
        return std::nullopt;
    }
    if (whole.front().error) {
        return Result<ImportedMesh>(*whole.front().error);
    }
    return join(std::move(whole));
}

}  // namespace

Result<ImportedMesh> parseObj(std::string_view text, const ProgressSink& progress) {
    const std::size_t parts = std::clamp<std::size_t>(text.size() / kLeastPart, 1, usefulThreads());
    return parseObjInParts(text, parts, progress);
}

Result<ImportedMesh> parseObjInParts(std::string_view text, std::size_t parts, const ProgressSink& progress) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark)) {
        text.remove_prefix(kByteOrderMark.size());
    }
    const bool isOldMac = text.find('\n') == text.npos && text.find('\r') != text.npos;
    std::optional<Result<ImportedMesh>> mesh = isOldMac ? std::nullopt : parseText(text, parts, progress);
    return mesh ? *std::move(mesh) : *parseText(withLineFeeds(text), parts, progress);
}

}  // namespace hitscope
