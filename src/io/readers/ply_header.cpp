// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/ply_header.h"

#include <optional>
#include <utility>

#include "io/readers/text_cursor.h"

namespace hitscope {
namespace {

const char* const kAdvice = "Save or download the file again; it is no PLY as Hitscope knows it.";

std::optional<PlyType> typeNamed(std::string_view name) {
    static constexpr std::pair<std::string_view, PlyType> kNames[] = {
        {"char", PlyType::Int8},       {"int8", PlyType::Int8},       {"uchar", PlyType::Uint8},
        {"uint8", PlyType::Uint8},     {"short", PlyType::Int16},     {"int16", PlyType::Int16},
        {"ushort", PlyType::Uint16},   {"uint16", PlyType::Uint16},   {"int", PlyType::Int32},
        {"int32", PlyType::Int32},     {"uint", PlyType::Uint32},     {"uint32", PlyType::Uint32},
        {"float", PlyType::Float32},   {"float32", PlyType::Float32}, {"double", PlyType::Float64},
        {"float64", PlyType::Float64},
    };
    for (const auto& [known, type] : kNames) {
        if (known == name) {
            return type;
        }
    }
    return std::nullopt;
}

std::optional<PlyEncoding> encodingNamed(std::string_view name) {
    if (name == "ascii") {
        return PlyEncoding::Ascii;
    }
    if (name == "binary_little_endian") {
        return PlyEncoding::LittleEndian;
    }
    if (name == "binary_big_endian") {
        return PlyEncoding::BigEndian;
    }
    return std::nullopt;
}

bool parseElement(TextCursor& line, PlyHeader& header) {
    PlyElement element;
    element.name = line.word();
    line.skipBlanks();
    const std::optional<long long> count = line.integer();
    const bool isWholeNumber = line.atEnd() || TextCursor::isBlank(line.peek());
    if (element.name.empty() || !count || *count < 0 || !isWholeNumber) {
        return false;
    }
    element.count = static_cast<std::uint64_t>(*count);
    header.elements.push_back(std::move(element));
    return true;
}

bool parseProperty(TextCursor& line, PlyHeader& header) {
    PlyProperty property;
    std::optional<PlyType> type = PlyType::Uint8;
    std::string_view word = line.word();
    if (word == "list") {
        property.isList = true;
        type = typeNamed(line.word());
        if (!type || !isWhole(*type)) {
            return false;
        }
        property.countType = *type;
        word = line.word();
    }
    type = typeNamed(word);
    property.name = line.word();
    if (!type || property.name.empty() || header.elements.empty()) {
        return false;
    }
    property.type = *type;
    header.elements.back().properties.push_back(std::move(property));
    return true;
}

void parseComment(TextCursor& line, PlyHeader& header) {
    if (line.word() == "TextureFile") {
        line.skipBlanks();
        std::string_view name = line.rest();
        while (!name.empty() && TextCursor::isBlank(name.back())) {
            name.remove_suffix(1);
        }
        header.textures.emplace_back(name);
    }
}

/// Bytes that one element takes at least.
std::uint64_t leastSize(const PlyElement& element, PlyEncoding encoding) {
    std::uint64_t size = 0;
    for (const PlyProperty& property : element.properties) {
        const PlyType fixed = property.isList ? property.countType : property.type;
        size += encoding == PlyEncoding::Ascii ? 2 : sizeOf(fixed);  // a digit and a blank
    }
    return size;
}

Status checkRoom(const PlyHeader& header, std::uint64_t fileSize) {
    std::uint64_t room = fileSize - header.size + 1;  // the last number needs no blank behind it
    for (const PlyElement& element : header.elements) {
        const std::uint64_t least = leastSize(element, header.encoding);
        if (least > 0 && element.count > room / least) {
            return Error{"The header promises " + std::to_string(element.count) + " of \"" + element.name +
                             "\", but the file ends too early for them: there is room for " +
                             std::to_string(room / least) + " at most.",
                         "header", kCutAdvice};
        }
        room -= least * element.count;
    }
    return Done{};
}

Error lineError(std::size_t number, std::string_view line) {
    return {quoted(line) + " is not a line of a PLY header.", "line " + std::to_string(number), kAdvice};
}

}  // namespace

Result<PlyHeader> parsePlyHeader(std::string_view file) {
    return parsePlyHeader(file, file.size());
}

Result<PlyHeader> parsePlyHeader(std::string_view start, std::uint64_t fileSize) {
    TextCursor lines(start);
    if (!start.starts_with("ply") || TextCursor(lines.line()).word() != "ply") {
        return Error{"It does not begin with \"ply\", so it is not a PLY file.",
                     {},
                     "Check that the file's suffix tells its format."};
    }
    PlyHeader header;
    bool hasFormat = false;
    for (std::size_t number = 2; !lines.atEnd(); ++number) {
        const std::string_view text = lines.line();
        TextCursor line(text);
        const std::string_view keyword = line.word();
        bool good = true;
        if (keyword == "format") {
            const std::optional<PlyEncoding> encoding = encodingNamed(line.word());
            good = hasFormat = encoding.has_value();
            header.encoding = encoding.value_or(PlyEncoding::Ascii);
        } else if (keyword == "element") {
            good = parseElement(line, header);
        } else if (keyword == "property") {
            good = parseProperty(line, header);
        } else if (keyword == "comment") {
            parseComment(line, header);
        } else if (keyword == "end_header") {
            header.size = lines.offset();
            if (!hasFormat) {
                return Error{"The header does not say which format the data has.", "header", kAdvice};
            }
            if (Status room = checkRoom(header, fileSize); !room) {
                return room.error();
            }
            return header;
        } else {
            // Old Blenders name themselves without the word "comment". Further on, a misspelt line could be
            // one that the data depends on.
            good = keyword.empty() || keyword == "obj_info" || (hasFormat && header.elements.empty());
        }
        if (!good) {
            return lineError(number, text);
        }
    }
    return Error{"The file ends inside its header.", {}, kCutAdvice};
}

std::optional<PlyEdgeEnds> plyEdgeEnds(const PlyElement& element) {
    std::optional<std::size_t> ends[2];
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const PlyProperty& property = element.properties[p];
        for (int i = 0; i < 2 && !property.isList; ++i) {
            ends[i] = property.name == (i == 0 ? "vertex1" : "vertex2") ? p : ends[i];
        }
    }
    const bool isWhole = element.name == "edge" && ends[0] && ends[1];
    return isWhole ? std::optional(PlyEdgeEnds{*ends[0], *ends[1]}) : std::nullopt;
}

}  // namespace hitscope
