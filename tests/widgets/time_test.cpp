// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <cmath>

#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::time_test {

/// Pause, single step, slow motion and time scale, by key and in the tool bar; the badge says so.
class TimeTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init();
    void cleanup() { dropWindow(); }
    void pauseKeyStopsAFlight();
    void stepKeyMakesOneStepAndPauses();
    void slowMotionAndScale();
    void whatIsSetIsRemembered();

private:
    [[nodiscard]] QLabel& badge() const { return *m_window->findChild<QLabel*>("timeBadge"); }
    [[nodiscard]] double time() const { return m_session->simulation().physics().clock().time(); }
};

void TimeTest::init() {
    makeWindow([](Session& session) { loadPaperRow(session, kDefaultPaperRow); });
}

void TimeTest::pauseKeyStopsAFlight() {
    QVERIFY(!badge().isVisible());
    m_session->simulation().shoot({{0, 50, 0}, {0, 1, 0}});
    QTRY_VERIFY_WITH_TIMEOUT(time() > 0.05, kPatience);
    QTest::keyClick(&m_window->viewport(), Qt::Key_P);
    QVERIFY(m_session->simulation().isPaused());
    QVERIFY(badge().isVisible());
    QCOMPARE(badge().text(), QStringLiteral("Paused"));
    const double stopped = time();
    QTest::qWait(200);
    QCOMPARE(time(), stopped);
    QTest::keyClick(&m_window->viewport(), Qt::Key_P);
    QVERIFY(!m_session->simulation().isPaused());
    QVERIFY(!badge().isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(time() > stopped, kPatience);
}

void TimeTest::stepKeyMakesOneStepAndPauses() {
    m_session->simulation().shoot({{0, 50, 0}, {0, 1, 0}});
    QTest::keyClick(&m_window->viewport(), Qt::Key_Period);
    QVERIFY(m_session->simulation().isPaused());
    const double before = time();
    QTest::keyClick(&m_window->viewport(), Qt::Key_Period);
    QVERIFY(std::abs(time() - before - m_session->simulation().physics().clock().step()) < 1e-12);
    QVERIFY(m_window->findChild<QAction*>("pauseTime")->isChecked());
}

void TimeTest::slowMotionAndScale() {
    auto* box = m_window->findChild<QDoubleSpinBox*>("timeScale");
    QVERIFY(box != nullptr && box->isVisible());
    QTest::keyClick(&m_window->viewport(), Qt::Key_Comma);
    QCOMPARE(m_session->simulation().physics().clock().timeScale(), 0.1);
    QCOMPARE(box->value(), 0.1);
    QVERIFY(badge().text().contains(QStringLiteral("0.1")));
    QTest::keyClick(&m_window->viewport(), Qt::Key_Comma);
    QCOMPARE(m_session->simulation().physics().clock().timeScale(), 1.0);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, box->locale().toString(2.5, 'f', 2));
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(m_session->simulation().physics().clock().timeScale(), 2.5);
    QVERIFY(badge().text().contains(QStringLiteral("2.5")));
    QVERIFY(m_window->viewport().hasFocus());
}

void TimeTest::whatIsSetIsRemembered() {
    m_session->simulation().setStep(1.0 / 1000.0);
    QAction* texture = nullptr;
    for (QAction* action : m_window->findChildren<QAction*>()) {
        texture = action->text().contains(QStringLiteral("1K")) ? action : texture;
    }
    QVERIFY(texture != nullptr);
    texture->trigger();
    m_window->close();
    m_window.reset();
    m_session = std::make_unique<Session>();
    m_window = std::make_unique<MainWindow>(*m_session);
    QVERIFY(std::abs(m_session->simulation().physics().clock().step() - 0.001) < 1e-12);
    QTRY_VERIFY_WITH_TIMEOUT(m_session->settings().coverTexture() != nullptr, kPatience);
    QCOMPARE(m_session->settings().coverTexture()->width, 1024);
}

HITSCOPE_TEST(TimeTest, QApplication)

}  // namespace hitscope::time_test

#include "time_test.moc"
