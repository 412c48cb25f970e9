// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "io/writers/file_positions.h"
#include "io/writers/piece_writer.h"
#include "io/writers/ply_added.h"
#include "io/writers/ply_pieces.h"

namespace hitscope {

/// Writes the PLY file that a mesh came from once more, with what hits changed.
class PlyCopy {
public:
    /// Both outlive this.
    PlyCopy(const MeshExport& what, const PlyOptions& options);

    /// Reads the source and holds it against the mesh. False: it is no longer the same, and whyNot() says in
    /// what; or the export was given up.
    [[nodiscard]] bool check();
    [[nodiscard]] const QString& whyNot() const { return m_whyNot; }
    /// check() failed since its coordinates are whole numbers, and the mesh is elsewhere now, in metres.
    [[nodiscard]] bool isTooCoarse() const { return m_isTooCoarse; }
    [[nodiscard]] bool isGivenUp() const { return m_isGivenUp; }
    /// The texture is called so in the copy. Empty: as in the source.
    void setTexture(std::string name) { m_texture = std::move(name); }
    /// After check().
    void write(PieceWriter& out);
    [[nodiscard]] QStringList notes() const;

private:
    /// What the places of a vertex's record mean.
    struct Slots {
        int position[3] = {-1, -1, -1};  ///< properties x, y, z
        int normal[3] = {-1, -1, -1};
    };
    bool readHeader();
    void findSlots();
    void findTurned();
    [[nodiscard]] std::string newHeader() const;
    // With `out` null they only look.
    void walkVertices(PlyPieces& pieces, PieceWriter* out);
    void walkFaces(PlyPieces& pieces, const PlyElement& element, PieceWriter* out);
    void walkEdges(PlyPieces& pieces, const PlyElement& element, const PlyEdgeEnds& ends);
    void walkOthers(PlyPieces& pieces, const PlyElement& element, PieceWriter* out);
    void walkFace(PlyPieces& pieces, const PlyElement& element, PieceWriter* out);
    double pass(PlyPieces& pieces, PlyType type, PieceWriter* out);
    void passList(PlyPieces& pieces, const PlyProperty& property, PieceWriter* out);
    void replace(PlyType type, double value, std::string_view raw, PieceWriter& out) const;
    void vertexValue(std::size_t v, int slot, const PlyPiece& piece, PlyType type, PieceWriter* out);
    void endRecord(PieceWriter* out);
    void putRest(PlyPieces& pieces, PieceWriter& out) const;
    void look(std::uint64_t done);
    /// done: records of the element at hand.
    [[nodiscard]] double shareOf(std::uint64_t done) const {
        return static_cast<double>(m_before + done) / static_cast<double>(m_all > 0 ? m_all : 1);
    }
    void differs(const QString& how);

    const MeshExport& m_what;
    const MeshData& m_mesh;  ///< as it was read
    const PlyOptions& m_options;
    FilePositions m_positions;
    QFile m_file;
    PlyHeader m_header;
    std::string m_headerText;
    std::string m_texture;
    const PlyElement* m_vertices = nullptr;
    std::uint64_t m_before = 0;  ///< records of the elements before the one at hand
    std::uint64_t m_all = 0;     ///< records of all elements
    Slots m_slots;
    std::unordered_map<std::uint32_t, glm::vec3> m_turned;  ///< normals that are no longer the file's
    PlyValues m_values{PlyEncoding::LittleEndian};
    bool m_isOther = false;
    std::optional<PlyAdded> m_added;
    glm::dvec3 m_read{0.0};  ///< of the vertex being read
    std::size_t m_face = 0;  ///< the next one of the mesh
    std::size_t m_line = 0;  ///< likewise
    bool m_hasStrips = false;
    bool m_isRounded = false;
    bool m_isTooCoarse = false;
    QString m_whyNot;
    bool m_isGivenUp = false;
};

}  // namespace hitscope
