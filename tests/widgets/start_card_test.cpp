// SPDX-License-Identifier: GPL-3.0-or-later
// What the first start shows, and how it goes away.
#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "app/notice_bar.h"
#include "app/overlays/start_card.h"
#include "app/session_files.h"
#include "session/welcome.h"
#include "support/test_program.h"
#include "viewport/inspect_tool.h"
#include "window_support.h"

namespace hitscope::start_card_test {

class StartCardTest : public QObject, WindowFixture {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        makeWindow(loadWelcomeScene);
        m_window->showFirstSteps();
    }
    void cleanup() { dropWindow(); }

    void firstSceneHasOneDent() {
        QCOMPARE(m_session->targets().size(), std::size_t{1});
        QCOMPARE(m_session->hits().history().size(), std::size_t{1});
        const DeformedMesh& mesh = m_session->targets().front()->deformed;
        QTRY_VERIFY_WITH_TIMEOUT(
            mesh.vertices().size() == mesh.render().vertices.size() && movedVertices(mesh) > 50, kPatience);
    }

    void saysMoreAfterTheFirstShot() {
        QVERIFY(card()->isVisible());
        const QRect picture = onScreen(m_window->viewport());
        QTest::keyClick(&m_window->viewport(), Qt::Key_Space);
        const auto* words = card()->findChild<QLabel*>(QStringLiteral("startWords"));
        QVERIFY(words->text().contains(QStringLiteral("Ctrl+Z")));
        // The picture does not jump under the cursor: neither now nor when the window lays itself out.
        QCoreApplication::processEvents();
        QVERIFY(card()->isVisible());
        QCOMPARE(onScreen(m_window->viewport()), picture);
        // Another scene is another picture anyway.
        loadWelcomeScene(*m_session);
        QVERIFY(!card()->isVisible());
        // At the next start as well, until Help brings it back.
        makeWindow(loadWelcomeScene);
        m_window->showFirstSteps();
        QVERIFY(!card()->isVisible());
        card()->toggle()->trigger();
        QVERIFY(card()->isVisible());
    }

    void goesAwayWithASessionThatHasHits() {
        QTemporaryDir folder;
        auto& files = *m_window->findChild<SessionFiles*>();
        files.save(folder.filePath(QStringLiteral("s.hitscope")));
        QTRY_VERIFY_WITH_TIMEOUT(!files.path().isEmpty(), kPatience);
        QVERIFY(card()->isVisible());
        files.open(files.path());
        QTRY_VERIFY_WITH_TIMEOUT(!card()->isVisible(), kPatience);
    }

    void closesByItsButton() {
        QTest::mouseClick(card()->findChild<QToolButton*>(QStringLiteral("closeStartCard")), Qt::LeftButton);
        QVERIFY(!card()->isVisible());
        QVERIFY(!card()->toggle()->isChecked());
    }

    void buttonsDoWhatTheySay() {
        auto* inspect = card()->findChild<QToolButton*>(QStringLiteral("startInspect"));
        QTest::mouseClick(inspect, Qt::LeftButton);
        QCOMPARE(m_window->viewport().inspectTool().tool(), Tool::Inspect);
        const auto* words = card()->findChild<QLabel*>(QStringLiteral("startWords"));
        QVERIFY(words->text().contains(QStringLiteral("Click a vertex")));
        m_window->viewport().inspectTool().setTool(Tool::Brush);
        QVERIFY(words->text().contains(QStringLiteral("paint")));
        m_window->viewport().inspectTool().setTool(Tool::Shoot);
        QVERIFY(words->text().contains(QStringLiteral("shoot")));
        auto* samples = card()->findChild<QToolButton*>(QStringLiteral("startSamples"));
        QVERIFY(!samples->menu()->actions().isEmpty());
    }

    /// Above the picture and below it: neither covers any of it.
    void coversNothing() {
        auto* notice = m_window->findChild<NoticeBar*>();
        notice->say(QStringLiteral("Something to know"));
        QTRY_VERIFY_WITH_TIMEOUT(notice->isVisible() && notice->height() > 0, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(!onScreen(*notice).intersects(onScreen(m_window->viewport())), kPatience);
        QVERIFY(!onScreen(*card()).intersects(onScreen(m_window->viewport())));
        const int height = m_window->viewport().height();
        notice->clear();
        QTRY_VERIFY_WITH_TIMEOUT(m_window->viewport().height() > height, kPatience);
    }

private:
    StartCard* card() { return m_window->findChild<StartCard*>(); }
    static QRect onScreen(const QWidget& widget) { return {widget.mapToGlobal(QPoint(0, 0)), widget.size()}; }
    static std::size_t movedVertices(const DeformedMesh& mesh) {
        std::size_t moved = 0;
        for (std::size_t i = 0; i < mesh.vertices().size(); ++i) {
            moved += mesh.vertices()[i].position != mesh.render().vertices[i].position ? 1 : 0;
        }
        return moved;
    }
};

HITSCOPE_TEST(StartCardTest, QApplication)

}  // namespace hitscope::start_card_test

#include "start_card_test.moc"
