// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/ply_copy.h"

#include <QFileInfo>
#include <algorithm>

#include "core/give_up.h"
#include "io/readers/ply_values.h"
#include "io/readers/text_cursor.h"
#include "io/writers/normal_plan.h"

namespace hitscope {
namespace {

/// The source is not what the mesh was read from.
struct Differs {};

bool isIndexList(const PlyProperty& property) {
    return property.isList && (property.name == "vertex_indices" || property.name == "vertex_index");
}

}  // namespace

PlyCopy::PlyCopy(const MeshExport& what, const PlyOptions& options)
    : m_what(what), m_mesh(what.inFile()), m_options(options), m_positions(what), m_file(what.sourcePath) {}

void PlyCopy::differs(const QString& how) {
    m_whyNot = how;
    throw Differs{};
}

void PlyCopy::look(std::uint64_t done) {
    constexpr std::uint64_t kBetween = 8192;
    if (m_what.goOn && done % kBetween == 0 && !m_what.goOn(ExportStep::Reading, shareOf(done))) {
        m_isGivenUp = true;
        throw Differs{};
    }
}

bool PlyCopy::check() {
    try {
        if (!readHeader()) {
            return false;
        }
        findSlots();
        if (m_isTooCoarse) {
            return false;
        }
        findTurned();
        PlyPieces pieces(m_file, m_header.encoding, static_cast<qint64>(m_header.size));
        for (const PlyElement& element : m_header.elements) {
            if (&element == m_vertices) {
                walkVertices(pieces, nullptr);
            } else {
                m_hasStrips = m_hasStrips || (element.name == "tristrips" && element.count > 0);
                const std::optional<PlyEdgeEnds> ends = plyEdgeEnds(element);
                element.name == "face" ? walkFaces(pieces, element, nullptr)
                : ends                 ? walkEdges(pieces, element, *ends)
                                       : walkOthers(pieces, element, nullptr);
            }
            m_before += element.count;
        }
        if (!m_hasStrips && m_face != m_mesh.faceCount()) {
            differs(QStringLiteral("it has other faces"));
        }
        if (m_line != m_mesh.lines.size()) {
            differs(QStringLiteral("it has other edges"));
        }
        return true;
    } catch (const PlyDataEnd&) {
        m_whyNot = QStringLiteral("it is no longer whole");
    } catch (const Differs&) {
    }
    return false;
}

void PlyCopy::write(PieceWriter& out) {
    m_face = 0;
    m_before = 0;
    out.put(newHeader());
    try {
        PlyPieces pieces(m_file, m_header.encoding, static_cast<qint64>(m_header.size));
        bool isRest = false;
        for (const PlyElement& element : m_header.elements) {
            if (isRest && !m_isOther) {
                break;
            }
            if (&element == m_vertices) {
                walkVertices(pieces, &out);
                isRest = true;
            } else {
                walkOthers(pieces, element, &out);
            }
            m_before += element.count;
        }
        if (!m_isOther) {
            putRest(pieces, out);
        }
    } catch (const PlyDataEnd&) {
        m_whyNot = QStringLiteral("it is no longer whole");
    } catch (const Differs&) {
    }
    if (!m_whyNot.isEmpty()) {
        out.fail(
            {"The mesh's file changed while it was read.", m_what.sourcePath.toStdString(), "Export again."});
    }
}

/// The bytes behind the vertices.
void PlyCopy::putRest(PlyPieces& pieces, PieceWriter& out) const {
    const double from = shareOf(0);
    const double all = std::max(1.0, static_cast<double>(pieces.bytesLeft()));
    std::string_view rest;
    do {
        rest = pieces.nextRest();
        out.put(rest);
    } while (!rest.empty() && out.asks(1.0 - (1.0 - from) * static_cast<double>(pieces.bytesLeft()) / all));
}

/// Hands a value on, written anew in another encoding.
double PlyCopy::pass(PlyPieces& pieces, PlyType type, PieceWriter* out) {
    const PlyPiece piece = pieces.next(type);
    if (out && m_isOther) {
        m_values.append(out->text(), type, piece.value);
    } else if (out) {
        out->put(piece.raw);
    }
    return piece.value;
}

void PlyCopy::passList(PlyPieces& pieces, const PlyProperty& property, PieceWriter* out) {
    const double length = property.isList ? pass(pieces, property.countType, out) : 1.0;
    if (!(length >= 0.0 && length <= static_cast<double>(pieces.bytesLeft()))) {
        differs(QStringLiteral("it is no longer whole"));
    }
    for (double i = 0.0; i < length; ++i) {
        pass(pieces, property.type, out);
    }
}

void PlyCopy::endRecord(PieceWriter* out) {
    if (out && m_isOther) {
        m_values.endRecord(out->text());
    }
}

void PlyCopy::walkOthers(PlyPieces& pieces, const PlyElement& element, PieceWriter* out) {
    for (std::uint64_t e = 0; e < element.count && !element.properties.empty(); ++e) {
        for (const PlyProperty& property : element.properties) {
            passList(pieces, property, out);
        }
        endRecord(out);
        if (out && !out->goesOn(m_before + e, m_all)) {
            throw Differs{};
        }
        look(out ? 1 : e);
    }
}

/// Faces with fewer than three corners are none of the mesh's.
void PlyCopy::walkFace(PlyPieces& pieces, const PlyElement& element, PieceWriter* out) {
    for (const PlyProperty& property : element.properties) {
        if (!isIndexList(property)) {
            passList(pieces, property, out);
            continue;
        }
        const double corners = pieces.next(property.countType).value;
        const bool isFace = corners >= 3.0;
        if (isFace &&
            (m_face >= m_mesh.faceCount() || corners != static_cast<double>(m_mesh.face(m_face).size()))) {
            differs(QStringLiteral("it has other faces"));
        }
        for (double c = 0.0; c < corners; ++c) {
            const double vertex = pieces.next(property.type).value;
            if (isFace && vertex != static_cast<double>(m_mesh.face(m_face)[static_cast<std::size_t>(c)])) {
                differs(QStringLiteral("it has other faces"));
            }
        }
        m_face += isFace ? 1 : 0;
    }
}

void PlyCopy::walkFaces(PlyPieces& pieces, const PlyElement& element, PieceWriter* out) {
    if (m_hasStrips) {
        return walkOthers(pieces, element, out);
    }
    for (std::uint64_t f = 0; f < element.count; ++f) {
        walkFace(pieces, element, out);
        look(f);
    }
}

/// It only looks.
void PlyCopy::walkEdges(PlyPieces& pieces, const PlyElement& element, const PlyEdgeEnds& ends) {
    for (std::uint64_t e = 0; e < element.count; ++e, ++m_line) {
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            if (p != ends.first && p != ends.second) {
                passList(pieces, property, nullptr);
                continue;
            }
            const double vertex = pieces.next(property.type).value;
            if (m_line >= m_mesh.lines.size() ||
                vertex != static_cast<double>(m_mesh.lines[m_line][p == ends.first ? 0 : 1])) {
                differs(QStringLiteral("it has other edges"));
            }
        }
        look(e);
    }
}

