// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace hitscope {

template <class T>
struct RawAllocator : std::allocator<T> {
    static_assert(std::is_trivially_destructible_v<T>);  // numbers, and vectors of them
    template <class U>
    struct rebind {
        using other = RawAllocator<U>;
    };
    template <class U>
    void construct(U* /*at*/) {}
    template <class U, class... Arguments>
    void construct(U* at, Arguments&&... arguments) {
        ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
    }
};

/// A vector whose values are undefined when it is made or grows, for large arrays that several threads fill
/// at once: each takes the pages it writes to from the system, instead of one thread all of them.
template <class T>
using RawVector = std::vector<T, RawAllocator<T>>;

}  // namespace hitscope
