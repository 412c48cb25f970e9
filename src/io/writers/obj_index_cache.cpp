// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/obj_index_cache.h"

#include <sys/stat.h>

#include <algorithm>
#include <deque>
#include <mutex>
#include <utility>

namespace hitscope {
namespace {

constexpr std::size_t kMostKept = 16;

struct Entry {
    FileStamp stamp;
    ObjFaces faces;
    std::shared_ptr<const ObjIndex> index;
};

struct Kept {
    std::mutex mutex;
    std::deque<Entry> entries;  // the latest first
};

Kept& kept() {
    static Kept all;
    return all;
}

bool isEqual(const timespec& a, const timespec& b) {
    return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
}

std::shared_ptr<const ObjIndex> find(const FileStamp& stamp, ObjFaces faces) {
    const std::lock_guard lock(kept().mutex);
    for (const Entry& entry : kept().entries) {
        if (entry.faces == faces && entry.stamp == stamp) {
            return entry.index;
        }
    }
    return nullptr;
}

void keep(const FileStamp& stamp, ObjFaces faces, const std::shared_ptr<const ObjIndex>& index) {
    const std::lock_guard lock(kept().mutex);
    std::erase_if(kept().entries, [&](const Entry& entry) {
        return entry.faces == faces && entry.stamp.device == stamp.device &&
               entry.stamp.number == stamp.number;
    });
    kept().entries.push_front({stamp, faces, index});
    if (kept().entries.size() > kMostKept) {
        kept().entries.pop_back();
    }
}

}  // namespace

FileStamp::FileStamp(int descriptor) {
    struct stat info {};
    if (::fstat(descriptor, &info) == 0) {
        isKnown = true;
        device = info.st_dev;
        number = info.st_ino;
        size = info.st_size;
        modified = info.st_mtim;
        changed = info.st_ctim;
    }
}

bool FileStamp::operator==(const FileStamp& other) const {
    return isKnown && other.isKnown && device == other.device && number == other.number &&
           size == other.size && isEqual(modified, other.modified) && isEqual(changed, other.changed);
}

bool FileStamp::isSettled() const {
    constexpr time_t kTick = 2;  // seconds: of FAT, the coarsest there is
    timespec now{};
    ::clock_gettime(CLOCK_REALTIME, &now);
    return isKnown && now.tv_sec - std::max(changed.tv_sec, modified.tv_sec) > kTick;
}

std::shared_ptr<const ObjIndex> indexedObj(int descriptor, ObjFaces faces,
                                           const std::function<bool(double)>& goOn) {
    const FileStamp stamp(descriptor);
    if (std::shared_ptr<const ObjIndex> known = find(stamp, faces)) {
        return known;
    }
    const bool isSettled = stamp.isSettled();
    std::optional<ObjIndex> index = indexObj(descriptor, faces, goOn);
    if (!index) {
        return nullptr;
    }
    auto shared = std::make_shared<const ObjIndex>(std::move(*index));
    if (isSettled && FileStamp(descriptor) == stamp) {
        keep(stamp, faces, shared);
    }
    return shared;
}

}  // namespace hitscope
