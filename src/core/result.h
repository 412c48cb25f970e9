// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace hitscope {

/// Why something could not be done, in words for the person at the screen.
struct Error {
    std::string
        what;  ///< what is wrong, one sentence without the place: "The file ends in the middle of face 12."
    std::string where;   ///< file, line or field it is about; may be empty
    std::string advice;  ///< what to do about it, one sentence; may be empty

    /// "WHERE: WHAT ADVICE", leaving out what is empty. One line; the form the command line prints.
    [[nodiscard]] std::string message() const;
};

/// A value or the reason there is none. Used across layers where other projects throw.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : m_state(std::in_place_index<1>, std::move(error)) {}

    [[nodiscard]] bool ok() const { return m_state.index() == 0; }
    explicit operator bool() const { return ok(); }

    /// The value; only when ok().
    [[nodiscard]] T& value() & { return std::get<0>(m_state); }
    [[nodiscard]] const T& value() const& { return std::get<0>(m_state); }
    [[nodiscard]] T&& value() && { return std::get<0>(std::move(m_state)); }
    /// The reason; only when not ok().
    [[nodiscard]] const Error& error() const { return std::get<1>(m_state); }

private:
    std::variant<T, Error> m_state;
};

/// For functions that either succeed or say why not.
struct Done {};
using Status = Result<Done>;

}  // namespace hitscope
