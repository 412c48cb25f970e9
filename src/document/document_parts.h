// SPDX-License-Identifier: GPL-3.0-or-later
// What session file and journal share; for the files of this folder.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/result.h"
#include "document/document_fields.h"
#include "document/field_writer.h"
#include "document/json_text.h"
#include "document/session_document.h"

namespace hitscope {

/// Appends a document, with no line end behind it.
void appendDocument(std::string& text, const SessionDocument& document, FieldWriter::Layout layout);

/// A document in a text that has passed checkJson(); what it says of itself has not been checked.
[[nodiscard]] Result<SessionDocument> documentOf(std::string_view text, const JsonValue& value);

/// Makes a section of `to` what it is in `from`.
void moveSection(Section section, SessionDocument& from, SessionDocument& to);

/// That no two have the same.
[[nodiscard]] Status checkIds(std::span<const SavedTarget> targets);

/// That what names a target or a hit names one that is there, and that no two targets have the same id.
[[nodiscard]] Status checkReferences(const SessionDocument& document);

/// Takes out of it what names a target or a hit that is not there; returns how many hits went.
std::size_t dropDangling(SessionDocument& document);

}  // namespace hitscope
