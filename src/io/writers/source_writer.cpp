// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/source_writer.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <string>
#include <utility>

#include "core/parallel.h"
#include "io/descriptor.h"

namespace hitscope {
namespace {

constexpr std::uint64_t kPiece = 8 << 20;          // bytes that are copied before somebody may give up
constexpr std::chrono::milliseconds kBetween{20};  // questions whether to go on

}  // namespace

void SourceWriter::takeNormals(NormalPlan normals) {
    {
        const std::lock_guard lock(m_mutex);
        m_patcher.setNormals(std::move(normals));
        m_hasNormals = true;
    }
    m_ended.notify_all();
}

std::optional<SourceWriter::Turn> SourceWriter::take(bool isTelling) {
    do {
        const std::lock_guard lock(m_mutex);
        const std::size_t parts = m_index.parts.size();
        const auto isKnown = [&] { return m_hasNormals || !m_patcher.needsNormals(m_nextPart); };
        while (m_nextPiece == 0 && m_nextPart < parts && isKnown() && !m_patcher.changes(m_nextPart)) {
            ++m_nextPart;
        }
        if (m_nextPart == parts || m_reason != 0) {
            return std::nullopt;
        }
        if (isKnown()) {
            Turn turn{m_nextPart, m_nextPiece++, false, false, m_taken++};
            turn.isLast = m_nextPiece == m_patcher.pieces(turn.part);
            if (turn.isLast) {
                m_givenPart = ++m_nextPart;
                m_nextPiece = 0;
            }
            return turn;
        }
        if (m_nextPart > m_givenPart) {
            m_givenPart = m_nextPart;
            return Turn{m_nextPart, 0, true, false, m_taken++};
        }
    } while (waitUntil([this] { return m_hasNormals; }, isTelling));
    return std::nullopt;
}

void SourceWriter::fail(int reason) {
    {
        const std::lock_guard lock(m_mutex);
        m_reason = m_reason == 0 ? reason : m_reason;
    }
    m_ended.notify_all();
}

bool SourceWriter::tell(bool isTelling) {
    if (isTelling && m_goOn && !m_goOn(m_share)) {
        fail(ECANCELED);
    }
    const std::lock_guard lock(m_mutex);
    return m_reason == 0;
}

/// False: there is nothing to be written any more. The condition is asked under the lock.
template <class Condition>
bool SourceWriter::waitUntil(const Condition& condition, bool isTelling) {
    for (;;) {
        {
            std::unique_lock lock(m_mutex);
            m_ended.wait_for(lock, kBetween, [&] { return condition() || m_reason != 0; });
            if (condition() || m_reason != 0) {
                return m_reason == 0;
            }
        }
        if (!tell(isTelling)) {
            return false;
        }
    }
}

void SourceWriter::wrote(std::uint64_t bytes) {
    m_written += bytes;
    if (m_written - m_started >= kPiece) {
        startToWrite(m_to, m_started, m_written - m_started);
        m_started = m_written;
    }
}

bool SourceWriter::copyUntil(std::uint64_t end, bool isTelling) {
    while (m_done < end) {
        const std::uint64_t size = std::min(end - m_done, kPiece);
        if (!copyRange(m_source, m_done, size, m_to)) {
            fail(errno);
            return false;
        }
        m_done += size;
        m_share = static_cast<double>(m_done) / static_cast<double>(m_index.size);
        wrote(size);
        if (!tell(isTelling)) {
            return false;
        }
    }
    return true;
}

bool SourceWriter::put(std::string_view text) {
    if (!writeAll(m_to, text.data(), text.size())) {
        fail(errno);
        return false;
    }
    wrote(text.size());
    return true;
}

/// isTelling: on the thread that asks whether to go on.
void SourceWriter::work(bool isTelling) {
    std::string before;
    TextBuffer after;
    while (const std::optional<Turn> turn = take(isTelling)) {
        const SourcePart& part = m_index.parts[turn->part];
        after.clear();
        if (!turn->isCopied) {
            before.resize(part.size + ObjPatcher::kPadding);
            const bool isOfText = turn->piece == 0 || turn->isLast;  // the others are added
            if (isOfText && !readAt(m_source, part.start, before.data(), part.size)) {
                m_couldNotRead = true;
                return fail(errno);
            }
            m_patcher.rewrite(turn->part, turn->piece, std::string_view(before).substr(0, part.size), after);
        }
        const auto isOurTurn = [&] { return m_turn == turn->number; };
        if (!waitUntil(isOurTurn, isTelling) || !copyUntil(part.start, isTelling) || !put(after.text())) {
            return;
        }
        m_done = turn->isLast ? part.start + part.size : part.start;
        m_share = static_cast<double>(m_done) / static_cast<double>(m_index.size);
        {
            const std::lock_guard lock(m_mutex);
            ++m_turn;
        }
        m_ended.notify_all();
        if (!tell(isTelling)) {
            return;
        }
    }
}

bool SourceWriter::write(int to) {
    m_to = to;
    const std::size_t threads = std::clamp<std::size_t>(m_index.parts.size(), 1, usefulThreads());
    forEachAtOnce(threads, [this](std::size_t thread) {
        try {
            work(thread == 0);  // on this thread
        } catch (...) {
            fail(ENOMEM);  // the others do not wait for this one's turn
            throw;
        }
    });
    if (m_reason != 0 || !copyUntil(m_index.size, true)) {
        errno = m_reason;
        return false;
    }
    return true;
}

}  // namespace hitscope
