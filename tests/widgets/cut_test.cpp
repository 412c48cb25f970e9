// SPDX-License-Identifier: GPL-3.0-or-later
// The cutting plane by hand: its key, its handle in the picture, its dock, its plot.
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/actions/cut_actions.h"
#include "app/settings/app_settings.h"
#include "app/settings/cut_settings.h"
#include "mesh/primitives.h"
#include "panels/cutting_plane/cutting_plane_panel.h"
#include "panels/cutting_plane/section_plot.h"
#include "session/target.h"
#include "support/baseline.h"
#include "support/test_program.h"
#include "viewport/handles/cut_handle.h"
#include "viewport/inspect_tool.h"
#include "widgets/window_support.h"

namespace hitscope::cut_test {

namespace {

/// With buttons and modifiers as a person has them.
void mouse(QWidget* widget, QEvent::Type type, const QPointF& global, bool held,
           Qt::KeyboardModifiers keys = {}) {
    QMouseEvent event(type, widget->mapFromGlobal(global), global,
                      type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                      held ? Qt::LeftButton : Qt::NoButton, keys);
    QCoreApplication::sendEvent(widget, &event);
}

}  // namespace

class CutTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        makeWindow();
        m_panel = m_window->findChild<CuttingPlanePanel*>();
        m_actions = m_window->findChild<CutActions*>();
        m_handle = m_window->viewport().findChild<CutHandle*>();
        QVERIFY(m_panel != nullptr && m_actions != nullptr && m_handle != nullptr);
    }
    void cleanup() { dropWindow(); }

    void theKeySwitchesItOnInTheMiddle() {
        QVERIFY(!m_handle->isVisible());
        QVERIFY(!m_actions->sections().isBusy());
        QTest::keyClick(&viewport(), Qt::Key_K);
        QVERIFY(cut().on);
        QVERIFY(m_panel->isVisible());  // its dock came up
        QVERIFY(m_handle->isVisible());
        QCOMPARE(cut().normal, glm::vec3(1.0f, 0.0f, 0.0f));
        QVERIFY(std::abs(cut().offset - middle().x) < 1.0e-4f);
        QVERIFY(child<QCheckBox>("on")->isChecked());
        QTest::keyClick(&viewport(), Qt::Key_K, Qt::ShiftModifier);
        QVERIFY(glm::distance(cut().normal, -viewport().camera().forward()) < 1.0e-5f);
        QTest::keyClick(&viewport(), Qt::Key_K);
        QVERIFY(!cut().on && !m_handle->isVisible());
        QVERIFY(!m_actions->sections().section());
    }

    void theHandleIsDraggedAndShootsNothing() {
        QTest::keyClick(&viewport(), Qt::Key_K);
        const glm::vec3 eye = viewport().camera().eye();
        const QPointF from = handleAt();
        const float before = cut().offset;
        // To where the plane's middle falls in the picture once it has moved by a metre.
        const QPointF to = placeOf(middle() + glm::vec3(1.0f, 0.0f, 0.0f));
        mouse(m_handle, QEvent::MouseButtonPress, from, true);
        QVERIFY(m_handle->isDragging());
        for (int step = 1; step <= 8; ++step) {
            mouse(m_handle, QEvent::MouseMove, from + step / 8.0 * (to - from), true);
        }
        QVERIFY2(std::abs(cut().offset - before - 1.0f) < 0.05f,
                 qPrintable(QString::number(static_cast<double>(cut().offset - before))));
        // The handle is where the plane is.
        QVERIFY(std::hypot((handleAt() - to).x(), (handleAt() - to).y()) < 3.0);
        QVERIFY(std::abs(child<QDoubleSpinBox>("offset")->value() - static_cast<double>(cut().offset)) <
                1.0e-3);
        mouse(m_handle, QEvent::MouseButtonRelease, to, false);
        QVERIFY(!m_handle->isDragging());
        mouse(m_handle, QEvent::MouseMove, from, false);
        QVERIFY(std::abs(cut().offset - before - 1.0f) < 0.05f);
        QVERIFY(viewport().camera().eye() == eye);
        QTest::qWait(500);
        QCOMPARE(m_session->simulation().physics().projectileCount(), std::size_t{0});
    }

    void everyChangeIsUndone() {
        const CuttingPlane before = cut();
        const std::size_t steps = m_session->steps().size();
        QTest::keyClick(&viewport(), Qt::Key_K);
        const CuttingPlane placed = cut();
        const QPointF from = handleAt();
        const QPointF to = placeOf(middle() + glm::vec3(1.0f, 0.0f, 0.0f));
        for (int drag = 0; drag < 2; ++drag) {
            mouse(m_handle, QEvent::MouseButtonPress, handleAt(), true);
            for (int step = 1; step <= 4; ++step) {
                mouse(m_handle, QEvent::MouseMove, from + (drag + step / 4.0) * (to - from), true);
            }
            mouse(m_handle, QEvent::MouseButtonRelease, to, false);
        }
        child<QToolButton>("flip")->click();
        QCOMPARE(m_session->steps().size(), steps + 4);
        mouse(m_handle, QEvent::MouseButtonPress, handleAt(), true);
        mouse(m_handle, QEvent::MouseMove, handleAt() + QPointF(20.0, 0.0), true);
        mouse(m_handle, QEvent::MouseButtonRelease, handleAt(), false);
        QCOMPARE(m_session->steps().size(), steps + 5);  // the button's step is not gone on with
        m_session->undo();
        m_session->undo();
        QVERIFY(!cut().flipped && !child<QToolButton>("flip")->isChecked());
        m_session->undo();
        QVERIFY(std::abs(cut().offset - placed.offset - 1.0f) < 0.05f);
        m_session->undo();
        QCOMPARE(cut(), placed);
        m_session->undo();
        QCOMPARE(cut(), before);
        QVERIFY(!m_handle->isVisible());
        m_session->goToStep(steps + 4);
        QVERIFY(cut().on && cut().flipped && m_handle->isVisible());
        // A drag that is taken back is no step.
        mouse(m_handle, QEvent::MouseButtonPress, handleAt(), true);
        mouse(m_handle, QEvent::MouseMove, handleAt() + QPointF(20.0, 0.0), true);
        QTest::keyClick(&viewport(), Qt::Key_Escape);
        QCOMPARE(m_session->steps().done(), steps + 4);
        // Another scene has a plane of its own, and that is no step either.
        loadPaperRow(*m_session, 0);
        QCOMPARE(m_session->steps().done(), steps + 5);
        // Nobody has put it anywhere there: switched on again, it goes through what is selected.
        QTest::keyClick(&viewport(), Qt::Key_K);
        m_session->targets().select(m_session->targets()[1]->id);
        QTest::keyClick(&viewport(), Qt::Key_K);
        const OffsetRange selected = offsetRange(m_session->targets()[1]->worldBounds(), cut().normal);
        QVERIFY(std::abs(cut().offset - selected.middle()) < 1.0e-4f);
        m_session->goToStep(steps + 4);
        QVERIFY(cut().on && cut().flipped);
        QVERIFY(std::abs(cut().offset - placed.offset - 2.0f) < 0.1f);
    }

    void dragsStayInTheSceneAndSnapAndAreTakenBack() {
        QTest::keyClick(&viewport(), Qt::Key_K);
        const QPointF from = handleAt();
        const QPointF along = placeOf(middle() + glm::vec3(1.0f, 0.0f, 0.0f)) - from;
        const OffsetRange range = offsetRange(m_session->targets().bounds(), cut().normal);
        mouse(m_handle, QEvent::MouseButtonPress, from, true);
        mouse(m_handle, QEvent::MouseMove, from + 3.9 * along, true);
        QCOMPARE(cut().offset, range.high);
        mouse(m_handle, QEvent::MouseMove, from + 0.333 * along, true, Qt::ControlModifier);
        const float step = 0.1f;  // of 5 m in 60
        QVERIFY(std::abs(cut().offset / step - std::round(cut().offset / step)) < 1.0e-3f);
        QTest::keyClick(&viewport(), Qt::Key_Escape);
        QVERIFY(!m_handle->isDragging());
        QVERIFY(std::abs(cut().offset - range.middle()) < 1.0e-5f);
    }

    void bothOfTwoPicturesHaveLines() {
        QTest::keyClick(&viewport(), Qt::Key_K);
        QTest::keyClick(&viewport(), Qt::Key_B, Qt::ShiftModifier);
        QVERIFY(viewport().options().sideBySide);
        viewport().decorations().setShowsCutPlane(false);
        const int half = viewport().width() / 2;
        const auto right = [&] {
            return viewport().surface().grab().copy(half, 0, half, viewport().height());
        };
        DisplayOptions options = viewport().options();
        options.cut.originalLine = false;
        options.cut.deformedLine = false;
        const DisplayOptions lines = viewport().options();
        QTRY_VERIFY_WITH_TIMEOUT(m_actions->sections().section() != nullptr, kPatience);
        viewport().setOptions(options);
        QVERIFY(viewport().syncNow().ok());
        const QImage without = right();
        viewport().setOptions(lines);
        QTRY_VERIFY_WITH_TIMEOUT(test::differing(without, right(), 40) > 100, kPatience);
        // And with the comparison they go.
        QTest::keyClick(&viewport(), Qt::Key_B, Qt::ShiftModifier);
        QVERIFY(!viewport().options().sideBySide);
    }

    void alongTheSightUpIsAway() {
        QTest::keyClick(&viewport(), Qt::Key_K, Qt::ShiftModifier);
        const float before = cut().offset;
        const QPointF from = handleAt();
        mouse(m_handle, QEvent::MouseButtonPress, from, true);
        mouse(m_handle, QEvent::MouseMove, from - QPointF(0.0, 30.0), true);
        mouse(m_handle, QEvent::MouseButtonRelease, from - QPointF(0.0, 30.0), false);
        QVERIFY(cut().offset < before - 0.05f);  // its normal points to the eye
    }

    void theDockSaysWhereItIs() {
        showDock();
        child<QCheckBox>("on")->click();
        QVERIFY(cut().on);
        child<QToolButton>("alongY")->click();
        QCOMPARE(cut().normal, glm::vec3(0.0f, 1.0f, 0.0f));
        QVERIFY(std::abs(cut().offset - middle().y) < 1.0e-4f);
        QVERIFY(child<QToolButton>("alongY")->isChecked() && !child<QToolButton>("alongX")->isChecked());
        child<QToolButton>("alongY")->click();
        QVERIFY(child<QToolButton>("alongY")->isChecked());
        child<QSlider>("offsetSlider")->setValue(0);
        QVERIFY(std::abs(cut().offset - (middle().y - 2.5f)) < 1.0e-3f);
        child<QDoubleSpinBox>("offset")->setValue(static_cast<double>(middle().y) + 1.25);
        QCOMPARE(child<QSlider>("offsetSlider")->value(), 750);
        child<QToolButton>("flip")->click();
        QVERIFY(cut().flipped);
        const glm::vec3 place = planeFrame(cut(), m_session->targets().bounds()).middle;
        child<QDoubleSpinBox>("normalX")->setValue(1.0);
        QVERIFY(glm::distance(cut().normal, glm::normalize(glm::vec3(1.0f, 1.0f, 0.0f))) < 1.0e-5f);
        QVERIFY(std::abs(glm::dot(cut().normal, place) - cut().offset) < 1.0e-4f);
        QCOMPARE(child<QDoubleSpinBox>("normalX")->value(), 1.0);  // as typed
        child<QToolButton>("fromView")->click();
        QVERIFY(glm::distance(cut().normal, -viewport().camera().forward()) < 1.0e-5f);
        QVERIFY(std::abs(child<QDoubleSpinBox>("normalX")->value() - static_cast<double>(cut().normal.x)) <
                1.0e-3);
        child<QToolButton>("reset")->click();
        QCOMPARE(cut().normal, glm::vec3(1.0f, 0.0f, 0.0f));
        QVERIFY(!cut().flipped);
    }

    void theSectionFollowsShotsAndIsRead() {
        showDock();
        QTest::keyClick(&viewport(), Qt::Key_K);
        QTRY_VERIFY_WITH_TIMEOUT(m_actions->sections().section() && !m_actions->sections().isBusy(),
                                 kPatience);
        QVERIFY(child<QLabel>("deepest")->text().contains(QStringLiteral("Nothing has moved")));
        Hit hit;
        hit.target = m_session->targets()[0]->id;
        hit.point = {0.0f, 2.5f, 0.0f};
        hit.direction = {0.0f, -1.0f, 0.0f};
        QVERIFY(m_session->hits().add(hit).ok());
        QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("deepest")->text().contains(QStringLiteral("Greatest depth")),
                                 kPatience);
        QVERIFY(!m_actions->sections().isBusy());
        auto* plot = child<SectionPlot>("plot");
        const auto deepest = deepestOf(*m_actions->sections().section(), {});
        QVERIFY(deepest && std::abs(deepest->depth.value() - 0.3) < 0.01);
        const auto read = [&] { return plot->readingAt(plot->pixelOf(deepest->place) + QPointF(0.0, 1.0)); };
        QTRY_VERIFY_WITH_TIMEOUT(read() && read()->depth.value() > 0.2, kPatience);  // it lays itself out
        QVERIFY(!plot->readingAt(plot->pixelOf(middle())));
        // Both axes at one scale.
        const QPointF a = plot->pixelOf(middle());
        const QPointF b = plot->pixelOf(middle() + glm::vec3(0.0f, 0.0f, 2.0f));
        const QPointF c = plot->pixelOf(middle() + glm::vec3(0.0f, 2.0f, 0.0f));
        QVERIFY(std::abs(std::abs(b.x() - a.x()) - std::abs(c.y() - a.y())) <= 2.0);
        QVERIFY(b.x() < a.x());  // z to the left: as seen from +x
        child<QToolButton>("copy")->click();
        QVERIFY(QGuiApplication::clipboard()->text().contains(QStringLiteral("Greatest depth\t0.")));
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("section.csv"));
        QVERIFY(m_panel->saveCsv(path).ok());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().count('\n') > 100);
        QVERIFY(!m_panel->saveCsv(folder.filePath(QStringLiteral("none/section.csv"))).ok());
    }

    // Its section has no height: the line fills the plot all the same, and what hits do to it is seen.
    void aFlatTargetFillsThePlot() {
        showDock();
        MeshData sheet;
        sheet.positions = {{-3, 0, -2}, {3, 0, -2}, {3, 0, 2}, {-3, 0, 2}, {-3, 0, 0}, {3, 0, 0}};
        sheet.faceStarts = {0, 4, 8};
        sheet.cornerVertices = {0, 4, 5, 1, 4, 3, 2, 5};
        loadMesh(*m_session, sheet);
        child<QCheckBox>("on")->click();
        child<QToolButton>("alongX")->click();
        QTRY_VERIFY_WITH_TIMEOUT(m_actions->sections().section() &&
                                     m_actions->sections().section()->targets.size() == 1 &&
                                     !m_actions->sections().isBusy(),
                                 kPatience);
        const auto* plot = child<SectionPlot>("plot");
        const auto& place = m_session->targets()[0]->transform;
        const auto at = [&](const glm::vec3& local) { return plot->pixelOf(place.toWorld(local)); };
        const auto width = [&] { return std::abs((at({0.0f, 0.0f, 2.0f}) - at({0.0f, 0.0f, -2.0f})).x()); };
        QTRY_VERIFY_WITH_TIMEOUT(width() > 0.5 * plot->width(), kPatience);  // it lays itself out
        const QPointF a = at({0.0f, 0.0f, -2.0f});
        const QPointF b = at({0.0f, 0.0f, 2.0f});
        QVERIFY(QRectF(plot->rect()).contains(a) && QRectF(plot->rect()).contains(b));
        QVERIFY(std::abs(a.y() - b.y()) <= 1.0);
        QVERIFY(a.y() > 0.2 * plot->height() && a.y() < 0.8 * plot->height());
        const QPointF dent = at({0.0f, -0.3f, 0.0f});
        QVERIFY(QRectF(plot->rect()).contains(dent) && dent.y() > a.y() + 3.0);
    }

    void whatIsCutAwayIsNotAimedAt() {
        // The sphere's near half is hidden: what the cursor meets is the inside of the far half.
        QTest::keyClick(&viewport(), Qt::Key_K, Qt::ShiftModifier);
        const Ray ray = viewport().rayThrough({0.5, 0.5});
        const Ray shot = viewport().aiming().shotAt(ray).ray;
        QVERIFY(std::abs(glm::dot(cut().kept(), glm::vec4(shot.origin, 1.0f))) < 1.0e-2f);
        viewport().inspectTool().setTool(Tool::Inspect);
        const auto vertex =
            viewport().picking().vertexAt({viewport().width() / 2.0, viewport().height() / 2.0});
        QVERIFY(vertex);
        const Target& target = *m_session->targets()[0];
        QVERIFY(!cut().hides(target.transform.toWorld(target.deformed.positions()[vertex->vertex])));
        QTest::keyClick(&viewport(), Qt::Key_K);
        const auto whole =
            viewport().picking().vertexAt({viewport().width() / 2.0, viewport().height() / 2.0});
        QVERIFY(whole && *whole != *vertex);
    }

    void picturesAreCutToo() {
        const PictureRequest whole = viewport().pictureRequest();
        QTest::keyClick(&viewport(), Qt::Key_K);
        const PictureRequest opened = viewport().pictureRequest();
        QVERIFY(opened.options.cut.on);
        const auto a = viewport().drawPicture(whole);
        const auto b = viewport().drawPicture(opened);
        QVERIFY(a.ok() && b.ok());
        QVERIFY(a.value().pixels != b.value().pixels);
    }

    void anotherSceneHasThePlaneInItsMiddle() {
        QTest::keyClick(&viewport(), Qt::Key_K);
        MeshData far = makeHighPolySphere();
        for (glm::vec3& position : far.positions) {
            position.x += 40.0f;
        }
        loadMesh(*m_session, far);
        QVERIFY(cut().on);
        QVERIFY(std::abs(cut().offset - middle().x) < 1.0e-3f);
        QTRY_VERIFY_WITH_TIMEOUT(
            m_actions->sections().section() && m_actions->sections().section()->targets.size() == 1,
            kPatience);
    }

    void settingsAreRemembered() {
        QTemporaryDir folder;
        QSettings settings(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
        AppSettings values;
        CuttingPlane& plane = values.display.cut;
        plane.on = true;
        plane.normal = glm::normalize(glm::vec3(1.0f, -2.0f, 0.5f));
        plane.offset = 7.0f;
        plane.flipped = plane.fill = true;
        plane.originalLine = false;
        saveAppSettings(settings, values);
        const CuttingPlane read = loadAppSettings(settings).display.cut;
        QVERIFY(!read.on);  // a scene starts whole
        QVERIFY(glm::distance(read.normal, plane.normal) < 1.0e-6f);
        QVERIFY(read.flipped && read.fill && !read.originalLine && read.deformedLine);
        settings.setValue(QStringLiteral("cut/normal"),
                          QStringList{QStringLiteral("9"), QStringLiteral("nan"), QStringLiteral("")});
        QCOMPARE(loadAppSettings(settings).display.cut.normal, CuttingPlane().normal);
    }

private:
    [[nodiscard]] Viewport& viewport() { return m_window->viewport(); }
    [[nodiscard]] const CuttingPlane& cut() { return viewport().options().cut; }
    [[nodiscard]] glm::vec3 middle() const { return m_session->targets().bounds().centre(); }
    [[nodiscard]] QPointF handleAt() const {
        return m_handle->mapToGlobal(QPointF(m_handle->rect().center()));
    }
    /// Global, of a place in the world.
    [[nodiscard]] QPointF placeOf(const glm::vec3& world) {
        const float aspect = viewport().navigation().aspect();
        const glm::vec4 clip =
            viewport().camera().projection(aspect) * viewport().camera().view() * glm::vec4(world, 1.0f);
        return viewport().mapToGlobal(
            QPointF(0.5 * (1.0 + static_cast<double>(clip.x / clip.w)) * viewport().width(),
                    0.5 * (1.0 - static_cast<double>(clip.y / clip.w)) * viewport().height()));
    }
    void showDock() {
        auto* dock = m_window->findChild<QDockWidget*>(QStringLiteral("cuttingPlane"));
        dock->show();
        dock->raise();
        QTRY_VERIFY_WITH_TIMEOUT(m_panel->isVisible(), kPatience);
    }
    template <class Widget>
    [[nodiscard]] Widget* child(const char* name) {
        auto* found = m_panel->findChild<Widget*>(QString::fromLatin1(name));
        Q_ASSERT(found != nullptr);
        return found;
    }

    CuttingPlanePanel* m_panel = nullptr;
    CutActions* m_actions = nullptr;
    CutHandle* m_handle = nullptr;
};

HITSCOPE_TEST(CutTest, QApplication)

}  // namespace hitscope::cut_test

#include "cut_test.moc"
