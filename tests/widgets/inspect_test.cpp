// SPDX-License-Identifier: GPL-3.0-or-later
// Pointing at vertices in the window, and the vertex changes dock, with real mouse and keys.
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QGuiApplication>
#include <QLabel>
#include <QTableView>
#include <glm/geometric.hpp>

#include "mesh/primitives.h"
#include "models/attribution_model.h"
#include "models/vertex_changes_model.h"
#include "scene/screen_space.h"
#include "session/vertex_selection.h"
#include "support/test_program.h"
#include "viewport/inspect_tool.h"
#include "widgets/window_support.h"

namespace hitscope::inspect_test {

class InspectTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        makeWindow();
        QVERIFY(m_session->simulation().hitscan(ray(centre())));
        QVERIFY(m_session->simulation().hitscan(ray(centre() + QPoint(60, 10))));
        QVERIFY(viewport().syncNow().ok());
        QVERIFY(target().deformed.statistics().changedVertices > 20);
    }
    void cleanup() { dropWindow(); }

    void altClickPicksAndShootsNothing() {
        const std::size_t hits = m_session->hits().history().size();
        QTest::mouseClick(&viewport(), Qt::LeftButton, Qt::AltModifier, centre());
        const auto picked = selection().picked();
        QVERIFY(picked.has_value());
        QCOMPARE(selection().count(), std::size_t{1});
        QVERIFY(distanceTo(*picked, centre()) < 25.0);
        QTest::qWait(500);
        QCOMPARE(m_session->hits().history().size(), hits);
        QVERIFY(!m_session->simulation().isMoving());
        QTest::keyClick(&viewport(), Qt::Key_Escape);
        QVERIFY(!selection().picked());
        QCOMPARE(selection().count(), std::size_t{0});
    }

    void plainClickStillShoots() {
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, centre());
        QTRY_VERIFY_WITH_TIMEOUT(m_session->simulation().isMoving(), kPatience);
        QVERIFY(!selection().picked());
    }

    void inspectClicksPickAddAndRemove() {
        inspect();
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, centre());
        const auto first = selection().picked();
        QVERIFY(first.has_value());
        QTest::mouseClick(&viewport(), Qt::LeftButton, Qt::ControlModifier, centre() + QPoint(60, 10));
        QVERIFY(selection().picked() != first);
        QCOMPARE(selection().count(), std::size_t{2});
        QTest::mouseClick(&viewport(), Qt::LeftButton, Qt::ShiftModifier, centre());
        QCOMPARE(selection().count(), std::size_t{1});
        QVERIFY(!selection().isSelected(*first));
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, QPoint(8, viewport().height() - 8));
        QCOMPARE(selection().count(), std::size_t{0});
        QVERIFY(!selection().picked());
        QCOMPARE(m_session->hits().history().size(), std::size_t{2});
    }

    void hoverSaysWhatIsUnderTheCursor() {
        inspect();
        auto* label = m_window->findChild<QLabel*>(QStringLiteral("vertexLabel"));
        QVERIFY(label != nullptr);
        QVERIFY(!label->isVisible());
        QTest::mouseMove(&viewport(), centre() + QPoint(3, 2));
        QTest::mouseMove(&viewport(), centre());
        QTRY_VERIFY_WITH_TIMEOUT(label->isVisible(), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(selection().hovered().has_value(), kPatience);
        const std::uint32_t vertex = selection().hovered()->vertex;
        QVERIFY(label->text().contains(vertexNumberText(vertex)));
        QVERIFY(label->text().contains(QStringLiteral("Moved by")) == target().deformed.isChanged(vertex));
        QVERIFY(viewport().rect().contains(label->geometry()));
        QTest::mouseMove(&viewport(), QPoint(viewport().width() - 4, 4));
        QTRY_VERIFY_WITH_TIMEOUT(!label->isVisible(), kPatience);
    }

    void dragsSelectChangedVertices() {
        inspect();
        drag({centre() - QPoint(70, 70), centre() + QPoint(140, 80)}, {});
        const std::size_t visible = selection().count();
        QVERIFY(visible > 10);
        for (const std::uint32_t vertex : selection().vertices(target().id)) {
            QVERIFY(target().deformed.isChanged(vertex));
        }
        QCOMPARE(m_session->hits().history().size(), std::size_t{2});
        // A lasso around the first dent's middle takes some away.
        viewport().inspectTool().setOutline(Outline::Lasso);
        drag({centre() + QPoint(-12, -12), centre() + QPoint(12, -12), centre() + QPoint(12, 12),
              centre() + QPoint(-12, 12)},
             Qt::ShiftModifier);
        const std::size_t left = selection().count();
        QVERIFY(left < visible);
        QVERIFY(left > 0);
        drag({centre() + QPoint(-12, -12), centre() + QPoint(12, -12), centre() + QPoint(12, 12),
              centre() + QPoint(-12, 12)},
             Qt::ControlModifier);
        QCOMPARE(selection().count(), visible);
        viewport().inspectTool().setOutline(Outline::Rectangle);
        drag({QPoint(2, 2), QPoint(20, 20)}, {});
        QCOMPARE(selection().count(), std::size_t{0});
    }

    void altDragMovesTheCamera() {
        inspect();
        const glm::vec3 before = viewport().camera().eye();
        drag({centre(), centre() + QPoint(80, 10)}, Qt::AltModifier);
        QVERIFY(glm::distance(viewport().camera().eye(), before) > 0.1f);
        QCOMPARE(selection().count(), std::size_t{0});
        const glm::vec3 turned = viewport().camera().eye();
        drag({centre() - QPoint(50, 50), centre() + QPoint(50, 50)}, {});
        QCOMPARE(viewport().camera().eye(), turned);
    }

    void keyAndEscape() {
        QCOMPARE(viewport().inspectTool().tool(), Tool::Shoot);
        QTest::keyClick(&viewport(), Qt::Key_I);
        QCOMPARE(viewport().inspectTool().tool(), Tool::Inspect);
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, centre());
        sendMove(centre() + QPoint(60, 60), {});
        QTest::keyClick(&viewport(), Qt::Key_Escape);  // gives the drag up
        sendMove(centre() + QPoint(90, 90), {});
        QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, centre() + QPoint(90, 90));
        QCOMPARE(selection().count(), std::size_t{0});
        QTest::keyClick(&viewport(), Qt::Key_I);
        QCOMPARE(viewport().inspectTool().tool(), Tool::Shoot);
    }

    void tableAndViewportShareTheSelection() {
        QTableView& table = vertexTable();
        const auto& model = *static_cast<const VertexChangesModel*>(table.model());
        QTRY_VERIFY_WITH_TIMEOUT(
            model.isUpToDate() &&
                model.rowCount() == static_cast<int>(target().deformed.statistics().changedVertices),
            kPatience);
        const QImage before = viewport().surface().grab();
        click(table, 0, {});
        QCOMPARE(selection().picked(), (VertexRef{target().id, model.vertexAt(0)}));
        click(table, 3, Qt::ShiftModifier);
        QCOMPARE(selection().count(), std::size_t{4});
        click(table, 1, Qt::ControlModifier);
        QCOMPARE(selection().count(), std::size_t{3});
        QVERIFY(viewport().surface().grab() != before);  // dots
        QTest::keyClick(&table, Qt::Key_Down);
        QCOMPARE(selection().count(), std::size_t{1});
        QVERIFY(selection().isSelected({target().id, model.vertexAt(2)}));
        QTest::keyClick(&table, Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(selection().count(), static_cast<std::size_t>(model.rowCount()));
        QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QGuiApplication::clipboard()->text().count(u'\n'), model.rowCount() + 1);
        QTest::keyClick(&table, Qt::Key_Escape);
        QCOMPARE(selection().count(), std::size_t{0});

        QTest::mouseClick(&viewport(), Qt::LeftButton, Qt::AltModifier, centre());
        const int row = model.rowOf(selection().picked()->vertex);
        QVERIFY(row >= 0);
        QCOMPARE(table.currentIndex().row(), row);
        QVERIFY(table.viewport()->rect().intersects(table.visualRect(table.currentIndex())));
    }

    void attributionSaysWhichHits() {
        vertexTable();
        QTest::mouseClick(&viewport(), Qt::LeftButton, Qt::AltModifier, centre());
        auto* table = m_window->findChild<QTableView*>(QStringLiteral("attribution"));
        const auto& model = *static_cast<const AttributionModel*>(table->model());
        QVERIFY(model.rowCount() > 0);
        QVERIFY(model.isBuffers());
        const QPoint cell = table->visualRect(model.index(0, 1)).center();
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, cell);
        QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, cell);
        QCOMPARE(m_session->hits().selected(), std::optional(model.contributions()[0].hit));
        auto* sum = m_window->findChild<QLabel*>(QStringLiteral("attributionSum"));
        QVERIFY(sum->text().contains(QStringLiteral("bit-exact")));
    }

