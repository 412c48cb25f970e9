// SPDX-License-Identifier: GPL-3.0-or-later
// What is done once for many signals of one turn of the event loop.
#include "session/once_a_turn.h"

#include <QCoreApplication>
#include <QTest>

#include "support/test_program.h"

namespace hitscope::once_a_turn_test {

class OnceATurnTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theFirstAtOnceTheOthersTogether() {
        int done = 0;
        OnceATurn once([&done] { ++done; });
        for (int i = 0; i < 5; ++i) {
            once.want();
            QCOMPARE(done, 1);
            QCOMPARE(once.isDue(), i > 0);
        }
        QTRY_COMPARE(done, 2);
        QVERIFY(!once.isDue());
        QTest::qWait(10);
        QCOMPARE(done, 2);  // nothing is left to do
        once.want();
        QCOMPARE(done, 3);
    }

    void nothingIsDueAfterNow() {
        int done = 0;
        OnceATurn once([&done] { ++done; });
        once.want();
        once.want();
        once.now();
        QCOMPARE(done, 2);
        QVERIFY(!once.isDue());
        QTest::qWait(10);
        QCOMPARE(done, 2);
    }
};

HITSCOPE_TEST(OnceATurnTest, QCoreApplication)

}  // namespace hitscope::once_a_turn_test

#include "once_a_turn_test.moc"
