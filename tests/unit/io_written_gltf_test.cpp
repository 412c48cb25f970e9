// SPDX-License-Identifier: GPL-3.0-or-later
// How a glTF file is read back: files that are none, and that it ends soon where nobody wants it.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <vector>

#include "core/give_up.h"
#include "io/check/written_check.h"
#include "io/writers/mesh_export.h"
#include "support/test_program.h"
#include "write_support.h"

namespace hitscope::io_written_gltf_test {

using namespace test;

namespace {

std::string gridText(int side) {
    std::string text;
    for (int i = 0; i < side * side; ++i) {
        text += "v " + std::to_string(i % side) + " " + std::to_string(i / side) + " 0\n";
    }
    for (int i = 0; i < side * (side - 1); ++i) {
        if (i % side + 1 < side) {
            const auto corner = [i](int more) { return " " + std::to_string(i + 1 + more); };
            text += "f" + corner(0) + corner(1) + corner(side + 1) + corner(side) + "\n";
        }
    }
    return text;
}

}  // namespace

class TestIoWrittenGltf : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatIsNoGlbIsSaid_data() {
        QTest::addColumn<int>("at");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("says");
        QTest::newRow("magic") << 0 << QByteArray("glTf") << QStringLiteral("its header");
        QTest::newRow("version") << 4 << QByteArray("\1", 1) << QStringLiteral("its header");
        QTest::newRow("size") << 8 << QByteArray("\1", 1) << QStringLiteral("its header");
        QTest::newRow("JSON too long") << 15 << QByteArray("\1", 1) << QStringLiteral("ends too early");
        QTest::newRow("JSON too short") << 12 << QByteArray("\4\0", 2) << QStringLiteral("its parts");
        QTest::newRow("no JSON") << 16 << QByteArray("NOSJ") << QStringLiteral("its parts");
        QTest::newRow("no object") << 20 << QByteArray("[") << QStringLiteral("cannot be read");
    }
    void whatIsNoGlbIsSaid() {
        QFETCH(int, at);
        QFETCH(QByteArray, bytes);
        QFETCH(QString, says);
        QTemporaryDir folder;
        const DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"), gridText(3)));
        const QString path = folder.filePath(QStringLiteral("b ~$HOME ä.glb"));
        QVERIFY(exportGltf(mesh.what(), path, {}));
        const Status sound = verifyWritten(path, mesh.what());
        QVERIFY2(sound, qPrintable(messageOf(sound)));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadWrite) && file.seek(at) && file.write(bytes) == bytes.size());
        file.close();
        const Status broken = verifyWritten(path, mesh.what());
        QVERIFY(!broken);
        QVERIFY2(messageOf(broken).contains(says), qPrintable(messageOf(broken)));
    }

    void cutShortItIsSaid() {
        QTemporaryDir folder;
        const DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"), gridText(3)));
        for (const char* const name : {"b.glb", "b.gltf"}) {
            const QString path = folder.filePath(QLatin1String(name));
            QVERIFY(exportGltf(mesh.what(), path, {}));
            QVERIFY(verifyWritten(path, mesh.what()));
            QFile cut(name == std::string("b.glb") ? path : folder.filePath(QStringLiteral("b.bin")));
            for (const qint64 left : {cut.size() - 1, qint64{16}, qint64{0}}) {
                QVERIFY(cut.resize(left));
                const Status broken = verifyWritten(path, mesh.what());
                QVERIFY(!broken);
                QVERIFY2(messageOf(broken).contains(QStringLiteral("cannot be read")),
                         qPrintable(messageOf(broken)));
            }
            QVERIFY(cut.remove());
            QVERIFY(!verifyWritten(path, mesh.what()));
        }
    }

    void endsSoonWhereNobodyWantsIt() {
        QTemporaryDir folder;
        const DentedFile mesh(writeFile(folder.path(), QStringLiteral("a.obj"), gridText(200)));
        for (const char* const name : {"b.glb", "b.gltf"}) {
            const QString path = folder.filePath(QLatin1String(name));
            QVERIFY(exportGltf(mesh.what(), path, {}));
            int questions = 0;
            std::vector<double> shares;
            const auto told = [&](ExportStep step, double share) {
                shares.push_back((step == ExportStep::Comparing ? 1.0 : 0.0) + share);
                return true;
            };
            const std::function<bool()> count = [&questions] { return ++questions > 0; };
            {
                const GiveUpScope watched(count);
                QVERIFY(verifyWritten(path, mesh.what(), {}, told));
            }
            const int megabytes =
                static_cast<int>(QFile(folder.filePath(QStringLiteral("b.glb"))).size() >> 20);
            QVERIFY(megabytes > 0);
            QVERIFY2(questions > 8 + megabytes, qPrintable(QString::number(questions)));
            QVERIFY(std::is_sorted(shares.begin(), shares.end()));
            QVERIFY(shares.size() > static_cast<std::size_t>(2 + megabytes));
            for (int k = 0; k < questions; ++k) {
                int left = k;
                const std::function<bool()> some = [&left] { return left-- > 0; };
                const GiveUpScope watched(some);
                QVERIFY_EXCEPTION_THROWN((void)verifyWritten(path, mesh.what(), {}), GivenUp);
                QCOMPARE(left, -1);
            }
        }
    }
};

HITSCOPE_TEST(TestIoWrittenGltf, QCoreApplication)

}  // namespace hitscope::io_written_gltf_test

#include "io_written_gltf_test.moc"
