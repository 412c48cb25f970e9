// SPDX-License-Identifier: GPL-3.0-or-later
// Normals that an export adds to an OBJ file, more than it writes at once.
#include <QTemporaryDir>
#include <QTest>

#include "export_support.h"
#include "io/export_obj.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_added_normals_test {

using namespace test;

class AddedNormalsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void addsManyNormals_data();
    void addsManyNormals();

private:
    QTemporaryDir m_folder;
};

void AddedNormalsTest::addsManyNormals_data() {
    QTest::addColumn<bool>("isRelative");
    QTest::newRow("behind the file's own") << false;
    QTest::newRow("at the end of a file that counts from there") << true;
}

void AddedNormalsTest::addsManyNormals() {
    QFETCH(const bool, isRelative);
    constexpr std::size_t kVertices = 30'000;
    std::string vertices;
    std::string moved;
    std::string faces;
    std::string turned;
    std::string added;
    for (std::size_t v = 0; v < kVertices; ++v) {
        const std::string number = std::to_string(v + 1);
        const std::string begin = v % 3 == 0 ? "f " : " ";
        const std::string end = v % 3 == 2 ? "\n" : "";
        const std::string place = "v " + number + (v % 2 == 0 ? " 0" : " 1");
        vertices += place + " 0\n";
        moved += place + " -0.5\n";
        faces += begin + number + (isRelative ? "//-1" : "//1") + end;
        turned += begin + number + "//" + std::to_string(v + 2) + end;
        added += "vn " + number + " 0 0\n";
    }
    const QString source = writeFile(m_folder.path(), QStringLiteral("mesh.obj"),
                                     vertices + "vn 0 0 1\n# faces\n" + faces + "# end");
    const MeshData original = read(source).mesh;
    PageVector<glm::vec3> positions = original.positions;
    for (glm::vec3& position : positions) {
        position.z = -0.5f;
    }
    std::vector<glm::vec3> normals;
    for (std::size_t c = 0; c < kVertices; ++c) {
        normals.emplace_back(static_cast<float>(c + 1), 0.0f, 0.0f);
    }
    ObjExport what = exportOf(original, positions);
    what.normals = {normals, {}};
    what.sourceFolder = m_folder.path();
    what.sourcePath = source;
    const QString target = m_folder.filePath(QStringLiteral("written.obj"));
    QVERIFY(exportObj(what, target));
    const std::string text = readFile(target);
    const std::string wanted = isRelative ? moved + "vn 0 0 1\n# faces\n" + turned + "# end\n" + added
                                          : moved + "vn 0 0 1\n" + added + "# faces\n" + turned + "# end";
    QCOMPARE(text.size(), wanted.size());
    QVERIFY(text == wanted);
}

HITSCOPE_TEST(AddedNormalsTest, QCoreApplication)

}  // namespace hitscope::io_added_normals_test

#include "io_added_normals_test.moc"
