// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/float_text.h"

#include <QTest>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <string_view>

#include "io/eight_digits.h"
#include "support/test_program.h"

namespace hitscope::float_text_test {

namespace {

std::string written(float value) {
    char text[kFloatText];
    return {text, writeFloat(text, value)};
}

/// The library's text, and all digits where reading it as a double first gives another float.
std::string expected(float value) {
    char text[64];
    std::string shortest(text, std::to_chars(text, text + sizeof text, value).ptr);
    double read = 0.0;
    std::from_chars(shortest.data(), shortest.data() + shortest.size(), read);
    if (static_cast<float>(read) == value) {
        return shortest;
    }
    return {text, std::to_chars(text, text + sizeof text, static_cast<double>(value)).ptr};
}

}  // namespace

class FloatTextTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void writesKnownNumbers_data() {
        QTest::addColumn<float>("value");
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("zero") << 0.0f << QByteArray("0");
        QTest::newRow("minus zero") << -0.0f << QByteArray("-0");
        QTest::newRow("power of two") << 0.25f << QByteArray("0.25");
        QTest::newRow("a tenth") << 0.1f << QByteArray("0.1");
        QTest::newRow("short") << -0.6f << QByteArray("-0.6");
        QTest::newRow("whole") << 120.0f << QByteArray("120");
        QTest::newRow("long whole") << 100000.0f << QByteArray("1e+05");
        QTest::newRow("small") << 0.0003f << QByteArray("3e-04");
        QTest::newRow("seven digits") << 3.141593f << QByteArray("3.141593");
        QTest::newRow("eight digits") << 0.98786795f << QByteArray("0.98786795");
        QTest::newRow("rounded up") << 99.99999f << QByteArray("99.99999");
        QTest::newRow("large") << 1.5e30f << QByteArray("1.5e+30");
    }
    void writesKnownNumbers() {
        QFETCH(float, value);
        QFETCH(QByteArray, text);
        QCOMPARE(QByteArray::fromStdString(written(value)), text);
    }

    void writesSixDecimals() {
        const auto text = [](float value) {
            char number[kFloatText];
            return QByteArray::fromStdString({number, writeSixDecimals(number, value)});
        };
        QCOMPARE(text(0.0f), QByteArray("0"));
        QCOMPARE(text(-0.0f), QByteArray("0"));
        QCOMPARE(text(-4e-7f), QByteArray("0"));
        QCOMPARE(text(-6e-7f), QByteArray("-0.000001"));
        QCOMPARE(text(1.0f), QByteArray("1"));
        QCOMPARE(text(-0.25f), QByteArray("-0.25"));
        QCOMPARE(text(0.99999994f), QByteArray("1"));
        QCOMPARE(text(0.70710678f), QByteArray("0.707107"));
        QCOMPARE(text(9.5f), QByteArray("9.5"));
        QCOMPARE(text(10.5f), QByteArray("10.5"));
        QCOMPARE(text(std::numeric_limits<float>::infinity()), QByteArray("inf"));
        std::mt19937 random(5);
        std::uniform_real_distribution<float> number(-9.99f, 9.99f);
        for (int i = 0; i < 100'000; ++i) {
            const float value = number(random);
            const QByteArray written = text(value);
            const QByteArray full = QByteArray::number(static_cast<double>(value), 'f', 6);
            QVERIFY2(std::abs(written.toDouble() - static_cast<double>(value)) <= 0.5000001e-6 &&
                         full.startsWith(written) && (written == full || full.endsWith('0')),
                     written.constData());
        }
    }

    void writesShortNumbers() {
        const auto check = [](std::uint32_t number) {
            char text[16];
            const std::string_view written(text,
                                           static_cast<std::size_t>(writeShortNumber(text, number) - text));
            if (written != std::to_string(number)) {
                QFAIL(qPrintable(QStringLiteral("%1 is written as %2")
                                     .arg(number)
                                     .arg(QString::fromUtf8(written.data(), qsizetype(written.size())))));
            }
        };
        for (std::uint32_t number = 0; number < 1'000'000 && !QTest::currentTestFailed(); ++number) {
            check(number);
            check(kMostOfEightDigits - number);
            check(97 * number);
        }
    }

    /// Of every size, dense and sparse, and what people write.
    void isTheShortestText() {
        std::mt19937 random(3);
        const auto check = [](float value) {
            if (written(value) != expected(value)) {
                QFAIL(qPrintable(QStringLiteral("%1 instead of %2")
                                     .arg(QString::fromStdString(written(value)),
                                          QString::fromStdString(expected(value)))));
            }
        };
        for (int i = 0; i < 2'000'000 && !QTest::currentTestFailed(); ++i) {
            check(std::bit_cast<float>(static_cast<std::uint32_t>(random())));
        }
        std::uniform_real_distribution<float> exponent(-14.0f, 24.0f);
        for (int i = 0; i < 2'000'000 && !QTest::currentTestFailed(); ++i) {
            check(std::exp2(exponent(random)) * (i % 2 == 0 ? 1.0f : -1.0f));
        }
        for (int i = 0; i < 200'000 && !QTest::currentTestFailed(); ++i) {
            check(static_cast<float>(i) * 0.001f);
            check(static_cast<float>(i) / 100'000.0f);
            check(static_cast<float>(5 * i));
        }
        for (std::uint32_t power = 100; power < 155; ++power) {
            for (std::uint32_t near : {0u, 1u, 2u, 0x7ffffeu, 0x7fffffu}) {
                check(std::bit_cast<float>(power << 23 | near));
            }
        }
    }
};

HITSCOPE_TEST(FloatTextTest, QCoreApplication)

}  // namespace hitscope::float_text_test

#include "float_text_test.moc"
