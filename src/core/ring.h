// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hitscope {

/// The last `capacity` values of a stream. Takes all its memory when it is made.
template <class Value>
class Ring {
public:
    explicit Ring(std::size_t capacity) : m_values(std::max<std::size_t>(capacity, 1)) {}

    /// The oldest goes where there is no room.
    void push(const Value& value) {
        m_values[(m_first + m_size) % m_values.size()] = value;
        if (m_size < m_values.size()) {
            ++m_size;
        } else {
            m_first = (m_first + 1) % m_values.size();
        }
    }
    void clear() { m_first = m_size = 0; }

    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] bool empty() const { return m_size == 0; }
    [[nodiscard]] std::size_t capacity() const { return m_values.size(); }
    /// 0: the oldest; index < size().
    [[nodiscard]] const Value& operator[](std::size_t index) const {
        return m_values[(m_first + index) % m_values.size()];
    }
    [[nodiscard]] Value& operator[](std::size_t index) {
        return m_values[(m_first + index) % m_values.size()];
    }
    [[nodiscard]] const Value& back() const { return (*this)[m_size - 1]; }  ///< of one that is not empty
    [[nodiscard]] Value& back() { return (*this)[m_size - 1]; }

private:
    std::vector<Value> m_values;
    std::size_t m_first = 0;
    std::size_t m_size = 0;
};

}  // namespace hitscope
