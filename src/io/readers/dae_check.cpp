// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/dae_check.h"

#include <QHash>
#include <QStringDecoder>
#include <QXmlStreamReader>
#include <algorithm>
#include <vector>

#include "io/readers/import_bounds.h"

namespace hitscope {
namespace {

struct Node {
    std::vector<std::size_t> children;
    std::vector<QString> instances;   ///< of nodes
    std::vector<QString> geometries;  ///< or controllers, which move one
    bool isTop = false;               ///< of a scene
};

std::uint64_t wordsIn(QStringView text) {
    std::uint64_t words = 0;
    bool inside = false;
    for (const QChar c : text) {
        words += !c.isSpace() && !inside ? 1 : 0;
        inside = !c.isSpace();
    }
    return words;
}

QString targetOf(QStringView url) {
    return url.startsWith(QLatin1Char('#')) ? url.mid(1).toString() : url.toString();
}

/// What of the file concerns how often something is made.
class DaeOutline {
public:
    void take(const QXmlStreamReader& xml);
    /// Of all scenes together, with every instance. False: an instance holds itself.
    bool expand(NodeCounts& all) const;

private:
    void begin(const QXmlStreamReader& xml);
    void end(QStringView name);
    [[nodiscard]] std::vector<std::size_t> below(const Node& node) const;

    std::vector<Node> m_nodes;
    QHash<QString, std::size_t> m_byId;
    QHash<QString, std::size_t> m_byName;
    std::vector<std::size_t> m_open;  ///< nodes
    QHash<QString, std::uint64_t> m_numbersOf;
    QHash<QString, QString> m_skinOf;
    QString m_geometry;
    QString m_controller;
    bool m_inScene = false;
    bool m_inPrimitive = false;
};

void DaeOutline::begin(const QXmlStreamReader& xml) {
    const QStringView name = xml.qualifiedName();
    const QXmlStreamAttributes attributes = xml.attributes();
    const auto value = [&](const char* key) { return attributes.value(QLatin1String(key)); };
    if (name == QLatin1String("visual_scene")) {
        m_inScene = true;
    } else if (name == QLatin1String("node")) {
        const std::size_t index = m_nodes.size();
        m_nodes.emplace_back().isTop = m_inScene && m_open.empty();
        if (!m_open.empty()) {
            m_nodes[m_open.back()].children.push_back(index);
        }
        m_open.push_back(index);
        m_byId.insert(value("id").toString(), index);
        m_byName.insert(value("name").toString(), index);
    } else if (name == QLatin1String("geometry")) {
        m_geometry = value("id").toString();
    } else if (name == QLatin1String("controller")) {
        m_controller = value("id").toString();
    } else if (name == QLatin1String("skin") || name == QLatin1String("morph")) {
        m_skinOf.insert(m_controller, targetOf(value("source")));
    } else if (name == QLatin1String("p") || name == QLatin1String("v")) {
        m_inPrimitive = true;
    } else if (!m_open.empty() && name == QLatin1String("instance_node")) {
        m_nodes[m_open.back()].instances.push_back(targetOf(value("url")));
    } else if (!m_open.empty() &&
               (name == QLatin1String("instance_geometry") || name == QLatin1String("instance_controller"))) {
        m_nodes[m_open.back()].geometries.push_back(targetOf(value("url")));
    }
}

void DaeOutline::end(QStringView name) {
    if (name == QLatin1String("visual_scene")) {
        m_inScene = false;
    } else if (name == QLatin1String("node") && !m_open.empty()) {
        m_open.pop_back();
    } else if (name == QLatin1String("geometry")) {
        m_geometry.clear();
    } else if (name == QLatin1String("p") || name == QLatin1String("v")) {
        m_inPrimitive = false;
    }
}

void DaeOutline::take(const QXmlStreamReader& xml) {
    if (xml.isStartElement()) {
        begin(xml);
    } else if (xml.isEndElement()) {
        end(xml.qualifiedName());
    } else if (xml.isCharacters() && m_inPrimitive && !m_geometry.isEmpty()) {
        m_numbersOf[m_geometry] += wordsIn(xml.text());
    }
}

std::vector<std::size_t> DaeOutline::below(const Node& node) const {
    std::vector<std::size_t> found = node.children;
    for (const QString& name : node.instances) {
        if (m_byId.contains(name)) {
            found.push_back(m_byId.value(name));
        } else if (m_byName.contains(name)) {  // as Assimp finds them
            found.push_back(m_byName.value(name));
        }
    }
    return found;
}

bool DaeOutline::expand(NodeCounts& all) const {
    std::vector<std::vector<std::size_t>> parts;
    std::vector<NodeCounts> counts;
    for (const Node& node : m_nodes) {
        parts.push_back(below(node));
        NodeCounts& own = counts.emplace_back();
        for (const QString& geometry : node.geometries) {
            own.add({0, m_numbersOf.value(m_skinOf.value(geometry, geometry))});
        }
    }
    if (!addUpParts(parts, counts)) {
        return false;
    }
    for (std::size_t n = 0; n < m_nodes.size(); ++n) {
        if (m_nodes[n].isTop) {
            all.add(counts[n]);
        }
    }
    return true;
}

}  // namespace

Status checkDae(std::string_view file) {
    constexpr std::size_t kPart = 1 << 20;  // bytes
    // Decoded here, since a name in some older encoding is no reason to refuse a mesh.
    QStringDecoder decode(QStringDecoder::Utf8);
    if (const auto encoding = QStringDecoder::encodingForData(
            QByteArrayView(file.data(), static_cast<qsizetype>(std::min<std::size_t>(file.size(), 4))))) {
        decode = QStringDecoder(*encoding);
    }
    QXmlStreamReader xml;
    xml.setNamespaceProcessing(false);
    DaeOutline outline;
    for (std::size_t at = 0; at < file.size(); at += kPart) {
        const std::string_view part = file.substr(at, kPart);
        xml.addData(QString(decode(QByteArrayView(part.data(), static_cast<qsizetype>(part.size())))));
        while (!xml.atEnd()) {
            xml.readNext();
            outline.take(xml);
        }
        if (xml.hasError() && xml.error() != QXmlStreamReader::PrematureEndOfDocumentError) {
            break;
        }
    }
    if (xml.hasError()) {
        return Error{xml.errorString().toStdString(), "line " + std::to_string(xml.lineNumber()), {}};
    }
    NodeCounts all;
    if (!outline.expand(all)) {
        return Error{"a node is an instance of what it is in", {}, {}};
    }
    if (all.tooMany()) {
        return Error{"with all instances it has more nodes or vertices than can be opened", {}, {}};
    }
    return Done{};
}

}  // namespace hitscope
