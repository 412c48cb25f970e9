// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <variant>

#include "core/result.h"

namespace hitscope {

/// What the import worker says on its standard output, one a line:
///   progress 0.42 Reading faces
///   note 3 faces with fewer than three corners were left out.
///   error ["what","where","advice"]
/// Errors about the file that the answer is written to, which has no name, are at kAnswerPlace.
inline constexpr char kAnswerPlace[] = "<answer>";

struct WorkerProgress {
    double fraction = 0.0;  ///< [0, 1]; negative: not known
    QString doing;
};
struct WorkerNote {
    QString text;
};
using WorkerMessage = std::variant<std::monostate, WorkerProgress, WorkerNote, Error>;

[[nodiscard]] QByteArray formatWorkerLine(const WorkerMessage& message);

/// The line without its end. Whatever is not one of the above is std::monostate.
[[nodiscard]] WorkerMessage parseWorkerLine(const QByteArray& line);

}  // namespace hitscope
