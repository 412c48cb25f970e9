// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions that may be recovered, several of them, and none of them now.
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "app/recovery_bar.h"
#include "document/journal_files.h"
#include "document/session_journal.h"
#include "session/shots/demo_shots.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::recovery_later_test {

class RecoveryLaterTest : public QObject, private WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private:
    [[nodiscard]] RecoveryBar& bar() const { return *m_window->findChild<RecoveryBar*>(); }
    [[nodiscard]] QString text() const {
        QString all;
        for (const QLabel* label : bar().findChildren<QLabel*>()) {
            all += label->text();
        }
        return all;
    }
    /// Hits, and the window goes without closing.
    void crashWith(int shots) {
        for (const Ray& ray : demoShots(*m_session, shots, 3)) {
            m_session->simulation().hitscan(ray);
        }
        auto* journal = m_window->findChild<SessionJournal*>();
        journal->flush();
        QVERIFY(journal->isBegun());
        QVERIFY(journal->writer().wait(kPatience));
        makeWindow([](Session& session) { loadTeapot(session); });
    }
    void clickLater() { bar().findChild<QPushButton*>(QStringLiteral("recoverLater"))->click(); }

private Q_SLOTS:
    void init() {
        makeWindow([](Session& session) { loadPaperRow(session, kDefaultPaperRow); });
    }
    void cleanup() { dropWindow(); }

    void theyStayForTheNextStart() {
        crashWith(4);
        crashWith(7);
        QCOMPARE(findJournals(journalFolder()).size(), std::size_t{2});
        m_window->offerRecovery();
        QTRY_VERIFY_WITH_TIMEOUT(bar().isVisible(), kPatience);
        QVERIFY2(text().contains(QStringLiteral("1 more session comes after it")), qPrintable(text()));
        QVERIFY2(text().contains(QStringLiteral("without its steps to undo")), qPrintable(text()));
        const QString first = text();
        clickLater();
        QTRY_VERIFY_WITH_TIMEOUT(bar().isVisible() && text() != first, kPatience);
        QVERIFY2(!text().contains(QStringLiteral("more session")), qPrintable(text()));
        clickLater();
        QVERIFY(!bar().isVisible());
        m_window->offerRecovery();  // not in this window again
        QTest::qWait(100);
        QVERIFY(!bar().isVisible());
        QCOMPARE(findJournals(journalFolder()).size(), std::size_t{2});
        makeWindow([](Session& session) { loadTeapot(session); });
        m_window->offerRecovery();
        QTRY_VERIFY_WITH_TIMEOUT(bar().isVisible(), kPatience);
    }
};

HITSCOPE_TEST(RecoveryLaterTest, QApplication)

}  // namespace hitscope::recovery_later_test

#include "recovery_later_test.moc"
