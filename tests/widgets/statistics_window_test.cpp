// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh statistics, pipeline agreement and tasks in the window, by mouse.
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QGuiApplication>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "mesh/primitives.h"
#include "models/mesh_statistics_model.h"
#include "panels/histogram/histogram_plot.h"
#include "session/task_list.h"
#include "session/vertex_selection.h"
#include "support/read_back.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::statistics_window_test {

namespace {

/// A window on a cube with one dent in its top.
struct Scene {
    /// `scale`: 1: a cube of five metres.
    explicit Scene(float scale = 1.0f) {
        loadMesh(session, makeHighPolyCube(2.5f * scale));
        window.emplace(session);
        showReady(*window);
        statistics = window->findChild<QDockWidget*>(QStringLiteral("meshStatistics"));
        statistics->raise();
        Hit hit;
        hit.target = session.targets().front()->id;
        hit.point = {0.0f, 2.5f * scale, 0.0f};
        hit.constants.maxDistance *= scale;
        hit.constants.maxMagnitude *= scale;
        hit.direction = {0.0f, -1.0f, 0.0f};
        QVERIFY(session.hits().add(hit).ok());
    }

    template <class Widget>
    Widget* find(const char* name) {
        return statistics->findChild<Widget*>(QLatin1String(name));
    }
    QString number(const char* key) {
        const auto* model = qobject_cast<const MeshStatisticsModel*>(find<QTreeView>("numbers")->model());
        return model->find(key, MeshStatisticsModel::DeformedColumn).data().toString();
    }
    void openTab(int index) {
        QTabBar* bar = find<QTabWidget>("tabs")->tabBar();
        QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(index).center());
    }

    Session session;
    std::optional<MainWindow> window;
    QDockWidget* statistics = nullptr;
};

}  // namespace

class StatisticsWindowTest : public QObject {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void numbersFollowAHit() {
        std::optional<Scene> scene(std::in_place);
        QTRY_COMPARE_WITH_TIMEOUT(scene->number("displacement_max"), QStringLiteral("0.30000"), kPatience);
        QVERIFY(scene->number("volume").toDouble() < 125.0);
        auto* numbers = scene->find<QTreeView>("numbers");
        const QModelIndex section = numbers->model()->index(0, 0);
        QVERIFY(numbers->isExpanded(section));
        const QRect title = numbers->visualRect(section);
        QTest::mouseClick(numbers->viewport(), Qt::LeftButton, {},
                          {title.left() - numbers->indentation() / 2, title.center().y()});
        QVERIFY(!numbers->isExpanded(section));
        closeAndDiscard(*scene->window);
        scene.reset();  // some drivers make no other context current while this one's window is gone
        // Remembered.
        Scene next;
        const QTreeView* others = next.find<QTreeView>("numbers");
        QVERIFY(!others->isExpanded(others->model()->index(0, 0)));
        QVERIFY(others->isExpanded(others->model()->index(1, 0)));
    }

    void nothingIsCutShort() {
        Scene scene;
        for (const float x : {-0.013f, 0.37f, 1.1f}) {
            Hit hit;
            hit.target = scene.session.targets().front()->id;
            hit.point = {x, 0.4f * x, 2.5f};
            hit.direction = {0.3f, -0.1f, -0.95f};
            QVERIFY(scene.session.hits().add(hit).ok());
        }
        QTRY_VERIFY_WITH_TIMEOUT(scene.number("changed_vertices").toInt() > 100, kPatience);
        const auto* numbers = scene.find<QTreeView>("numbers");
        const QAbstractItemModel& model = *numbers->model();
        const int margins = 2 * (numbers->style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1);
        int texts = 0;
        for (int section = 0; section < model.rowCount(); ++section) {
            const QModelIndex parent = model.index(section, 0);
            for (int row = 0; row < model.rowCount(parent); ++row) {
                for (int column = 0; column < model.columnCount(parent); ++column) {
                    const QModelIndex cell = model.index(row, column, parent);
                    const QString text = cell.data().toString();
                    const int indent = column == 0 ? 2 * numbers->indentation() : 0;
                    const int room = numbers->columnWidth(column) - indent - margins;
                    QVERIFY2(numbers->fontMetrics().horizontalAdvance(text) <= room, qPrintable(text));
                    texts += text.isEmpty() ? 0 : 1;
                }
            }
        }
        QVERIFY(texts > 100);
    }

