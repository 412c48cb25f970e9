// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string_view>

#include "io/writers/obj_index.h"
#include "io/writers/obj_patcher.h"

namespace hitscope {

/// Writes the copy of an OBJ file in which some parts are rewritten: parts are rewritten at once on all
/// processors and written in turn, while the disk has what was written before.
class SourceWriter {
public:
    /// goOn: as in ObjExport. All of it outlives the writer.
    SourceWriter(const ObjIndex& index, ObjPatcher& patcher, int source,
                 const std::function<bool(double)>& goOn)
        : m_index(index), m_patcher(patcher), m_source(source), m_goOn(goOn) {}

    /// Writes all of it to an empty file; false with errno where it fails. Once. What does not need the plan
    /// of the normals is written before that is there.
    bool write(int to);
    /// The plan of the normals is there. Of any thread, once.
    void takeNormals(NormalPlan normals);
    /// Ends the writing with an errno. Of any thread.
    void fail(int reason);
    [[nodiscard]] bool couldNotRead() const { return m_couldNotRead; }

private:
    /// A piece of a part that is rewritten, or parts before one that are copied, and how many turns come
    /// before it.
    struct Turn {
        std::size_t part = 0;
        std::size_t piece = 0;
        bool isCopied = false;
        bool isLast = false;  ///< of its part
        std::size_t number = 0;
    };
    void work(bool isTelling);
    std::optional<Turn> take(bool isTelling);
    template <class Condition>
    bool waitUntil(const Condition& condition, bool isTelling);
    bool copyUntil(std::uint64_t end, bool isTelling);
    bool put(std::string_view text);
    void wrote(std::uint64_t bytes);
    bool tell(bool isTelling);

    const ObjIndex& m_index;
    ObjPatcher& m_patcher;
    int m_source;
    const std::function<bool(double)>& m_goOn;
    int m_to = -1;

    std::mutex m_mutex;
    std::condition_variable m_ended;  // a turn, or all
    std::size_t m_nextPart = 0;
    std::size_t m_nextPiece = 0;  // of it
    std::size_t m_givenPart = 0;  // before which turns that were taken copy or rewrite all
    bool m_hasNormals = false;
    std::size_t m_taken = 0;  // turns
    std::size_t m_turn = 0;   // that may write now
    int m_reason = 0;         // errno; 0: all is well

    // Of whoever's turn it is:
    std::uint64_t m_done = 0;     // bytes of the source
    std::uint64_t m_written = 0;  // bytes
    std::uint64_t m_started = 0;  // bytes of them that are on their way to the disk
    std::atomic<double> m_share = 0.0;
    std::atomic<bool> m_couldNotRead = false;
};

}  // namespace hitscope
