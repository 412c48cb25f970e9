// SPDX-License-Identifier: GPL-3.0-or-later
// Drags of handles that are given up: by the right button, or by Escape.
#include <QMenu>

#include "support/test_program.h"
#include "viewport/handles/cut_handle.h"
#include "viewport/handles/handle_grip.h"
#include "widgets/window_support.h"

namespace hitscope::cancelled_drags_test {

class CancelledDragsTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        makeWindow();
        QVERIFY(m_session->simulation().hitscan(viewport().rayThrough({0.5, 0.5})));
        QVERIFY(viewport().syncNow().ok());
    }
    void cleanup() { dropWindow(); }

    void allIsAsBefore_data() {
        QTest::addColumn<QString>("what");
        QTest::addColumn<bool>("byKey");
        for (const char* what :
             {"wipe", "hitSize", "hitDepth", "hitDirection", "moveAcross", "turnY", "cutHandle"}) {
            QTest::addRow("%s, by the right button", what) << QString::fromLatin1(what) << false;
            QTest::addRow("%s, by Escape", what) << QString::fromLatin1(what) << true;
        }
    }
    void allIsAsBefore() {
        QFETCH(QString, what);
        QFETCH(bool, byKey);
        take(what);
        const State before = state();
        mouse(QEvent::MouseButtonPress, {}, Qt::LeftButton, Qt::LeftButton);
        mouse(QEvent::MouseMove, {30.0, 10.0}, Qt::NoButton, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!(state() == before), kPatience);
        if (byKey) {
            QTest::keyClick(&viewport(), Qt::Key_Escape);
        } else {
            mouse(QEvent::MouseButtonPress, {30.0, 10.0}, Qt::RightButton, Qt::LeftButton | Qt::RightButton);
        }
        QVERIFY(state() == before);
        // Until the buttons are up, and after that, nothing comes of them.
        mouse(QEvent::MouseMove, {60.0, 40.0}, Qt::NoButton, Qt::LeftButton);
        if (!byKey) {
            mouse(QEvent::MouseButtonRelease, {60.0, 40.0}, Qt::RightButton, Qt::LeftButton);
        }
        mouse(QEvent::MouseButtonRelease, {60.0, 40.0}, Qt::LeftButton, Qt::NoButton);
        QTest::qWait(50);
        QVERIFY(state() == before);
        QVERIFY(viewport().findChild<QMenu*>(QStringLiteral("viewportMenu")) == nullptr);
    }

private:
    /// All that the drags and clicks change.
    struct State {
        std::vector<Hit> hits;
        RigidTransform transform;
        float wipeAt = 0.0f;
        float cut = 0.0f;
        std::size_t done = 0;  ///< steps
        glm::vec3 eye{0.0f};
        bool operator==(const State&) const = default;
    };

    Viewport& viewport() { return m_window->viewport(); }
    State state() {
        const std::span<const Hit> hits = m_session->hits().history().hits();
        return {{hits.begin(), hits.end()},
                m_session->targets().front()->transform,
                viewport().options().beforeAfter.wipeAt,
                viewport().options().cut.offset,
                m_session->steps().done(),
                viewport().camera().eye()};
    }

    /// What is dragged, and where it is taken.
    void take(const QString& what) {
        m_widget = &viewport();
        if (what == QLatin1String("wipe")) {
            QTest::keyClick(&viewport(), Qt::Key_X);
        } else if (what == QLatin1String("cutHandle")) {
            QTest::keyClick(&viewport(), Qt::Key_K);
            m_widget = viewport().findChild<CutHandle*>();
        } else {
            if (what.startsWith(QLatin1String("hit"))) {
                m_session->hits().select(0);
            } else {
                QTest::keyClick(&viewport(), Qt::Key_M);
            }
            m_widget = viewport().findChild<HandleGrip*>(what);
        }
        QTRY_VERIFY_WITH_TIMEOUT(m_widget->isVisible(), kPatience);
        QPointF middle = QRectF(m_widget->rect()).center();
        if (m_widget == &viewport()) {
            middle.setX(static_cast<double>(viewport().options().beforeAfter.wipeAt) * viewport().width());
        }
        m_from = m_widget->mapToGlobal(middle);
    }

    void mouse(QEvent::Type type, const QPointF& way, Qt::MouseButton button, Qt::MouseButtons held) {
        const QPointF global = m_from + way;
        QMouseEvent event(type, m_widget->mapFromGlobal(global), global, button, held, {});
        QCoreApplication::sendEvent(m_widget, &event);
    }

    QWidget* m_widget = nullptr;
    QPointF m_from;  ///< on the screen
};

HITSCOPE_TEST(CancelledDragsTest, QApplication)

}  // namespace hitscope::cancelled_drags_test

#include "cancelled_drags_test.moc"
