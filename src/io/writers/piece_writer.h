// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "io/staged_files.h"
#include "io/writers/mesh_export.h"

namespace hitscope {

/// Takes a file's content in pieces of any size, and asks now and then whether to go on.
class PieceWriter {
public:
    PieceWriter(int descriptor, const std::function<bool(double)>& goOn)
        : m_descriptor(descriptor), m_goOn(goOn) {}

    /// What is to be written next; to be appended to.
    [[nodiscard]] std::string& text() { return m_text; }
    void put(std::string_view piece) { m_text += piece; }
    /// As it lies in memory: little endian.
    template <class Plain>
    void plain(const Plain& value) {
        static_assert(std::endian::native == std::endian::little && std::is_standard_layout_v<Plain>);
        m_text.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    /// To be asked before each vertex or face, `done` of `all`; false: stop, nothing more is needed.
    [[nodiscard]] bool goesOn(std::uint64_t done, std::uint64_t all);
    /// The same for who has no such number: asks each time.
    [[nodiscard]] bool asks(double share);
    /// Gives the file up for that reason.
    void fail(Error error);

    /// Writes what is left; whether all of it has been written.
    [[nodiscard]] bool finish();
    [[nodiscard]] bool isGivenUp() const { return m_isGivenUp; }
    [[nodiscard]] const std::optional<Error>& error() const { return m_error; }

private:
    void flush();

    int m_descriptor;
    const std::function<bool(double)>& m_goOn;
    std::string m_text;
    std::uint64_t m_written = 0;  ///< bytes
    std::uint64_t m_started = 0;  ///< bytes of them that are on their way to the disk
    bool m_isGood = true;
    bool m_isGivenUp = false;
    std::optional<Error> m_error;
};

/// Whether the lengths of all spans fit the mesh.
[[nodiscard]] Status checkLengths(const MeshExport& what);

/// Adds a file whose content `make` puts to `staged`; its errors, and that it was given up.
[[nodiscard]] Status stageInPieces(const MeshExport& what, const QString& path, StagedFiles& staged,
                                   StagedFiles::Existing existing,
                                   const std::function<void(PieceWriter&)>& make);

/// One file alone: whole or not at all.
[[nodiscard]] Status writeInPieces(const MeshExport& what, const QString& path,
                                   const std::function<void(PieceWriter&)>& make);

[[nodiscard]] Error noMemoryFor(const QString& path);
[[nodiscard]] Error cancelledAt(const QString& path);

}  // namespace hitscope
