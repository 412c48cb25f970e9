// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <optional>
#include <vector>

#include "cli/bench/arguments.h"
#include "support/test_program.h"

namespace hitscope::bench_arguments_test {

using namespace bench;

namespace {

const Usage& usage() {
    static const Usage made{.name = QStringLiteral("bench test"),
                            .files = {},
                            .about = {},
                            .description = {},
                            .options = {valueOption("size", "S", {}, QStringLiteral("1280x720")),
                                        valueOption("count", "LIST", {}, QStringLiteral("1,2K,3M")),
                                        valueOption("one", "N", {}, QStringLiteral("7")),
                                        wordsOption("kind", {QStringLiteral("b"), QStringLiteral("a")}, {})},
                            .examples = {}};
    return made;
}

/// Takes all there is out of it; the error.
QString errorOf(const QStringList& list) {
    Invocation given(usage(), list);
    static_cast<void>(takeSize(given, "size"));
    static_cast<void>(takeCounts(given, "count", 0, 5000000));
    static_cast<void>(takeCount(given, "one", 1, 9));
    static_cast<void>(takeWords(given, "kind"));
    return given.error();
}

}  // namespace

class BenchArgumentsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void defaultsAreRead() {
        Invocation given(usage(), {});
        QCOMPARE(takeSize(given, "size").width, 1280);
        QCOMPARE(takeSize(given, "size").height, 720);
        QCOMPARE(takeCounts(given, "count", 0, 5000000), (std::vector<int>{1, 2000, 3000000}));
        QCOMPARE(takeCount(given, "one", 1, 9), 7);
        QCOMPARE(takeWords(given, "kind"), (QStringList{"b", "a"}));
        QVERIFY(given.error().isEmpty());
    }

    void helpSaysTheWords() {
        QCOMPARE(usage().find(QStringLiteral("kind"))->fullHelp().simplified(),
                 QStringLiteral("Of b, a; separated by commas. Default: all."));
    }

    void repeatedValuesCountOnce() {
        Invocation given(usage(), {QStringLiteral("--count"), QStringLiteral("1000, 1K,5")});
        QCOMPARE(takeCounts(given, "count", 0, 5000), (std::vector<int>{1000, 5}));
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
        row("--kind c", "--kind does not know \"c\"; it takes b, a");
        row("--kind ,", "--kind takes at least one of b, a");
        row("--fast", "fast");
        row("more", "takes no files");
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
