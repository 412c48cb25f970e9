// SPDX-License-Identifier: GPL-3.0-or-later
// The dock "Change", its keys, its handles, and the wipe's line, by hand.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <cmath>
#include <utility>

#include "app/settings/change_settings.h"
#include "mesh/primitives.h"
#include "panels/change/change_panel.h"
#include "panels/histogram/histogram_plot.h"
#include "session/shots/demo_shots.h"
#include "support/test_program.h"
#include "viewport/inspect_tool.h"
#include "widgets/window_support.h"

namespace hitscope::change_test {

namespace {

void mouse(QWidget* widget, QEvent::Type type, const QPointF& at, bool held) {
    QMouseEvent event(type, at, widget->mapToGlobal(at),
                      type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                      held ? Qt::LeftButton : Qt::NoButton, {});
    QCoreApplication::sendEvent(widget, &event);
}

}  // namespace

class ChangeTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        makeWindow();
        choosePipeline(*m_window, PipelineKind::TransformFeedback);  // also where it is not exact
        m_panel = m_window->findChild<ChangePanel*>();
        QVERIFY(m_panel != nullptr);
    }
    void cleanup() { dropWindow(); }

    void keysSwitchWhatIsShown() {
        Viewport& viewport = m_window->viewport();
        QTest::keyClick(&viewport, Qt::Key_V);
        QVERIFY(viewport.options().change.on);
        QVERIFY(child<QCheckBox>("on")->isChecked());
        QTest::keyClick(&viewport, Qt::Key_V, Qt::ShiftModifier);
        QVERIFY(viewport.options().change.isolines);
        QTest::keyClick(&viewport, Qt::Key_B);
        QCOMPARE(viewport.options().beforeAfter.ghost, GhostMode::Wire);
        QTest::keyClick(&viewport, Qt::Key_X);
        QVERIFY(viewport.options().beforeAfter.wipe);
        QTest::keyClick(&viewport, Qt::Key_X, Qt::ShiftModifier);
        QCOMPARE(viewport.options().beforeAfter.exaggeration, 5.0f);
        QTest::keyClick(&viewport, Qt::Key_X, Qt::ShiftModifier);
        QCOMPARE(viewport.options().beforeAfter.exaggeration, 1.0f);
    }

    void handlesSetTheMapsRange() {
        showDock();
        child<QCheckBox>("on")->click();
        shootAll(*m_session, demoShots(*m_session, 30, 3));
        auto* plot = child<HistogramPlot>("histogram");
        QTRY_VERIFY_WITH_TIMEOUT(!plot->histogram().counts.empty(), kPatience);
        QTRY_COMPARE_WITH_TIMEOUT(
            static_cast<double>(static_cast<float>(plot->range()->high)),
            static_cast<double>(static_cast<float>(m_session->targets()[0]->deformed.statistics().maximum)),
            kPatience);
        const ChangeRange automatic{static_cast<float>(plot->range()->low),
                                    static_cast<float>(plot->range()->high)};
        QCOMPARE(automatic.low, 0.0f);
        QWidget* surface = plot->childAt(plot->rect().center());
        const double y = surface->height() / 2.0;
        const double half = 0.5 * static_cast<double>(automatic.high);
        mouse(surface, QEvent::MouseButtonPress, {plot->pixelOf(static_cast<double>(automatic.high)), y},
              true);
        mouse(surface, QEvent::MouseMove, {plot->pixelOf(half), y}, true);
        mouse(surface, QEvent::MouseButtonRelease, {plot->pixelOf(half), y}, false);
        const QuantityStyle& style = m_window->viewport().options().change.style();
        QVERIFY(!style.automatic);
        QVERIFY(!child<QCheckBox>("automatic")->isChecked());
        QVERIFY(std::abs(static_cast<double>(style.fixed.high) - half) < 0.02);
        QVERIFY(std::abs(child<QDoubleSpinBox>("high")->value() - half) < 0.02);
        child<QCheckBox>("automatic")->click();
        QCOMPARE(static_cast<float>(plot->range()->high), automatic.high);
    }

    void rangeFollowsUndo() {
        showDock();
        shootAll(*m_session, demoShots(*m_session, 10, 3));
        auto* plot = child<HistogramPlot>("histogram");
        QTRY_VERIFY_WITH_TIMEOUT(!plot->histogram().counts.empty(), kPatience);
        m_session->hits().clear();
        QTRY_VERIFY_WITH_TIMEOUT(plot->histogram().counts.empty(), kPatience);
        QTRY_COMPARE_WITH_TIMEOUT(child<QLabel>("numbers")->text(), QStringLiteral("No vertex has changed"),
                                  kPatience);
        m_session->undo();
        QTRY_VERIFY_WITH_TIMEOUT(!plot->histogram().counts.empty(), kPatience);
    }

    void theWipesLineIsDraggedAndShootsNothing() {
        Viewport& viewport = m_window->viewport();
        QTest::keyClick(&viewport, Qt::Key_X);
        const double y = viewport.height() / 2.0;
        const double x = viewport.width() / 2.0;
        const glm::vec3 eye = viewport.camera().eye();
        mouse(&viewport, QEvent::MouseButtonPress, {x, y}, true);
        mouse(&viewport, QEvent::MouseMove, {x - 100, y}, true);
        mouse(&viewport, QEvent::MouseButtonRelease, {x - 100, y}, false);
        const float at = static_cast<float>((x - 100) / viewport.width());
        QVERIFY(std::abs(viewport.options().beforeAfter.wipeAt - at) < 1e-3f);
        QVERIFY(std::abs(static_cast<float>(child<QSlider>("wipeAt")->value()) / 1000.0f - at) < 2e-3f);
        QVERIFY(viewport.camera().eye() == eye);
        QTest::qWait(500);
        QCOMPARE(m_session->simulation().physics().projectileCount(), std::size_t{0});
    }

    void theCursorIsTheToolsBesideTheLine() {
        Viewport& viewport = m_window->viewport();
        const QPointF line(viewport.width() / 2.0, viewport.height() / 2.0);
        const QPointF beside = line + QPointF(80.0, 0.0);
        const auto shape = [&viewport] { return viewport.cursor().shape(); };
        for (const auto& [tool, own] : {std::pair(Tool::Shoot, Qt::ArrowCursor),
                                        {Tool::Inspect, Qt::CrossCursor},
                                        {Tool::Brush, Qt::CrossCursor}}) {
            viewport.inspectTool().setTool(tool);
            QCOMPARE(shape(), own);
            QTest::keyClick(&viewport, Qt::Key_X);
            mouse(&viewport, QEvent::MouseMove, line, false);
            QCOMPARE(shape(), Qt::SplitHCursor);
            mouse(&viewport, QEvent::MouseMove, beside, false);
            QCOMPARE(shape(), own);
            mouse(&viewport, QEvent::MouseMove, line, false);
            viewport.inspectTool().setTool(Tool::Move);
            QCOMPARE(shape(), Qt::SplitHCursor);
            viewport.inspectTool().setTool(tool);
            QTest::keyClick(&viewport, Qt::Key_X);  // the line goes
            QVERIFY(!viewport.options().beforeAfter.wipe);
            QCOMPARE(shape(), own);
        }
    }

    void comparingPrintsThatPipelinesAgree() {
        showDock();
        shootAll(*m_session, demoShots(*m_session, 50, 3));
        auto* other = child<QComboBox>("other");
        const int index = other->findText(QStringLiteral("Uniform array"));
        QVERIFY(index > 0);
        other->setCurrentIndex(index);
        Q_EMIT other->activated(index);
        QVERIFY(child<QCheckBox>("sideBySide")->isEnabled());
        child<QCheckBox>("sideBySide")->click();
        QVERIFY(m_window->viewport().options().sideBySide);
        // Each picture has its own line.
        Viewport& viewport = m_window->viewport();
        child<QCheckBox>("wipe")->click();
        const double half = viewport.width() / 2.0;
        const double y = viewport.height() / 2.0;
        mouse(&viewport, QEvent::MouseButtonPress, {1.5 * half, y}, true);
        mouse(&viewport, QEvent::MouseMove, {1.25 * half, y}, true);
        mouse(&viewport, QEvent::MouseButtonRelease, {1.25 * half, y}, false);
        QVERIFY(std::abs(viewport.options().beforeAfter.wipeAt - 0.25f) < 5e-3f);
        const auto isExact = [this] {
            const auto* verdict = m_session->readBack().verdict().of(PipelineKind::TransformFeedback);
            return verdict != nullptr && verdict->isExact();
        };
        const auto agree = [&] {
            if (!isExact()) {  // nor are they the same as one another
                return child<QLabel>("report")->text().startsWith(QStringLiteral("A and B differ by up to "));
            }
            const std::size_t changed = m_session->targets()[0]->deformed.statistics().changedVertices;
            return child<QLabel>("report")->text() ==
                   QStringLiteral("A and B are equal in all %1 moved vertices")
                       .arg(QLocale().toString(static_cast<qulonglong>(changed)));
        };
        QTRY_VERIFY_WITH_TIMEOUT(agree(), kPatience);
        QVERIFY(m_window->viewport().surface().context() != nullptr);
    }

    void aKeyPutsThePapersPipelinesSideBySide() {
        Viewport& viewport = m_window->viewport();
        showDock();
        QCOMPARE(child<QComboBox>("other")->currentIndex(), 0);
        QTest::keyClick(&viewport, Qt::Key_B, Qt::ShiftModifier);
        QVERIFY(viewport.options().sideBySide);
        QCOMPARE(child<QComboBox>("other")->currentText(), QStringLiteral("Uniform array"));
        QVERIFY(child<QCheckBox>("sideBySide")->isChecked());
        QTest::keyClick(&viewport, Qt::Key_B, Qt::ShiftModifier);
        QVERIFY(!viewport.options().sideBySide);
    }

    void labelsGoWithSideBySide() {
        Viewport& viewport = m_window->viewport();
        showDock();
        shootAll(*m_session, demoShots(*m_session, 5, 3));
        QVERIFY(viewport.syncNow().ok());
        // The upper edge, where A and B are named, and the lower, where it is said whether they are equal.
        const auto edges = [&viewport] {
            const QImage picture = viewport.surface().grab();
            const QImage top = picture.copy(0, 0, picture.width(), 50);
            const QImage bottom = picture.copy(0, picture.height() - 50, picture.width(), 50);
            return std::pair(top, bottom);
        };
        const auto before = edges();
        QTest::keyClick(&viewport, Qt::Key_B, Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("report")->text().contains(QStringLiteral("moved vertices")),
                                 kPatience);
        QVERIFY(edges() != before);
        QTest::keyClick(&viewport, Qt::Key_B, Qt::ShiftModifier);
        QVERIFY(edges() == before);
        QVERIFY(!child<QLabel>("report")->isVisible());
        QCOMPARE(child<QComboBox>("other")->currentIndex(), 0);
        // By the box in the dock likewise.
        child<QCheckBox>("sideBySide")->click();
        QVERIFY(viewport.options().sideBySide && child<QLabel>("report")->isVisible());
        child<QCheckBox>("sideBySide")->click();
        QVERIFY(edges() == before);
    }

    void aNewSceneBringsANewReport() {
        showDock();
        shootAll(*m_session, demoShots(*m_session, 5, 3));
        QTest::keyClick(&m_window->viewport(), Qt::Key_B, Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("report")->text().contains(QStringLiteral("moved vertices")),
                                 kPatience);
        loadTeapot(*m_session);
        QVERIFY(child<QLabel>("report")->text().contains(QStringLiteral("no vertex has moved")));
    }

    void settingsAreRemembered() {
        DisplayOptions display;
        display.change.on = true;
        display.change.quantity = ChangeQuantity::EdgeStretch;
        display.change.isolines = true;
        display.change.style() = {ColourMap::Cividis, false, {-3.5f, 12.25f}};
        display.beforeAfter.ghost = GhostMode::Translucent;
        QSettings settings;
        saveChangeSettings(settings, display);
        DisplayOptions loaded;
        loadChangeSettings(settings, loaded);
        QVERIFY(!loaded.change.on);  // a new start may have no hits to show
        loaded.change.on = true;
        QVERIFY(loaded.change == display.change);
        QVERIFY(loaded.beforeAfter == display.beforeAfter);
        settings.setValue(QStringLiteral("change/edge-stretch/low"), QStringLiteral("nonsense"));
        settings.setValue(QStringLiteral("change/ghost"), 99);
        DisplayOptions careful;
        loadChangeSettings(settings, careful);
        QCOMPARE(careful.change.style().fixed, defaultQuantityStyles()[8].fixed);
        QCOMPARE(careful.beforeAfter.ghost, GhostMode::Off);
        settings.clear();
    }

private:
    template <class T>
    T* child(const char* name) {
        return m_panel->findChild<T*>(QLatin1String(name));
    }
    void showDock() {
        auto* dock = m_window->findChild<QDockWidget*>(QStringLiteral("change"));
        dock->raise();
        QTRY_VERIFY_WITH_TIMEOUT(m_panel->isVisible(), kPatience);
    }

    ChangePanel* m_panel = nullptr;
};

HITSCOPE_TEST(ChangeTest, QApplication)

}  // namespace hitscope::change_test

#include "change_test.moc"
