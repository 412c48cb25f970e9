// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <random>

#include "io/readers/mtl_reader.h"
#include "io/readers/obj_reader.h"
#include "io/readers/off_reader.h"
#include "io/readers/ply_reader.h"
#include "io/readers/stl_reader.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_mutations_test {

using namespace test;

namespace {

/// Changes, removes or repeats a few pieces of a file, as a broken disk or a hostile person would.
std::string mutate(std::string bytes, std::mt19937& random) {
    static const std::string kPieces[] = {
        "-1",   "99999999999", "nan", "\n", " ", std::string(4, '\xff'), std::string(1, '\0'),
        "1e39", "/",           "\\\n"};
    const auto upTo = [&](std::size_t most) {
        return std::uniform_int_distribution<std::size_t>(0, most)(random);
    };
    for (std::size_t change = upTo(5) + 1; change > 0; --change) {
        const std::size_t at = upTo(bytes.size());
        switch (upTo(4)) {
            case 0:
                if (at < bytes.size()) {
                    bytes[at] = static_cast<char>(upTo(255));
                }
                break;
            case 1:
                bytes.erase(at, upTo(20));
                break;
            case 2:
                bytes.insert(at, kPieces[upTo(std::size(kPieces) - 1)]);
                break;
            case 3:
                bytes.insert(at, bytes.substr(upTo(bytes.size()), upTo(40)));
                break;
            default:
                bytes.resize(at);
        }
    }
    return bytes;
}

const char* const kObj =
    "mtllib a.mtl\no cube\nv 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0.5\nvn 0 0 1\ng a "
    "b\nusemtl m\n"
    "s 1\nf 1/1/1 2/2/1 3/1/1 4/2/1\nf -1//-1 -2//-1 \\\n -3//-1\nl 1 2 3\np 1\ns off\n";
const char* const kMtl =
    "newmtl m\nKa 1 1 1\nKd 0.5 0.5 0.5\nKs 0 0 0\nNs 10\nd 0.5\nmap_Kd -s 1 1 1 wood.png\nillum 2\n";
const char* const kOff =
    "STCNOFF\n3 2 0\n0 0 0 0 0 1 255 0 0 255 0 1\n1 0 0 0 0 1 9 9 9 0 0 0\n0 1 0 0 0 1 0 0 0 0 1 1\n"
    "3 0 1 2\n3 2 1 0 255 0 0\n";
const char* const kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
    "property list uchar int vertex_indices\nproperty list uchar float texcoord\nelement tristrips 1\n"
    "property list int int vertex_indices\nend_header\n"
    "0 0 0 1 2 3\n1 0 0 4 5 6\n0 1 0 7 8 9\n3 0 1 2 6 0 0 1 0 0 1\n5 0 1 2 -1 0\n";

std::string binaryPly() {
    std::string file =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    for (int v = 0; v < 3; ++v) {
        put(file, static_cast<float>(v), static_cast<float>(v * v), 0.1);
    }
    put(file, std::uint8_t{3}, 0, 1, 2);
    return file;
}

std::string binaryStl() {
    std::string file(80, ' ');
    put(file, std::uint32_t{1});
    put(file, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, std::uint16_t{0});
    return file;
}

/// Whatever the bytes: a mesh that passes validate(), or an error that says something.
template <class Parse>
void tryMutations(const std::string& original, const Parse& parse) {
    std::mt19937 random(20240607);
    for (int i = 0; i < 2000; ++i) {
        const std::string bytes = mutate(original, random);
        const Result<ImportedMesh> result = parse(bytes);
        const bool fine = result ? validate(result.value().mesh).ok() : !result.error().what.empty();
        QVERIFY2(fine, qPrintable(QStringLiteral("mutation %1").arg(i)));
    }
}

}  // namespace

class MutationsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void obj() {
        tryMutations(kObj, [](const std::string& bytes) { return parseObj(bytes); });
    }
    void off() {
        tryMutations(kOff, [](const std::string& bytes) { return parseOff(bytes); });
    }
    void ply() {
        tryMutations(kPly, [](const std::string& bytes) { return parsePly(bytes); });
    }
    void plyBinary() {
        tryMutations(binaryPly(), [](const std::string& bytes) { return parsePly(bytes); });
    }
    void stl() {
        tryMutations(binaryStl(), [](const std::string& bytes) { return parseStl(bytes); });
    }
    void mtl() {
        std::mt19937 random(7);
        for (int i = 0; i < 2000; ++i) {
            for (const Material& material : parseMtl(mutate(kMtl, random))) {
                QVERIFY(material.shininess > 0.0f && material.opacity >= 0.0f && material.opacity <= 1.0f);
            }
        }
    }
};

HITSCOPE_TEST(MutationsTest, QCoreApplication)

}  // namespace hitscope::io_mutations_test

#include "io_mutations_test.moc"
