// SPDX-License-Identifier: GPL-3.0-or-later
// What a journal says beside hits and settings.
#include <QTest>
#include <array>
#include <functional>
#include <string>

#include "document/journal_records.h"
#include "document_support.h"
#include "support/test_program.h"

namespace hitscope::journal_context_test {

using namespace test;

class JournalContextTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// The last counts.
    void aFileIsNamed() {
        JournalLines lines;
        QByteArray bytes = QByteArray::fromStdString(lines.begin(exampleDocument()));
        QCOMPARE(readJournal(bytes).value().file, QString());
        const QString first = QStringLiteral("/tmp/a “b”.hitscope");
        bytes += QByteArray::fromStdString(lines.file(first));
        QCOMPARE(readJournal(bytes).value().file, first);
        const QString second = QStringLiteral("/tmp/b.hitscope");
        bytes += QByteArray::fromStdString(lines.edit(0, 1, {}));
        bytes += QByteArray::fromStdString(lines.file(second));
        const Result<RecoveredJournal> read = readJournal(bytes);
        QCOMPARE(read.value().file, second);
        QVERIFY2(read.value().problem.empty(), read.value().problem.c_str());
    }

    /// Once hits or targets are others nobody knows them: they would be told apart from what is recovered.
    void positionsAreThoseOfTheSnapshot() {
        const SessionDocument document = exampleDocument();
        const auto positionsAfter = [&document](const std::function<std::string(JournalLines&)>& more) {
            JournalLines lines;
            std::string text = lines.begin(document);
            text += more(lines);
            return readJournal(QByteArray::fromStdString(text)).value().document.positions.size();
        };
        const auto set = [&document](Section section) {
            return [&document, section](JournalLines& lines) {
                return lines.set(std::array{section}, document);
            };
        };
        QCOMPARE(positionsAfter([](JournalLines&) { return std::string(); }), document.positions.size());
        QCOMPARE(positionsAfter(set(Section::Lights)), document.positions.size());
        QCOMPARE(positionsAfter(set(Section::Targets)), std::size_t(0));
        QCOMPARE(positionsAfter([](JournalLines& lines) { return lines.edit(0, 1, {}); }), std::size_t(0));
    }
};

HITSCOPE_TEST(JournalContextTest, QCoreApplication)

}  // namespace hitscope::journal_context_test

#include "journal_context_test.moc"
