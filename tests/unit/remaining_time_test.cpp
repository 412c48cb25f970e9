// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remaining_time.h"

#include <QTest>

#include "support/test_program.h"

namespace hitscope::remaining_time_test {

class RemainingTimeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void goesOnAsBefore() {
        QCOMPARE(remainingSeconds(0.25, 3.0), std::optional(9.0));
        QCOMPARE(remainingSeconds(1.0, 8.0), std::optional(0.0));
    }
    void saysNothingTooEarly() {
        QVERIFY(!remainingSeconds(0.5, 1.9));
        QVERIFY(!remainingSeconds(0.01, 10.0));
        QVERIFY(!remainingSeconds(-1.0, 10.0));
    }
};

HITSCOPE_TEST(RemainingTimeTest, QCoreApplication)

}  // namespace hitscope::remaining_time_test

#include "remaining_time_test.moc"
