// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/ply_reader.h"

#include <unordered_map>

#include "io/readers/ply_indices.h"
#include "io/readers/ply_values.h"
#include "io/readers/text_cursor.h"
#include "io/readers/tidy.h"

namespace hitscope {
namespace {

/// What a vertex property fills; each has a place in VertexReader's row of numbers.
enum VertexSlot { X, Y, Z, Nx, Ny, Nz, S, T, Red, Green, Blue, SlotCount };

int vertexSlot(const std::string& name) {
    static const std::unordered_map<std::string, int> slots{
        {"x", X},         {"y", Y},
        {"z", Z},         {"nx", Nx},
        {"ny", Ny},       {"nz", Nz},
        {"s", S},         {"t", T},
        {"u", S},         {"v", T},
        {"texture_u", S}, {"texture_v", T},
        {"red", Red},     {"green", Green},
        {"blue", Blue},   {"diffuse_red", Red},
        {"r", Red},       {"diffuse_green", Green},
        {"g", Green},     {"diffuse_blue", Blue},
        {"b", Blue},
    };
    const auto found = slots.find(name);
    return found == slots.end() ? -1 : found->second;
}

struct BadElement : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Reads the elements' data from a source of numbers (PlyAsciiSource or PlyBinarySource).
template <class Source>
class PlyParser {
public:
    PlyParser(const PlyHeader& header, Source source, const ProgressSink& progress)
        : m_header(header), m_source(source), m_progress(progress), m_dataSize(source.bytesLeft()) {}

    Result<ImportedMesh> parse();

private:
    void readElement(const PlyElement& element);
    void readVertices(const PlyElement& element);
    void readFaces(const PlyElement& element, bool strips);
    void readEdges(const PlyElement& element, const PlyEdgeEnds& ends);
    void skipElement(const PlyElement& element);
    void skipProperty(const PlyProperty& property);
    std::uint64_t listLength(const PlyProperty& property);
    std::uint32_t index(double value) const;
    void readPolygon(const PlyProperty& property);
    void readStrips(const PlyProperty& property);
    void addStripTriangle(std::span<const std::uint32_t> strip);
    void readFaceTexcoords(const PlyProperty& property);
    void finishVertexAttributes();
    void addTextures();
    void report();

