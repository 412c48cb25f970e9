// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <random>
#include <utility>

#include "export_support.h"
#include "io/export_obj.h"
#include "io_support.h"
#include "mesh/same_bits.h"
#include "random_obj.h"
#include "support/test_program.h"

namespace hitscope::io_source_obj_test {

using namespace test;

namespace {

/// Unit normals of a mesh's corners: the file's own, or straight up.
std::vector<glm::vec3> normalsOf(const MeshData& mesh) {
    std::vector<glm::vec3> normals(mesh.cornerVertices.size(), glm::vec3(0, 1, 0));
    for (std::size_t c = 0; c < mesh.cornerNormals.size(); ++c) {
        if (mesh.cornerNormals[c] != kNoIndex) {
            normals[c] = glm::normalize(mesh.normals[mesh.cornerNormals[c]]);
        }
    }
    return normals;
}

}  // namespace

/// OBJ files as the copy of another one, in which only what changed is replaced.
class SourceObjTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void isTheFileWhereNothingMoved_data();
    void isTheFileWhereNothingMoved();
    void replacesWhatChanged_data();
    void replacesWhatChanged();
    void replacesNormals_data();
    void replacesNormals();
    void givesNormalsWhereAsked();
    void undoesThePlacement();
    void renamesLibrariesInTheWay();
    void saysThatTheFileChanged_data();
    void saysThatTheFileChanged();
    void noticesAChangeMeanwhile();
    void copiesLargeFiles();
    void isRightForAnyFile();
    void canBeGivenUp();

private:
    struct Exported {
        std::string text;
        QStringList notes;
    };
    /// `source` as source/mesh.obj, with positions and normals changed by `change`.
    Exported exported(std::string_view source,
                      const std::function<void(MeshData&, std::vector<glm::vec3>&)>& change = {},
                      bool allNormals = false);

    std::unique_ptr<QTemporaryDir> m_folder;
};

void SourceObjTest::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("source")));
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("target")));
}

SourceObjTest::Exported SourceObjTest::exported(
    std::string_view source, const std::function<void(MeshData&, std::vector<glm::vec3>&)>& change,
    bool allNormals) {
    const QString folder = m_folder->filePath(QStringLiteral("source"));
    const QString path = writeFile(folder, QStringLiteral("mesh.obj"), source);
    const MeshData original = read(path).mesh;
    MeshData deformed = original;
    std::vector<glm::vec3> normals = normalsOf(original);
    if (change) {
        change(deformed, normals);
    }
    ObjExport what = exportOf(original, deformed.positions);
    what.normals = {normals, {}};
    what.allNormals = allNormals;
    what.sourceFolder = folder;
    what.sourcePath = path;
    const QString target = m_folder->filePath(QStringLiteral("target/mesh.obj"));
    const Result<QStringList> written = exportObj(what, target);
    if (!written) {
        qWarning("%s", written.error().message().c_str());
        return {};
    }
    return {readFile(target), written.value()};
}

void SourceObjTest::isTheFileWhereNothingMoved_data() {
    QTest::addColumn<QByteArray>("text");
    const QByteArray plain = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    QByteArray crlf = plain;
    QByteArray cr = plain;
    crlf.replace("\n", "\r\n");
    cr.replace('\n', '\r');
    QTest::addRow("plain") << plain;
    QTest::addRow("CRLF") << crlf;
    QTest::addRow("CR") << cr;
    QTest::addRow("all of these") << plain + "v 2 0.50 0\r# a\rf 1 2 4\r\n" + cr + crlf;
    QTest::addRow("mark") << "\xEF\xBB\xBF" + plain;
    QTest::addRow("no line end") << plain.chopped(1);
    QTest::addRow("numbers as they are spelled")
        << QByteArray("v 0.100000 +1. -.5e0\nv 0.3487989902496338 007 -0\nv 1e-400 1E+2 2\nf 1 2 3\n");
    QTest::addRow("more than is used") << QByteArray(
        "# a comment \\\nthat goes on\n\n  v  0\t0 0 1 # w\nv 1 0 0 0.5 0.25 1\nv 0 \\\n 1 \\\r\n0\n"
        "vt 0.12345678901234 1 0.5\nvp 0.1 0.2\ncstype bezier\nusemtl a\nusemtl a\ns 1\ns 1\n"
        "mtllib lost.mtl ./other.mtl\ng\no \xFF\xFE name \ng a b c\nf -3/1 -2/1 -1/1\n\n\n#end");
    QTest::addRow("rich") << QByteArray(kRich);
}

