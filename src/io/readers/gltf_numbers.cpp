// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/gltf_numbers.h"

#include <QFile>
#include <QJsonArray>
#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "io/file_scope.h"
#include "io/readers/gltf_json.h"
#include "io/readers/gltf_texture_transform.h"

namespace hitscope {
namespace {

constexpr std::uint64_t kByteKind = 5120;
constexpr std::uint64_t kUnsignedByteKind = 5121;
constexpr std::uint64_t kShortKind = 5122;
constexpr std::uint64_t kUnsignedShortKind = 5123;
constexpr std::uint64_t kFloatKind = 5126;

constexpr const char* kAdvice = "Export it without quantisation from the program it came from.";

template <class Number>
Number numberAt(const char* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return number;
}

template <class Number>
float scaled(const char* bytes, bool isNormalised) {
    const auto value = static_cast<float>(numberAt<Number>(bytes));
    return isNormalised ? std::max(value / static_cast<float>(std::numeric_limits<Number>::max()), -1.0f)
                        : value;
}

/// glTF 2.0, section 3.6.2.2, and KHR_mesh_quantization.
float floatAt(const char* bytes, std::uint64_t kind, bool isNormalised) {
    switch (kind) {
        case kByteKind:
            return scaled<std::int8_t>(bytes, isNormalised);
        case kUnsignedByteKind:
            return scaled<std::uint8_t>(bytes, isNormalised);
        case kShortKind:
            return scaled<std::int16_t>(bytes, isNormalised);
        case kUnsignedShortKind:
            return scaled<std::uint16_t>(bytes, isNormalised);
        default:
            return numberAt<float>(bytes);
    }
}

/// Numbers that lie in steps of so many bytes.
struct Strided {
    std::string_view bytes;
    std::uint64_t step = 0;
};

class GltfDecoder {
public:
    GltfDecoder(QJsonObject& root, std::string_view binary, const QString& folder)
        : m_root(root), m_binary(binary), m_folder(folder), m_bytes(m_buffers.size()) {}

    std::string run();

private:
    void lookAt(const QJsonObject& attributes, bool isCompressed);
    void lookAt(const QString& attribute, std::size_t accessor, bool isCompressed);
    [[nodiscard]] std::string_view bytesOf(std::size_t buffer);
    [[nodiscard]] Strided numbersOf(const QJsonObject& from, std::uint64_t count, std::uint64_t element);
    [[nodiscard]] std::uint64_t stepOf(const QJsonObject& accessor) const;
    [[nodiscard]] std::vector<float> floatsOf(const QJsonObject& accessor, bool isNormalised);
    void replaceSome(const QJsonObject& accessor, bool isNormalised, std::vector<float>& values);
    [[nodiscard]] QJsonObject withFloats(QJsonObject accessor, const std::vector<float>& values);
    void decode(std::size_t accessor, bool isNormalised);
    void moveTexcoords(QJsonObject& primitive);
    QJsonArray lookAtPrimitives(const QJsonArray& primitives);