private:
    [[nodiscard]] Viewport& viewport() { return m_window->viewport(); }
    [[nodiscard]] VertexSelection& selection() { return m_session->selection(); }
    [[nodiscard]] const Target& target() const { return *m_session->targets().front(); }
    [[nodiscard]] QPoint centre() { return viewport().rect().center(); }
    [[nodiscard]] Ray ray(const QPoint& at) { return viewport().navigation().rayAt(at); }
    void inspect() { viewport().inspectTool().setTool(Tool::Inspect); }

    /// Logical pixels between where a vertex is seen and a point.
    [[nodiscard]] double distanceTo(const VertexRef& vertex, const QPoint& point) {
        SceneGpu::View view;
        view.width = viewport().width();
        view.height = viewport().height();
        view.camera = viewport().camera();
        const auto at =
            ScreenSpace(view, target().transform).project(target().deformed.positions()[vertex.vertex]);
        return std::hypot(static_cast<double>(at->at.x) - point.x(),
                          static_cast<double>(at->at.y) - point.y());
    }

    void sendMove(const QPoint& to, Qt::KeyboardModifiers keys) {
        QMouseEvent move(QEvent::MouseMove, to, viewport().mapToGlobal(QPointF(to)), Qt::NoButton,
                         Qt::LeftButton, keys);
        QCoreApplication::sendEvent(&viewport(), &move);
    }

    void drag(const QList<QPoint>& path, Qt::KeyboardModifiers keys) {
        QTest::mousePress(&viewport(), Qt::LeftButton, keys, path.constFirst());
        for (qsizetype i = 1; i < path.size(); ++i) {
            for (int step = 1; step <= 4; ++step) {
                sendMove(path[i - 1] + (path[i] - path[i - 1]) * step / 4, keys);
            }
        }
        QTest::mouseRelease(&viewport(), Qt::LeftButton, keys, path.constLast());
    }

    void click(QTableView& table, int row, Qt::KeyboardModifiers keys) {
        QTest::mouseClick(table.viewport(), Qt::LeftButton, keys,
                          table.visualRect(table.model()->index(row, 0)).center());
    }

    /// Shows the dock.
    QTableView& vertexTable() {
        auto* dock = m_window->findChild<QDockWidget*>(QStringLiteral("vertexChanges"));
        dock->show();
        dock->raise();
        QCoreApplication::processEvents();
        return *dock->findChild<QTableView*>(QStringLiteral("table"));
    }
};

HITSCOPE_TEST(InspectTest, QApplication)

}  // namespace hitscope::inspect_test

#include "inspect_test.moc"
