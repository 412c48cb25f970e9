// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/journal_records.h"

#include <algorithm>
#include <map>
#include <optional>

#include "deform/fingerprint.h"
#include "document/checked_lines.h"
#include "document/document_parts.h"
#include "document/field_reader.h"
#include "document/hit_pieces.h"

namespace hitscope {

namespace {

/// An edit of the history, for writing and for reading.
struct WrittenEdit {
    std::size_t at;
    std::size_t remove;
    std::span<const Hit> insert;
};
struct ReadEdit {
    std::size_t at = 0;
    std::size_t remove = 0;
    std::vector<Hit> insert;
};
struct EditLine {
    WrittenEdit hits;
};
struct SetLine {
    std::span<const Section> sections;
    const SessionDocument& document;
    std::string_view key = "set";
};
struct SetObject {
    const SetLine& line;
};
struct PictureLine {
    std::string base64;
};
struct FileLine {
    QString path;
};
struct JournalHead {};
struct ReadSections {
    SessionDocument document;
    std::vector<Section> sections;
};

}  // namespace

template <>
struct Fields<JournalHead> {
    static void visit(FieldWriter& writer, const JournalHead& /*head*/) {
        writer.text("format", kJournalFormat);
        writer.number("version", kJournalVersion);
    }
};

template <>
struct Fields<WrittenEdit> {
    static void visit(FieldWriter& writer, const WrittenEdit& edit) {
        writer.number("at", edit.at);
        writer.number("remove", edit.remove);
        writer.begin("insert");
        writer.open('[');
        for (const Hit& hit : edit.insert) {
            writer.whole({}, hit);
        }
        writer.close(']');
    }
};

template <>
struct Fields<EditLine> {
    static void visit(FieldWriter& writer, const EditLine& line) { writer.object("hits", line.hits); }
};

template <>
struct Fields<ReadEdit> {
    static void visit(FieldReader& reader, ReadEdit& edit) {
        reader.require("at");
        reader.number("at", edit.at);
        reader.number("remove", edit.remove);
        reader.list("insert", "hit", edit.insert, SessionDocument::kMostHits);
    }
};

template <>
struct Fields<SetObject> {
    static void visit(FieldWriter& writer, const SetObject& set) {
        for (const Section section : set.line.sections) {
            visitSection(writer, set.line.document, section);
        }
    }
};

template <>
struct Fields<SetLine> {
    static void visit(FieldWriter& writer, const SetLine& line) { writer.object(line.key, SetObject{line}); }
};

template <>
struct Fields<PictureLine> {
    static void visit(FieldWriter& writer, const PictureLine& line) { writer.text("picture", line.base64); }
};

template <>
struct Fields<FileLine> {
    static void visit(FieldWriter& writer, const FileLine& line) { writer.text("file", line.path); }
};

/// The sections that a line sets.
template <>
struct Fields<ReadSections> {
    static void visit(FieldReader& reader, ReadSections& read) {
        for (std::size_t i = 0; i < kSections.size(); ++i) {
            const auto section = static_cast<Section>(i);
            if (section != Section::Hits && reader.has(kSections[i])) {
                visitSection(reader, read.document, section);
                read.sections.push_back(section);
            }
        }
    }
};

// Writing

std::string JournalLines::line(std::string_view json) {
    std::string text = fingerprintText(lineChecksum(m_number++, json));
    text.reserve(text.size() + json.size() + 2);
    text += ' ';
    text += json;
    text += '\n';
    return text;
}

std::string JournalLines::begin(const SessionDocument& document) {
    m_number = 0;
    std::string head;
    FieldWriter(head, FieldWriter::Layout::Compact).whole({}, JournalHead());
    std::string snapshot;
    appendDocument(snapshot, document, FieldWriter::Layout::Compact);
    std::string text = line(head);
    return text += line(snapshot);
}

std::string JournalLines::edit(std::size_t at, std::size_t remove, std::span<const Hit> insert) {
    std::string json;
    FieldWriter(json, FieldWriter::Layout::Compact).whole({}, EditLine{{at, remove, insert}});
    return line(json);
}

std::string JournalLines::set(std::span<const Section> sections, const SessionDocument& document) {
    std::string json;
    FieldWriter(json, FieldWriter::Layout::Compact).whole({}, SetLine{sections, document});
    return line(json);
}

std::string JournalLines::someTargets(const SessionDocument& part) {
    constexpr Section kTargets = Section::Targets;
    std::string json;
    FieldWriter(json, FieldWriter::Layout::Compact).whole({}, SetLine{{&kTargets, 1}, part, "some"});
    return line(json);
}

std::string JournalLines::picture(const QByteArray& jpeg) {
    std::string json;
    FieldWriter(json, FieldWriter::Layout::Compact).whole({}, PictureLine{jpeg.toBase64().toStdString()});
    return line(json);
}

std::string JournalLines::file(const QString& path) {
    std::string json;
    FieldWriter(json, FieldWriter::Layout::Compact).whole({}, FileLine{path});
    return line(json);
}

// Reading

namespace {

Status checkHead(std::string_view json) {
    const Result<JsonValue> root = checkJson(json);
    if (!root) {
        return root.error();
    }
    FieldReader reader(json, root.value());
    std::string format;
    std::uint64_t version = 0;
    reader.text("format", format);
    reader.number("version", version, 1.0, 1.0e9);
    if (!reader.ok()) {
        return reader.status();
    }
    if (format != kJournalFormat || version == 0) {
        return Error{"This is no journal of Hitscope.", "line 1", ""};
    }
    if (version > static_cast<std::uint64_t>(kJournalVersion)) {
        return Error{"This journal was written by a newer Hitscope.", "line 1",
                     "Recover it with that Hitscope, or install the newest one."};
    }
    return Done{};
}

/// A journal while it is read: its hits are where they can be edited fast.
struct Replay {
    RecoveredJournal recovered;
    HitPieces hits;

