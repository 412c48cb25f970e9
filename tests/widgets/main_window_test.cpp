// SPDX-License-Identifier: GPL-3.0-or-later
// The whole window, used as a person uses it.
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QStatusBar>
#include <QTableView>
#include <QTreeView>
#include <QUrl>
#include <vector>

#include "io/import.h"
#include "mesh/primitives.h"
#include "models/mesh_statistics_model.h"
#include "session/frame_costs.h"
#include "session/task_list.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::main_window_test {

class MainWindowTest : public QObject {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init();
    void cleanup();
    void opensOnTheDefaultScene();
    void openClickInspectExport();
    void undoAndRedoByKey();
    void aPauseIsNoFrame();
    void pipelinesGiveTheSameMesh();
    void badFilesSayOneThing_data();
    void badFilesSayOneThing();
    void dropOpens();
    void openingCanBeCancelled();
    void placesTheMeshOnRequest();
    void layoutIsRemembered();
    void settingsAreRemembered();
    void savesThePicture();

private:
    [[nodiscard]] QString path(const QString& name) const { return m_folder->filePath(name); }
    void openCube(MainWindow& window, Session& session);
    void clickCentre(MainWindow& window, const QPoint& offset = {});
    static QTableView* table(MainWindow& window, const char* dock) {
        return window.findChild<QDockWidget*>(QLatin1String(dock))->findChild<QTableView*>();
    }

    std::unique_ptr<TestSettings> m_settings;
    std::unique_ptr<QTemporaryDir> m_folder;
};

void MainWindowTest::init() {
    m_settings = std::make_unique<TestSettings>();
    m_folder = std::make_unique<QTemporaryDir>();
}

void MainWindowTest::cleanup() {
    m_settings.reset();
    m_folder.reset();
}

void MainWindowTest::openCube(MainWindow& window, Session& session) {
    writeObj(makeHighPolyCube(2.5f), path(QStringLiteral("cube.obj")));
    window.openFiles({path(QStringLiteral("cube.obj"))});
    QTRY_COMPARE_WITH_TIMEOUT(session.targets().size(), std::size_t{1}, kPatience);
    QCOMPARE(session.targets().front()->deformed.original().vertexCount(), std::size_t{6146});
}

void MainWindowTest::clickCentre(MainWindow& window, const QPoint& offset) {
    QTest::mouseClick(&window.viewport(), Qt::LeftButton, {}, window.viewport().rect().center() + offset);
}

void MainWindowTest::opensOnTheDefaultScene() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    MainWindow window(session);
    showReady(window);
    QCOMPARE(session.targets().size(), std::size_t{16});
    QVERIFY(window.windowTitle().contains(session.sceneName()));
    QVERIFY(window.findChildren<QMessageBox*>().isEmpty());
}

void MainWindowTest::openClickInspectExport() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    MainWindow window(session);
    showReady(window);
    openCube(window, session);
    const QTableView* history = table(window, "hitHistory");
    auto* dock = window.findChild<QDockWidget*>(QStringLiteral("meshStatistics"));
    dock->raise();
    const auto* statistics = qobject_cast<const MeshStatisticsModel*>(dock->findChild<QTreeView*>()->model());
    const auto changed = [statistics] {
        return statistics->find("changed_vertices", MeshStatisticsModel::DeformedColumn).data().toString();
    };
    QTRY_COMPARE_WITH_TIMEOUT(changed(), QStringLiteral("0"), kPatience);

    clickCentre(window);
    QTRY_COMPARE_WITH_TIMEOUT(history->model()->rowCount(), 1, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(changed() != QStringLiteral("0"), kPatience);
    clickCentre(window, {60, 40});
    QTRY_COMPARE_WITH_TIMEOUT(history->model()->rowCount(), 2, kPatience);

    const QString saved = path(QStringLiteral("dented.obj"));
    const Status exported = window.exportTo(saved);
    QVERIFY2(exported.ok(), exported.ok() ? "" : exported.error().message().c_str());
    const Result<ImportedMesh> again = importMesh(saved);
    QVERIFY2(again.ok(), again.ok() ? "" : again.error().message().c_str());
    const DeformedMesh& deformed = session.targets().front()->deformed;
    const PageVector<glm::vec3> shown(deformed.positions().begin(), deformed.positions().end());
    QVERIFY(again.value().mesh.positions == shown);
    QVERIFY(again.value().mesh.cornerVertices == deformed.original().cornerVertices);
    QVERIFY(shown != deformed.original().positions);

    // A hit that no frame has shown yet is in the file all the same.
    Hit unseen = session.hits().history().hits().front();
    unseen.point = {0.0f, 2.5f, 0.0f};
    QVERIFY(session.hits().add(unseen).ok());
    QVERIFY(window.exportTo(saved).ok());
    const Result<ImportedMesh> last = importMesh(saved);
    QVERIFY(last.ok());
    QVERIFY(last.value().mesh.positions != shown);
}

