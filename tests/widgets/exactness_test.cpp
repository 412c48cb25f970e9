// SPDX-License-Identifier: GPL-3.0-or-later
// The window says whether what it shows is the reference's in every bit.
#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QMessageBox>
#include <QSignalSpy>
#include <QStatusBar>

#include "support/test_program.h"
#include "widgets/window_support.h"

using namespace hitscope;

class ExactnessTest : public QObject {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void theStatusBarSaysIt();
    void theAboutBoxSaysIt();

private:
    /// The status bar's entry with the renderer's name.
    static QLabel* rendererCell(MainWindow& window) {
        for (QLabel* label : window.statusBar()->findChildren<QLabel*>()) {
            if (label->text().startsWith(window.viewport().rendererName())) {
                return label;
            }
        }
        return nullptr;
    }
    TestSettings m_settings;
};

void ExactnessTest::theStatusBarSaysIt() {
    Session session;
    session.loadPaperRow(0);
    QVERIFY(!session.exactness());
    MainWindow window(session);
    showReady(window);
    QVERIFY(session.exactness());  // measured on this renderer
    const QLabel* cell = rendererCell(window);
    QVERIFY(cell != nullptr);

    session.setExactness({.exact = true, .vertices = 4096});
    QCOMPARE(cell->text(), window.viewport().rendererName() + QStringLiteral(", bit-exact"));
    QVERIFY(cell->toolTip().contains(QStringLiteral("bit-exact: every vertex as the reference has it")));
    const QSignalSpy changes(&session, &Session::exactnessChanged);
    session.setExactness({.vertices = 4096, .different = 12, .largest = 0.1f});
    session.setExactness({.vertices = 4096, .different = 12, .largest = 0.1f});
    QCOMPARE(changes.count(), 1);
    QCOMPARE(cell->text(), window.viewport().rendererName() + QStringLiteral(", not bit-exact"));
    QVERIFY(cell->toolTip().contains(QStringLiteral("12 of 4,096 vertices differ, by up to 0.1 m")));
}

void ExactnessTest::theAboutBoxSaysIt() {
    Session session;
    session.loadPaperRow(0);
    MainWindow window(session);
    showReady(window);
    session.setExactness({.vertices = 4096, .different = 12, .largest = 0.1f});
    for (QAction* action : window.findChildren<QAction*>()) {
        if (action->text() == QStringLiteral("&About Hitscope")) {
            action->trigger();
        }
    }
    const auto* box = window.findChild<QMessageBox*>();
    QVERIFY(box != nullptr);
    QVERIFY(box->informativeText().contains(QStringLiteral("12 of 4,096 vertices differ, by up to 0.1 m")));
}

HITSCOPE_TEST(ExactnessTest, QApplication)
#include "exactness_test.moc"