void SourceObjTest::isTheFileWhereNothingMoved() {
    QFETCH(QByteArray, text);
    writeFile(m_folder->filePath(QStringLiteral("source")), QStringLiteral("rich.mtl"), kRichMtl);
    const Exported same = exported(text.toStdString());
    QCOMPARE(QByteArray::fromStdString(same.text), text);
    const QStringList written{QStringLiteral("Also written beside it: rich.mtl.")};
    QCOMPARE(same.notes, text == kRich ? written : QStringList());
}

void SourceObjTest::replacesWhatChanged_data() {
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    QTest::addRow("one coordinate") << QByteArray("v 0.100 0.200 0.300\n")
                                    << QByteArray("v 0.100 7.5 0.300\n");
    QTest::addRow("layout") << QByteArray(" v\t 0.100  2 \t3 0.5 # w\r\n")
                            << QByteArray(" v\t 0.100  7.5 \t3 0.5 # w\r\n");
    QTest::addRow("colours") << QByteArray("v 1 2 3 0.50 0.25 1\n") << QByteArray("v 1 7.5 3 0.50 0.25 1\n");
    QTest::addRow("continued") << QByteArray("v 1 \\\n2\\\n 3\n") << QByteArray("v 1 \\\n7.5\\\n 3\n");
    QTest::addRow("other line ends") << QByteArray("v 1.0 2 3\rvt 0 0\r\n")
                                     << QByteArray("v 1.0 7.5 3\rvt 0 0\r\n");
    QTest::addRow("other line ends before it")
        << QByteArray("\rvp 1\rv 1 2 \\\r3\r\rs 1\r") << QByteArray("\rvp 1\rv 1 7.5 \\\r3\r\rs 1\r");
    QTest::addRow("continued keyword") << QByteArray("v\\\n 1 2 3\n") << QByteArray("v\\\n 1 7.5 3\n");
}

void SourceObjTest::replacesWhatChanged() {
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    const QByteArray head = "# v 9 9 9 \\\nv 9 9 9\nv 5 5 5\n";
    const QByteArray tail = "v 0 0 1\nv 3 3 3\nf 1 2 3\nf 1 2\nf 2 3 4 # face\n";
    const Exported moved =
        exported((head + before + tail).toStdString(),
                 [](MeshData& mesh, std::vector<glm::vec3>&) { mesh.positions[2].y = 7.5f; });
    QCOMPARE(QByteArray::fromStdString(moved.text), head + after + tail);
}

