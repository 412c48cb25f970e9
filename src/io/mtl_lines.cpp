// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mtl_lines.h"

#include <algorithm>
#include <string>

#include "io/readers/text_cursor.h"

namespace hitscope {
namespace {

/// What follows an option of a map line.
struct MapOption {
    std::string_view name;
    int words;         ///< at most
    bool areOptional;  ///< only those that are numbers belong to it
};

constexpr MapOption kMapOptions[] = {
    {"-o", 3, true},       {"-s", 3, true},           {"-t", 3, true},        {"-mm", 2, true},
    {"-bm", 1, false},     {"-boost", 1, false},      {"-texres", 1, false},  {"-clamp", 1, false},
    {"-blendu", 1, false}, {"-blendv", 1, false},     {"-imfchan", 1, false}, {"-cc", 1, false},
    {"-type", 1, false},   {"-colorspace", 1, false},
};

bool isMapKeyword(std::string_view keyword) {
    std::string word(keyword);
    std::transform(word.begin(), word.end(), word.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return word.starts_with("map_") || word == "bump" || word == "norm" || word == "disp" ||
           word == "decal" || word == "refl";
}

/// Some programs write the comma of their language.
bool isNumberWord(std::string_view word) {
    std::string text(word);
    std::replace(text.begin(), text.end(), ',', '.');
    TextCursor cursor(text);
    return !text.empty() && cursor.number() && cursor.atEnd();
}

/// The option at the cursor, past which it goes; null, and the cursor where it was, if there is none.
const MapOption* takeOption(TextCursor& line) {
    TextCursor ahead = line;
    const std::string_view word = ahead.word();
    for (const MapOption& option : kMapOptions) {
        if (option.name == word) {
            line = ahead;
            return &option;
        }
    }
    return nullptr;
}

}  // namespace

std::optional<MtlMap> mtlMapOf(std::string_view text) {
    while (!text.empty() && (TextCursor::isBlank(text.back()) || text.back() == '\n')) {
        text.remove_suffix(1);
    }
    TextCursor line(text);
    MtlMap map{line.word(), {}, {}};
    if (!isMapKeyword(map.keyword)) {
        return std::nullopt;
    }
    while (const MapOption* const option = takeOption(line)) {
        for (int i = 0; i < option->words; ++i) {
            TextCursor ahead = line;
            const std::string_view word = ahead.word();
            if (option->areOptional && !isNumberWord(word)) {
                break;
            }
            line = ahead;
            map.bumps = option->name == "-bm" ? word : map.bumps;
        }
    }
    line.skipBlanks();
    map.name = line.rest();
    return map;
}

char mtlLineEnd(std::string_view file) {
    return file.find('\n') == std::string_view::npos ? '\r' : '\n';
}

std::string mtlText(std::string_view file) {
    constexpr std::string_view kMark = "\xef\xbb\xbf";
    std::string text(file.substr(file.starts_with(kMark) ? kMark.size() : 0));
    std::replace(text.begin(), text.end(), mtlLineEnd(text), '\n');
    std::erase(text, '\r');
    std::erase(text, '\0');
    return text;
}

bool definesMaterials(std::string_view file) {
    const std::string text = mtlText(file);
    for (TextCursor lines(text); !lines.atEnd();) {
        TextCursor line(lines.line());
        const bool begins = line.word() == "newmtl";
        line.skipBlanks();
        if (begins && !line.atEnd()) {
            return true;
        }
    }
    return false;
}

}  // namespace hitscope
