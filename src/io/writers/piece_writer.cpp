// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/piece_writer.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>

#include "io/descriptor.h"

namespace hitscope {
namespace {

constexpr std::size_t kPiece = 1 << 20;           // bytes written at once
constexpr std::uint64_t kDiskPiece = 8 << 20;     // bytes that the disk begins to write
constexpr std::uint64_t kElementsBetween = 8192;  // questions whether to go on

}  // namespace

void PieceWriter::flush() {
    std::string_view left = m_text;
    while (m_isGood && !left.empty()) {
        const ssize_t written = ::write(m_descriptor, left.data(), left.size());
        m_isGood = written >= 0 || errno == EINTR;
        left.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
    m_written += m_text.size() - left.size();
    if (m_written - m_started >= kDiskPiece) {
        startToWrite(m_descriptor, m_started, m_written - m_started);
        m_started = m_written;
    }
    m_text.clear();
}

bool PieceWriter::goesOn(std::uint64_t done, std::uint64_t all) {
    if (done % kElementsBetween == 0) {
        return asks(all == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(all));
    }
    if (m_text.size() >= kPiece) {
        flush();
    }
    return m_isGood && !m_isGivenUp && !m_error;
}

bool PieceWriter::asks(double share) {
    if (m_text.size() >= kPiece) {
        flush();
    }
    if (m_goOn && !m_isGivenUp) {
        m_isGivenUp = !m_goOn(share);
    }
    return m_isGood && !m_isGivenUp && !m_error;
}

void PieceWriter::fail(Error error) {
    if (!m_error) {
        m_error = std::move(error);
    }
}

bool PieceWriter::finish() {
    const bool goesOnToEnd = goesOn(0, 0);
    flush();
    return m_isGood && goesOnToEnd;
}

Error noMemoryFor(const QString& path) {
    return {"There is not enough memory to write the mesh.", path.toStdString(), "Close other programs."};
}

Error cancelledAt(const QString& path) {
    return {"The export was cancelled.", path.toStdString(), "The file is as it was."};
}

Status checkLengths(const MeshExport& what) {
    const bool fits = what.mesh && what.positions.size() == what.mesh->positions.size() &&
                      (what.normals.empty() || what.normals.size() == what.mesh->cornerVertices.size()) &&
                      (what.hits.empty() || what.hits.size() == what.mesh->positions.size());
    const auto isThere = [&what](const MovedVertex& moved) { return moved.vertex < what.positions.size(); };
    const bool stepsFit =
        fits && std::all_of(what.steps.begin(), what.steps.end(), [&isThere](const MorphStep& step) {
            return std::all_of(step.moved.begin(), step.moved.end(), isThere);
        });
    return stepsFit
               ? Status(Done{})
               : Status(Error{"The deformed mesh and its original do not have the same vertices.", {}, {}});
}

Status stageInPieces(const MeshExport& what, const QString& path, StagedFiles& staged,
                     StagedFiles::Existing existing, const std::function<void(PieceWriter&)>& make) {
    bool isGivenUp = false;
    std::optional<Error> error;
    const auto write = [&](int descriptor) {
        const std::function<bool(double)> goOn = within(what.goOn, ExportStep::Writing);
        PieceWriter writer(descriptor, goOn);
        make(writer);
        const bool isWritten = writer.finish();
        isGivenUp = writer.isGivenUp();
        error = writer.error();
        return isWritten;
    };
    const Status added = staged.add(path, write, existing);
    if (isGivenUp) {
        return cancelledAt(path);
    }
    return error ? Status(*error) : added;
}

Status writeInPieces(const MeshExport& what, const QString& path,
                     const std::function<void(PieceWriter&)>& make) {
    try {
        StagedFiles staged(what.beforeStep);
        if (Status added = stageInPieces(what, path, staged, StagedFiles::Existing::Replace, make); !added) {
            return added;
        }
        return staged.commit();
    } catch (const std::bad_alloc&) {
        return noMemoryFor(path);
    }
}

}  // namespace hitscope
