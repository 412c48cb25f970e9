// SPDX-License-Identifier: GPL-3.0-or-later
// Drags whose button is released where the viewport does not hear of it: over a dialog that came meanwhile.
#include <QDialog>

#include "support/test_program.h"
#include "viewport/brush_tool.h"
#include "viewport/handles/cut_handle.h"
#include "viewport/handles/handle_grip.h"
#include "viewport/inspect_tool.h"
#include "widgets/window_support.h"

namespace hitscope::lost_release_test {

class LostReleaseTest : public QObject, protected WindowFixture {
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

    void dragsEnd_data() {
        QTest::addColumn<QString>("what");
        QTest::addColumn<bool>("isBlocked");
        for (const char* what : {"brush", "wipe", "hitSize", "hitDirection", "moveAcross", "cutHandle"}) {
            QTest::addRow("%s, seen by the mouse", what) << QString::fromLatin1(what) << false;
            QTest::addRow("%s, by a dialog", what) << QString::fromLatin1(what) << true;
        }
    }
    void dragsEnd() {
        QFETCH(QString, what);
        QFETCH(bool, isBlocked);
        take(what);
        const State before = state();
        mouse(QEvent::MouseButtonPress, {}, Qt::LeftButton);
        mouse(QEvent::MouseMove, {30.0, 10.0}, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(state() != before, kPatience);
        loseTheButton(isBlocked);
        QTRY_VERIFY_WITH_TIMEOUT(!viewport().brushTool().isPainting(), kPatience);
        const State dropped = state();
        mouse(QEvent::MouseMove, {45.0, 30.0}, Qt::NoButton);
        mouse(QEvent::MouseMove, {60.0, 40.0}, Qt::NoButton);
        QTest::qWait(50);
        QVERIFY(state() == dropped);
        // It is a step of its own, and what comes is another.
        m_from = grabbedAt();
        mouse(QEvent::MouseButtonPress, {}, Qt::LeftButton);
        mouse(QEvent::MouseMove, {-25.0, 20.0}, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(state() != dropped, kPatience);
        mouse(QEvent::MouseButtonRelease, {-25.0, 20.0}, Qt::NoButton);
        QTRY_VERIFY_WITH_TIMEOUT(!viewport().brushTool().isPainting(), kPatience);
        if (what != QLatin1String("wipe")) {
            m_session->undo();
            QVERIFY(state() == dropped);
            m_session->undo();
            QVERIFY(state() == before);
        }
    }

    void outlinesSelect_data() {
        QTest::addColumn<bool>("isBlocked");
        QTest::newRow("seen by the mouse") << false;
        QTest::newRow("by a dialog") << true;
    }
    void outlinesSelect() {
        QFETCH(bool, isBlocked);
        viewport().inspectTool().setTool(Tool::Inspect);
        m_widget = &viewport();
        m_from = viewport().mapToGlobal(QPointF(viewport().rect().center()) - QPointF(80.0, 80.0));
        mouse(QEvent::MouseButtonPress, {}, Qt::LeftButton);
        mouse(QEvent::MouseMove, {160.0, 160.0}, Qt::LeftButton);
        loseTheButton(isBlocked);
        const std::size_t selected = m_session->selection().count();
        QVERIFY(selected > 0);
        mouse(QEvent::MouseMove, {81.0, 81.0}, Qt::NoButton);
        QCOMPARE(m_session->selection().count(), selected);
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, QPoint(8, viewport().height() - 8));
        QCOMPARE(m_session->selection().count(), std::size_t{0});
        // A press that has not become a drag is no click either.
        mouse(QEvent::MouseButtonPress, {80.0, 80.0}, Qt::LeftButton);
        loseTheButton(isBlocked);
        mouse(QEvent::MouseMove, {81.0, 80.0}, Qt::NoButton);
        QCOMPARE(m_session->selection().count(), std::size_t{0});
    }

private:
    /// All that the drags change.
    struct State {
        std::vector<Hit> hits;
        RigidTransform transform;
        float wipeAt = 0.0f;
        float cut = 0.0f;
        bool operator==(const State&) const = default;
    };

    Viewport& viewport() { return m_window->viewport(); }
    State state() {
        const std::span<const Hit> hits = m_session->hits().history().hits();
        return {{hits.begin(), hits.end()},
                m_session->targets().front()->transform,
                viewport().options().beforeAfter.wipeAt,
                viewport().options().cut.offset};
    }
    /// In the middle of what is dragged: of the picture, on the line between original and deformed.
    QPointF grabbedAt() {
        QPointF middle = QRectF(m_widget->rect()).center();
        if (m_widget == &viewport()) {
            middle.setX(static_cast<double>(viewport().options().beforeAfter.wipeAt) * viewport().width());
        }
        return m_widget->mapToGlobal(middle);
    }

    /// What is dragged, and where.
    void take(const QString& what) {
        const auto press = [this](Qt::Key key) { QTest::keyClick(&viewport(), key); };
        m_widget = &viewport();
        if (what == QLatin1String("brush")) {
            press(Qt::Key_R);
        } else if (what == QLatin1String("wipe")) {
            press(Qt::Key_X);
        } else if (what == QLatin1String("cutHandle")) {
            press(Qt::Key_K);
            m_widget = viewport().findChild<CutHandle*>();
        } else {
            if (what == QLatin1String("moveAcross")) {
                press(Qt::Key_M);
            } else {
                m_session->hits().select(0);
            }
            m_widget = viewport().findChild<HandleGrip*>(what);
        }
        QTRY_VERIFY_WITH_TIMEOUT(m_widget->isVisible(), kPatience);
        m_from = grabbedAt();
    }

    void mouse(QEvent::Type type, const QPointF& way, Qt::MouseButtons held) {
        const QPointF global = m_from + way;
        QMouseEvent event(type, m_widget->mapFromGlobal(global), global,
                          type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, held, {});
        QCoreApplication::sendEvent(m_widget, &event);
    }

    /// A dialog gets the release, or the mouse is moved without a button.
    void loseTheButton(bool isBlocked) {
        if (!isBlocked) {
            mouse(QEvent::MouseMove, {30.0, 10.0}, Qt::NoButton);
            return;
        }
        QDialog dialog(m_window.get());
        dialog.setModal(true);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog, kPatience));
        dialog.close();
        makeActive(*m_window);
    }

    QWidget* m_widget = nullptr;
    QPointF m_from;  ///< on the screen
};

HITSCOPE_TEST(LostReleaseTest, QApplication)

}  // namespace hitscope::lost_release_test

#include "lost_release_test.moc"
