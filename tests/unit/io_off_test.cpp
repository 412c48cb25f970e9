// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "io/readers/off_reader.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_off_test {

using namespace test;

/// What an OFF file says of itself, and what it holds. Its kinds are tested in io_formats_test.cpp.
class OffTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void notesWhatFollows();
    void refuses_data();
    void refuses();
};

void OffTest::notesWhatFollows() {
    const std::string text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n";
    QCOMPARE(parseOff(text + "\n # the end\r\n").value().notes, QStringList());
    QCOMPARE(parseOff(text + "3 2 1 0\n").value().notes,
             QStringList{QStringLiteral("The file goes on after its last face; the rest was not read.")});
}

void OffTest::refuses_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("message");
    const QByteArray vertices = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
    const char* const counts = "line 2: Here should be the numbers of vertices and faces.";
    const char* const corner = "line 6: A corner of the face is no whole number.";
    QTest::newRow("vertices") << QByteArray(vertices).replace("3 1", "3.0 1") + "3 0 1 2\n" << counts;
    QTest::newRow("faces") << QByteArray(vertices).replace("3 1", "3 1.5") + "3 0 1 2\n" << counts;
    QTest::newRow("corners") << vertices + "3e0 0 1 2\n"
                             << "line 6: A face begins with the number of its corners.";
    QTest::newRow("corner") << vertices + "3 0 1.5 2\n" << corner;
    QTest::newRow("last corner") << vertices + "3 0 1 2.5\n" << corner;
    QTest::newRow("too few") << vertices + "3 0 1 \n"
                             << "line 6: The face has fewer corners than it says.";
}

void OffTest::refuses() {
    QFETCH(QByteArray, text);
    QFETCH(QString, message);
    const Result<ImportedMesh> result = parseOff(text.toStdString());
    QVERIFY2(messageOf(result).contains(message), qPrintable(messageOf(result)));
}

HITSCOPE_TEST(OffTest, QCoreApplication)

}  // namespace hitscope::io_off_test

#include "io_off_test.moc"
