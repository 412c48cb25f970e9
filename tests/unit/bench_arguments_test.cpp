// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <memory>

#include "cli/bench/arguments.h"
#include "support/test_program.h"

namespace hitscope::bench_arguments_test {

using namespace bench;

class BenchArgumentsTest : public QObject {
    Q_OBJECT

    static std::unique_ptr<Arguments> parsed(const QStringList& list) {
        auto made = std::make_unique<Arguments>(QStringLiteral("About."));
        Arguments& arguments = *made;
        arguments.addOption(QStringLiteral("size"), {}, QStringLiteral("s"), QStringLiteral("1280x720"));
        arguments.addOption(QStringLiteral("count"), {}, QStringLiteral("n"), QStringLiteral("1,2K,3M"));
        arguments.addOption(QStringLiteral("one"), {}, QStringLiteral("n"), QStringLiteral("7"));
        arguments.addOption(QStringLiteral("seconds"), {}, QStringLiteral("n"), QStringLiteral("0.5"));
        arguments.addOption(QStringLiteral("kind"), {}, QStringLiteral("list"), QStringLiteral("b,a"));
        arguments.addOption(QStringLiteral("json"), {}, QStringLiteral("file"));
        arguments.addFlag(QStringLiteral("quick"), {});
        arguments.parse(QStringList{QStringLiteral("program")} + list, {QStringLiteral("--json")});
        return made;
    }

    /// Takes all there is out of it; the error.
    static QString errorOf(const QStringList& list) {
        const std::unique_ptr<Arguments> made = parsed(list);
        Arguments& arguments = *made;
        static_cast<void>(arguments.size(QStringLiteral("size")));
        static_cast<void>(arguments.wholeNumbers(QStringLiteral("count"), 0, 5000000));
        static_cast<void>(arguments.wholeNumber(QStringLiteral("one"), 1, 9));
        static_cast<void>(arguments.number(QStringLiteral("seconds"), 0.1, 10.0));
        static_cast<void>(arguments.list(QStringLiteral("kind"), {QStringLiteral("a"), QStringLiteral("b")}));
        return arguments.error();
    }

private Q_SLOTS:
    void defaultsAreRead() {
        const std::unique_ptr<Arguments> made = parsed({});
        Arguments& arguments = *made;
        QCOMPARE(arguments.size(QStringLiteral("size")).width, 1280);
        QCOMPARE(arguments.size(QStringLiteral("size")).height, 720);
        QCOMPARE(arguments.wholeNumbers(QStringLiteral("count"), 0, 5000000),
                 (std::vector<int>{1, 2000, 3000000}));
        QCOMPARE(arguments.wholeNumber(QStringLiteral("one"), 1, 9), 7);
        QCOMPARE(arguments.number(QStringLiteral("seconds"), 0.1, 10.0), 0.5);
        QCOMPARE(arguments.list(QStringLiteral("kind"), {}), (QStringList{"b", "a"}));
        QVERIFY(!arguments.isSet(QStringLiteral("quick")));
        QVERIFY(arguments.error().isEmpty());
    }

    void repeatedValuesCountOnce() {
        const std::unique_ptr<Arguments> arguments =
            parsed({QStringLiteral("--count"), QStringLiteral("1000, 1K,5")});
        QCOMPARE(arguments->wholeNumbers(QStringLiteral("count"), 0, 5000), (std::vector<int>{1000, 5}));
    }

    void counts() {
        QCOMPARE(parseCount(QStringLiteral("250")), std::optional(250));
        QCOMPARE(parseCount(QStringLiteral("8k")), std::optional(8000));
        QCOMPARE(parseCount(QStringLiteral("10M")), std::optional(10000000));
        QCOMPARE(parseCount(QStringLiteral("3000M")), std::nullopt);
        QCOMPARE(parseCount(QStringLiteral("1.5K")), std::nullopt);
        QCOMPARE(parseCount(QStringLiteral("-1")), std::nullopt);
        QCOMPARE(parseCount(QString()), std::nullopt);
    }

    void jsonMayStandAlone() {
        QCOMPARE(parsed({QStringLiteral("--json")})->text(QStringLiteral("json")), QStringLiteral("-"));
        const std::unique_ptr<Arguments> before =
            parsed({QStringLiteral("--json"), QStringLiteral("--quick")});
        QCOMPARE(before->text(QStringLiteral("json")), QStringLiteral("-"));
        QVERIFY(before->isSet(QStringLiteral("quick")));
        const std::unique_ptr<Arguments> file = parsed({QStringLiteral("--json"), QStringLiteral("a.json")});
        QCOMPARE(file->text(QStringLiteral("json")), QStringLiteral("a.json"));
        QCOMPARE(parsed({})->text(QStringLiteral("json")), QString());
    }

    void errorsNameTheOption_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("piece");
        const auto row = [](const char* arguments, const char* piece) {
            QTest::addRow("%s", arguments)
                << QString::fromLatin1(arguments).split(QLatin1Char(' ')) << QString::fromLatin1(piece);
        };
        row("--size 320", "--size takes WIDTHxHEIGHT");
        row("--size 8x8", "from 16 to 8192");
        row("--size 99999x16", "--size");
        row("--count x", "\"x\"");
        row("--count ,", "--count takes at least one");
        row("--count 6M", "from 0 to 5,000,000");
        row("--one 10", "--one takes a whole number from 1 to 9");
        row("--one 1.5", "--one");
        row("--seconds nan", "--seconds takes a number from 0.1 to 10");
        row("--kind c", "--kind does not know \"c\"; it takes a, b");
        row("--kind ,", "--kind takes at least one of a, b");
        row("--fast", "fast");
        row("more", "\"more\"");
    }
    void errorsNameTheOption() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, piece);
        const QString error = errorOf(arguments);
        QVERIFY2(error.contains(piece), qPrintable(error));
    }
};

HITSCOPE_TEST(BenchArgumentsTest, QCoreApplication)

}  // namespace hitscope::bench_arguments_test

#include "bench_arguments_test.moc"
