// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <ctime>
#include <memory>

#include "io/writers/obj_index.h"

namespace hitscope {

/// What tells that somebody wrote to a file, or put another in its place.
struct FileStamp {
    /// Of an open file; isKnown is false where the system does not say.
    explicit FileStamp(int descriptor);

    [[nodiscard]] bool operator==(const FileStamp& other) const;
    /// Whether a write from now on is certain to give another stamp: clocks of file systems tick, so that a
    /// write right after the last has the same time.
    [[nodiscard]] bool isSettled() const;

    bool isKnown = false;
    dev_t device = 0;
    ino_t number = 0;
    off_t size = -1;
    timespec modified{};
    timespec changed{};  ///< also when the time of modification is set by hand
};

/// indexObj() of files that were indexed lately and have not changed since, for all of the process: exports
/// of one file after the other read it once. Of any thread.
[[nodiscard]] std::shared_ptr<const ObjIndex> indexedObj(int descriptor, ObjFaces faces,
                                                         const std::function<bool(double)>& goOn);

}  // namespace hitscope
