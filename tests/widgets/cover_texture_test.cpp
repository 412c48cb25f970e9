// SPDX-License-Identifier: GPL-3.0-or-later
// Worn panels on all targets, made beside the window's work.
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "app/dialogs/texture_chooser.h"
#include "app/session_files.h"
#include "mesh/panel_texture.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::cover_texture_test {

class CoverTextureTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() { makeWindow(loadTeapot); }
    void cleanup() { dropWindow(); }

    /// What the settings ask for is being made while the session is opened: it comes too late.
    void aSessionWithoutOneStaysWithout() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("plain.hitscope"));
        auto* files = m_window->findChild<SessionFiles*>();
        files->save(path);
        QTRY_VERIFY_WITH_TIMEOUT(!files->isBusy(), kPatience);
        QElapsedTimer clock;
        clock.start();
        QCOMPARE(makePanelTexture(kLarge).width, kLarge);
        const qint64 takes = clock.elapsed();

        auto* chooser = m_window->findChild<TextureChooser*>();
        QSignalSpy opened(files, &SessionFiles::opened);
        chooser->restore(kLarge);
        m_window->openFiles({path});
        QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatience);
        QTest::qWait(static_cast<int>(3 * takes) + 500);
        QVERIFY(m_session->settings().coverTexture() == nullptr);
        QCOMPARE(chooser->chosen(), 0);

        chooser->choose(kSmall);
        QTRY_VERIFY_WITH_TIMEOUT(m_session->settings().coverTexture() != nullptr, kPatience);
        QCOMPARE(m_session->settings().coverTexture()->width, kSmall);
        QCOMPARE(chooser->chosen(), kSmall);
    }

    /// What was chosen last wins, whichever is ready first.
    void theLastChoiceCounts() {
        auto* chooser = m_window->findChild<TextureChooser*>();
        chooser->choose(kLarge);
        chooser->choose(kSmall);
        QTRY_VERIFY_WITH_TIMEOUT(m_session->settings().coverTexture() != nullptr, kPatience);
        QCOMPARE(m_session->settings().coverTexture()->width, kSmall);
        chooser->choose(0);
        QVERIFY(m_session->settings().coverTexture() == nullptr);
    }

private:
    static constexpr int kSmall = 1024;  // pixels each way
    static constexpr int kLarge = 2048;
};

HITSCOPE_TEST(CoverTextureTest, QApplication)

}  // namespace hitscope::cover_texture_test

#include "cover_texture_test.moc"
