// SPDX-License-Identifier: GPL-3.0-or-later
// Several files and scenes of ours brought in through the real window, and its Scene dock.
#include <QApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "app/notice_bar.h"
#include "app/opening_progress.h"
#include "app/overlays/coming_picture.h"
#include "app/scene_files.h"
#include "mesh/primitives.h"
#include "panels/scene/scene_panel.h"
#include "session/sample_scenes.h"
#include "session/task_list.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::scene_files_test {

namespace {

QAction* menuAction(const QWidget& window, const QString& text) {
    for (QAction* action : window.findChildren<QAction*>()) {
        if (QString(action->text()).remove(u'&') == text) {
            return action;
        }
    }
    return nullptr;
}

}  // namespace

class SceneFilesTest : public QObject {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        QVERIFY(m_folder.isValid());
        writeObj(makeLowPolyCube(1.0f), path("a.obj"));
        writeObj(makeLowPolySphere(1.0f), path("b.obj"));
        QFile broken(path("broken.obj"));
        QVERIFY(broken.open(QIODevice::WriteOnly));
        broken.write("v 0 0 0\nf 1 2 3\n");
    }
    void severalFilesAreOneScene();
    void severalFilesAreOneTask();
    void theShareOfAllFilesOnlyGrows();
    void whatCannotBeReadIsLeftOut();
    void filesAndTargetsAreAdded();
    void cancellingLeavesTheScene();
    void noFilesGiveNothingUp();
    void aLargeMeshIsSeenBeforeItIsPrepared();
    void theSceneComesWhenAllIsReady();
    void whatIsNotReadyYetCanBeCancelled();
    void sampleScenesAreMade_data();
    void sampleScenesAreMade();
    void deleteInTheViewportRemovesTheTarget();

private:
    [[nodiscard]] QString path(const char* name) const {
        return m_folder.filePath(QString::fromLatin1(name));
    }

    TestSettings m_settings;
    QTemporaryDir m_folder;
};

void SceneFilesTest::severalFilesAreOneTask() {
    Session session;
    SceneFiles files(session);
    QSignalSpy ended(&files, &SceneFiles::ended);
    QList<int> tasks;
    QStringList said;
    std::vector<double> shares;
    connect(&session.tasks(), &TaskList::changed, this, [&] {
        const TaskList::Task* const task = session.tasks().current();
        if (task != nullptr) {
            tasks += tasks.contains(task->id) ? QList<int>() : QList<int>{task->id};
            said += task->what;
            shares.push_back(task->fraction);
        }
    });
    files.open({path("a.obj"), path("broken.obj"), path("b.obj")});
    QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, kPatience);
    QCOMPARE(session.targets().size(), std::size_t{2});
    QCOMPARE(tasks.size(), 1);
    for (const char* const text :
         {"Opening a.obj (1 of 3)", "Preparing a.obj (1 of 3)", "Opening broken.obj (2 of 3)",
          "Opening b.obj (3 of 3)", "Preparing b.obj (3 of 3)"}) {
        QVERIFY2(said.contains(QString::fromLatin1(text)), text);
    }
    QVERIFY(std::is_sorted(shares.begin(), shares.end()));
    QVERIFY(shares.back() > 0.25 && shares.back() <= 1.0);
}

void SceneFilesTest::theShareOfAllFilesOnlyGrows() {
    const OpeningProgress progress({100.0, 300.0});
    double last = progress.reading(0, 0.0);
    QCOMPARE(last, 0.0);
    const auto grows = [&last](double share) { return std::exchange(last, share) < share && share < 1.0; };
    for (const std::size_t file : {0u, 1u}) {
        QVERIFY(file == 0 || std::abs(progress.reading(file, 0.0) - 0.25) < 1e-12);
        QVERIFY(grows(progress.reading(file, 0.5)));
        QVERIFY(grows(progress.reading(file, 1.0)));
        QCOMPARE(progress.preparing(file, 2.0, 0.0), last);
        for (const double seconds : {1.0, 3.0, 4.6, 5.0, 7.0, 9.0}) {  // 5.1 are expected
            QVERIFY2(grows(progress.preparing(file, 2.0, seconds)), qPrintable(QString::number(seconds)));
        }
        QVERIFY(last > 0.99 * (file == 0 ? 0.25 : 1.0));
    }
    QVERIFY(std::abs(progress.preparing(1, 2.0, 2.57) - (0.25 + 0.75 * 0.64)) < 0.001);  // half of it
}

