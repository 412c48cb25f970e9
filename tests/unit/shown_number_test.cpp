// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in the window have no powers of ten where people read plain ones.
#include "session/shown_number.h"

#include <QTest>
#include <limits>

#include "support/test_program.h"

namespace hitscope::shown_number_test {

class ShownNumberTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void significantDigits_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<int>("digits");
        QTest::addColumn<QString>("text");
        QTest::newRow("thousands") << 32000.0 << 4 << QStringLiteral("32,000");
        QTest::newRow("rounded") << 32076.4 << 4 << QStringLiteral("32,080");
        QTest::newRow("below zero") << -1334.5 << 3 << QStringLiteral("-1,330");
        QTest::newRow("up to more digits") << 999.7 << 3 << QStringLiteral("1,000");
        QTest::newRow("few digits") << 74.878 << 4 << QStringLiteral("74.88");
        QTest::newRow("as many digits") << 1234.4 << 4 << QStringLiteral("1,234");
        QTest::newRow("small") << 0.00027 << 3 << QStringLiteral("0.00027");
        QTest::newRow("none") << 0.0 << 3 << QStringLiteral("0");
        QTest::newRow("very large") << 1.2e12 << 3 << QStringLiteral("1.2e+12");
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity() << 3 << QStringLiteral("inf");
    }
    void significantDigits() {
        QFETCH(double, value);
        QFETCH(int, digits);
        QFETCH(QString, text);
        QCOMPARE(shownNumber(copiedLocale(), value, 'g', digits), text);
    }
};

HITSCOPE_TEST(ShownNumberTest, QCoreApplication)

}  // namespace hitscope::shown_number_test

#include "shown_number_test.moc"
