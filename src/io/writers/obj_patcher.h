// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/text_buffer.h"
#include "io/writers/normal_plan.h"
#include "io/writers/obj_index.h"
#include "io/writers/obj_lines.h"
#include "mesh/mesh_data.h"

namespace hitscope {

/// What an OBJ file's text is to say instead. All of it outlives the patcher.
struct ObjChanges {
    const MeshData& mesh;                  ///< as it was read from the file
    std::span<const glm::vec3> positions;  ///< one for each of mesh.positions
    std::span<const std::uint8_t> moved;   ///< 1: the vertex has a coordinate that changes; else 0
    /// What mtllib lines name instead, by their number from 0.
    const std::map<std::size_t, std::string>& libraries;
    bool isElsewhere = false;  ///< the positions are what is written, no longer in the mesh's frame
};

/// Rewrites parts of an OBJ file: the words that change, and nothing else.
class ObjPatcher {
public:
    ObjPatcher(const ObjChanges& changes, const ObjIndex& index, ObjFaces faces);

    /// What becomes of the normals. Until then only parts that do not need it may be asked about.
    void setNormals(NormalPlan normals) { m_normals = std::move(normals); }
    [[nodiscard]] bool needsNormals(std::size_t p) const;

    /// Whether part `p` of the index has something that changes.
    [[nodiscard]] bool changes(std::size_t p) const;
    /// Bytes behind a part's text that may be read.
    static constexpr std::size_t kPadding = 8;
    /// In how many pieces it is rewritten, 1 at least: added normals, of which there may be millions, are
    /// some.
    [[nodiscard]] std::size_t pieces(std::size_t p) const;
    /// Appends a piece of the part's new text to `out`. `text`: the part's bytes in the file, and kPadding of
    /// any behind, which only the first and the last piece need. Of any thread.
    void rewrite(std::size_t p, std::size_t piece, std::string_view text, TextBuffer& out) const;

private:
    /// How many of each come before a part, or a line; and how many of NormalPlan::replaced.
    struct Counts {
        std::size_t vertices = 0;
        std::size_t normals = 0;
        std::size_t faces = 0;
        std::size_t libraries = 0;
        std::size_t replaced = 0;
    };
    class Part;
    void rewriteLine(const TextRange& line, Counts& at, Part& part) const;
    void vertex(std::string_view line, std::size_t vertex, TextBuffer& out) const;
    void normal(std::string_view line, const glm::vec3& value, TextBuffer& out) const;
    void face(std::string_view line, std::size_t face, TextBuffer& out) const;
    [[nodiscard]] bool plainFace(std::string_view line, std::size_t face, TextBuffer& out) const;
    void library(std::string_view line, const std::string& name, TextBuffer& out) const;
    [[nodiscard]] bool canAddIn(std::size_t p) const;
    [[nodiscard]] bool addsIn(std::size_t p) const;
    [[nodiscard]] bool changesNormals(std::size_t p) const;
    [[nodiscard]] const NormalPlan& normalsOf(std::size_t p) const;
    void rewriteLines(std::size_t p, std::string_view text, std::size_t from, std::size_t to,
                      TextBuffer& out) const;
    void appendAdded(std::size_t piece, TextBuffer& out) const;

    const ObjChanges& m_changes;
    const ObjIndex& m_index;
    ObjFaces m_faces;
    NormalPlan m_normals;
    std::vector<Counts> m_before;  // one a part, and the totals behind
    std::uint64_t m_addAt = 0;     // byte in the file before which the added normals come
};

}  // namespace hitscope
