// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/document_json.h"

#include <string>
#include <string_view>

#include "document/document_parts.h"
#include "document/field_reader.h"

namespace hitscope {

namespace {

/// What a file says of itself.
struct Head {
    std::string format;
    std::uint64_t version = 0;
};

struct Whole {
    const SessionDocument& document;
};

}  // namespace

template <>
struct Fields<Head> {
    template <class Visit>
    static void visit(Visit& visit, Head& head) {
        visit.text("format", head.format);
        visit.number("version", head.version, 1.0, 1.0e9);
    }
};

template <>
struct Fields<Whole> {
    static void visit(FieldWriter& writer, const Whole& whole) {
        writer.text("format", kSessionFormat);
        writer.number("version", kSessionVersion);
        visitDocument(writer, whole.document);
    }
};

namespace {

Status checkHead(FieldReader& reader) {
    Head head;
    Fields<Head>::visit(reader, head);
    if (head.format != kSessionFormat) {
        return Error{"This is no session of Hitscope.", "line 1",
                     "Choose a file that Hitscope saved as a session."};
    }
    if (reader.ok() && head.version == 0) {
        return Error{"Its version is missing.", "line 1", "Compare it with a session that Hitscope saved."};
    }
    if (head.version > static_cast<std::uint64_t>(kSessionVersion)) {
        return Error{"This session was saved by a newer Hitscope, in version " +
                         std::to_string(head.version) + " of the format.",
                     "line 1", "Open it with that Hitscope, or install the newest one."};
    }
    return reader.status();
}

/// As checkReferences() says it, with the line where that stands.
Error withLine(const Error& error, std::string_view text, const JsonValue& root) {
    const std::size_t space = error.where.find(' ');
    const std::string key = error.where.substr(0, space) + 's';
    std::vector<JsonMember> members;
    static_cast<void>(root.members(members));
    for (const JsonMember& member : members) {
        if (!isKey(member.key, key) || space == std::string::npos) {
            continue;
        }
        std::optional<JsonValue> item = member.value.first();
        for (std::size_t left = std::stoul(error.where.substr(space)); left > 1 && item; --left) {
            item = item->next();
        }
        if (item) {
            const std::string line = "line " + std::to_string(lineAt(text, item->offset()));
            return {error.what, line + ", " + error.where, error.advice};
        }
    }
    return error;
}

}  // namespace

void appendDocument(std::string& text, const SessionDocument& document, FieldWriter::Layout layout) {
    FieldWriter(text, layout).whole({}, Whole{document});
}

Result<SessionDocument> documentOf(std::string_view text, const JsonValue& value) {
    FieldReader reader(text, value);
    if (const Status head = checkHead(reader); !head) {
        return reader.ok() ? head.error() : reader.status().error();
    }
    SessionDocument document;
    visitDocument(reader, document);
    if (const Status read = reader.status(); !read) {
        return read.error();
    }
    document.notKnown = reader.takePassedOver();
    return document;
}

QByteArray writeDocument(const SessionDocument& document) {
    constexpr std::size_t kUsualHit = 400;  // bytes
    constexpr std::size_t kUsualRest = 10'000;
    std::string text;
    text.reserve(kUsualRest + document.hits.size() * kUsualHit);
    appendDocument(text, document, FieldWriter::Layout::Lines);
    text += '\n';
    return {text.data(), static_cast<qsizetype>(text.size())};
}

Result<SessionDocument> readDocument(const QByteArray& bytes) {
    const std::string_view text(bytes.constData(), static_cast<std::size_t>(bytes.size()));
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
        return Error{"The file is empty.", "", "Choose a session that Hitscope saved."};
    }
    const Result<JsonValue> root = checkJson(text);
    if (!root) {
        return root.error();
    }
    Result<SessionDocument> document = documentOf(text, root.value());
    if (!document) {
        return document;
    }
    if (const Status referred = checkReferences(document.value()); !referred) {
        return withLine(referred.error(), text, root.value());
    }
    return document;
}

}  // namespace hitscope