    void copiesAsMarkdown() {
        Scene scene;
        QTRY_COMPARE_WITH_TIMEOUT(scene.number("displacement_max"), QStringLiteral("0.30000"), kPatience);
        const QList<QAction*> actions = scene.find<QPushButton>("copy")->menu()->actions();
        QCOMPARE(actions.size(), qsizetype{3});
        actions[2]->trigger();
        QVERIFY(QGuiApplication::clipboard()->text().contains(QStringLiteral("| Largest |  | 0.30000 |")));
        actions[1]->trigger();
        QVERIFY(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("section,key,")));
    }

    void numbersOfBeforeAreNotShownAsThoseOfNow() {
        Scene scene;
        auto* numbers = scene.find<QTreeView>("numbers");
        const auto* model = qobject_cast<const MeshStatisticsModel*>(numbers->model());
        QTRY_VERIFY_WITH_TIMEOUT(
            scene.number("changed_vertices").toInt() > 0 && model->measuring().isUpToDate(), kPatience);
        const QModelIndex cell = model->find("changed_vertices", MeshStatisticsModel::DeformedColumn);
        const QString before = cell.data().toString();
        numbers->expandAll();  // what was folded is remembered
        numbers->scrollTo(cell);
        const auto ink = [numbers, &cell] {
            const QImage picture = numbers->viewport()->grab(numbers->visualRect(cell)).toImage();
            int darkest = 255;
            for (int y = 0; y < picture.height(); ++y) {
                for (int x = 0; x < picture.width(); ++x) {
                    darkest = std::min(darkest, qGray(picture.pixel(x, y)));
                }
            }
            return darkest;
        };
        const QPalette light(Qt::black, Qt::lightGray, Qt::white, Qt::darkGray, Qt::gray, Qt::black,
                             Qt::white);
        numbers->setPalette(light);
        const int current = ink();
        Hit hit = scene.session.hits().history().hits()[0];
        hit.point.x = 1.5f;
        QVERIFY(scene.session.hits().add(hit).ok());
        QVERIFY(scene.window->viewport().syncNow().ok());
        // What is measured comes by the event loop.
        QVERIFY(cell.data(MeshStatisticsModel::OutOfDateRole).toBool());
        QCOMPARE(cell.data().toString(), before);
        QVERIFY(ink() > current + 60);
        QVERIFY(model->headerData(0, Qt::Horizontal).toString().startsWith(QStringLiteral("Updating")));
        QGuiApplication::clipboard()->setText(QStringLiteral("nothing"));
        scene.find<QPushButton>("copy")->menu()->actions()[1]->trigger();
        QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("nothing"));
        QTRY_VERIFY_WITH_TIMEOUT(!cell.data(MeshStatisticsModel::OutOfDateRole).toBool(), kPatience);
        QVERIFY(cell.data().toInt() > before.toInt());
        QVERIFY(
            QGuiApplication::clipboard()->text().contains(QStringLiteral(",%1,").arg(cell.data().toInt())));
        QVERIFY(ink() <= current + 5);
    }

    void handlesOfTheHistogramSelectVertices() {
        Scene scene;
        QTRY_COMPARE_WITH_TIMEOUT(scene.number("displacement_max"), QStringLiteral("0.30000"), kPatience);
        scene.openTab(1);
        auto* histogram = scene.find<HistogramPlot>("histogram");
        QTRY_VERIFY_WITH_TIMEOUT(histogram->isVisible() && histogram->range(), kPatience);
        QTest::mouseClick(scene.find<QPushButton>("selectRange"), Qt::LeftButton);
        const TargetId target = scene.session.targets().front()->id;
        const std::size_t all = scene.session.selection().vertices(target).size();
        QCOMPARE(scene.session.targets().front()->deformed.statistics().changedVertices, all);

        QWidget* plot = histogram->findChildren<QWidget*>().constFirst();
        const int y = plot->height() / 2;
        const auto at = [&](double value) { return QPoint(qRound(histogram->pixelOf(value)), y); };
        QTest::mousePress(plot, Qt::LeftButton, {}, at(histogram->range()->low));
        QTest::mouseMove(plot, at(0.15));
        QTest::mouseMove(plot, at(0.2));
        QTest::mouseRelease(plot, Qt::LeftButton, {}, at(0.2));
        const std::size_t some = scene.session.selection().vertices(target).size();
        QVERIFY(some > 0 && some < all);
        QVERIFY(scene.find<QLabel>("between")->text().startsWith(QString::number(some) + u' '));
        QTest::mouseClick(scene.find<QPushButton>("wholeRange"), Qt::LeftButton);
        QCOMPARE(scene.session.selection().count(), std::size_t{0});
    }

    void harmedFacesAreJumpedTo() {
        Scene scene;
        QTRY_COMPARE_WITH_TIMEOUT(scene.number("displacement_max"), QStringLiteral("0.30000"), kPatience);
        scene.openTab(2);
        auto* harms = scene.find<QTableView>("harms");
        scene.find<QDoubleSpinBox>("stretchLimit")->setValue(1.1);
        QTRY_VERIFY_WITH_TIMEOUT(harms->model()->rowCount() > 0, kPatience);
        const float before = scene.window->viewport().camera().distance();
        const QPoint row = harms->visualRect(harms->model()->index(0, 1)).center();
        QTest::mouseClick(harms->viewport(), Qt::LeftButton, {}, row);
        QVERIFY(scene.session.selection().count() >= 3);
        QTest::mouseDClick(harms->viewport(), Qt::LeftButton, {}, row);
        QTRY_VERIFY_WITH_TIMEOUT(scene.window->viewport().camera().distance() < 0.5f * before, kPatience);
        QCOMPARE(scene.session.hits().selected(), std::optional<std::size_t>(0));
    }

    /// As near as the size of the mesh asks for, not within half a metre.
    void harmedFacesOfSmallMeshesAreSeen() {
        Scene scene(0.001f);
        scene.openTab(2);
        auto* harms = scene.find<QTableView>("harms");
        scene.find<QDoubleSpinBox>("stretchLimit")->setValue(1.1);
        QTRY_VERIFY_WITH_TIMEOUT(harms->model()->rowCount() > 0, kPatience);
        const float before = scene.window->viewport().camera().distance();
        const QPoint row = harms->visualRect(harms->model()->index(0, 1)).center();
        QTest::mouseClick(harms->viewport(), Qt::LeftButton, {}, row);
        QTest::mouseDClick(harms->viewport(), Qt::LeftButton, {}, row);
        QTRY_VERIFY_WITH_TIMEOUT(scene.window->viewport().camera().distance() < 0.5f * before, kPatience);
    }

    void thePipelineAgrees() {
        Scene scene;
        auto* dock = scene.window->findChild<QDockWidget*>(QStringLiteral("pipelineAgreement"));
        dock->show();
        dock->raise();
        QTest::mouseClick(dock->findChild<QPushButton*>(QStringLiteral("compare")), Qt::LeftButton);
        auto* different = dock->findChild<QLabel*>(QStringLiteral("different"));
        QTRY_COMPARE_WITH_TIMEOUT(different->text(), QStringLiteral("0"), kPatience);
        QVERIFY(dock->findChild<QLabel*>(QStringLiteral("verdict"))
                    ->text()
                    .contains(QStringLiteral("bit-exact")));
        QVERIFY(!dock->findChild<QToolButton*>(QStringLiteral("worst"))->isEnabled());

        // A vertex disturbed behind the pipeline's back.
        const Target& target = *scene.session.targets().front();
        DynamicVertex vertex = target.deformed.vertices()[100];
        vertex.position.x += 0.5f;
        test::readBackOf(scene.session).take(target.id, 100, {&vertex, 1});
        test::readBackOf(scene.session).finish();
        QTest::mouseClick(dock->findChild<QPushButton*>(QStringLiteral("compare")), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(different->text(), QStringLiteral("1"), kPatience);
        QTest::mouseClick(dock->findChild<QToolButton*>(QStringLiteral("worst")), Qt::LeftButton);
        QVERIFY(scene.session.selection().picked());
        QCOMPARE(scene.session.selection().picked()->vertex, target.deformed.render().fileVertices[100]);
    }

    void theStatusBarShowsWhatTakesAWhile() {
        Scene scene;
        auto* cancel = scene.window->findChild<QToolButton*>(QStringLiteral("cancelTask"));
        bool isCancelled = false;
        {
            TaskProgress task(scene.session.tasks(), QStringLiteral("Thinking"),
                              [&isCancelled] { isCancelled = true; });
            task.report(0.5);
            QVERIFY(!cancel->isVisible());  // it may be over soon
            QTRY_VERIFY_WITH_TIMEOUT(cancel->isVisible(), kPatience);
            QTest::mouseClick(cancel, Qt::LeftButton);
            QVERIFY(isCancelled);
        }
        QTRY_VERIFY_WITH_TIMEOUT(!cancel->isVisible(), kPatience);
    }

private:
    TestSettings m_settings;
};

HITSCOPE_TEST(StatisticsWindowTest, QApplication)

}  // namespace hitscope::statistics_window_test

#include "statistics_window_test.moc"