void SceneFilesTest::severalFilesAreOneScene() {
    Session session;
    SceneFiles files(session);
    QSignalSpy opened(&files, &SceneFiles::opened);
    QSignalSpy ended(&files, &SceneFiles::ended);
    files.open({path("a.obj"), path("b.obj")});
    QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, kPatience);
    QCOMPARE(opened.count(), 1);
    QCOMPARE(opened[0][0].toStringList(), (QStringList{path("a.obj"), path("b.obj")}));
    QCOMPARE(session.targets().size(), std::size_t{2});
    QCOMPARE(session.targets()[1]->sourcePath, path("b.obj"));
    QVERIFY(session.sceneName().contains(QStringLiteral("1 more")));
    const Bounds first = session.targets()[0]->worldBounds();
    const Bounds second = session.targets()[1]->worldBounds();
    QVERIFY(second.min.x > first.max.x);  // they would overlap
    QCOMPARE(session.targets().floorHeight(), -1.0f);
}

void SceneFilesTest::whatCannotBeReadIsLeftOut() {
    Session session;
    SceneFiles files(session);
    QSignalSpy opened(&files, &SceneFiles::opened);
    QSignalSpy failed(&files, &SceneFiles::failed);
    QSignalSpy ended(&files, &SceneFiles::ended);
    files.open({path("broken.obj"), path("a.obj")});
    QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, kPatience);
    QCOMPARE(opened.count(), 1);
    QCOMPARE(session.targets().size(), std::size_t{1});
    QVERIFY(opened[0][1].toStringList().join(u'\n').contains(QStringLiteral("broken.obj")));
    files.open({path("broken.obj")});
    QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 2, kPatience);
    QCOMPARE(failed.count(), 1);
    QCOMPARE(session.targets().size(), std::size_t{1});
}

void SceneFilesTest::filesAndTargetsAreAdded() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    SceneFiles files(session);
    QSignalSpy ended(&files, &SceneFiles::ended);
    files.open({path("a.obj"), path("b.obj")}, SceneFiles::Into::ThisScene);
    QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, kPatience);
    QCOMPARE(session.targets().size(), std::size_t{18});
    files.make(QStringLiteral("Sheet"), SceneFiles::Into::ThisScene, [] {
        return ScenePlan{{}, {planPrimitive({PrimitiveKind::Sheet, 8, 2.0f})}};
    });
    QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 2, kPatience);
    QCOMPARE(session.targets().back()->name, QStringLiteral("Sheet"));
    session.undo();
    session.undo();  // two files are one step
    QCOMPARE(session.targets().size(), std::size_t{16});
}

void SceneFilesTest::cancellingLeavesTheScene() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    SceneFiles files(session);
    QSignalSpy made(&files, &SceneFiles::made);
    files.make(QStringLiteral("Late"), SceneFiles::Into::NewScene, [] {
        QThread::msleep(200);
        return planSampleScene(SampleScene::Turntable);
    });
    files.cancel();
    QVERIFY(!files.isOpening());
    QTest::qWait(600);
    QCOMPARE(made.count(), 0);
    QCOMPARE(session.targets().size(), std::size_t{16});
}

/// As a dialog gives them that was cancelled.
void SceneFilesTest::noFilesGiveNothingUp() {
    Session session;
    SceneFiles files(session);
    QSignalSpy opened(&files, &SceneFiles::opened);
    files.open({path("a.obj")});
    files.open({}, SceneFiles::Into::ThisScene);
    QVERIFY(files.isOpening());
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatience);
}

void SceneFilesTest::theSceneComesWhenAllIsReady() {
    Session session;
    SceneFiles files(session);
    QSignalSpy ended(&files, &SceneFiles::ended);
    int asked = 0;
    int turns = 0;
    QTimer turn;
    connect(&turn, &QTimer::timeout, this, [&turns] { ++turns; });
    files.setReadying([&](const ScenePlan& scene) {
        if (asked == 0) {
            turn.start(0);
        }
        return scene.targets.size() == 1 && session.targets().empty() && ++asked == 20;
    });
    files.open({path("a.obj")});
    QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, kPatience);
    QCOMPARE(asked, 20);
    QVERIFY2(turns >= 10, qPrintable(QString::number(turns)));  // others had their turns meanwhile
    QCOMPARE(session.targets().size(), std::size_t{1});
}

void SceneFilesTest::whatIsNotReadyYetCanBeCancelled() {
    Session session;
    SceneFiles files(session);
    QSignalSpy opened(&files, &SceneFiles::opened);
    int asked = 0;
    files.setReadying([&asked](const ScenePlan&) {
        ++asked;
        return false;
    });
    files.open({path("a.obj")});
    QTRY_VERIFY_WITH_TIMEOUT(asked > 3, kPatience);
    files.cancel();
    const int then = asked;
    QTest::qWait(50);
    QCOMPARE(asked, then);
    QCOMPARE(opened.count(), 0);
    QVERIFY(session.targets().empty());
}

