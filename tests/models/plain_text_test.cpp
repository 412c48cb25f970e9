// SPDX-License-Identifier: GPL-3.0-or-later
// Names and paths where Qt looks for markup.
#include "models/plain_text.h"

#include <QTest>
#include <QTextDocument>
#include <QTextDocumentFragment>

#include "support/test_program.h"

namespace hitscope::plain_text_test {

class PlainTextTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void isShownAsItStands_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("tags") << QStringLiteral("/a/<b>x</b>.obj");
        QTest::newRow("picture") << QStringLiteral("<img src=\"/etc/picture.png\">");
        QTest::newRow("lines") << QStringLiteral("<i>one</i>\ntwo  and three & four");
        QTest::newRow("entity") << QStringLiteral("a &lt; b");
        QTest::newRow("place") << QStringLiteral("<b>%1</b>");
    }
    void isShownAsItStands() {
        QFETCH(QString, text);
        QVERIFY(Qt::mightBeRichText(text));
        const QString plain = asPlainText(text);
        QVERIFY(Qt::mightBeRichText(plain));
        QCOMPARE(QTextDocumentFragment::fromHtml(plain).toPlainText(), text);
    }

    void plainTextStays() {
        for (const QString& text : {QString(), QStringLiteral("C:\\a & b.obj"), QStringLiteral("2 < 3\n<b>"),
                                    QStringLiteral("“rock”: 3 hits")}) {
            QVERIFY(!Qt::mightBeRichText(text));
            QCOMPARE(asPlainText(text), text);
        }
    }

    void marksOfKeysAreNotRead() {
        QCOMPARE(withoutMarks(QStringLiteral("Export A&gain…")), QStringLiteral("Export Again"));
        QCOMPARE(withoutMarks(QStringLiteral("A&gain to R&&D.obj")), QStringLiteral("Again to R&D.obj"));
        QCOMPARE(withoutMarks(QStringLiteral("&&&Cut &")), QStringLiteral("&Cut "));
    }
};

HITSCOPE_TEST(PlainTextTest, QCoreApplication)

}  // namespace hitscope::plain_text_test

#include "plain_text_test.moc"
