// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

namespace hitscope {

/// Thrown out of long work that nobody wants any more, as std::bad_alloc out of work that memory ends. Who
/// makes a GiveUpScope catches it.
struct GivenUp {};

/// While it lives, long work on this thread asks whether somebody still wants it. Not copied; the latest of
/// a thread counts.
class GiveUpScope {
public:
    /// Who may ask: this thread, or also those that help it (parallel.h).
    enum class Asked : std::uint8_t { Here, Anywhere };

    /// goOn: false ends the work; called often. Outlives the scope.
    explicit GiveUpScope(const std::function<bool()>& goOn, Asked asked = Asked::Here)
        : m_goOn(&goOn), m_asked(asked), m_outer(std::exchange(s_latest, this)) {}
    /// On a thread that helps: of the thread that it helps, as forHelpers() gives it.
    explicit GiveUpScope(const GiveUpScope* helped)
        : m_goOn(helped != nullptr ? helped->m_goOn : nullptr),
          m_asked(Asked::Anywhere),
          m_outer(std::exchange(s_latest, this)) {}
    ~GiveUpScope() { s_latest = m_outer; }
    GiveUpScope(const GiveUpScope&) = delete;
    GiveUpScope& operator=(const GiveUpScope&) = delete;

    /// Whether the work of this thread is to end; false where nobody can end it.
    [[nodiscard]] static bool isGivenUp() {
        return s_latest != nullptr && s_latest->m_goOn != nullptr && *s_latest->m_goOn &&
               !(*s_latest->m_goOn)();
    }
    /// This thread's, if others may ask it.
    [[nodiscard]] static const GiveUpScope* forHelpers() {
        return s_latest != nullptr && s_latest->m_asked == Asked::Anywhere ? s_latest : nullptr;
    }

private:
    const std::function<bool()>* m_goOn;
    Asked m_asked;
    GiveUpScope* m_outer;
    static inline thread_local GiveUpScope* s_latest = nullptr;
};

/// To be called in the middle of long work; throws GivenUp where the work is to end.
inline void mayGiveUp() {
    if (GiveUpScope::isGivenUp()) {
        throw GivenUp{};
    }
}

inline constexpr std::size_t kStepsBetweenLooks = 65536;  ///< vertices, faces or corners

/// The same, to be called before each of many small steps: asks now and then.
inline void mayGiveUp(std::size_t step, std::size_t between = kStepsBetweenLooks) {
    if (step % between == 0) {
        mayGiveUp();
    }
}

/// As std::sort(), with looks in between: pieces first, which are then merged.
template <class Iterator, class Less = std::less<>>
void sortWatched(Iterator begin, Iterator end, const Less& less = {}) {
    constexpr std::ptrdiff_t kPiece = 1 << 18;
    const std::ptrdiff_t count = end - begin;
    for (std::ptrdiff_t first = 0; first < count; first += kPiece) {
        mayGiveUp();
        std::sort(begin + first, begin + std::min(first + kPiece, count), less);
    }
    for (std::ptrdiff_t sorted = kPiece; sorted < count; sorted *= 2) {
        for (std::ptrdiff_t first = 0; first + sorted < count; first += 2 * sorted) {
            mayGiveUp();
            std::inplace_merge(begin + first, begin + first + sorted,
                               begin + std::min(first + 2 * sorted, count), less);
        }
    }
}

}  // namespace hitscope