/// Which pixels are not the background, whose colour changes from row to row only.
QImage coverOf(const QImage& picture) {
    QImage cover(picture.size(), QImage::Format_Grayscale8);
    for (int y = 0; y < picture.height(); ++y) {
        const QRgb ground = picture.pixel(0, y);
        for (int x = 0; x < picture.width(); ++x) {
            const QRgb here = picture.pixel(x, y);
            const int gap = std::abs(qRed(here) - qRed(ground)) + std::abs(qGreen(here) - qGreen(ground)) +
                            std::abs(qAlpha(here) - qAlpha(ground));
            cover.scanLine(y)[x] = gap > 20 ? 255 : 0;
        }
    }
    return cover;
}

void SceneFilesTest::aLargeMeshIsSeenBeforeItIsPrepared() {
    writeObj(makeUvSphere(700, 400, 3.0f), path("large.obj"));
    Session session;
    MainWindow window(session);
    showReady(window);
    DisplayOptions options = window.viewport().options();
    options.floor = false;
    window.viewport().setOptions(options);
    auto* files = window.findChild<SceneFiles*>();
    auto* coming = window.findChild<ComingPicture*>();
    QImage seen;
    QString sceneThen = QStringLiteral("none");
    connect(files, &SceneFiles::seen, this, [&](const QImage& picture) {
        seen = picture;
        sceneThen = session.sceneName();
    });
    QSignalSpy ended(files, &SceneFiles::ended);
    files->open({path("a.obj")});
    QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, kPatience);
    QVERIFY(seen.isNull());  // it is there at once
    files->open({path("large.obj")});
    QTRY_VERIFY_WITH_TIMEOUT(coming->isVisible(), kPatience);
    QVERIFY(!seen.isNull());
    QCOMPARE(sceneThen, QStringLiteral("a"));
    QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 2, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!coming->isVisible(), kPatience);
    // Where it is going to be.
    const QImage drawn = window.viewport().surface().grab().scaled(seen.size());
    const QImage before = coverOf(seen);
    const QImage after = coverOf(drawn);
    int covered = 0;
    int different = 0;
    for (int y = 0; y < after.height(); ++y) {
        for (int x = 0; x < after.width(); ++x) {
            covered += after.constScanLine(y)[x] != 0 ? 1 : 0;
            different += after.constScanLine(y)[x] != before.constScanLine(y)[x] ? 1 : 0;
        }
    }
    QVERIFY(covered > after.width() * after.height() / 10);
    QVERIFY2(different < covered / 20, qPrintable(QString::number(different)));
}

void SceneFilesTest::sampleScenesAreMade_data() {
    QTest::addColumn<int>("scene");
    QTest::addColumn<std::size_t>("targets");
    QTest::addColumn<std::size_t>("triangles");
    QTest::newRow("turntable") << static_cast<int>(SampleScene::Turntable) << std::size_t{2}
                               << std::size_t{0};
    QTest::newRow("wall") << static_cast<int>(SampleScene::Wall) << std::size_t{100} << std::size_t{0};
    QTest::newRow("two million") << static_cast<int>(SampleScene::TwoMillion) << std::size_t{1}
                                 << std::size_t{2'000'000};
}

void SceneFilesTest::sampleScenesAreMade() {
    QFETCH(int, scene);
    QFETCH(std::size_t, targets);
    QFETCH(std::size_t, triangles);
    Session session;
    MainWindow window(session);
    showReady(window);
    menuAction(window, sampleSceneName(static_cast<SampleScene>(scene)))->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(session.targets().size(), targets, 3 * kPatience);
    std::size_t made = 0;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        made += target->deformed.render().triangles.size() / 3;
        for (const std::unique_ptr<Target>& other : session.targets()) {
            QVERIFY(target == other || target->name != other->name);
        }
    }
    QVERIFY(triangles == 0 || made == triangles);
    QVERIFY(std::abs(session.targets().bounds().min.y) < 1.0e-3f);
}

void SceneFilesTest::deleteInTheViewportRemovesTheTarget() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    MainWindow window(session);
    showReady(window);
    auto* dock = window.findChild<QDockWidget*>(QStringLiteral("scene"));
    QVERIFY(dock != nullptr && !dock->isHidden());
    session.targets().select(session.targets()[3]->id);
    window.viewport().setFocus();
    QTest::keyClick(&window.viewport(), Qt::Key_Delete);
    QCOMPARE(session.targets().size(), std::size_t{15});
    QVERIFY(menuAction(window, QStringLiteral("Undo Remove Target")) != nullptr);
    QTest::keyClick(&window.viewport(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(session.targets().size(), std::size_t{16});
}

HITSCOPE_TEST(SceneFilesTest, QApplication)

}  // namespace hitscope::scene_files_test

#include "scene_files_test.moc"
