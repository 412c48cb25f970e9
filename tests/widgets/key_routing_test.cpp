// SPDX-License-Identifier: GPL-3.0-or-later
// Keys while a spin box of a dock or of the tool bar has the focus, with real key events.
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QTableView>

#include "app/main_window.h"
#include "support/test_program.h"
#include "viewport/inspect_tool.h"
#include "widgets/window_support.h"

namespace hitscope::key_routing_test {

class KeyRoutingTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        makeWindow();
        Hit hit;
        hit.target = m_session->targets().front()->id;
        hit.point = {0.0f, 0.0f, 2.5f};
        QVERIFY(m_session->hits().add(hit));
    }
    void cleanup() { dropWindow(); }

    void keysWorkInEveryPanel_data() {
        QTest::addColumn<QString>("parent");
        QTest::addColumn<QString>("name");
        QTest::newRow("constants") << "deformationConstants"
                                   << "max_distance";
        QTest::newRow("lights") << "lights"
                                << "diffuse";
        QTest::newRow("scene") << "scene"
                               << "positionX";
        QTest::newRow("tool bar") << "tools"
                                  << "timeScale";
    }
    void keysWorkInEveryPanel() {
        QFETCH(QString, parent);
        QFETCH(QString, name);
        QAbstractSpinBox* box = focusedBox(parent, name);
        QVERIFY(box != nullptr);
        QLineEdit* editor = box->findChild<QLineEdit*>();

        // What has been typed is not a command yet, nor are keys pressed then.
        editor->selectAll();
        QTest::keyClicks(box, QStringLiteral("0.7"));
        const WireframeMode wireframe = viewport().options().wireframe;
        QTest::keyClick(box, Qt::Key_L);
        QCOMPARE(viewport().options().wireframe, wireframe);
        QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_session->hits().history().size(), std::size_t{1});
        // Return: the number is in force, and the picture has the focus.
        editor->selectAll();
        QTest::keyClicks(box, QStringLiteral("0,75"));
        QTest::keyClick(box, Qt::Key_Return);
        QVERIFY(viewport().hasFocus());
        QVERIFY2(editor->text().startsWith(QStringLiteral("0.75")), qPrintable(editor->text()));
        const double scale = m_session->simulation().physics().clock().timeScale();
        QCOMPARE(scale, name == QStringLiteral("timeScale") ? 0.75 : 1.0);  // not the key of slow motion

        // A box that merely has the focus leaves the keys to the window.
        box->setFocus();
        QTest::keyClick(box, Qt::Key_L);
        QVERIFY(viewport().options().wireframe != wireframe);
        QVERIFY(box->hasFocus());
        while (m_session->steps().canUndo()) {
            QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
        }
        QCOMPARE(m_session->hits().history().size(), std::size_t{0});
        QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(m_session->hits().history().size(), std::size_t{1});
        QTest::keyClick(box, Qt::Key_I);
        QCOMPARE(viewport().inspectTool().tool(), Tool::Inspect);
        m_session->hits().select(0);
        QTest::keyClick(box, Qt::Key_Escape);
        QVERIFY(!m_session->hits().selected());
        QVERIFY(viewport().hasFocus());

        // The keys that fly take the focus along; digits are the box's.
        box->setFocus();
        const glm::vec3 eye = viewport().camera().eye();
        QTest::keyPress(box, Qt::Key_W);
        QVERIFY(viewport().hasFocus());
        QTRY_VERIFY_WITH_TIMEOUT(viewport().camera().eye() != eye, kPatience);
        QTest::keyRelease(&viewport(), Qt::Key_W);
    }

    void whatATextRefusesIsNoCommand_data() {
        QTest::addColumn<int>("way");
        QTest::newRow("mouse") << 0;
        QTest::newRow("select all") << 1;
        QTest::newRow("tab") << 2;
    }
    void whatATextRefusesIsNoCommand() {
        QFETCH(int, way);
        QAbstractSpinBox* box = focusedBox(QStringLiteral("scene"), QStringLiteral("positionX"));
        QVERIFY(box != nullptr);
        auto* editor = box->findChild<QLineEdit*>();
        if (way == 0) {
            QTest::mouseClick(editor, Qt::LeftButton, {}, QPoint(6, editor->height() / 2));
        } else if (way == 1) {
            QTest::keyClick(box, Qt::Key_A, Qt::ControlModifier);
        } else {
            viewport().setFocus();
            box->setFocus(Qt::TabFocusReason);
        }
        QVERIFY(box->hasFocus());
        const QString text = editor->text();
        const glm::vec3 eye = viewport().camera().eye();
        const WireframeMode wireframe = viewport().options().wireframe;
        for (const Qt::Key key : {Qt::Key_L, Qt::Key_W, Qt::Key_Space, Qt::Key_I}) {
            QTest::keyClick(box, key);
        }
        QCOMPARE(viewport().options().wireframe, wireframe);
        QCOMPARE(viewport().inspectTool().tool(), Tool::Shoot);
        QVERIFY(viewport().camera().eye() == eye);
        QVERIFY(box->hasFocus());
        QCOMPARE(m_session->simulation().physics().projectileCount(), std::size_t{0});
        QTest::keyClick(box, Qt::Key_Return);
        QCOMPARE(editor->text(), text);  // what is no number is not taken
    }

    void escapeDropsWhatWasTyped_data() {
        QTest::addColumn<QString>("parent");
        QTest::addColumn<QString>("name");
        QTest::newRow("lights") << "lights"
                                << "diffuse";
        QTest::newRow("tool bar") << "tools"
                                  << "timeScale";
    }
    void escapeDropsWhatWasTyped() {
        QFETCH(QString, parent);
        QFETCH(QString, name);
        auto* box = qobject_cast<QDoubleSpinBox*>(focusedBox(parent, name));
        QVERIFY(box != nullptr);
        const double before = box->value();
        box->findChild<QLineEdit*>()->selectAll();
        QTest::keyClicks(box, QStringLiteral("0.3"));
        QTest::keyClick(box, Qt::Key_Escape);
        QVERIFY(viewport().hasFocus());
        QCOMPARE(box->value(), before);
    }

    void listsKeepHomeAndEnd() {
        auto* dock = m_window->findChild<QDockWidget*>(QStringLiteral("deformationConstants"));
        dock->show();
        dock->raise();
        auto* box = dock->findChild<QComboBox*>(QStringLiteral("profile"));
        QVERIFY(box != nullptr && QTest::qWaitFor([box] { return box->isVisible(); }, kPatience));
        box->setFocus();
        const glm::vec3 eye = viewport().camera().eye();
        QTest::keyClick(box, Qt::Key_End);
        QCOMPARE(box->currentIndex(), box->count() - 1);
        QTest::keyClick(box, Qt::Key_Home);
        QCOMPARE(box->currentIndex(), 0);
        QVERIFY(viewport().camera().eye() == eye);
    }

    void tablesKeepTheirKeys() {
        auto* dock = m_window->findChild<QDockWidget*>(QStringLiteral("hitHistory"));
        dock->raise();
        auto* table = dock->findChild<QTableView*>(QStringLiteral("table"));
        table->setFocus();
        table->selectRow(0);
        QTest::keyClick(table, Qt::Key_Space);
        QCOMPARE(m_session->hits().disabled(), std::size_t{1});
        QTest::keyClick(table, Qt::Key_Escape);
        QVERIFY(!m_session->hits().selected());
        QVERIFY(viewport().hasFocus());
    }

private:
    Viewport& viewport() { return m_window->viewport(); }
    QAbstractSpinBox* focusedBox(const QString& parent, const QString& name) {
        auto* widget = m_window->findChild<QWidget*>(parent);
        widget->show();
        widget->raise();
        m_session->targets().select(m_session->targets().front()->id);
        auto* box = widget->findChild<QAbstractSpinBox*>(name);
        if (box == nullptr || !QTest::qWaitFor([box] { return box->isVisible(); }, kPatience)) {
            return nullptr;
        }
        box->setFocus();
        return box->hasFocus() ? box : nullptr;
    }
};

HITSCOPE_TEST(KeyRoutingTest, QApplication)

}  // namespace hitscope::key_routing_test

#include "key_routing_test.moc"