void SourceObjTest::replacesNormals_data() {
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    const QByteArray vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nv 8 9 9\nv 9 8 9\n";
    QTest::addRow("of one vertex")
        << vertices + "vn 0 0 2 # a\nvn 0 1 0\nvn 1 0 0\nf 1//1 2//2 3//3\nf 4//3 5//3 6//3\n"
        << vertices + "vn 1 0 0 # a\nvn 0 1 0\nvn 1 0 0\nf 1//1 2//2 3//3\nf 4//3 5//3 6//3\n";
    QTest::addRow("that others share")
        << vertices + "vt 0 0\nvn 0 0 1\n# faces\nf 1/1/1 2//1 3/1/1 # first\nf 4//1 5//1 6//1\n"
        << vertices + "vt 0 0\nvn 0 0 1\nvn 1 0 0\n# faces\nf 1/1/2 2//1 3/1/1 # first\nf 4//1 5//1 6//1\n";
    const auto withReturns = [](QByteArray text) { return text.replace("\n", "\r\n"); };
    QTest::addRow("that others share, with CRLF")
        << withReturns(vertices + "vn 0 0 1\nf 1//1 2//1 3//1\nf 4//1 5//1 6//1\n")
        << withReturns(vertices + "vn 0 0 1\nvn 1 0 0\nf 1//2 2//1 3//1\nf 4//1 5//1 6//1\n");
    QTest::addRow("between all sorts of blanks")
        << vertices + "vn 0 0 1\nf\t1//1\t2//1  3//1\nf  4//1\t5//1 6//1 \n"
        << vertices + "vn 0 0 1\nvn 1 0 0\nf\t1//2\t2//1  3//1\nf  4//1\t5//1 6//1 \n";
    QTest::addRow("beside long numbers")
        << vertices +
               "vt 0 0\nvn 0 0 1\nf 000000000001/0000000001/1 2/1/1\t3/1/1\nf 4/1/00000000000001 5//1 6//1\n"
        << vertices +
               "vt 0 0\nvn 0 0 1\nvn 1 0 0\nf 000000000001/0000000001/2 2/1/1\t3/1/1\n"
               "f 4/1/00000000000001 5//1 6//1\n";
    QTest::addRow("counted from the end")
        << vertices + "vn 0 0 1\nf -6//-1 2//-1 3//-1\nf 4//1 5//1 6//-1"
        << vertices + "vn 0 0 1\nf -6//2 2//-1 3//-1\nf 4//1 5//1 6//-1\nvn 1 0 0\n";
    for (const char* const end : {"", "\n"}) {
        const QByteArray cut = "f 4//1 5//1 6//-1 \\";  // would go on with the line that is added
        QTest::addRow("counted from the end, continued, and %d line ends", *end == 0 ? 0 : 1)
            << vertices + "vn 0 0 1\nf -6//-1 2//-1 3//-1\n" + cut + end
            << vertices + "vn 0 0 1\nf -6//2 2//-1 3//-1\n" + cut + "\n\nvn 1 0 0\n";
    }
    QTest::addRow("beside one that is not there")
        << vertices + "vn 0 0 1\nf 1//1 2//2 3//1\nf 4//1 5//7 6//\n"
        << vertices + "vn 0 0 1\nvn 1 0 0\nf 1//2 2 3//1\nf 4//1 5 6\n";
    QTest::addRow("of corners that have none") << vertices + "vn 0 0 1\nf 1 2//1 3//1\nf 4 5 6\n"
                                               << vertices + "vn 0 0 1\nf 1 2//1 3//1\nf 4 5 6\n";
}

// The first vertex moves, and the normal of the first corner turns.
void SourceObjTest::replacesNormals() {
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    const Exported moved =
        exported(before.toStdString(), [](MeshData& mesh, std::vector<glm::vec3>& normals) {
            mesh.positions[0].z = -0.5f;
            normals[0] = {1, 0, 0};
        });
    after.replace("v 0 0 0", "v 0 0 -0.5");
    QCOMPARE(QByteArray::fromStdString(moved.text), after);
}

