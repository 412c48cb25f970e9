// SPDX-License-Identifier: GPL-3.0-or-later
// Texts with counts, as tr() gives them.
#include <QLocale>
#include <QTest>
#include <QTranslator>

#include "session/shown_number.h"
#include "support/test_program.h"

namespace hitscope::plurals_test {

/// A language with a translation of its own.
class German : public QTranslator {
public:
    QString translate(const char*, const char* text, const char*, int number) const override {
        return qstrcmp(text, "%Ln {hit|hits}") == 0
                   ? (number == 1 ? QStringLiteral("%Ln Treffer, einer") : QStringLiteral("%Ln Treffer"))
                   : QString();
    }
};

class PluralsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void cleanup() { QLocale::setDefault(QLocale::c()); }

    void oneAndSeveral() {
        QCOMPARE(tr("%Ln {hit|hits}", nullptr, 0), QStringLiteral("0 hits"));
        QCOMPARE(tr("%Ln {hit|hits}", nullptr, 1), QStringLiteral("1 hit"));
        QCOMPARE(tr("%Ln {hit|hits}", nullptr, 2), QStringLiteral("2 hits"));
        QCOMPARE(tr("%Ln {shot is|shots are} on {its|their} way.", nullptr, 1),
                 QStringLiteral("1 shot is on its way."));
        QCOMPARE(tr("%Ln {vertex|vertices}, %1 m deep", nullptr, 1).arg(QStringLiteral("0.25")),
                 QStringLiteral("1 vertex, 0.25 m deep"));
    }

    void digitsAreGroupedAsElsewhere() {
        for (const QLocale& locale : {QLocale::c(), QLocale(QLocale::English), QLocale(QLocale::German)}) {
            QLocale::setDefault(locale);
            QCOMPARE(tr("%Ln {hit|hits}", nullptr, 1'234'567),
                     shownCount(1'234'567) + QStringLiteral(" hits"));
        }
    }

    void textsWithoutACountStayAsTheyAre() {
        QCOMPARE(tr("A {brace|bracket}"), QStringLiteral("A {brace|bracket}"));
    }

    void translationsComeFirst() {
        German german;
        QCoreApplication::installTranslator(&german);
        QCOMPARE(tr("%Ln {hit|hits}", nullptr, 1), QStringLiteral("1 Treffer, einer"));
        QCOMPARE(tr("%Ln {step|steps}", nullptr, 1), QStringLiteral("1 step"));
        QCoreApplication::removeTranslator(&german);
    }

    void countsThatAreTooLargeAreTheLargest() {
        QCOMPARE(trCount(7), 7);
        QCOMPARE(trCount(std::size_t{1} << 40), 2'147'483'647);
    }
};

HITSCOPE_TEST(PluralsTest, QCoreApplication)

}  // namespace hitscope::plurals_test

#include "plurals_test.moc"
