// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include "core/result.h"
#include "document/session_document.h"

namespace hitscope {

/// What begins a session file, and the version of the format that this program writes.
inline constexpr std::string_view kSessionFormat = "hitscope session";
inline constexpr int kSessionVersion = 1;

/// A session file's bytes: JSON for people to read and for diff to compare. The order is always the same, and
/// each hit has a line; every number is the shortest text that reads back as the same bits.
[[nodiscard]] QByteArray writeDocument(const SessionDocument& document);

/// What writeDocument() wrote, or a person changed since. What is left out is as in a new SessionDocument,
/// and what is not known is passed over: SessionDocument::notKnown. All numbers have been checked, hits by
/// checkedHit(), and all that names a target or a hit names one that is there. The error's place is the line
/// and the value.
[[nodiscard]] Result<SessionDocument> readDocument(const QByteArray& bytes);

}  // namespace hitscope