void MainWindowTest::undoAndRedoByKey() {
    Session session;
    loadMesh(session, makeHighPolyCube(2.5f));
    MainWindow window(session);
    showReady(window);
    const Target& cube = *session.targets().front();
    clickCentre(window);
    QTRY_COMPARE_WITH_TIMEOUT(session.hits().history().size(), std::size_t{1}, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(cube.deformed.statistics().changedVertices > 0, kPatience);
    const std::size_t dented = cube.deformed.statistics().changedVertices;

    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(session.hits().history().size(), std::size_t{0});
    QCOMPARE(window.statusBar()->currentMessage(), QStringLiteral("Undone: Hit 1"));
    QTRY_COMPARE_WITH_TIMEOUT(cube.deformed.statistics().changedVertices, std::size_t{0}, kPatience);
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(session.hits().history().size(), std::size_t{1});
    QCOMPARE(window.statusBar()->currentMessage(), QStringLiteral("Redone: Hit 1"));
    QTRY_COMPARE_WITH_TIMEOUT(cube.deformed.statistics().changedVertices, dented, kPatience);
}

/// Whatever is drawn when a pause begins, the first frame behind it is not counted as long as the pause.
void MainWindowTest::aPauseIsNoFrame() {
    constexpr int kPause = 1500;  // milliseconds
    Session session;
    loadMesh(session, makeHighPolyCube(2.5f));
    MainWindow window(session);
    showReady(window);
    clickCentre(window);
    QTRY_COMPARE_WITH_TIMEOUT(session.hits().history().size(), std::size_t{1}, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!session.simulation().isMoving(), kPatience);
    // A bar opens, and another scene comes: frames that nothing moves in.
    window.resize(window.size() - QSize(0, 30));
    QTest::qWait(kPause);
    loadMesh(session, makeHighPolyCube(2.5f));
    QTest::qWait(kPause);
    const std::uint64_t before = session.frameCosts().frames().back().number;
    clickCentre(window);
    QTRY_COMPARE_WITH_TIMEOUT(session.hits().history().size(), std::size_t{1}, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(session.frameCosts().frames().back().number > before, kPatience);
    const Ring<FrameCost>& frames = session.frameCosts().frames();
    for (std::size_t i = 1; i < frames.size(); ++i) {
        QVERIFY2(frames[i].total < 0.9e-3 * kPause,
                 qPrintable(QStringLiteral("frame %1 took %2 s").arg(i).arg(frames[i].total)));
    }
}

void MainWindowTest::pipelinesGiveTheSameMesh() {
    Session session;
    loadMesh(session, makeHighPolySphere(2.5f));
    MainWindow window(session);
    showReady(window);
    if (!session.readBack().verdict().of(PipelineKind::TransformFeedback)->isExact()) {
        QSKIP("this renderer's arithmetic is not exact: its pipelines differ");
    }
    for (int i = 0; i < 3; ++i) {
        clickCentre(window, {25 * i, -20 * i});
        QTRY_COMPARE_WITH_TIMEOUT(session.hits().history().size(), static_cast<std::size_t>(i) + 1,
                                  kPatience);
    }
    const auto positions = [&] {
        [&] { QVERIFY(window.viewport().syncNow().ok()); }();
        const std::span<const glm::vec3> shown = session.targets().front()->deformed.positions();
        return std::vector<glm::vec3>(shown.begin(), shown.end());
    };
    const std::vector<glm::vec3> first = positions();
    session.settings().setPipeline(session.settings().pipeline() == PipelineKind::UniformArray
                                       ? PipelineKind::TransformFeedback
                                       : PipelineKind::UniformArray);
    QVERIFY(positions() == first);
}

void MainWindowTest::badFilesSayOneThing_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("missing") << QStringLiteral("nowhere.obj") << QByteArray();
    QTest::newRow("empty") << QStringLiteral("empty.ply") << QByteArray("");
    QTest::newRow("no mesh") << QStringLiteral("words.stl") << QByteArray("these are words\n");
    QTest::newRow("bad index") << QStringLiteral("bad.obj")
                               << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
}

void MainWindowTest::badFilesSayOneThing() {
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    if (!content.isNull()) {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
    }
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    MainWindow window(session);
    showReady(window);
    window.openFiles({path(name)});
    QTRY_COMPARE_WITH_TIMEOUT(window.findChildren<QMessageBox*>().size(), 1, kPatience);
    const QMessageBox* box = window.findChildren<QMessageBox*>().front();
    QVERIFY(!box->text().isEmpty());
    QVERIFY2((box->text() + box->informativeText()).contains(name), qPrintable(box->informativeText()));
    QCOMPARE(session.targets().size(), std::size_t{16});
    QTest::qWait(200);
    QCOMPARE(window.findChildren<QMessageBox*>().size(), 1);
}

void MainWindowTest::dropOpens() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    MainWindow window(session);
    showReady(window);
    writeObj(makeLowPolyCube(1.0f), path(QStringLiteral("dropped.obj")));
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path(QStringLiteral("dropped.obj")))});
    QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({100.0, 100.0}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&window, &drop);
    QTRY_COMPARE_WITH_TIMEOUT(session.targets().size(), std::size_t{1}, kPatience);
    QCOMPARE(session.targets().front()->deformed.original().vertexCount(), std::size_t{386});

    QMimeData other;
    other.setUrls({QUrl::fromLocalFile(path(QStringLiteral("notes.txt")))});
    QDragEnterEvent refused({100, 100}, Qt::CopyAction, &other, Qt::LeftButton, {});
    refused.ignore();
    QCoreApplication::sendEvent(&window, &refused);
    QVERIFY(!refused.isAccepted());
}

