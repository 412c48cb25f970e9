// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "core/result.h"

namespace hitscope::cli {

// What the program ends with: exitStatuses() has the words.
inline constexpr int kGood = 0;
inline constexpr int kDiffers = 1;      ///< what was compared differs, or a promise was not kept
inline constexpr int kWrongUsage = 2;   ///< of the command line
inline constexpr int kBadInput = 3;     ///< a file cannot be read or written, or holds what it must not
inline constexpr int kCannotDraw = 4;   ///< no OpenGL, a pipeline that does not run here, no ffmpeg
inline constexpr int kSignalled = 128;  ///< and the signal's number: it was ended, or nobody read on

/// How a verb went: good, or an error with the status that the program ends with.
class [[nodiscard]] Outcome {
public:
    Outcome(Done /*done*/) {}
    Outcome(Error error, int status = kBadInput) : m_error(std::move(error)), m_status(status) {}
    /// Of what reads or writes files.
    Outcome(const Status& status) {
        if (!status) {
            *this = Outcome(status.error());
        }
    }

    explicit operator bool() const { return !m_error; }
    [[nodiscard]] const Error& error() const { return *m_error; }  ///< only where there is one
    [[nodiscard]] int status() const { return m_status; }

private:
    std::optional<Error> m_error;
    int m_status = kGood;
};
[[nodiscard]] inline Outcome differs(Error error) {
    return {std::move(error), kDiffers};
}
[[nodiscard]] inline Outcome cannotDraw(Error error) {
    return {std::move(error), kCannotDraw};
}

/// Says on the standard error what is wrong with the arguments; returns kWrongUsage. `verb` names whose help
/// has more; empty: the program's.
int wrongUsage(const QString& text, const QString& verb = {});
/// The exit status; an error goes to the standard error.
int finish(const Outcome& outcome);
/// "1 hit", "12 hits".
[[nodiscard]] QString counted(std::size_t count, const char* one, const char* many);
/// What helps to know and is no error: a line on the standard error, unless quiet.
void note(const QString& text);
/// Neither notes nor progress from now on.
void setQuiet(bool quiet);
[[nodiscard]] bool isQuiet();

/// To be called at the very end: says if what was printed could not be written, and gives the exit status.
int flushOutput(int status);

}  // namespace hitscope::cli
