// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <new>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace hitscope {

namespace pages {

/// Memory that copyOf() can share; null where it is small, or the system has none: see PageAllocator.
[[nodiscard]] void* allocate(std::size_t bytes);
/// Whether allocate() gave it; if so it is given back.
[[nodiscard]] bool deallocate(void* memory, std::size_t bytes) noexcept;
/// Memory of one's own with the content of what allocate() gave, which does not change any more. The system
/// copies a page (4 KiB) when it is first written to. Null where allocate() did not give it, or the system
/// has no room.
[[nodiscard]] void* copyOf(const void* memory, std::size_t bytes);
void dropCopy(void* memory, std::size_t bytes) noexcept;

}  // namespace pages

/// Takes large arrays from the system as files in memory, of which there can be copies that share what is not
/// changed (PageCopy), and others from operator new.
template <class T>
struct PageAllocator {
    using value_type = T;
    PageAllocator() = default;
    template <class U>
    PageAllocator(const PageAllocator<U>& /*other*/) {}  // NOLINT(google-explicit-constructor)

    [[nodiscard]] T* allocate(std::size_t count) {
        void* const memory = pages::allocate(count * sizeof(T));
        return static_cast<T*>(memory != nullptr ? memory : ::operator new(count * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t count) noexcept {
        if (!pages::deallocate(memory, count * sizeof(T))) {
            ::operator delete(memory);
        }
    }
    bool operator==(const PageAllocator& /*other*/) const { return true; }
};

template <class T>
using PageVector = std::vector<T, PageAllocator<T>>;

/// A copy of an array that takes memory only for what is changed of it, if the array is large: the first
/// change of a mesh of millions of vertices would otherwise wait for the copy of all of it.
template <class T>
class PageCopy {
    static_assert(std::is_trivially_destructible_v<T>);

public:
    PageCopy() = default;
    /// `original` outlives this and stays as it is.
    explicit PageCopy(const PageVector<T>& original) : m_size(original.size()) {
        m_shared = static_cast<T*>(pages::copyOf(original.data(), original.size() * sizeof(T)));
        if (m_shared == nullptr) {
            m_own.assign(original.begin(), original.end());
        }
    }
    ~PageCopy() {
        if (m_shared != nullptr) {
            pages::dropCopy(m_shared, m_size * sizeof(T));
        }
    }
    PageCopy(PageCopy&& other) noexcept { swap(other); }
    PageCopy& operator=(PageCopy&& other) noexcept {
        PageCopy(std::move(other)).swap(*this);
        return *this;
    }

    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] T* data() { return m_shared != nullptr ? m_shared : m_own.data(); }
    [[nodiscard]] std::span<T> all() { return {data(), m_size}; }
    [[nodiscard]] std::span<const T> all() const {
        return {m_shared != nullptr ? m_shared : m_own.data(), m_size};
    }
    [[nodiscard]] T& operator[](std::size_t i) { return data()[i]; }
    [[nodiscard]] const T& operator[](std::size_t i) const { return all()[i]; }

private:
    void swap(PageCopy& other) noexcept {
        std::swap(m_shared, other.m_shared);
        std::swap(m_size, other.m_size);
        m_own.swap(other.m_own);
    }

    T* m_shared = nullptr;  ///< null: m_own has it
    std::size_t m_size = 0;
    std::vector<T> m_own;
};

}  // namespace hitscope