void SourceObjTest::givesNormalsWhereAsked() {
    const std::string before = "v 0 0 0\nv 1 0 0\nv 0 1 0\ng a\nf 1 2/ 3/1\n";
    QCOMPARE(exported(before + "vt 0 0\n").text, before + "vt 0 0\n");
    QCOMPARE(exported(before + "vt 0 0\n", {}, true).text,
             std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\ng a\nvn 0 1 0\nf 1//1 2//1 3/1/1\nvt 0 0\n"));
}

void SourceObjTest::undoesThePlacement() {
    const QString folder = m_folder->filePath(QStringLiteral("source"));
    const QString path =
        writeFile(folder, QStringLiteral("far.obj"), "v 100.10 0.0 0\nv 104.1 0 0\nv 100.1 2 0\nf 1 2 3\n");
    MeshData placed = read(path).mesh;
    place(placed, 1.0f);
    PageVector<glm::vec3> positions = placed.positions;
    positions[1].z = 0.25f;  // of an extent of 4 in the file
    ObjExport what = exportOf(placed, positions);
    what.sourceFolder = folder;
    what.sourcePath = path;
    const QString target = m_folder->filePath(QStringLiteral("target/far.obj"));
    QVERIFY(exportObj(what, target).ok());
    QCOMPARE(readFile(target), std::string("v 100.10 0.0 0\nv 104.1 0 1\nv 100.1 2 0\nf 1 2 3\n"));
}

void SourceObjTest::renamesLibrariesInTheWay() {
    const QString target = m_folder->filePath(QStringLiteral("target"));
    writeFile(m_folder->filePath(QStringLiteral("source")), QStringLiteral("rich.mtl"), kRichMtl);
    writeFile(target, QStringLiteral("rich.mtl"), "newmtl another\n");
    std::string wanted = kRich;
    wanted.replace(wanted.find("rich.mtl"), 8, "rich-1.mtl");
    QCOMPARE(exported(kRich).text, wanted);
    QCOMPARE(readFile(target + QStringLiteral("/rich-1.mtl")), std::string(kRichMtl));
    QCOMPARE(readFile(target + QStringLiteral("/rich.mtl")), std::string("newmtl another\n"));
}

void SourceObjTest::saysThatTheFileChanged_data() {
    QTest::addColumn<QByteArray>("now");
    QTest::addColumn<QString>("note");
    QTest::addRow("gone") << QByteArray() << QStringLiteral("“mesh.obj” is not there any more");
    QTest::addRow("changed") << QByteArray("# A\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
                             << QStringLiteral("“mesh.obj” has changed since it was opened");
}

void SourceObjTest::saysThatTheFileChanged() {
    QFETCH(QByteArray, now);
    QFETCH(QString, note);
    const Exported written =
        exported("# a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", [&](MeshData&, std::vector<glm::vec3>&) {
            const QString path = m_folder->filePath(QStringLiteral("source/mesh.obj"));
            QVERIFY(QFile::remove(path));
            if (!now.isEmpty()) {
                writeFile(m_folder->filePath(QStringLiteral("source")), QStringLiteral("mesh.obj"),
                          now.toStdString());
            }
        });
    QCOMPARE(written.notes.size(), 1);
    QVERIFY2(written.notes.first().startsWith(note), qPrintable(written.notes.first()));
    QVERIFY(written.text.starts_with("# Written by Hitscope"));
}

// Somebody writes to the file while it is copied.
void SourceObjTest::noticesAChangeMeanwhile() {
    const QString folder = m_folder->filePath(QStringLiteral("source"));
    const QString path = writeFile(folder, QStringLiteral("mesh.obj"), kRich);
    const MeshData mesh = read(path).mesh;
    ObjExport what = exportOf(mesh, mesh.positions);
    what.sourceFolder = folder;
    what.sourcePath = path;
    bool isChanged = false;
    what.goOn = [&](ExportStep, double) {
        if (!std::exchange(isChanged, true)) {
            writeFile(folder, QStringLiteral("mesh.obj"), std::string(kRich) + "# more\n");
        }
        return true;
    };
    const QString target = m_folder->filePath(QStringLiteral("target/mesh.obj"));
    const Result<QStringList> written = exportObj(what, target);
    QVERIFY(written.ok());
    QVERIFY2(written.value().join(u' ').contains(QStringLiteral("has changed")),
             qPrintable(written.value().join(u' ')));
    QVERIFY(readFile(target).starts_with("# Written by Hitscope"));
}

// More than one piece, whose ends fall into lines.
void SourceObjTest::copiesLargeFiles() {
    std::string text;
    for (int v = 0; v < 150'000; ++v) {
        text += v % 50 == 0 ? "v " + std::to_string(v) + ".0 \\\n0.50 1\n"
                            : "v " + std::to_string(v) + ".0 0.50 1\n";
    }
    text += "f 1 2 3\n# " + std::string(3 << 20, '-') + "\nf 149998 149999 150000\n";
    QCOMPARE(exported(text).text == text, true);
    const std::vector<std::size_t> moving = {0, 50'000, 99'999, 149'999};
    std::string wanted = text;
    for (const std::size_t v : moving) {
        const std::size_t line = wanted.find("v " + std::to_string(v) + ".0 ");
        wanted.replace(wanted.find(".50 1", line), 3, ".625");
    }
    const Exported moved = exported(text, [&](MeshData& mesh, std::vector<glm::vec3>&) {
        for (const std::size_t v : moving) {
            mesh.positions[v].y = 0.625f;
        }
    });
    QCOMPARE(moved.text == wanted, true);
    // All of them: those too whose lines are cut by a piece's end.
    const QByteArray all = QByteArray::fromStdString(text).replace("0.50 1", "0.625 1");
    const Exported every = exported(text, [](MeshData& mesh, std::vector<glm::vec3>&) {
        for (glm::vec3& position : mesh.positions) {
            position.y = 0.625f;
        }
    });
    QCOMPARE(every.text == all.toStdString(), true);
}

void SourceObjTest::isRightForAnyFile() {
    std::mt19937 random(7);
    for (int tried = 0; tried < 150; ++tried) {
        const std::string text = randomObj(random);
        QCOMPARE(QByteArray::fromStdString(exported(text).text), QByteArray::fromStdString(text));
        MeshData wanted;
        std::vector<glm::vec3> normals;
        const Exported moved = exported(text, [&](MeshData& mesh, std::vector<glm::vec3>& cornerNormals) {
            for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
                mesh.positions[v] += random() % 3 == 0 ? glm::vec3(0.1f, 0.0f, -7.3f) : glm::vec3(0.0f);
            }
            for (std::size_t c = 0; c < cornerNormals.size(); ++c) {
                const bool moves =
                    !sameBits(mesh.positions[mesh.cornerVertices[c]], glm::vec3(0.0f)) && random() % 3 == 0;
                cornerNormals[c] = moves ? glm::vec3(1, 0, 0) : cornerNormals[c];
            }
            wanted = mesh;
            normals = cornerNormals;
        });
        QCOMPARE(moved.notes, QStringList());
        writeFile(m_folder->path(), QStringLiteral("moved.obj"), moved.text);
        const MeshData again = read(m_folder->filePath(QStringLiteral("moved.obj"))).mesh;
        QVERIFY2(again.positions.size() == wanted.positions.size() &&
                     std::equal(again.positions.begin(), again.positions.end(), wanted.positions.begin(),
                                [](const glm::vec3& a, const glm::vec3& b) { return sameBits(a, b); }),
                 text.c_str());
        QCOMPARE(again.cornerVertices, wanted.cornerVertices);
        QCOMPARE(again.faceStarts, wanted.faceStarts);
        QCOMPARE(again.lines, wanted.lines);
        QCOMPARE(again.groups.size(), wanted.groups.size());
        for (std::size_t c = 0; c < again.cornerNormals.size(); ++c) {
            const bool has = wanted.cornerNormals[c] != kNoIndex;
            QVERIFY2(has == (again.cornerNormals[c] != kNoIndex), text.c_str());
            const glm::vec3 now = has ? glm::normalize(again.normals[again.cornerNormals[c]]) : glm::vec3(0);
            const glm::vec3 before =
                has ? glm::normalize(wanted.normals[wanted.cornerNormals[c]]) : glm::vec3(0);
            // A normal changes only where a vertex of a face did.
            QVERIFY2(!has || glm::distance(now, normals[c]) < 1e-5f || glm::distance(now, before) < 1e-5f,
                     (text + "\n=====\n" + moved.text).c_str());
        }
    }
}

void SourceObjTest::canBeGivenUp() {
    const QString folder = m_folder->filePath(QStringLiteral("source"));
    const QString path = writeFile(folder, QStringLiteral("mesh.obj"), kRich);
    const MeshData mesh = read(path).mesh;
    const QString target = writeFile(m_folder->path(), QStringLiteral("target/mesh.obj"), "what was there");
    for (int steps = 0; steps < 2; ++steps) {
        ObjExport what = exportOf(mesh, mesh.positions);
        what.sourceFolder = folder;
        what.sourcePath = path;
        what.goOn = [left = steps](ExportStep, double) mutable { return left-- > 0; };
        const Result<QStringList> written = exportObj(what, target);
        QVERIFY(!written.ok());
        QCOMPARE(written.error().what, std::string("The export was cancelled."));
        QCOMPARE(readFile(target), std::string("what was there"));
        QCOMPARE(
            QDir(m_folder->filePath(QStringLiteral("target"))).entryList(QDir::Files | QDir::Hidden).size(),
            1);
    }
}

HITSCOPE_TEST(SourceObjTest, QCoreApplication)

}  // namespace hitscope::io_source_obj_test

#include "io_source_obj_test.moc"
