// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace hitscope {

/// Numbers that are all 0 at first. Memory that the system gives is 0 already, and of a large array only the
/// pages that are written to are taken from it: to make one takes no time, however large it is.
template <class T>
class ZeroArray {
    static_assert(std::is_arithmetic_v<T>);

public:
    ZeroArray() = default;
    explicit ZeroArray(std::size_t size)
        : m_values(static_cast<T*>(std::calloc(size, sizeof(T)))), m_size(size) {
        if (size > 0 && !m_values) {
            throw std::bad_alloc();
        }
    }
    ZeroArray(ZeroArray&& other) noexcept
        : m_values(std::move(other.m_values)), m_size(std::exchange(other.m_size, 0)) {}
    ZeroArray& operator=(ZeroArray&& other) noexcept {
        m_values = std::move(other.m_values);
        m_size = std::exchange(other.m_size, 0);
        return *this;
    }

    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] bool empty() const { return m_size == 0; }
    [[nodiscard]] T& operator[](std::size_t i) { return m_values[i]; }
    [[nodiscard]] const T& operator[](std::size_t i) const { return m_values[i]; }
    [[nodiscard]] std::span<const T> all() const { return {m_values.get(), m_size}; }
    void clear() { *this = ZeroArray(m_size); }  ///< all 0 again

private:
    struct Free {
        void operator()(T* values) const { std::free(values); }
    };
    std::unique_ptr<T[], Free> m_values;
    std::size_t m_size = 0;
};

}  // namespace hitscope
