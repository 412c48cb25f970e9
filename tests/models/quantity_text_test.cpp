// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/quantity_text.h"

#include <QLocale>
#include <QTest>
#include <limits>

#include "support/test_program.h"

namespace hitscope::quantity_text_test {

class QuantityTextTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void fitsAColumn_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("text");
        const auto row = [](double value, const char* text) {
            QTest::newRow(text) << value << QString::fromLatin1(text);
        };
        row(0.0, "0");
        row(12.5663706, "12.566");
        row(0.3, "0.30000");
        row(-0.00105432, "-0.001054");
        row(0.000105432, "0.000105");
        row(-0.0000105432, "-1.05e-05");
        row(2.6028e-8, "2.60e-08");
        row(125.0, "125.00");
        row(61196.0, "61,196");
        row(1234567.8, "1,234,568");
        row(25527300.0, "2.55e+07");
        row(1.0e12, "1.00e+12");
        row(std::numeric_limits<double>::infinity(), "inf");
    }
    void fitsAColumn() {
        QFETCH(double, value);
        QFETCH(QString, text);
        QCOMPARE(quantityText(value), text);
        QVERIFY(text.size() <= 9);
    }
    void smallCoordinatesAreNotZero() {
        QCOMPARE(vectorText({1.25f, -0.3f, 0.0f}), QStringLiteral("1.250, -0.300, 0.000"));
        QCOMPARE(vectorText({0.0123f, 0.0f, -0.0005f}), QStringLiteral("0.0123, 0.0000, -0.0005"));
        QCOMPARE(vectorText({1.05e-5f, 0.0f, 2.0e-6f}), QStringLiteral("1.05e-05, 0.00e+00, 2.00e-06"));
        QCOMPARE(copiedVectorText({0.0123f, 0.0f, 0.0f}), QStringLiteral("0.0123, 0.0000, 0.0000"));
        QCOMPARE(vectorText({0.0f, 0.0f, 0.0f}), QStringLiteral("0.000, 0.000, 0.000"));
        QCOMPARE(vectorText({1.0f, -0.0004f, -0.0f}), QStringLiteral("1.000, 0.000, 0.000"));
        QCOMPARE(quantityText(-0.0), QStringLiteral("0"));
    }
};

HITSCOPE_TEST(QuantityTextTest, QCoreApplication)

}  // namespace hitscope::quantity_text_test

#include "quantity_text_test.moc"
