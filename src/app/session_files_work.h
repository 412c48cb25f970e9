// SPDX-License-Identifier: GPL-3.0-or-later
// For session_files.cpp alone.
#pragma once

#include <atomic>
#include <functional>
#include <utility>
#include <vector>

#include "app/session_files.h"
#include "core/give_up.h"
#include "document/session_file.h"

namespace hitscope {

/// What is being written or read. The other thread holds on to it too; whoever finds that it is no longer
/// SessionFiles' current work drops it.
struct SessionFiles::Work {
    QString path;     ///< empty: of no file
    FileStamp stamp;  ///< of the file before it was read, or after it was written
    SessionDocument document;
    bool isRead = false;  ///< document is what the file says
    bool isRecovered = false;
    bool isSave = false;
    std::uint64_t scene = 0;                 ///< SessionUndo::scene() that is written
    std::uint64_t sceneAfter = 0;            ///< that is to be written there after it; 0: none
    std::uint64_t state = 0;                 ///< SessionUndo::state() that is written, or is to be replaced
    std::function<void(Ended)> ended = {};   ///< openDocument()'s
    QString noteInPart;                      ///< likewise
    std::vector<CopiedPositions> positions;  ///< that are written
    bool isGivenUp = false;                  ///< what is saved; by the other thread, last
    MeshPlaces places;
    std::atomic<bool> cancelled = false;
    Status status = Done{};
    PreparedSession prepared;

    /// On the other thread. Given up, the file is as it was: only what comes before its renaming asks.
    void write() {
        const std::function<bool()> isWanted = [this] { return !cancelled; };
        const GiveUpScope watched(isWanted);
        try {
            document.positions = fingerprintsOf(positions);
            positions = {};
            status = writeSessionFile(std::move(document), path);
            stamp = stampOf(path);
        } catch (const GivenUp&) {
            isGivenUp = true;
        }
    }

    /// On the other thread.
    void prepare(const std::function<void(double, const QString&)>& report) {
        if (!isRead) {
            stamp = stampOf(path);
            Result<SessionDocument> read = readSessionFile(path);
            if (!read) {
                status = read.error();
                return;
            }
            document = std::move(read.value());
            isRead = true;
        }
        Result<PreparedSession> made = prepareSession(document, places, {report, &cancelled});
        if (made) {
            prepared = std::move(made.value());
        } else {
            status = made.error();
        }
    }
};

}  // namespace hitscope
