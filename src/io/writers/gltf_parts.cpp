// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/writers/gltf_parts.h"

#include <QJsonDocument>
#include <QUrl>
#include <algorithm>
#include <limits>
#include <memory>

#include "core/give_up.h"
#include "core/srgb.h"

namespace hitscope {
namespace {

constexpr double kStepTargets = 0.6;               // of what is prepared, at their end
constexpr std::uint32_t kMostNumbered = 1u << 24;  // whole numbers up to here are floats

bool isFaces(const GltfPrimitive& primitive) {
    return primitive.kind == GltfPrimitive::Kind::Triangles;
}

}  // namespace

/// Asking whether to go on is the writer's.
void GltfParts::tell(double share) const {
    if (m_what.goOn) {
        m_what.goOn(ExportStep::Preparing, share);
    }
}

/// Share of what is prepared: with steps, most of it is theirs.
double GltfParts::laidOut() const {
    return 2.0 / (3.0 + (m_options.steps ? static_cast<double>(m_what.steps.size()) : 0.0));
}

Status GltfParts::make() {
    tell(laidOut());
    bool plain = false;
    for (const GltfPrimitive& primitive : m_layout.primitives) {
        plain = plain || (isFaces(primitive) && primitive.material == kNoIndex);
        m_hasLoose = m_hasLoose || !isFaces(primitive);
        m_copies += primitive.fileVertices.size();
    }
    m_copies -= std::min(m_copies, m_mesh.positions.size());
    if (Status made = m_materials.make(plain); !made) {
        return made;
    }
    m_deformed = deformedTarget(m_what, m_originals);
    if (m_options.steps) {
        m_steps = stepTargets(m_what, m_deformed,
                              [this](double share) { tell(laidOut() + (kStepTargets - laidOut()) * share); });
    }
    for (std::uint32_t object = 0; object < m_layout.objects.size(); ++object) {
        addNode(object);
    }
    return Done{};
}

void GltfParts::addNode(std::uint32_t object) {
    std::vector<const GltfPrimitive*> primitives;
    for (const GltfPrimitive& primitive : m_layout.primitives) {
        if (primitive.object == object) {
            primitives.push_back(&primitive);
        }
    }
    const auto isReachedBy = [&primitives](const MorphTarget& target) {
        return std::any_of(primitives.begin(), primitives.end(), [&target](const GltfPrimitive* primitive) {
            return isReached(*primitive, target);
        });
    };
    std::vector<const MorphTarget*> targets{&m_deformed};
    for (const MorphTarget& step : m_steps) {
        if (isReachedBy(step)) {
            targets.push_back(&step);
        }
    }
    const bool isMorphed = targets.size() > 1 || isReachedBy(m_deformed);
    targets.resize(isMorphed ? targets.size() : 0);
    QJsonArray list;
    for (const GltfPrimitive* const primitive : primitives) {
        list.append(primitiveOf(*primitive, targets));
    }
    const QString name = fileNameText(m_layout.objects[object]);
    QJsonObject mesh{{QStringLiteral("name"), name}, {QStringLiteral("primitives"), list}};
    if (isMorphed) {
        QJsonArray names;
        QJsonArray weights;
        for (const MorphTarget* const target : targets) {
            names.append(fileNameText(target->name));
            weights.append(target == &m_deformed ? 1.0 : 0.0);
        }
        mesh[QStringLiteral("weights")] = weights;
        mesh[QStringLiteral("extras")] = QJsonObject{{QStringLiteral("targetNames"), names}};
    }
    m_meshes.append(mesh);
    m_nodes.append(
        QJsonObject{{QStringLiteral("name"), name}, {QStringLiteral("mesh"), m_meshes.size() - 1}});
    if (targets.size() > 1) {
        addAnimation(static_cast<int>(m_nodes.size() - 1), targets);
    }
}

int GltfParts::addPositions(const GltfPrimitive& primitive) {
    const std::vector<std::uint32_t>& vertices = primitive.fileVertices;
    glm::vec3 least(std::numeric_limits<float>::infinity());
    glm::vec3 most(-std::numeric_limits<float>::infinity());
    for (const std::uint32_t vertex : vertices) {
        mayGiveUp(vertex);
        const glm::vec3 position(m_positions.original(vertex));
        least = glm::min(least, position);
        most = glm::max(most, position);
    }
    const int view = m_document.addView(vertices.size(), sizeof(glm::vec3), gltf::kVertices,
                                        [this, &vertices](PieceWriter& out, std::size_t i) {
                                            out.plain(glm::vec3(m_positions.original(vertices[i])));
                                        });
    return m_document.addAccessor(
        view, gltf::kFloat, "VEC3", vertices.size(),
        {{QStringLiteral("min"), jsonOf(least)}, {QStringLiteral("max"), jsonOf(most)}});
}

/// Normals, texture coordinates and colours, as far as the mesh has them; lines and points have colours only.
void GltfParts::addVectors(QJsonObject& attributes, const GltfPrimitive& primitive) {
    const std::size_t count = primitive.fileVertices.size();
    const auto add = [&](const char* key, const char* type, std::size_t bytes,
                         const GltfDocument::PutElement& put) {
        const int view = m_document.addView(count, bytes, gltf::kVertices, put);
        attributes[QLatin1String(key)] = m_document.addAccessor(view, gltf::kFloat, type, count);
    };
    if (!m_originals.empty() && isFaces(primitive)) {
        add("NORMAL", "VEC3", sizeof(glm::vec3), [this, &primitive](PieceWriter& out, std::size_t i) {
            const std::uint32_t corner = primitive.corners[i];
            out.plain(unitNormal(corner == kNoIndex ? glm::vec3(0.0f) : m_originals[corner]));
        });
    }
    if (!m_mesh.cornerTexcoords.empty() && isFaces(primitive)) {
        add("TEXCOORD_0", "VEC2", sizeof(glm::vec2), [this, &primitive](PieceWriter& out, std::size_t i) {
            const std::uint32_t corner = primitive.corners[i];
            const std::uint32_t index = corner == kNoIndex ? kNoIndex : m_mesh.cornerTexcoords[corner];
            const glm::vec2 texcoord = index == kNoIndex ? glm::vec2(0.0f) : m_mesh.texcoords[index];
            out.plain(glm::vec2(texcoord.x, 1.0f - texcoord.y));  // glTF's begin above
        });
    }
    if (!m_mesh.colours.empty()) {
        add("COLOR_0", "VEC3", sizeof(glm::vec3), [this, &primitive](PieceWriter& out, std::size_t i) {
            const glm::vec3& srgb = m_mesh.colours[primitive.fileVertices[i]];
            out.plain(glm::vec3(linearOfSrgb(srgb.x), linearOfSrgb(srgb.y), linearOfSrgb(srgb.z)));
        });
    }
}

/// Which vertex of the mesh each is, and, where the mesh is not as its file has it, which of the file's: -1
/// is a new one.
void GltfParts::addNumbers(QJsonObject& attributes, const GltfPrimitive& primitive) {
    const std::vector<std::uint32_t>& vertices = primitive.fileVertices;
    const auto add = [&](const char* key, const GltfDocument::PutElement& put) {
        const int view = m_document.addView(vertices.size(), sizeof(float), gltf::kVertices, put);
        attributes[QLatin1String(key)] =
            m_document.addAccessor(view, gltf::kFloat, "SCALAR", vertices.size());
    };
    add("_FILE_VERTEX",
        [&vertices](PieceWriter& out, std::size_t i) { out.plain(static_cast<float>(vertices[i])); });
    if (!m_mesh.isAsRead()) {
        add("_SOURCE_VERTEX", [this, &vertices](PieceWriter& out, std::size_t i) {
            const std::uint32_t source = m_mesh.sourceVertices[vertices[i]];
            out.plain(source == kNoIndex ? -1.0f : static_cast<float>(source));
        });
    }
}

QJsonObject GltfParts::attributesOf(const GltfPrimitive& primitive) {
    QJsonObject attributes{{QStringLiteral("POSITION"), addPositions(primitive)}};
    addVectors(attributes, primitive);
    if (m_mesh.positions.size() <= kMostNumbered) {
        addNumbers(attributes, primitive);
    }
    return attributes;
}

/// The largest number of a type is not for vertices.
int GltfParts::addIndices(const GltfPrimitive& primitive) {
    const std::vector<std::uint32_t>& indices = primitive.indices;
    const bool areShort = primitive.fileVertices.size() <= 0xffff;
    const int view = m_document.addView(
        indices.size(), areShort ? sizeof(std::uint16_t) : sizeof(std::uint32_t), gltf::kIndices,
        [&indices, areShort](PieceWriter& out, std::size_t i) {
            areShort ? out.plain(static_cast<std::uint16_t>(indices[i])) : out.plain(indices[i]);
        });
    return m_document.addAccessor(view, areShort ? gltf::kUint16 : gltf::kUint32, "SCALAR", indices.size());
}

QJsonObject GltfParts::primitiveOf(const GltfPrimitive& primitive,
                                   const std::vector<const MorphTarget*>& targets) {
    QJsonObject result{{QStringLiteral("attributes"), attributesOf(primitive)},
                       {QStringLiteral("indices"), addIndices(primitive)}};
    if (isFaces(primitive)) {
        result[QStringLiteral("material")] = m_materials.indexOf(primitive.material);
    } else {
        result[QStringLiteral("mode")] = static_cast<int>(primitive.kind);
    }
    QJsonArray morphs;
    for (const MorphTarget* const target : targets) {
        morphs.append(addMorph(m_document, primitive, *target, m_what, m_originals));
        tell(std::max(kStepTargets, laidOut()) +
             (1.0 - std::max(kStepTargets, laidOut())) * static_cast<double>(++m_made) /
                 static_cast<double>((m_steps.size() + 1) * m_layout.primitives.size()));
    }
    if (!morphs.isEmpty()) {
        result[QStringLiteral("targets")] = morphs;
    }
    return result;
}

/// Of the keys: one before the first step, and one after each.
int GltfParts::times() {
    if (m_times < 0) {
        const std::size_t keys = m_steps.size() + 1;
        const auto at = [seconds = m_options.stepSeconds](std::size_t key) {
            return static_cast<float>(seconds * static_cast<double>(key));
        };
        const int view = m_document.addView(keys, sizeof(float), gltf::kNeither,
                                            [at](PieceWriter& out, std::size_t i) { out.plain(at(i)); });
        m_times = m_document.addAccessor(
            view, gltf::kFloat, "SCALAR", keys,
            {{QStringLiteral("min"), QJsonArray{0.0}},
             {QStringLiteral("max"), QJsonArray{static_cast<double>(at(m_steps.size()))}}});
    }
    return m_times;
}

/// One step after the other comes in, and "Deformed" is off meanwhile.
void GltfParts::addAnimation(int node, const std::vector<const MorphTarget*>& targets) {
    const std::size_t keys = m_steps.size() + 1;
    const auto from = std::make_shared<std::vector<std::size_t>>();  // the key at which a target is there
    for (const MorphTarget* const target : targets) {
        from->push_back(target == &m_deformed ? keys : static_cast<std::size_t>(target - m_steps.data()) + 1);
    }
    const std::size_t count = keys * targets.size();
    const int view =
        m_document.addView(count, sizeof(float), gltf::kNeither, [from](PieceWriter& out, std::size_t i) {
            out.plain(i / from->size() >= (*from)[i % from->size()] ? 1.0f : 0.0f);
        });
    const int output = m_document.addAccessor(view, gltf::kFloat, "SCALAR", count);
    m_samplers.append(QJsonObject{{QStringLiteral("input"), times()},
                                  {QStringLiteral("interpolation"), QStringLiteral("LINEAR")},
                                  {QStringLiteral("output"), output}});
    const QJsonObject target{{QStringLiteral("node"), node},
                             {QStringLiteral("path"), QStringLiteral("weights")}};
    m_channels.append(
        QJsonObject{{QStringLiteral("sampler"), m_samplers.size() - 1}, {QStringLiteral("target"), target}});
}

QByteArray GltfParts::json(const QString& bufferFile) {
    QJsonArray nodes;
    for (qsizetype n = 0; n < m_nodes.size(); ++n) {
        nodes.append(n);
    }
    QJsonObject buffer{{QStringLiteral("byteLength"), static_cast<qint64>(m_document.size())}};
    if (!bufferFile.isEmpty()) {
        buffer[QStringLiteral("uri")] = QString::fromLatin1(QUrl::toPercentEncoding(bufferFile));
    }
    QJsonObject root{{QStringLiteral("asset"), QJsonObject{{QStringLiteral("version"), QStringLiteral("2.0")},
                                                           {QStringLiteral("generator"),
                                                            QStringLiteral("Hitscope " HITSCOPE_VERSION)}}},
                     {QStringLiteral("scene"), 0},
                     {QStringLiteral("scenes"), QJsonArray{QJsonObject{{QStringLiteral("nodes"), nodes}}}},
                     {QStringLiteral("nodes"), m_nodes},
                     {QStringLiteral("meshes"), m_meshes},
                     {QStringLiteral("accessors"), m_document.accessors()},
                     {QStringLiteral("bufferViews"), m_document.views()},
                     {QStringLiteral("buffers"), QJsonArray{buffer}}};
    m_materials.addTo(root);
    if (!m_channels.isEmpty()) {
        root[QStringLiteral("animations")] =
            QJsonArray{QJsonObject{{QStringLiteral("name"), QStringLiteral("Hits")},
                                   {QStringLiteral("channels"), m_channels},
                                   {QStringLiteral("samplers"), m_samplers}}};
    }
    return QJsonDocument(root).toJson(QJsonDocument::Compact);
}

QStringList GltfParts::notes() const {
    QStringList notes = m_materials.notes();
    if (m_mesh.cornerVertices.size() != 3 * m_mesh.faceCount()) {
        notes += QStringLiteral("glTF has triangles only: polygons are cut into triangles.");
    }
    if (m_copies > 0) {
        notes +=
            QStringLiteral(
                "Vertices with several normals, texture coordinates, materials or objects%1 are "
                "repeated (%2 added).")
                .arg(m_hasLoose ? QStringLiteral(", and those of faces and of lines or points,") : QString())
                .arg(m_copies);
    }
    if (m_mesh.positions.size() > kMostNumbered) {
        notes += QStringLiteral("There are too many vertices to keep their numbers in the file.");
    }
    if (!m_positions.fitFloats()) {
        notes += QStringLiteral("glTF has floats only; the coordinates are rounded.");
    }
    const auto isGroup = [](const FaceGroup& group) { return group.kind == FaceGroup::Kind::Group; };
    if (std::any_of(m_mesh.groups.begin(), m_mesh.groups.end(), isGroup)) {
        notes += QStringLiteral("glTF has objects, but no groups within them; those are left out.");
    }
    if (m_deformed.deltas.empty()) {
        notes += QStringLiteral("Nothing has moved, so there is no morph target.");
    }
    return notes;
}

}  // namespace hitscope
