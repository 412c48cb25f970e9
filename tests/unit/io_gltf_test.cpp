// SPDX-License-Identifier: GPL-3.0-or-later
// What glTF files hold beyond the plain ones of io_formats_test.
#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "gltf_support.h"
#include "io/import.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_gltf_test {

using namespace test;

class GltfTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void encodedNames_data();
    void encodedNames();
    void encodedNamesStayInTheFolder();
    void encodedPictures();

private:
    QString write(const QString& name, const std::string& content) {
        return writeFile(m_folder.path(), name, content);
    }
    QTemporaryDir m_folder;
};

void GltfTest::encodedNames_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("uri");
    QTest::newRow("a blank") << "a b.bin"
                             << "a%20b.bin";
    QTest::newRow("beyond ASCII") << QStringLiteral("m\u00fchle.bin") << "m%C3%BChle.bin";
    QTest::newRow("not encoded") << "a b c.bin"
                                 << "a b c.bin";
    QTest::newRow("a percent sign") << "5%25.bin"
                                    << "5%25.bin";
    QTest::newRow("in a folder") << "in ner/a.bin"
                                 << "in%20ner/a.bin";
}

void GltfTest::encodedNames() {
    QFETCH(QString, file);
    QFETCH(QString, uri);
    QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("in ner")));
    const GltfFile triangle = triangleFile();
    write(file, triangle.numbers);
    const Result<ImportedMesh> read = importMesh(write(QStringLiteral("a.gltf"), triangle.text(uri)));
    QVERIFY2(read.ok(), qPrintable(messageOf(read)));
    QCOMPARE(read.value().mesh.positions[1], glm::vec3(100, 0, 0));
}

/// The folder's own name is no URI.
void GltfTest::encodedNamesStayInTheFolder() {
    QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("5%20in")));
    const GltfFile triangle = triangleFile();
    write(QStringLiteral("out.bin"), triangle.numbers);
    for (const char* const uri : {"%2e%2e/out.bin", "%2E%2E%2Fout.bin", "..%5cout.bin", "%2e./out.bin"}) {
        const Result<ImportedMesh> read =
            importMesh(write(QStringLiteral("5%20in/a.gltf"), triangle.text(QString::fromLatin1(uri))));
        QVERIFY2(!read.ok(), uri);
        QVERIFY2(messageOf(read).contains(QStringLiteral("could not open referenced file")),
                 qPrintable(messageOf(read)));
    }
    write(QStringLiteral("5%20in/a b.bin"), triangle.numbers);
    const QString path =
        write(QStringLiteral("5%20in/a.gltf"), triangle.text(QStringLiteral("./x%2F../a%20b.bin")));
    QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("5%20in/x")));
    const Result<ImportedMesh> read = importMesh(path);
    QVERIFY2(read.ok(), qPrintable(messageOf(read)));
}

void GltfTest::encodedPictures() {
    write(QStringLiteral("my tex.png"), smallPng().toStdString());
    GltfFile file = triangleFile();
    file.primitive = {{QStringLiteral("material"), 0}};
    const QByteArray material = R"({"images": [{"uri": "my%20tex.png"}, {"uri": "gone%20too.png"}],
        "textures": [{"source": 0}, {"source": 1}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0},
                       "metallicRoughnessTexture": {"index": 0}}, "normalTexture": {"index": 1}}]})";
    file.more = QJsonDocument::fromJson(material).object();
    const Result<ImportedMesh> read = importMesh(write(QStringLiteral("p.gltf"), file.text()));
    QVERIFY2(read.ok(), qPrintable(messageOf(read)));
    const Material& paint = read.value().mesh.materials.at(0);
    QCOMPARE(paint.diffuseTexture, std::string("my tex.png"));
    QCOMPARE(paint.diffuseImage, 0);
    QCOMPARE(paint.metalRoughness.image, 0);
    QCOMPARE(read.value().mesh.pictureFiles, std::vector<std::string>{"my tex.png"});
    QCOMPARE(paint.normalMap.texture, std::string("gone%20too.png"));
}

HITSCOPE_TEST(GltfTest, QCoreApplication)

}  // namespace hitscope::io_gltf_test

#include "io_gltf_test.moc"
