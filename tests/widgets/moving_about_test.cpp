// SPDX-License-Identifier: GPL-3.0-or-later
// Ways to a view and to a vertex: the axes in the corner, the menu under the cursor, Go to Vertex.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QToolTip>

#include "app/actions/viewport_menu.h"
#include "app/dialogs/go_to_vertex.h"
#include "app/overlays/keys_lines.h"
#include "panels/help/help_text.h"
#include "session/mesh_steps/scale_target.h"
#include "support/test_program.h"
#include "viewport/axis_gizmo.h"
#include "viewport/inspect_tool.h"
#include "widgets/window_support.h"

namespace hitscope::moving_about_test {

namespace {

QAction* entry(const QMenu& menu, const QString& text) {
    for (QAction* action : menu.actions()) {
        QString plain = action->text();
        if (plain.remove(QLatin1Char('&')).startsWith(text)) {
            return action;
        }
    }
    return nullptr;
}

}  // namespace

class MovingAboutTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() { makeWindow(); }
    void cleanup() { dropWindow(); }

    void axisEndsSetTheViews() {
        AxisGizmo& axes = *viewport().findChild<AxisGizmo*>();
        QVERIFY(axes.isVisible());
        QVERIFY(axes.geometry().right() < viewport().width() && axes.geometry().top() > 0);
        QVERIFY(axes.geometry().left() > viewport().width() / 2);
        const std::pair<StandardView, glm::vec3> views[] = {{StandardView::Top, {0, -1, 0}},
                                                            {StandardView::Right, {-1, 0, 0}},
                                                            {StandardView::Front, {0, 0, -1}}};
        for (const auto& [view, forward] : views) {
            turnFreely();
            clickEnd(axes, view);
            QVERIFY(glm::dot(viewport().camera().forward(), forward) > 0.9999f);
            QVERIFY(viewport().navigation().isSceneInSight());
            // From there a second click looks from the other side.
            clickEnd(axes, view);
            QVERIFY(glm::dot(viewport().camera().forward(), forward) < -0.9999f);
        }
        QCOMPARE(m_session->simulation().shotsToCome() + m_session->simulation().physics().projectileCount(),
                 std::size_t{0});
        QCOMPARE(m_session->hits().history().size(), std::size_t{0});
    }

    void axesNameViewAndKey() {
        AxisGizmo& axes = *viewport().findChild<AxisGizmo*>();
        turnFreely();
        const QPoint at = axes.endOf(StandardView::Top).toPoint();
        QHelpEvent help(QEvent::ToolTip, at, axes.mapToGlobal(at));
        QCoreApplication::sendEvent(&axes, &help);
        QVERIFY(QToolTip::text().contains(QStringLiteral("Top")));
        QVERIFY(QToolTip::text().contains(QStringLiteral("Num+7")));
    }

    /// No step to undo comes of that.
    void scaledTargetsAreFramedWhereTheyHaveTo() {
        const auto scaleTo = [this](double extent) {
            const Result<ScaledTarget> scaled = scaledTo(*m_session->targets().front(), extent);
            QVERIFY(scaled.ok() && takeScaled(*m_session, scaled.value()).ok());
        };
        const auto isSeen = [this] {
            const Bounds bounds = m_session->targets().front()->worldBounds();
            return glm::distance(viewport().navigation().goal().eye(), bounds.centre()) >
                   bounds.diagonal() / 2.0f;
        };
        const Camera before = viewport().navigation().goal();
        scaleTo(5.5);
        QVERIFY(viewport().navigation().goal().eye() == before.eye());
        scaleTo(500.0);
        QVERIFY(viewport().navigation().goal().distance() > 10.0f * before.distance());
        QVERIFY(isSeen());
        QCOMPARE(m_session->steps().size(), std::size_t{2});
        viewport().navigation().setCamera(before, Navigation::Arrival::AtOnce);
        m_session->undo();
        QVERIFY(viewport().navigation().goal().eye() == before.eye());
        m_session->redo();
        QVERIFY(isSeen());
        QCOMPARE(m_session->steps().size(), std::size_t{2});
    }

