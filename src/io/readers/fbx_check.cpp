// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/fbx_check.h"

#include <charconv>
#include <cstring>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "io/readers/import_bounds.h"

namespace hitscope {
namespace {

using Id = std::int64_t;

/// What of a file concerns how often a model is made.
struct Outline {
    std::unordered_map<Id, std::size_t> models{{0, 0}};  ///< the scene is 0
    std::vector<std::pair<Id, Id>> links;                ///< child, parent

    void addModel(Id id) { models.try_emplace(id, models.size()); }
};

constexpr std::string_view kBinary = "Kaydara FBX Binary";

/// Of a binary file: what lies at a place, or nothing behind the end.
class Bytes {
public:
    explicit Bytes(std::string_view file) : m_file(file) {}

    template <class Number>
    [[nodiscard]] std::optional<Number> number(std::uint64_t at) const {
        Number value{};
        if (at > m_file.size() || m_file.size() - at < sizeof value) {
            return std::nullopt;
        }
        std::memcpy(&value, m_file.data() + at, sizeof value);
        return value;
    }
    [[nodiscard]] std::string_view text(std::uint64_t at, std::uint64_t size) const {
        return at > m_file.size() ? std::string_view() : m_file.substr(at, size);
    }

private:
    std::string_view m_file;
};

struct Record {
    bool isThere = false;  ///< else it is the end of a list, or broken
    std::uint64_t end = 0;
    std::uint64_t properties = 0;  ///< where they begin
    std::uint64_t children = 0;    ///< where they would
    std::string_view name;
};

Record recordAt(const Bytes& bytes, std::uint64_t at, bool isWide) {
    const std::uint64_t size = isWide ? 8 : 4;
    const auto field = [&](std::uint64_t index) -> std::uint64_t {
        const std::uint64_t place = at + index * size;
        return isWide ? bytes.number<std::uint64_t>(place).value_or(0)
                      : bytes.number<std::uint32_t>(place).value_or(0);
    };
    Record record;
    record.end = field(0);
    const std::uint64_t nameAt = at + 3 * size + 1;
    const std::uint64_t nameSize = bytes.number<std::uint8_t>(nameAt - 1).value_or(0);
    record.properties = nameAt + nameSize;
    record.children = record.properties + field(2);
    record.name = bytes.text(nameAt, nameSize);
    record.isThere = record.end >= record.children && record.children >= record.properties;
    return record;
}

/// 'L' and eight bytes.
std::optional<Id> idAt(const Bytes& bytes, std::uint64_t at) {
    return bytes.text(at, 1) == "L" ? bytes.number<Id>(at + 1) : std::nullopt;
}

/// "OO", child, parent.
void addLink(const Bytes& bytes, std::uint64_t at, Outline& outline) {
    constexpr std::uint64_t kText = 5;  // bytes before a text: 'S' and its length
    constexpr std::uint64_t kId = 9;
    const std::uint64_t first = at + kText + bytes.number<std::uint32_t>(at + 1).value_or(0);
    const std::string_view kind = bytes.text(at + kText, 2);
    const std::optional<Id> child = idAt(bytes, first);
    const std::optional<Id> parent = idAt(bytes, first + kId);
    if (bytes.text(at, 1) == "S" && kind != "OP" && kind != "PP" && child && parent) {
        outline.links.emplace_back(*child, *parent);
    }
}

Outline outlineOfBinary(std::string_view file) {
    constexpr std::uint64_t kVersionAt = 23;
    constexpr std::uint64_t kFirstAt = 27;
    constexpr std::uint32_t kWideSince = 7500;
    const Bytes bytes(file);
    const bool isWide = bytes.number<std::uint32_t>(kVersionAt).value_or(0) >= kWideSince;
    Outline outline;
    for (Record section = recordAt(bytes, kFirstAt, isWide); section.isThere;
         section = recordAt(bytes, section.end, isWide)) {
        if (section.name != "Objects" && section.name != "Connections") {
            continue;
        }
        for (Record record = recordAt(bytes, section.children, isWide);
             record.isThere && record.end <= section.end; record = recordAt(bytes, record.end, isWide)) {
            if (record.name == "C") {
                addLink(bytes, record.properties, outline);
            } else if (record.name == "Model") {
                if (const auto id = idAt(bytes, record.properties)) {
                    outline.addModel(*id);
                }
            }
        }
    }
    return outline;
}

/// Goes over blanks, then takes `wanted`, or stays.
bool take(std::string_view& text, char wanted) {
    const std::size_t at = text.find_first_not_of(" \t\r\n");
    if (at == std::string_view::npos || text[at] != wanted) {
        return false;
    }
    text.remove_prefix(at + 1);
    return true;
}

std::optional<Id> takeId(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    Id id = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
    if (error != std::errc()) {
        return std::nullopt;
    }
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return id;
}

/// What begins a "C:", from its colon on.
void addLink(std::string_view text, Outline& outline) {
    if (!take(text, '"')) {
        return;
    }
    const std::size_t quote = text.find('"');
    if (quote == std::string_view::npos) {
        return;
    }
    const std::string_view kind = text.substr(0, quote);
    text.remove_prefix(quote + 1);
    if (kind == "OP" || kind == "PP" || !take(text, ',')) {
        return;
    }
    const std::optional<Id> child = takeId(text);
    const std::optional<Id> parent = take(text, ',') ? takeId(text) : std::nullopt;
    if (child && parent) {
        outline.links.emplace_back(*child, *parent);
    }
}

Outline outlineOfText(std::string_view file) {
    constexpr std::string_view kModel = "Model";
    Outline outline;
    for (std::size_t colon = file.find(':'); colon != std::string_view::npos;
         colon = file.find(':', colon + 1)) {
        std::string_view after = file.substr(colon + 1);
        const std::string_view before = file.substr(0, colon);
        if (before.ends_with('C')) {
            addLink(after, outline);
        } else if (before.ends_with(kModel)) {
            if (const auto id = takeId(after)) {
                outline.addModel(*id);
            }
        }
    }
    return outline;
}

}  // namespace

Status checkFbx(std::string_view file) {
    const Outline outline = file.starts_with(kBinary) ? outlineOfBinary(file) : outlineOfText(file);
    std::vector<std::vector<std::size_t>> parts(outline.models.size());
    std::vector<NodeCounts> counts(outline.models.size());
    for (const auto& [child, parent] : outline.links) {
        const auto of = outline.models.find(parent);
        const auto part = outline.models.find(child);
        if (of != outline.models.end() && part != outline.models.end()) {
            parts[of->second].push_back(part->second);
        }
    }
    if (!addUpParts(parts, counts)) {
        return Error{"a model is a part of itself", {}, {}};
    }
    if (counts[0].tooMany()) {
        return Error{"with all instances it has more nodes than can be opened", {}, {}};
    }
    return Done{};
}

}  // namespace hitscope
