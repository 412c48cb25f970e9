// SPDX-License-Identifier: GPL-3.0-or-later
// The window says whether what it shows is the reference's in every bit.
#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QSignalSpy>
#include <QStatusBar>

#include "app/pipeline_chooser.h"
#include "support/read_back.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::exactness_test {

class ExactnessTest : public QObject {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void theStatusBarSaysIt();
    void inexactPipelineIsLeft();
    void theAboutBoxSaysIt();
    void theStatusBarSaysWhatFillsTheArrays();

private:
    /// Of the reference alone.
    static RendererVerdict referenceVerdict(const VertexDifference& compared) {
        RendererVerdict verdict;
        verdict.pipelines[PipelineKind::Reference] = {compared, {}};
        return verdict;
    }
    /// The status bar's entry with the renderer's name.
    static QLabel* rendererCell(MainWindow& window) {
        for (QLabel* label : window.statusBar()->findChildren<QLabel*>()) {
            if (label->text().startsWith(window.viewport().scene().rendererName())) {
                return label;
            }
        }
        return nullptr;
    }
    TestSettings m_settings;
};

void ExactnessTest::theStatusBarSaysIt() {
    Session session;
    loadPaperRow(session, 0);
    QVERIFY(session.readBack().verdict().pipelines.empty());
    MainWindow window(session);
    showReady(window);
    QVERIFY(session.readBack().exactness());  // measured on this renderer
    QVERIFY(session.readBack().verdict().of(session.settings().pipeline()) != nullptr);
    const QLabel* cell = rendererCell(window);
    QVERIFY(cell != nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(session.readBack().verdict().picking.has_value(),
                             kPatience);  // the rest follows
    QCOMPARE(session.readBack().verdict().pipelines.size(), allPipelines().size());

    session.settings().setPipeline(PipelineKind::Reference);
    test::readBackOf(session).setVerdict(referenceVerdict({15000, 0, 0.0f}));
    QCOMPARE(cell->text(), window.viewport().scene().rendererName() + QStringLiteral(", bit-exact"));
    QVERIFY(cell->toolTip().contains(QStringLiteral("Reference: bit-exact in 15,000 vertices compared")));
    QVERIFY(cell->toolTip().contains(QStringLiteral("Transform feedback: not compared yet")));
    const QSignalSpy changes(&session.readBack(), &ReadBack::verdictChanged);
    test::readBackOf(session).setVerdict(referenceVerdict({15000, 12, 0.1f}));
    test::readBackOf(session).setVerdict(referenceVerdict({15000, 12, 0.1f}));
    QCOMPARE(changes.count(), 1);
    QCOMPARE(cell->text(), window.viewport().scene().rendererName() + QStringLiteral(", not bit-exact"));
    QVERIFY(cell->toolTip().contains(QStringLiteral("12 of 15,000 vertices differ, by up to 0.1 m")));
    session.settings().setPipeline(PipelineKind::TransformFeedback);  // nothing is said of what was not tried
    test::readBackOf(session).setVerdict(referenceVerdict({15000, 12, 0.1f}));
    QCOMPARE(cell->text(), window.viewport().scene().rendererName());
}

/// One that nobody asked for is left where it is not exact; one that was chosen is not.
void ExactnessTest::inexactPipelineIsLeft() {
    Session session;
    loadPaperRow(session, 0);
    session.settings().setPipeline(PipelineKind::TransformFeedback);
    PipelineChooser chooser(session);
    QMenu menu;
    chooser.fill(menu);
    const QSignalSpy left(&chooser, &PipelineChooser::fellBack);
    chooser.leaveInexact();
    QCOMPARE(left.count(), 0);
    RendererVerdict verdict = referenceVerdict({15000, 0, 0.0f});
    verdict.pipelines[PipelineKind::TransformFeedback] = {{15000, 870, 3.3f}, {}};
    test::readBackOf(session).setVerdict(verdict);
    QCOMPARE(left.count(), 0);
    chooser.leaveInexact();
    QCOMPARE(session.settings().pipeline(), PipelineKind::Reference);
    QCOMPARE(left.count(), 1);
    QVERIFY(left.first().first().toString().contains(QStringLiteral("870 of 15,000 vertices differ")));
    for (QAction* action : menu.actions()) {
        if (action->text() == QStringLiteral("Transform feedback")) {
            QVERIFY(action->toolTip().contains(QStringLiteral("870 of 15,000 vertices differ")));
            QVERIFY(action->isEnabled());
            action->trigger();
        }
    }
    QCOMPARE(session.settings().pipeline(), PipelineKind::TransformFeedback);
    chooser.leaveInexact();
    QCOMPARE(session.settings().pipeline(), PipelineKind::TransformFeedback);
    QCOMPARE(left.count(), 1);
}

void ExactnessTest::theAboutBoxSaysIt() {
    Session session;
    loadPaperRow(session, 0);
    MainWindow window(session);
    showReady(window);
    session.settings().setPipeline(PipelineKind::Reference);
    test::readBackOf(session).setVerdict(referenceVerdict({4096, 12, 0.1f}));
    for (QAction* action : window.findChildren<QAction*>()) {
        if (action->text() == QStringLiteral("&About Hitscope")) {
            action->trigger();
        }
    }
    const auto* box = window.findChild<QMessageBox*>();
    QVERIFY(box != nullptr);
    QVERIFY(box->informativeText().contains(
        QStringLiteral("Reference: not bit-exact: 12 of 4,096 vertices differ, by up to 0.1 m")));
}

/// 600 hits are the paper's; fewer are the driver's.
void ExactnessTest::theStatusBarSaysWhatFillsTheArrays() {
    Session session;
    loadPaperRow(session, 0);
    MainWindow window(session);
    const auto saysDriver = [&window] {
        for (const QLabel* label : window.statusBar()->findChildren<QLabel*>()) {
            if (label->toolTip().startsWith(QStringLiteral("Hits made so far"))) {
                return label->toolTip().contains(
                    QStringLiteral("This graphics driver has room for no more."));
            }
        }
        return false;
    };
    CapacityReport report{600, false, 0, {}};
    test::readBackOf(session).setCapacity(report);
    QVERIFY(!saysDriver());
    report.capacity = 94;
    report.byDriver = true;
    test::readBackOf(session).setCapacity(report);
    QVERIFY(saysDriver());
}

HITSCOPE_TEST(ExactnessTest, QApplication)

}  // namespace hitscope::exactness_test

#include "exactness_test.moc"