    void draggingTheAxesOrbitsAndBesideThemIsTheViews() {
        AxisGizmo& axes = *viewport().findChild<AxisGizmo*>();
        const Camera before = viewport().camera();
        const QPoint middle = axes.rect().center();
        QTest::mousePress(&axes, Qt::LeftButton, {}, middle);
        for (const int x : {10, 30, 60}) {
            const QPointF at = middle + QPoint(x, 0);
            QMouseEvent move(QEvent::MouseMove, at, axes.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
            QCoreApplication::sendEvent(&axes, &move);
        }
        QTest::mouseRelease(&axes, Qt::LeftButton, {}, middle + QPoint(60, 0));
        QVERIFY(glm::dot(viewport().camera().forward(), before.forward()) < 0.99f);
        QCOMPARE(viewport().camera().distance(), before.distance());
        // The square's corner is none of its disc.
        QVERIFY(viewport().childAt(axes.geometry().topLeft() + QPoint(2, 2)) != &axes);
        QVERIFY(viewport().childAt(axes.geometry().center()) == &axes);
    }

    void rightClickOpensTheMenuAndRightDragPans() {
        QMenu* menu = openMenu(centre());
        QVERIFY(entry(*menu, QStringLiteral("Pick Vertex"))->isEnabled());
        menu->close();
        const Camera before = viewport().camera();
        QTest::mousePress(&viewport(), Qt::RightButton, {}, centre());
        const QPointF at = centre() + QPoint(50, 0);
        QMouseEvent move(QEvent::MouseMove, at, viewport().mapToGlobal(at), Qt::NoButton, Qt::RightButton,
                         {});
        QCoreApplication::sendEvent(&viewport(), &move);
        QTest::mouseRelease(&viewport(), Qt::RightButton, {}, at.toPoint());
        QTest::qWait(50);
        QVERIFY(viewport().findChild<QMenu*>(QStringLiteral("viewportMenu")) == nullptr);
        QVERIFY(viewport().camera().pivot() != before.pivot());
    }

    void menuPicksSelectsAndFrames() {
        QMenu* menu = openMenu(centre());
        entry(*menu, QStringLiteral("Pick Vertex"))->trigger();
        menu->close();
        const auto picked = m_session->selection().picked();
        QVERIFY(picked && *picked == *viewport().picking().vertexAt(centre()));
        viewport().navigation().flyStep({2.0f, 0.0f, 0.0f});
        const Camera before = viewport().camera();
        menu = openMenu(centre() + QPoint(-60, 0));
        entry(*menu, QStringLiteral("Frame"))->trigger();
        menu->close();
        QTRY_VERIFY_WITH_TIMEOUT(!viewport().navigation().isMoving(), kPatience);
        QVERIFY(viewport().camera().pivot() != before.pivot());
        menu = openMenu(centre() + QPoint(30, 20));
        const auto met = viewport().aiming().met(viewport().navigation().rayAt(centre() + QPoint(30, 20)));
        entry(*menu, QStringLiteral("Centre View Here"))->trigger();
        menu->close();
        QTRY_VERIFY_WITH_TIMEOUT(!viewport().navigation().isMoving(), kPatience);
        QVERIFY(glm::length(viewport().camera().pivot() - met->point) < 1.0e-3f);
    }

    void menuNamesAndRemovesTheLastHitHere() {
        const Ray ray = viewport().navigation().rayAt(centre());
        QVERIFY(m_session->simulation().hitscan(ray));
        QVERIFY(viewport().syncNow().ok());
        QMenu* menu = openMenu(centre());
        QAction* remove = entry(*menu, QStringLiteral("Remove Hit 1"));
        QVERIFY(remove != nullptr && remove->isEnabled());
        menu->close();
        // Another one far from there: it is not the last that moved this vertex.
        const glm::vec3 middle = m_session->targets().bounds().centre();
        QVERIFY(m_session->simulation().hitscan({middle + glm::vec3(0, 9, 0), {0, -1, 0}}));
        QVERIFY(viewport().syncNow().ok());
        menu = openMenu(centre());
        entry(*menu, QStringLiteral("Measure Dent Here"))->trigger();
        auto* dock = m_window->findChild<QDockWidget*>(QStringLiteral("dentMeasurement"));
        QTRY_VERIFY_WITH_TIMEOUT(!dock->visibleRegion().isEmpty(), kPatience);
        remove = entry(*menu, QStringLiteral("Remove Hit 1"));
        QVERIFY(remove != nullptr);
        remove->trigger();
        menu->close();
        QCOMPARE(m_session->hits().history().size(), std::size_t{1});
        m_session->undo();
        QCOMPARE(m_session->hits().history().size(), std::size_t{2});
    }

    void menuSaysWhyAnEntryIsDisabled() {
        QMenu* menu = openMenu({3, viewport().height() / 2});
        int disabled = 0;
        for (const QAction* action : menu->actions()) {
            disabled += !action->isEnabled() ? 1 : 0;
            QVERIFY2(action->isEnabled() || action->isSeparator() || !whyDisabled(*action).isEmpty(),
                     qPrintable(action->text()));
        }
        QVERIFY(disabled >= 5);
        QVERIFY(entry(*menu, QStringLiteral("Shoot Here"))->isEnabled());
        menu->close();
        // The last entry that is disabled, under the mouse.
        menu = openMenu({3, viewport().height() / 2});
        QAction* pick = entry(*menu, QStringLiteral("Pick Vertex"));
        const QPoint at = menu->actionGeometry(pick).center();
        QHelpEvent help(QEvent::ToolTip, at, menu->mapToGlobal(at));
        QCoreApplication::sendEvent(menu, &help);
        QVERIFY(QToolTip::text().contains(QStringLiteral("no target")));
        menu->close();
    }

    void menuIsolatesAndShowsAll() {
        makeWindow([](Session& session) { loadPaperRow(session, 0); });
        QVERIFY(m_session->targets().size() > 1);
        QPoint at = centre();
        for (int x = 20; x < viewport().width() && !viewport().picking().vertexAt(at); x += 20) {
            at = {x, viewport().height() / 2};
        }
        QMenu* menu = openMenu(at);
        entry(*menu, QStringLiteral("Isolate"))->trigger();
        menu->close();
        const auto shown = [this] {
            return std::count_if(m_session->targets().begin(), m_session->targets().end(),
                                 [](const auto& target) { return target->visible; });
        };
        QCOMPARE(shown(), 1);
        menu = openMenu(at);
        QVERIFY(!entry(*menu, QStringLiteral("Isolate"))->isEnabled());
        entry(*menu, QStringLiteral("Show All"))->trigger();
        menu->close();
        QCOMPARE(shown(), static_cast<long>(m_session->targets().size()));
    }

    void menuKeyOpensItToo() {
        QContextMenuEvent key(QContextMenuEvent::Keyboard, centre(), viewport().mapToGlobal(centre()));
        QCoreApplication::sendEvent(&viewport(), &key);
        QTRY_VERIFY_WITH_TIMEOUT(viewport().findChild<QMenu*>(QStringLiteral("viewportMenu")) != nullptr,
                                 kPatience);
        viewport().findChild<QMenu*>(QStringLiteral("viewportMenu"))->close();
    }

    void goToVertexGivesViewRowAndAttribution() {
        QVERIFY(m_session->simulation().hitscan(viewport().navigation().rayAt(centre())));
        QVERIFY(viewport().syncNow().ok());
        const Target& target = *m_session->targets().front();
        // The far side, which is not to be seen from here, and a dented one.
        const std::uint32_t dented = target.deformed.onceChanged().front();
        for (const std::uint32_t vertex : {farthest(target), dented}) {
            QTest::keyClick(m_window.get(), Qt::Key_G, Qt::ControlModifier);
            auto* dialog = m_window->findChild<GoToVertexDialog*>();
            QVERIFY(dialog != nullptr);
            QTRY_VERIFY_WITH_TIMEOUT(dialog->isVisible(), kPatience);
            auto* number = dialog->findChild<QLineEdit*>(QStringLiteral("number"));
            QTest::keyClicks(number, QString::number(vertex + 1));
            QTest::keyClick(number, Qt::Key_Return);
            QTRY_VERIFY_WITH_TIMEOUT(m_window->findChild<GoToVertexDialog*>() == nullptr, kPatience);
            QTRY_VERIFY_WITH_TIMEOUT(!viewport().navigation().isMoving(), kPatience);
            const VertexRef wanted{target.id, vertex};
            QVERIFY(m_session->selection().picked() == wanted && m_session->selection().isSelected(wanted));
            const auto seen = viewport().picking().vertexAt(centre());
            QVERIFY(seen.has_value());
            const auto at = [&](std::uint32_t v) { return target.deformed.positions()[v]; };
            QVERIFY(glm::length(at(seen->vertex) - at(vertex)) < 0.05f * target.extent());
            makeActive(*m_window);
        }
        const auto* title = m_window->findChild<QLabel*>(QStringLiteral("attributionTitle"));
        QVERIFY(title->text().contains(QLocale().toString(dented + 1)));
        auto* dock = m_window->findChild<QDockWidget*>(QStringLiteral("vertexChanges"));
        QTRY_VERIFY_WITH_TIMEOUT(!dock->visibleRegion().isEmpty(), kPatience);
    }

    void goToVertexSaysTheRange() {
        m_session->targets().duplicate(std::array{m_session->targets().front()->id});
        GoToVertexDialog dialog(*m_session, m_window.get());
        dialog.show();
        const std::size_t count = m_session->targets().front()->deformed.positions().size();
        auto* number = dialog.findChild<QLineEdit*>(QStringLiteral("number"));
        auto* range = dialog.findChild<QLabel*>(QStringLiteral("range"));
        for (const QString& wrong :
             {QStringLiteral("0"), QString::number(count + 1), QStringLiteral("-3"), QStringLiteral("x")}) {
            number->setText(wrong);
            dialog.accept();
            QVERIFY(dialog.isVisible() && !dialog.vertex());
            QVERIFY(range->text().contains(QLocale().toString(static_cast<qulonglong>(count))));
            QVERIFY(range->text().contains(wrong));
        }
        auto* targets = dialog.findChild<QComboBox*>(QStringLiteral("target"));
        QCOMPARE(targets->count(), 2);
        targets->setCurrentIndex(1);
        number->setText(QLocale().toString(static_cast<qulonglong>(count)));
        QVERIFY((dialog.vertex() ==
                 VertexRef{m_session->targets()[1]->id, static_cast<std::uint32_t>(count - 1)}));
    }

    void keysNameTheMenu() {
        QString all;
        for (const KeysLine& line : mouseKeys(NavigationPreset::Hitscope, OrbitMode::Point).lines) {
            all += line.keys + u' ' + line.meaning + u'\n';
        }
        QVERIFY(all.contains(QStringLiteral("Right-click")) && all.contains(QStringLiteral("Alt+click")));
        // What recommended Alt+click alone names the other way.
        const auto* title = m_window->findChild<QLabel*>(QStringLiteral("attributionTitle"));
        QVERIFY(title->text().contains(QStringLiteral("right-click")));
    }

private:
    [[nodiscard]] Viewport& viewport() { return m_window->viewport(); }
    [[nodiscard]] QPoint centre() { return viewport().rect().center(); }
    void turnFreely() {
        Camera camera = viewport().camera();
        camera.setPivot(camera.pivot(), 0.6f, 0.35f, camera.distance());
        viewport().navigation().setCamera(camera, Navigation::Arrival::AtOnce);
    }
    void clickEnd(AxisGizmo& axes, StandardView view) {
        QTest::mouseClick(&axes, Qt::LeftButton, {}, axes.endOf(view).toPoint());
        QTRY_VERIFY_WITH_TIMEOUT(!viewport().navigation().isMoving(), kPatience);
    }
    QMenu* openMenu(const QPoint& at) {
        QTest::mousePress(&viewport(), Qt::RightButton, {}, at);
        QTest::mouseRelease(&viewport(), Qt::RightButton, {}, at);
        QMenu* menu = nullptr;
        (void)QTest::qWaitFor(
            [&] {
                for (QMenu* found : viewport().findChildren<QMenu*>(QStringLiteral("viewportMenu"))) {
                    menu = found->isVisible() ? found : menu;
                }
                return menu != nullptr;
            },
            kPatience);
        return menu;
    }
    [[nodiscard]] std::uint32_t farthest(const Target& target) {
        const glm::vec3 eye = viewport().camera().eye();
        std::uint32_t found = 0;
        float most = 0.0f;
        for (std::uint32_t v = 0; v < target.deformed.positions().size(); ++v) {
            const float away = glm::distance(target.transform.toWorld(target.deformed.positions()[v]), eye);
            if (away > most) {
                most = away;
                found = v;
            }
        }
        return found;
    }
};

HITSCOPE_TEST(MovingAboutTest, QApplication)

}  // namespace hitscope::moving_about_test

#include "moving_about_test.moc"
