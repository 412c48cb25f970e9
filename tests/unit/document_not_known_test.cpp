// SPDX-License-Identifier: GPL-3.0-or-later
// What a session file has that this version does not know: passed over, and named.
#include <QTemporaryDir>
#include <QTest>

#include "document/document_json.h"
#include "document/open_document.h"
#include "document/session_file.h"
#include "support/test_program.h"
#include "unit/document_support.h"

namespace hitscope::document_not_known_test {

using namespace test;

class DocumentNotKnownTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void itIsNamedWithItsLine() {
        const Result<SessionDocument> read = readDocument(
            R"({"format": "hitscope session", "version": 1, "mood": {"a": [1]},
"targets": [{"id": 2, "weight": 5, "source": {"kind": "primitive", "shape": "cube", "path": "x"}}],
"constants": {"powr": 3}, "simulation": {"paused": true},
"hits": [{"target": 2, "point": [1, 2, 3], "direction": [0, 0, 1]},
{"target": 2, "powr": 3, "point": [1, 2, 3], "direction": [0, 0, 1]},
{"target": 2, "powr": 3, "point": [1, 2, 3], "direction": [0, 0, 1]}]})");
        QVERIFY2(read.ok(), read ? "" : read.error().message().c_str());
        QCOMPARE(read.value().hits.size(), std::size_t{3});
        QCOMPARE(read.value().notKnown,
                 (std::vector<std::string>{"line 2, target 1, source, path", "line 2, target 1, weight",
                                           "line 3, constants, powr", "line 5, hit 2, powr (2 times)",
                                           "line 1, mood"}));
    }

    void whatIsSavedIsKnown() {
        for (const SessionDocument& document : {SessionDocument(), exampleDocument()}) {
            const Result<SessionDocument> read = readDocument(writeDocument(document));
            QVERIFY(read.ok());
            QCOMPARE(read.value().notKnown, std::vector<std::string>());
        }
    }

    void manyAreCounted() {
        QByteArray text = R"({"format": "hitscope session", "version": 1)";
        for (int i = 0; i < 100; ++i) {
            text += ", \"key" + QByteArray::number(i) + "\": 1";
        }
        const Result<SessionDocument> read = readDocument(text + '}');
        QVERIFY(read.ok());
        QCOMPARE(read.value().notKnown.size(), std::size_t{20});
    }

    void openedItIsNoted() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a.hitscope"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{\"format\": \"hitscope session\", \"version\": 1,\n\"scene\": {\"height\": 1}}");
        file.close();
        Result<SessionDocument> read = readSessionFile(path);
        QVERIFY(read.ok());
        const Result<PreparedSession> prepared = prepareSession(std::move(read).value(), {});
        QVERIFY(prepared.ok());
        QCOMPARE(prepared.value().notes,
                 QStringList(path + QStringLiteral(", line 2, scene, height is not known to this version and "
                                                   "was left out.")));
    }
};

HITSCOPE_TEST(DocumentNotKnownTest, QCoreApplication)

}  // namespace hitscope::document_not_known_test

#include "document_not_known_test.moc"
