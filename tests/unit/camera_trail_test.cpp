// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/camera_trail.h"

#include <QSignalSpy>
#include <QTest>

#include "support/test_program.h"
#include "view/camera_text.h"
#include "viewport/navigation.h"

namespace hitscope::camera_trail_test {

class CameraTrailTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_navigation = std::make_unique<Navigation>([](const QPointF&) { return std::nullopt; });
        m_navigation->setGlides(false);
        m_trail = std::make_unique<CameraTrail>(*m_navigation);
        m_trail->note();
    }
    void cleanup() {
        m_trail.reset();
        m_navigation.reset();
    }

    void goesBackAndForward() {
        const std::string first = now();
        QVERIFY(!m_trail->canGoBack() && !m_trail->canGoForward());
        turn();
        const std::string second = now();
        m_trail->note();
        turn();  // did not come to rest yet
        const std::string third = now();
        QVERIFY(m_trail->canGoBack());
        m_trail->goBack();
        QCOMPARE(now(), second);
        m_trail->goBack();
        QCOMPARE(now(), first);
        QVERIFY(!m_trail->canGoBack());
        m_trail->goBack();
        QCOMPARE(now(), first);
        m_trail->goForward();
        m_trail->goForward();
        QCOMPARE(now(), third);
        QVERIFY(!m_trail->canGoForward());
    }

    void anotherWayEndsForward() {
        turn();
        const std::string second = now();
        m_trail->note();
        turn();
        m_trail->note();
        m_trail->goBack();
        turn();
        QVERIFY(m_trail->canGoBack());
        m_trail->goForward();  // the motion counts first
        QVERIFY(!m_trail->canGoForward());
        m_trail->goBack();
        QCOMPARE(now(), second);
    }

    void aViewCountsOnceTheCameraRests() {
        QSignalSpy changed(m_trail.get(), &CameraTrail::changed);
        turn();
        turn();
        QVERIFY(changed.wait());
        QCOMPARE(changed.size(), 1);
        m_trail->goBack();
        QVERIFY(!m_trail->canGoBack());
        m_trail->goForward();
        m_trail->note();  // where it is already
        QCOMPARE(changed.size(), 3);
    }

    void theOldestAreForgotten() {
        for (std::size_t i = 0; i < CameraTrail::kMost + 5; ++i) {
            turn();
            m_trail->note();
        }
        std::size_t back = 0;
        for (; m_trail->canGoBack(); ++back) {
            m_trail->goBack();
        }
        QCOMPARE(back, CameraTrail::kMost - 1);
        m_trail->clear();
        QVERIFY(!m_trail->canGoBack() && !m_trail->canGoForward());
    }

private:
    [[nodiscard]] std::string now() const { return cameraText(m_navigation->camera()); }
    void turn() { m_navigation->turnBy({7.0, 0.0}); }

    std::unique_ptr<Navigation> m_navigation;
    std::unique_ptr<CameraTrail> m_trail;
};

HITSCOPE_TEST(CameraTrailTest, QCoreApplication)

}  // namespace hitscope::camera_trail_test

#include "camera_trail_test.moc"
