// SPDX-License-Identifier: GPL-3.0-or-later
// Hits as JSON: {"hits": [{"target": "High-poly sphere 1", "point_x_m": 0.5, ...}, ...]}.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <utility>

#include "io/hit_records_fields.h"
#include "io/number_text.h"

namespace hitscope {

namespace {

using namespace hit_fields;

void appendQuoted(std::string& text, std::string_view value) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    text += '"';
    for (const char c : value) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            text += '\\';
            text += c;
        } else if (code < 0x20) {
            text += "\\u00";
            text += kDigits[code >> 4];
            text += kDigits[code & 15];
        } else {
            text += c;
        }
    }
    text += '"';
}

void appendHit(std::string& text, const HitRecords& table, std::size_t index) {
    text += '{';
    bool isFirst = true;
    for (const FieldName& key : kFields) {
        const std::string value = valueOf(table, index, key.field);
        if (value.empty() && key.field != Field::Target) {
            continue;  // not known
        }
        text += std::exchange(isFirst, false) ? "\"" : ", \"";
        text += key.name;
        text += "\": ";
        if (isText(key.field)) {
            appendQuoted(text, value);
        } else if (key.field == Field::Enabled) {
            text += table.hits[index].enabled ? "true" : "false";
        } else {
            text += value;
        }
    }
    text += '}';
}

std::size_t lineAt(std::string_view text, std::size_t offset) {
    return 1 + static_cast<std::size_t>(
                   std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

/// The line where the object of that number in the array of hits begins. `text` is JSON; `depth` is how many
/// brackets are around each of them.
std::size_t lineOfHit(std::string_view text, std::size_t number, int depth) {
    int open = 0;
    bool isInText = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (isInText) {
            i += c == '\\' ? 1 : 0;
            isInText = c != '"';
        } else if (c == '"') {
            isInText = true;
        } else if (c == '{' || c == '[') {
            if (open == depth && number-- == 0) {
                return lineAt(text, i);
            }
            ++open;
        } else if (c == '}' || c == ']') {
            --open;
        }
    }
    return 1;
}

/// As the table's reader wants it; nothing: neither text, number, nor true or false.
std::optional<std::string> textOf(const QJsonValue& value, Field field) {
    std::string text;
    if (isText(field)) {
        return value.isString() ? std::optional(value.toString().toStdString()) : std::nullopt;
    }
    if (value.isBool() && field == Field::Enabled) {
        return value.toBool() ? "1" : "0";
    }
    if (!value.isDouble()) {
        return std::nullopt;
    }
    const double number = value.toDouble();
    if (field == Field::Triangle && number >= 0.0 && number < 1e10 && std::floor(number) == number) {
        appendNumber(text, static_cast<std::uint64_t>(number));  // a double's shortest text may be 1e+05
    } else {
        appendNumber(text, number);
    }
    return text;
}

Status readHit(RecordReader& reader, const QJsonValue& value) {
    if (!value.isObject()) {
        return Error{"A hit is not an object in braces.", "", ""};
    }
    const QJsonObject object = value.toObject();
    for (const FieldName& needed : kFields) {
        const QLatin1StringView name(needed.name.data(), static_cast<qsizetype>(needed.name.size()));
        if (needed.isRequired && !object.contains(name)) {
            return Error{"“" + std::string(needed.name) + "” is missing.", "", ""};
        }
    }
    Hit hit;
    for (auto entry = object.begin(); entry != object.end(); ++entry) {
        const std::string name = entry.key().toStdString();
        const std::optional<Field> field = fieldNamed(name);
        if (!field) {
            return Error{"“" + name.substr(0, 40) + "” is nothing that a hit has.", "", ""};
        }
        const std::optional<std::string> text = textOf(entry.value(), *field);
        if (!text) {
            return Error{"“" + name + "” has a value of the wrong kind.", "", ""};
        }
        if (Status status = reader.set(hit, *field, *text); !status) {
            return status;
        }
    }
    return reader.add(hit);
}

}  // namespace

std::string toJson(const HitRecords& table) {
    std::string text = "{\"hits\": [";
    for (std::size_t i = 0; i < table.hits.size(); ++i) {
        text += i == 0 ? "\n" : ",\n";
        appendHit(text, table, i);
    }
    text += "\n]}\n";
    return text;
}

Result<HitRecords> hit_fields::readJson(std::string_view text, std::vector<std::string> pipelines) {
    QJsonParseError problem;
    const QByteArray bytes = QByteArray::fromRawData(text.data(), static_cast<qsizetype>(text.size()));
    const QJsonDocument document = QJsonDocument::fromJson(bytes, &problem);
    if (problem.error != QJsonParseError::NoError) {
        const auto offset = static_cast<std::size_t>(std::max(problem.offset, 0));
        return atLine(lineAt(text, std::min(offset, text.size())),
                      "This is not JSON: " + problem.errorString().toStdString() + ".");
    }
    QJsonValue hits = document.array();
    if (document.isObject()) {
        for (const QString& key : document.object().keys()) {
            if (key != QLatin1StringView("hits")) {
                return atLine(1, "“" + key.left(40).toStdString() + "” is nothing that a table of hits has.");
            }
        }
        hits = document.object().value(QLatin1StringView("hits"));
    }
    if (!hits.isArray()) {
        return atLine(1, "There is no array “hits”.");
    }
    RecordReader reader(std::move(pipelines));
    const QJsonArray array = hits.toArray();
    for (qsizetype i = 0; i < array.size(); ++i) {
        if (Status status = readHit(reader, array.at(i)); !status) {
            const int depth = document.isObject() ? 2 : 1;
            return atLine(lineOfHit(text, static_cast<std::size_t>(i), depth), status.error().what);
        }
    }
    return reader.take();
}

}  // namespace hitscope