    QJsonObject& m_root;
    std::string_view m_binary;
    QString m_folder;
    GltfThings m_buffers{m_root, "buffers", "a buffer"};
    GltfThings m_views{m_root, "bufferViews", "a buffer view"};
    GltfThings m_accessors{m_root, "accessors", "an accessor"};
    std::vector<std::optional<QByteArray>> m_bytes;  ///< of buffers, read when they are needed
    std::set<std::size_t> m_known;                   ///< accessors that were decoded
    QJsonArray m_newAccessors = m_root.value(QLatin1String("accessors")).toArray();
    QJsonArray m_newViews = m_root.value(QLatin1String("bufferViews")).toArray();
    std::string m_decoded;
    std::vector<MaterialTransform> m_transforms = textureTransformsOf(m_root);
    std::map<std::pair<std::size_t, std::size_t>, qsizetype>
        m_moved;  ///< of accessor and material: the new one
};

std::string_view GltfDecoder::bytesOf(std::size_t buffer) {
    const QString uri = m_buffers[buffer].value(QLatin1String("uri")).toString();
    if (uri.isEmpty()) {
        return m_binary;
    }
    std::optional<QByteArray>& bytes = m_bytes[buffer];
    const qsizetype comma = uri.indexOf(QLatin1Char(','));
    if (!bytes && uri.startsWith(QLatin1String("data:"))) {
        bytes = QByteArray::fromBase64(uri.mid(comma + 1).toLatin1());
    } else if (!bytes) {
        QFile file(resolveUri(m_folder, uri));
        if (file.fileName().isEmpty() || !file.open(QIODevice::ReadOnly)) {
            throw BadGltf("could not open referenced file \"" + uri.toStdString() + "\"");
        }
        bytes = file.readAll();
    }
    return {bytes->constData(), static_cast<std::size_t>(bytes->size())};
}

/// `from`: an accessor, or what it is replaced by where it is sparse. As many as `count`, or BadGltf.
Strided GltfDecoder::numbersOf(const QJsonObject& from, std::uint64_t count, std::uint64_t element) {
    const QJsonObject& view = m_views[m_views.find(from.value(QLatin1String("bufferView")))];
    std::string_view bytes = bytesOf(m_buffers.find(view.value(QLatin1String("buffer"))));
    for (const QJsonObject* each : {&view, &from}) {
        bytes.remove_prefix(std::min<std::size_t>(gltfNumber(*each, "byteOffset"), bytes.size()));
        bytes = bytes.substr(0, gltfNumber(*each, "byteLength", bytes.size()));
    }
    const std::uint64_t stride = gltfNumber(view, "byteStride");
    const std::uint64_t step = stride == 0 ? element : stride;
    if (count > 0 && (bytes.size() < element || (bytes.size() - element) / step < count - 1)) {
        throw BadGltf("an accessor goes on behind the end of its buffer");
    }
    return {bytes, step};
}

/// Zero: they are one after the other.
std::uint64_t GltfDecoder::stepOf(const QJsonObject& accessor) const {
    const QJsonValue view = accessor.value(QLatin1String("bufferView"));
    const std::uint64_t element = gltfComponentBytes(accessor) * gltfComponentCount(accessor);
    const std::uint64_t step = view.isUndefined() ? 0 : gltfNumber(m_views[m_views.find(view)], "byteStride");
    return step == element ? 0 : step;
}

std::vector<float> GltfDecoder::floatsOf(const QJsonObject& accessor, bool isNormalised) {
    const std::uint64_t count = gltfNumber(accessor, "count");
    const std::uint64_t components = gltfComponentCount(accessor);
    const std::uint64_t size = gltfComponentBytes(accessor);
    const std::uint64_t kind = gltfNumber(accessor, "componentType");
    std::vector<float> values(count * components, 0.0f);
    if (accessor.contains(QLatin1String("bufferView"))) {
        const Strided from = numbersOf(accessor, count, size * components);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::size_t at = i / components * from.step + i % components * size;
            values[i] = floatAt(from.bytes.data() + at, kind, isNormalised);
        }
    }
    replaceSome(accessor, isNormalised, values);
    return values;
}

void GltfDecoder::replaceSome(const QJsonObject& accessor, bool isNormalised, std::vector<float>& values) {
    const QJsonObject sparse = accessor.value(QLatin1String("sparse")).toObject();
    if (sparse.isEmpty()) {
        return;
    }
    const std::uint64_t count = gltfNumber(sparse, "count");
    const std::uint64_t components = gltfComponentCount(accessor);
    const std::uint64_t size = gltfComponentBytes(accessor);
    const QJsonObject places = sparse.value(QLatin1String("indices")).toObject();
    const std::uint64_t placeKind = gltfNumber(places, "componentType");
    const Strided placesFrom = numbersOf(places, count, gltfComponentBytes(places));
    const Strided from =
        numbersOf(sparse.value(QLatin1String("values")).toObject(), count, size * components);
    for (std::uint64_t i = 0; i < count; ++i) {
        const char* const at = placesFrom.bytes.data() + i * placesFrom.step;
        const std::uint64_t place = placeKind == kUnsignedByteKind    ? numberAt<std::uint8_t>(at)
                                    : placeKind == kUnsignedShortKind ? numberAt<std::uint16_t>(at)
                                                                      : numberAt<std::uint32_t>(at);
        if (place >= values.size() / components) {
            throw BadGltf("a sparse accessor replaces a number that it does not have");
        }
        for (std::uint64_t c = 0; c < components; ++c) {
            values[place * components + c] = floatAt(from.bytes.data() + i * from.step + c * size,
                                                     gltfNumber(accessor, "componentType"), isNormalised);
        }
    }
}

QJsonObject GltfDecoder::withFloats(QJsonObject accessor, const std::vector<float>& values) {
    const std::size_t bytes = values.size() * sizeof(float);
    for (const char* const key : {"sparse", "normalized", "byteOffset", "min", "max"}) {
        accessor.remove(QLatin1String(key));
    }
    accessor[QLatin1String("componentType")] = static_cast<int>(kFloatKind);
    accessor[QLatin1String("bufferView")] = m_newViews.size();
    m_newViews.append(QJsonObject{{QStringLiteral("buffer"), static_cast<qint64>(m_buffers.size())},
                                  {QStringLiteral("byteOffset"), static_cast<qint64>(m_decoded.size())},
                                  {QStringLiteral("byteLength"), static_cast<qint64>(bytes)}});
    m_decoded.append(reinterpret_cast<const char*>(values.data()), bytes);
    return accessor;
}

void GltfDecoder::decode(std::size_t accessor, bool isNormalised) {
    if (m_known.insert(accessor).second) {
        const QJsonObject& from = m_accessors[accessor];
        m_newAccessors[static_cast<qsizetype>(accessor)] = withFloats(from, floatsOf(from, isNormalised));
    }
}

/// As the primitive's material wants them: textures are looked up at its texture coordinates.
void GltfDecoder::moveTexcoords(QJsonObject& primitive) {
    const auto material = static_cast<std::size_t>(primitive.value(QLatin1String("material")).toInteger(-1));
    QJsonObject attributes = primitive.value(QLatin1String("attributes")).toObject();
    const QJsonValue texcoords = attributes.value(QLatin1String("TEXCOORD_0"));
    if (texcoords.isUndefined() || material >= m_transforms.size() ||
        m_transforms[material].main == TextureTransform()) {
        return;
    }
    const std::size_t accessor = m_accessors.find(texcoords);
    const auto [moved, isNew] = m_moved.try_emplace({accessor, material}, m_newAccessors.size());
    if (isNew) {
        const QJsonObject& from = m_accessors[accessor];
        const std::uint64_t step = gltfComponentCount(from);
        std::vector<float> values = floatsOf(from, from.value(QLatin1String("normalized")).toBool());
        for (std::size_t i = 0; i + 1 < values.size(); i += step) {
            const glm::vec2 place = m_transforms[material].main.apply({values[i], values[i + 1]});
            values[i] = place.x;
            values[i + 1] = place.y;
        }
        m_newAccessors.append(withFloats(from, values));
    }
    attributes[QLatin1String("TEXCOORD_0")] = moved->second;
    primitive[QLatin1String("attributes")] = attributes;
}

/// How many numbers an attribute's value has; 0: that is not looked at.
std::uint64_t componentsOf(const QString& attribute) {
    return attribute == QLatin1String("POSITION") || attribute == QLatin1String("NORMAL") ? 3
           : attribute.startsWith(QLatin1String("TEXCOORD_"))                             ? 2
                                                                                          : 0;
}

void GltfDecoder::lookAt(const QString& attribute, std::size_t index, bool isCompressed) {
    const QJsonObject& accessor = m_accessors[index];
    const std::uint64_t wanted = componentsOf(attribute);
    const std::uint64_t given = gltfComponentCount(accessor);
    const std::uint64_t kind = gltfNumber(accessor, "componentType");
    const bool isTangent = attribute == QLatin1String("TANGENT");
    const auto name = [&] { return "its " + attribute.toStdString(); };
    // More texture coordinates than two do no harm.
    if (given < wanted || (wanted == 3 && given > wanted)) {
        throw BadGltf(name() + " is of the type " +
                      accessor.value(QLatin1String("type")).toString().toStdString() + ", not VEC" +
                      std::to_string(wanted));
    }
    if (wanted > 0 && (kind < kByteKind || kind > kUnsignedShortKind) && kind != kFloatKind) {
        throw BadGltf(name() + " is of numbers of the component type " + std::to_string(kind) +
                      ", not of floats");
    }
    const bool isInterleaved = accessor.contains(QLatin1String("sparse")) && stepOf(accessor) > 0;
    const bool isColour = attribute.startsWith(QLatin1String("COLOR_"));
    const bool isSmall = (wanted > 0 || isTangent) && kind != kFloatKind;
    if (!isSmall && !(isInterleaved && (wanted > 0 || isTangent || isColour))) {
        return;
    }
    if (m_accessors.areNamed() || (isCompressed && !accessor.contains(QLatin1String("bufferView")))) {
        throw BadGltf(name() + " is quantised, which is read neither in glTF 1.0 nor where it is compressed",
                      kAdvice);
    }
    // Lengths are small there: a normal that does not say so would be up to 32767 long.
    const bool isUnit = isTangent || attribute == QLatin1String("NORMAL");
    decode(index, isUnit || isColour || accessor.value(QLatin1String("normalized")).toBool());
}

void GltfDecoder::lookAt(const QJsonObject& attributes, bool isCompressed) {
    for (auto it = attributes.begin(); it != attributes.end(); ++it) {
        lookAt(it.key(), m_accessors.find(it.value()), isCompressed);
    }
}

QJsonArray GltfDecoder::lookAtPrimitives(const QJsonArray& primitives) {
    QJsonArray changed;
    for (const QJsonValue& each : primitives) {
        QJsonObject primitive = each.toObject();
        const bool isCompressed = primitive.value(QLatin1String("extensions"))
                                      .toObject()
                                      .contains(QLatin1String("KHR_draco_mesh_compression"));
        lookAt(primitive.value(QLatin1String("attributes")).toObject(), isCompressed);
        for (const QJsonValue& target : primitive.value(QLatin1String("targets")).toArray()) {
            lookAt(target.toObject(), false);
        }
        const QJsonValue indices = primitive.value(QLatin1String("indices"));
        if (const QJsonObject* const of =
                indices.isUndefined() ? nullptr : &m_accessors[m_accessors.find(indices)];
            of && of->contains(QLatin1String("sparse")) && stepOf(*of) > 0) {
            throw BadGltf("its indices are sparse and interleaved");
        }
        if (!isCompressed) {
            moveTexcoords(primitive);
        }
        changed.append(primitive);
    }
    return changed;
}

std::string GltfDecoder::run() {
    const GltfThings meshes(m_root, "meshes", "a mesh");
    QJsonArray changed;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        QJsonObject mesh = meshes[m];
        mesh[QLatin1String("primitives")] =
            lookAtPrimitives(mesh.value(QLatin1String("primitives")).toArray());
        changed.append(mesh);
    }
    if (!m_moved.empty()) {
        m_root[QLatin1String("meshes")] = changed;
    }
    if (!m_decoded.empty()) {
        QJsonArray buffers = m_root.value(QLatin1String("buffers")).toArray();
        buffers.append(QJsonObject{{QStringLiteral("byteLength"), static_cast<qint64>(m_decoded.size())},
                                   {QStringLiteral("uri"), QLatin1String(kDecodedGltfBuffer)}});
        m_root[QLatin1String("buffers")] = buffers;
        m_root[QLatin1String("bufferViews")] = m_newViews;
        m_root[QLatin1String("accessors")] = m_newAccessors;
    }
    return std::move(m_decoded);
}

}  // namespace

std::string decodeGltf(QJsonObject& root, std::string_view binary, const QString& folder) {
    return GltfDecoder(root, binary, folder).run();
}

}  // namespace hitscope