    Status apply(std::string_view json) {
        const Result<JsonValue> root = checkJson(json);
        if (!root) {
            return root.error();
        }
        FieldReader reader(json, root.value());
        if (reader.has("hits")) {
            return edit(reader);
        }
        if (reader.has("set")) {
            return set(reader);
        }
        if (reader.has("some")) {
            return some(reader);
        }
        if (reader.has("picture")) {
            return picture(reader);
        }
        if (reader.has("file")) {
            reader.text("file", recovered.file);
            return reader.status();
        }
        return reader.ok() ? Status(Error{"A line changes nothing that is known.", "", ""}) : reader.status();
    }

private:
    Status edit(FieldReader& reader) {
        ReadEdit edit;
        reader.object("hits", edit);
        if (!reader.ok()) {
            return reader.status();
        }
        if (edit.at > hits.size() || edit.remove > hits.size() - edit.at ||
            hits.size() - edit.remove + edit.insert.size() > SessionDocument::kMostHits) {
            return Error{"A line edits hits that are not there.", "", ""};
        }
        hits.splice(edit.at, edit.remove, edit.insert);
        recovered.document.positions.clear();  // they are those of the hits before
        ++recovered.edits;
        return Done{};
    }

    Status set(FieldReader& reader) {
        ReadSections read;
        reader.within("set", read);
        if (!reader.ok()) {
            return reader.status();
        }
        if (const Status ids = checkIds(read.document.targets); !ids) {
            return ids;
        }
        for (const Section section : read.sections) {
            if (section == Section::Targets) {
                recovered.document.positions.clear();
            }
            moveSection(section, read.document, recovered.document);
        }
        ++recovered.settings;
        return Done{};
    }

    Status some(FieldReader& reader) {
        ReadSections read;
        reader.within("some", read);
        if (!reader.ok()) {
            return reader.status();
        }
        std::map<TargetId, SavedTarget*> places;
        for (SavedTarget& target : recovered.document.targets) {
            places[target.id] = &target;
        }
        for (const SavedTarget& target : read.document.targets) {
            if (!places.contains(target.id)) {
                return Error{"A line changes a target that is not there.", "", ""};
            }
        }
        for (SavedTarget& target : read.document.targets) {
            *places[target.id] = std::move(target);
        }
        recovered.document.positions.clear();
        ++recovered.settings;
        return Done{};
    }

    Status picture(FieldReader& reader) {
        std::string base64;
        reader.text("picture", base64);
        if (!reader.ok()) {
            return reader.status();
        }
        const auto decoded = QByteArray::fromBase64Encoding(QByteArray::fromStdString(base64),
                                                            QByteArray::AbortOnBase64DecodingErrors);
        if (!decoded || static_cast<std::size_t>((*decoded).size()) > kMostPicture) {
            return Error{"A line has a picture that cannot be read.", "", ""};
        }
        recovered.picture = *decoded;
        return Done{};
    }
};

Result<SessionDocument> snapshotOf(std::string_view json) {
    const Result<JsonValue> root = checkJson(json);
    if (!root) {
        return root.error();
    }
    Result<SessionDocument> document = documentOf(json, root.value());
    if (!document) {
        return document;
    }
    document.value().notKnown.clear();  // the lines of a journal are nobody's
    const Status referred = checkReferences(document.value());
    return referred ? std::move(document) : Result<SessionDocument>(referred.error());
}

}  // namespace

Result<RecoveredJournal> readJournal(const QByteArray& bytes) {
    CheckedLines lines({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    const auto refused = [](const Error& error) {
        return Error{"Nothing can be recovered from this journal. " + error.what, error.where,
                     error.advice.empty() || error.where != "line 1" ? "Discard it." : error.advice};
    };
    const Result<std::string_view> head = lines.next();
    if (!head) {
        return refused(head.error());
    }
    if (const Status checked = checkHead(head.value()); !checked) {
        return refused(checked.error());
    }
    lines.keep(head.value());
    const Result<std::string_view> snapshot = lines.next();
    if (!snapshot) {
        return refused(snapshot.error());
    }
    Result<SessionDocument> document = snapshotOf(snapshot.value());
    if (!document) {
        return refused(document.error());
    }
    lines.keep(snapshot.value());
    HitPieces hits(std::exchange(document.value().hits, {}));
    Replay replay{{std::move(document).value()}, std::move(hits)};
    RecoveredJournal& recovered = replay.recovered;
    while (!lines.isAtEnd()) {
        const Result<std::string_view> json = lines.next();
        const Status applied = json ? replay.apply(json.value()) : Status(json.error());
        if (!applied) {
            recovered.problem = applied.error().what;
            break;
        }
        lines.keep(json.value());
    }
    recovered.goodBytes = lines.goodBytes();
    recovered.lostLines = static_cast<std::size_t>(
        std::count(bytes.begin() + static_cast<qsizetype>(recovered.goodBytes), bytes.end(), '\n'));
    recovered.document.hits = replay.hits.take();
    recovered.droppedHits = dropDangling(recovered.document);
    return std::move(recovered);
}

}  // namespace hitscope
