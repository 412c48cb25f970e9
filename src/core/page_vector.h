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
    /// `original` stays as it is.
    explicit PageCopy(const PageVector<T>& original)
        : m_size(original.size()), m_data(static_cast<T*>(pages::copyOf(original.data(), bytes()))) {
        if (m_data == nullptr) {
            m_own.assign(original.begin(), original.end());
            m_data = m_own.data();
        }
    }
    /// A copy of all, of values that change.
    explicit PageCopy(std::span<const T> values)
        : m_size(values.size()), m_own(values.begin(), values.end()), m_data(m_own.data()) {}
    ~PageCopy() {
        if (m_data != m_own.data()) {
            pages::dropCopy(m_data, bytes());
        }
    }
    PageCopy(PageCopy&& other) noexcept { swap(other); }
    PageCopy& operator=(PageCopy&& other) noexcept {
        PageCopy(std::move(other)).swap(*this);
        return *this;
    }

    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] T* data() { return m_data; }
    [[nodiscard]] std::span<T> all() { return {m_data, m_size}; }
    [[nodiscard]] std::span<const T> all() const { return {m_data, m_size}; }
    [[nodiscard]] T& operator[](std::size_t i) { return m_data[i]; }
    [[nodiscard]] const T& operator[](std::size_t i) const { return m_data[i]; }

private:
    [[nodiscard]] std::size_t bytes() const { return m_size * sizeof(T); }
    void swap(PageCopy& other) noexcept {
        std::swap(m_size, other.m_size);
        m_own.swap(other.m_own);
        std::swap(m_data, other.m_data);
    }

    std::size_t m_size = 0;
    std::vector<T> m_own;  ///< empty where memory is shared
    T* m_data = nullptr;
};

}  // namespace hitscope