    const PlyHeader& m_header;
    Source m_source;
    const ProgressSink& m_progress;
    std::uint64_t m_dataSize;
    ImportedMesh m_imported;
    MeshData& m_mesh = m_imported.mesh;
    std::vector<glm::dvec3> m_positions;
    std::vector<glm::vec3> m_colours;
    std::vector<std::array<float, 2>> m_pendingTexcoords;  ///< of the face being read, one a corner
    std::size_t m_smallFaces = 0;
    const char* m_elementName = "";
    std::uint64_t m_element = 0;  ///< the one being read, from 1
    bool m_vertexNormals = false;
    bool m_vertexTexcoords = false;
    bool m_faceTexcoords = false;
};

template <class Source>
void PlyParser<Source>::report() {
    constexpr std::uint64_t kEvery = 1 << 16;
    if (m_progress && m_element % kEvery == 0) {
        m_progress(1.0 - static_cast<double>(m_source.bytesLeft()) / static_cast<double>(m_dataSize + 1),
                   "Reading PLY");
    }
}

template <class Source>
std::uint64_t PlyParser<Source>::listLength(const PlyProperty& property) {
    const double length = m_source.value(property.countType);
    if (!(length >= 0.0)) {
        throw BadElement("A list has a negative length");
    }
    if (length != std::floor(length)) {
        throw BadElement("The length of a list is no whole number");
    }
    if (length > static_cast<double>(m_source.room(property.type))) {
        throw PlyDataEnd("The file ends");
    }
    return static_cast<std::uint64_t>(length);
}

template <class Source>
void PlyParser<Source>::skipProperty(const PlyProperty& property) {
    m_source.skip(property.type, property.isList ? listLength(property) : 1);
}

template <class Source>
void PlyParser<Source>::skipElement(const PlyElement& element) {
    if (element.properties.empty()) {
        return;  // takes no room, however many there are
    }
    for (m_element = 1; m_element <= element.count; ++m_element) {
        for (const PlyProperty& property : element.properties) {
            skipProperty(property);
        }
        report();
    }
}

float fullColour(PlyType type) {
    return type == PlyType::Uint8 ? 255.0f : type == PlyType::Uint16 ? 65535.0f : 1.0f;
}

template <class Source>
void PlyParser<Source>::readVertices(const PlyElement& element) {
    std::vector<int> slots;
    std::array<bool, SlotCount> has{};
    float full = 1.0f;
    for (const PlyProperty& property : element.properties) {
        const int slot = property.isList ? -1 : vertexSlot(property.name);
        slots.push_back(slot);
        if (slot >= 0) {
            has[static_cast<std::size_t>(slot)] = true;
        }
        full = slot == Red ? fullColour(property.type) : full;
    }
    if (!has[X] || !has[Y] || !has[Z]) {
        throw BadElement("The vertices have no x, y and z");
    }
    m_vertexNormals = has[Nx] && has[Ny] && has[Nz];
    m_vertexTexcoords = has[S] && has[T];
    const bool colours = has[Red] && has[Green] && has[Blue];
    m_positions.reserve(element.count);
    std::array<double, SlotCount> row{};
    for (m_element = 1; m_element <= element.count; ++m_element) {
        for (std::size_t p = 0; p < slots.size(); ++p) {
            if (slots[p] < 0) {
                skipProperty(element.properties[p]);
            } else {
                row[static_cast<std::size_t>(slots[p])] = m_source.value(element.properties[p].type);
            }
        }
        m_positions.emplace_back(row[X], row[Y], row[Z]);
        if (m_vertexNormals) {
            m_mesh.normals.emplace_back(row[Nx], row[Ny], row[Nz]);
        }
        if (m_vertexTexcoords) {
            m_mesh.texcoords.emplace_back(row[S], row[T]);
        }
        if (colours) {
            m_colours.push_back(glm::vec3(row[Red], row[Green], row[Blue]) / full);
        }
        report();
    }
}

template <class Source>
std::uint32_t PlyParser<Source>::index(double value) const {
    if (!(value >= 0.0 && value < static_cast<double>(kNoIndex)) || value != std::floor(value)) {
        throw BadElement("It refers to a vertex that cannot be");
    }
    return static_cast<std::uint32_t>(value);
}

template <class Source>
void PlyParser<Source>::readPolygon(const PlyProperty& property) {
    const std::uint64_t corners = listLength(property);
    if (corners + m_mesh.cornerVertices.size() >= kNoIndex) {
        throw BadElement("The mesh has more face corners than Hitscope can count");
    }
    if (corners < 3) {
        m_source.skip(property.type, corners);
        ++m_smallFaces;
        return;
    }
    for (std::uint64_t c = 0; c < corners; ++c) {
        m_mesh.cornerVertices.push_back(index(m_source.value(property.type)));
    }
    m_mesh.faceStarts.push_back(static_cast<std::uint32_t>(m_mesh.cornerVertices.size()));
}

/// Every other triangle of a strip winds the other way; one that repeats a vertex only joins two strips.
template <class Source>
void PlyParser<Source>::addStripTriangle(std::span<const std::uint32_t> strip) {
    if (strip.size() < 3) {
        return;
    }
    const std::span<const std::uint32_t> last = strip.last(3);
    if (last[0] == last[1] || last[1] == last[2] || last[0] == last[2]) {
        return;
    }
    const bool odd = strip.size() % 2 == 0;
    m_mesh.cornerVertices.push_back(odd ? last[1] : last[0]);
    m_mesh.cornerVertices.push_back(odd ? last[0] : last[1]);
    m_mesh.cornerVertices.push_back(last[2]);
    m_mesh.faceStarts.push_back(static_cast<std::uint32_t>(m_mesh.cornerVertices.size()));
}

template <class Source>
void PlyParser<Source>::readStrips(const PlyProperty& property) {
    const std::uint64_t length = listLength(property);
    std::vector<std::uint32_t> strip;
    for (std::uint64_t i = 0; i < length; ++i) {
        const double value = m_source.value(property.type);
        const bool restart = value < 0.0 || value == static_cast<double>(kNoIndex);  // -1, also as unsigned
        if (restart) {
            strip.clear();
        } else {
            strip.push_back(index(value));
            addStripTriangle(strip);
        }
        if (m_mesh.cornerVertices.size() >= kNoIndex - 3) {
            throw BadElement("The mesh has more face corners than Hitscope can count");
        }
    }
}

template <class Source>
void PlyParser<Source>::readFaceTexcoords(const PlyProperty& property) {
    const std::uint64_t length = listLength(property);
    m_pendingTexcoords.clear();
    for (std::uint64_t i = 0; i < length / 2; ++i) {
        const double u = m_source.value(property.type);
        const double v = m_source.value(property.type);
        m_pendingTexcoords.push_back({static_cast<float>(u), static_cast<float>(v)});
    }
    m_source.skip(property.type, length % 2);
}

template <class Source>
void PlyParser<Source>::readFaces(const PlyElement& element, bool strips) {
    bool hasIndices = false;
    for (const PlyProperty& property : element.properties) {
        hasIndices = hasIndices || property.name == "vertex_indices" || property.name == "vertex_index";
        m_faceTexcoords = m_faceTexcoords || (!strips && property.isList && property.name == "texcoord");
    }
    if (!hasIndices) {
        throw BadElement("There is no vertex_indices list");
    }
    m_mesh.faceStarts.reserve(strips ? 1 : element.count + 1);
    for (m_element = 1; m_element <= element.count; ++m_element) {
        const std::size_t first = m_mesh.cornerVertices.size();
        m_pendingTexcoords.clear();
        for (const PlyProperty& property : element.properties) {
            if (property.isList && (property.name == "vertex_indices" || property.name == "vertex_index")) {
                strips ? readStrips(property) : readPolygon(property);
            } else if (property.isList && property.name == "texcoord" && !strips) {
                readFaceTexcoords(property);
            } else {
                skipProperty(property);
            }
        }
        const std::size_t corners = m_mesh.cornerVertices.size() - first;
        for (std::size_t c = 0; m_faceTexcoords && c < corners; ++c) {
            const bool there = m_pendingTexcoords.size() == corners;
            m_mesh.cornerTexcoords.resize(first + c, kNoIndex);
            m_mesh.cornerTexcoords.push_back(there ? static_cast<std::uint32_t>(m_mesh.texcoords.size())
                                                   : kNoIndex);
            if (there) {
                m_mesh.texcoords.emplace_back(m_pendingTexcoords[c][0], m_pendingTexcoords[c][1]);
            }
        }
        report();
    }
}

template <class Source>
void PlyParser<Source>::readEdges(const PlyElement& element, const PlyEdgeEnds& ends) {
    for (m_element = 1; m_element <= element.count; ++m_element) {
        std::vector<std::uint32_t> line(2);
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            if (p == ends.first || p == ends.second) {
                line[p == ends.first ? 0 : 1] = index(m_source.value(property.type));
            } else {
                skipProperty(property);
            }
        }
        m_mesh.lines.push_back(std::move(line));
        report();
    }
}

template <class Source>
void PlyParser<Source>::readElement(const PlyElement& element) {
    m_elementName = element.name.c_str();
    m_element = 0;
    if (element.name == "vertex" && m_positions.empty()) {
        readVertices(element);
    } else if ((element.name == "face" || element.name == "tristrips") && element.count > 0) {
        readFaces(element, element.name == "tristrips");
    } else if (const std::optional<PlyEdgeEnds> ends = plyEdgeEnds(element)) {
        readEdges(element, *ends);
    } else {
        skipElement(element);
    }
}

template <class Source>
void PlyParser<Source>::finishVertexAttributes() {
    if (m_vertexNormals) {
        m_mesh.cornerNormals = m_mesh.cornerVertices;
    }
    if (m_faceTexcoords) {
        m_mesh.cornerTexcoords.resize(m_mesh.cornerVertices.size(), kNoIndex);
    } else if (m_vertexTexcoords) {
        m_mesh.cornerTexcoords = m_mesh.cornerVertices;
    }
    if (!m_colours.empty()) {
        setColours(m_mesh, std::move(m_colours));
    }
}

/// Which face has which texture is not standard; with one, all have it.
template <class Source>
void PlyParser<Source>::addTextures() {
    if (m_header.textures.size() == 1) {
        Material& material = m_mesh.materials.emplace_back();
        material.name = "texture";
        material.diffuse = glm::vec3(1.0f);
        material.diffuseTexture = m_header.textures.front();
        m_mesh.faceMaterials.assign(m_mesh.faceCount(), 0);
    } else if (m_header.textures.size() > 1) {
        m_imported.notes += QStringLiteral("The file names several textures; they are not shown.");
    }
}

template <class Source>
Result<ImportedMesh> PlyParser<Source>::parse() {
    m_mesh.faceStarts.push_back(0);
    try {
        for (const PlyElement& element : m_header.elements) {
            readElement(element);
        }
    } catch (const PlyDataEnd& end) {
        return Error{std::string(end.what()) + " in the middle of the data.",
                     std::string(m_elementName) + " " + std::to_string(m_element), kCutAdvice};
    } catch (const BadElement& bad) {
        return Error{std::string(bad.what()) + ".",
                     std::string(m_elementName) + " " + std::to_string(m_element),
                     "Write the file again with the program it came from."};
    }
    if (m_mesh.faceStarts.size() == 1) {
        m_mesh.faceStarts.clear();
    }
    if (Status good = checkPlyIndices(m_mesh, m_positions.size()); !good) {
        return good.error();
    }
    if (Status set = setPositions(m_mesh, std::move(m_positions)); !set) {
        return set.error();
    }
    finishVertexAttributes();
    addTextures();
    if (m_smallFaces > 0) {
        m_imported.notes += counted(m_smallFaces, "face with fewer than three corners was left out.",
                                    "faces with fewer than three corners were left out.");
    }
    if (holdsMore(m_source.rest())) {
        m_imported.notes +=
            QStringLiteral("The file goes on after what its header names; the rest was not read.");
    }
    tidy(m_imported);
    return std::move(m_imported);
}

}  // namespace

Result<ImportedMesh> parsePly(std::string_view file, const ProgressSink& progress) {
    const Result<PlyHeader> header = parsePlyHeader(file);
    if (!header) {
        return header.error();
    }
    const std::string_view data = file.substr(header.value().size);
    if (header.value().encoding == PlyEncoding::Ascii) {
        return PlyParser(header.value(), PlyAsciiSource(data), progress).parse();
    }
    const bool fileIsLittle = header.value().encoding == PlyEncoding::LittleEndian;
    const bool swapped = fileIsLittle != (std::endian::native == std::endian::little);
    return PlyParser(header.value(), PlyBinarySource(data, swapped), progress).parse();
}

}  // namespace hitscope