void MainWindowTest::openingCanBeCancelled() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    MainWindow window(session);
    showReady(window);
    writeObj(makeHighPolyCube(1.0f), path(QStringLiteral("slow.obj")));
    window.openFiles({path(QStringLiteral("slow.obj"))});
    const TaskList::Task* task = session.tasks().current();
    QVERIFY(task != nullptr);
    session.tasks().cancel(task->id);
    QTest::qWait(1000);
    QCOMPARE(session.targets().size(), std::size_t{16});
    QVERIFY(window.findChildren<QMessageBox*>().isEmpty());
}

void MainWindowTest::placesTheMeshOnRequest() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    MainWindow window(session);
    showReady(window);
    MeshData far = makeLowPolyCube(50.0f);
    for (glm::vec3& position : far.positions) {
        position += glm::vec3(1000.0f, 0.0f, 0.0f);
    }
    writeObj(far, path(QStringLiteral("far.obj")));
    window.openFiles({path(QStringLiteral("far.obj"))});
    QTRY_COMPARE_WITH_TIMEOUT(session.targets().size(), std::size_t{1}, kPatience);
    QCOMPARE(session.targets().bounds().size().x, 100.0f);
    window.placeMesh(5.0);
    QCOMPARE(session.targets().bounds().size().x, 5.0f);
    QCOMPARE(session.targets().bounds().centre().x, 0.0f);
    QVERIFY(window.exportTo(path(QStringLiteral("again.obj"))).ok());
    const Result<ImportedMesh> again = importMesh(path(QStringLiteral("again.obj")));
    QVERIFY(again.ok());
    QVERIFY(again.value().mesh.positions == far.positions);
    window.placeMesh(0.0);
    QCOMPARE(session.targets().bounds().size().x, 100.0f);
}

void MainWindowTest::layoutIsRemembered() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    {
        MainWindow window(session);
        showReady(window);
        auto* lights = window.findChild<QDockWidget*>(QStringLiteral("lights"));
        auto* rate = window.findChild<QDockWidget*>(QStringLiteral("frameRate"));
        QVERIFY(rate->isVisible());
        lights->toggleViewAction()->trigger();
        QVERIFY(!lights->toggleViewAction()->isChecked());
        window.addDockWidget(Qt::LeftDockWidgetArea, rate);
        window.close();
    }
    MainWindow window(session);
    showReady(window);
    QVERIFY(!window.findChild<QDockWidget*>(QStringLiteral("lights"))->toggleViewAction()->isChecked());
    auto* rate = window.findChild<QDockWidget*>(QStringLiteral("frameRate"));
    QCOMPARE(window.dockWidgetArea(rate), Qt::LeftDockWidgetArea);
    QVERIFY(window.centralWidget()->isAncestorOf(&window.viewport()));
}

void MainWindowTest::settingsAreRemembered() {
    DeformationConstants constants;
    constants.power = 0.07f;
    {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        MainWindow window(session);
        showReady(window);
        QVERIFY(session.settings().setConstants(constants).ok());
        session.settings().setPipeline(PipelineKind::UniformArray);
        QTest::keyClick(&window, Qt::Key_L);
        QTest::keyClick(&window, Qt::Key_H);
        QVERIFY(!session.settings().lights().points[2].on);
        QCOMPARE(window.viewport().options().wireframe, WireframeMode::Over);
        window.close();
    }
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    MainWindow window(session);
    QVERIFY(session.settings().constants() == constants);
    QCOMPARE(session.settings().pipeline(), PipelineKind::UniformArray);
    QVERIFY(!session.settings().lights().points[2].on);
    QVERIFY(session.settings().lights().spot.on);
    QCOMPARE(window.viewport().options().wireframe, WireframeMode::Over);
}

void MainWindowTest::savesThePicture() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    MainWindow window(session);
    showReady(window);
    const QString file = path(QStringLiteral("picture.png"));
    QVERIFY(window.savePictureTo(file).ok());
    const QImage picture(file);
    QCOMPARE(picture.size(), window.viewport().size() * window.viewport().devicePixelRatioF());
    QVERIFY(picture.pixel(picture.width() / 2, picture.height() / 2) != picture.pixel(2, 2));
}

HITSCOPE_TEST(MainWindowTest, QApplication)

}  // namespace hitscope::main_window_test

#include "main_window_test.moc"