/// In text, the blanks stay.
void PlyCopy::replace(PlyType type, double value, std::string_view raw, PieceWriter& out) const {
    if (!m_values.isAscii() || m_isOther) {
        m_values.append(out.text(), type, value);
        return;
    }
    const std::size_t blanks = std::min(raw.find_first_not_of(" \t\r\n\f\v"), raw.size());
    out.put(raw.substr(0, blanks));
    std::string text;
    m_values.append(text, type, value);
    out.put(text);
}

void PlyCopy::vertexValue(std::size_t v, int slot, const PlyPiece& piece, PlyType type, PieceWriter* out) {
    double value = piece.value;
    bool isNew = false;
    const auto turned = m_turned.find(static_cast<std::uint32_t>(v));
    for (int i = 0; i < 3; ++i) {
        if (slot == m_slots.position[i]) {
            m_read[i] = piece.value;
            isNew = m_what.asRead || m_positions.isMoved(v);
            value = isNew ? m_positions.now(v)[i] : value;
            isNew = isNew && !(m_what.asRead && isInFile(m_mesh, v, m_what.positions[v], i));
            m_isRounded = m_isRounded || (isNew && isWhole(type));
        } else if (slot == m_slots.normal[i] && turned != m_turned.end()) {
            isNew = true;
            value = static_cast<double>(turned->second[i]);
        }
    }
    if (out && isNew) {
        replace(type, value, piece.raw, *out);
    } else if (out && m_isOther) {
        m_values.append(out->text(), type, value);
    } else if (out) {
        out->put(piece.raw);
    }
}

void PlyCopy::walkVertices(PlyPieces& pieces, PieceWriter* out) {
    const std::vector<PlyProperty>& properties = m_vertices->properties;
    for (std::size_t v = 0; v < m_mesh.positions.size(); ++v) {
        for (std::size_t p = 0; p < properties.size(); ++p) {
            if (properties[p].isList) {
                passList(pieces, properties[p], out);
            } else {
                const PlyPiece piece = pieces.next(properties[p].type);
                vertexValue(v, static_cast<int>(p), piece, properties[p].type, out);
            }
        }
        const bool isSame = m_mesh.filePositions.empty() ? glm::dvec3(m_mesh.positions[v]) == m_read
                                                         : m_mesh.filePositions[v] == m_read;
        if (!isSame) {
            differs(QStringLiteral("vertex %1 is somewhere else").arg(v + 1));
        }
        if (out) {
            m_added->append(out->text(), m_values, v);
        }
        endRecord(out);
        if (out && !out->goesOn(m_before + v, m_all)) {
            throw Differs{};
        }
        look(out ? 1 : v);
    }
}

QStringList PlyCopy::notes() const {
    QStringList notes;
    if (m_added->isRenamed()) {
        QStringList names;
        for (const PlyProperty& property : m_added->properties()) {
            names += QString::fromStdString(property.name);
        }
        notes += QStringLiteral("The file has properties of these names already; the new ones are called %1.")
                     .arg(names.join(QStringLiteral(", ")));
    }
    if (m_isRounded) {
        notes += QStringLiteral(
            "The file has whole numbers for coordinates; those of vertices that moved "
            "are rounded.");
    }
    return notes;
}

}  // namespace hitscope
