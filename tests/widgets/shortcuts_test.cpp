// SPDX-License-Identifier: GPL-3.0-or-later
// Two actions of the window with one key would both be dead: Qt calls that ambiguous.
#include <QAction>
#include <QApplication>
#include <QMap>
#include <QMenu>
#include <QMenuBar>
#include <QTest>

#include "app/main_window.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::shortcuts_test {

class ShortcutsTest : public QObject {
    Q_OBJECT

public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void everyKeyHasOneMeaning() {
        const TestSettings settings;
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        MainWindow window(session);
        QMap<QString, QStringList> meanings;
        for (const QAction* action : window.findChildren<QAction*>()) {
            if (action->shortcutContext() != Qt::WindowShortcut &&
                action->shortcutContext() != Qt::ApplicationShortcut) {
                continue;  // a list's own, while it has the focus
            }
            for (const QKeySequence& keys : action->shortcuts()) {
                meanings[keys.toString()] << action->text();
            }
        }
        QVERIFY(meanings.size() > 20);
        for (auto it = meanings.cbegin(); it != meanings.cend(); ++it) {
            QVERIFY2(it.value().size() == 1,
                     qPrintable(it.key() + QStringLiteral(": ") + it.value().join(u'|')));
        }
    }

    /// Of two entries with one letter, pressing it only selects one after the other.
    void everyLetterOfAMenuHasOneMeaning() {
        const TestSettings settings;
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        MainWindow window(session);
        QStringList doubles;
        const auto check = [&doubles](const QString& menu, const QList<QAction*>& actions) {
            QMap<QString, QStringList> meanings;
            for (const QAction* action : actions) {
                const QKeySequence letter = QKeySequence::mnemonic(action->text());
                if (!letter.isEmpty()) {
                    meanings[letter.toString()] << action->text();
                }
            }
            for (auto it = meanings.cbegin(); it != meanings.cend(); ++it) {
                if (it.value().size() > 1) {
                    doubles << menu + u' ' + it.key() + QStringLiteral(": ") + it.value().join(u'|');
                }
            }
        };
        check(QStringLiteral("menu bar"), window.menuBar()->actions());
        const QList<QMenu*> menus = window.menuBar()->findChildren<QMenu*>();
        QVERIFY(menus.size() > 8);
        for (const QMenu* menu : menus) {
            check(menu->title(), menu->actions());
        }
        QVERIFY2(doubles.isEmpty(), qPrintable(doubles.join(u'\n')));
    }
};

HITSCOPE_TEST(ShortcutsTest, QApplication)

}  // namespace hitscope::shortcuts_test

#include "shortcuts_test.moc"
