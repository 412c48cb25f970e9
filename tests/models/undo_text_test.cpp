// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/undo_text.h"

#include <QtTest>

using namespace hitscope;

class UndoTextTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void namesTheStep_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("hits");
        QTest::addColumn<QString>("text");
        const auto row = [](HistoryUndo::Kind kind, int hits, const char* text) {
            QTest::newRow(text) << static_cast<int>(kind) << hits << QString::fromLatin1(text);
        };
        row(HistoryUndo::Kind::Hit, 1, "Hit");
        row(HistoryUndo::Kind::Hit, 2, "2 Hits");
        row(HistoryUndo::Kind::Remove, 1, "Remove Hit");
        row(HistoryUndo::Kind::Remove, 3, "Remove 3 Hits");
        row(HistoryUndo::Kind::Clear, 1000, "Clear 1,000 Hits");
        row(HistoryUndo::Kind::Move, 1, "Move Hit");
        row(HistoryUndo::Kind::Enable, 2, "Enable 2 Hits");
        row(HistoryUndo::Kind::Disable, 1, "Disable Hit");
        row(HistoryUndo::Kind::Constants, 12, "Constants");
    }
    void namesTheStep() {
        QFETCH(int, kind);
        QFETCH(int, hits);
        QFETCH(QString, text);
        QCOMPARE(undoText({static_cast<HistoryUndo::Kind>(kind), static_cast<std::size_t>(hits)}), text);
    }
};

QTEST_GUILESS_MAIN(UndoTextTest)
#include "undo_text_test.moc"
