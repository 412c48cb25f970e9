// SPDX-License-Identifier: GPL-3.0-or-later
// What goes between the window and other programs: dropped and dragged files, and the clipboard.
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QImage>
#include <QMenu>
#include <QMimeData>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <QUrl>

#include "app/actions/exchange_actions.h"
#include "app/actions/pasted_text.h"
#include "app/discard_guard.h"
#include "document/session_file.h"
#include "io/import.h"
#include "io/save_image.h"
#include "mesh/same_bits.h"
#include "panels/fields/drag_out.h"
#include "panels/hit_history/hit_table.h"
#include "panels/scene/scene_panel.h"
#include "scene/picture.h"
#include "support/test_program.h"
#include "view/camera_text.h"
#include "window_support.h"

namespace hitscope::exchange_test {

class ExchangeTest : public QObject {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init();
    void cleanup();
    void picturesAreCopied();
    void hitsArePastedAsText();
    void filesArePasted();
    void otherTextIsRefused();
    void hitsAreDropped();
    void hitsAreDraggedOutAsATable();
    void targetsAreDraggedOutAsAFile();
    void copiedFilesArePasted_data();
    void copiedFilesArePasted();
    void copiedTextIsPasted();
    void textOfAnyMeshFormatIsTold();
    void picturesBringTheirCamera();
    void picturesReplaceMissingTextures_data();
    void picturesReplaceMissingTextures();
    void buttonsAreDraggedOut();
    void whatIsDraggedOutDoesNotComeBack();

private:
    void addHit();
    [[nodiscard]] QString writtenHits();
    void chooseEntry(const QString& title, const QString& entry);
    /// As the panel drags them.
    [[nodiscard]] std::unique_ptr<QMimeData> draggedHits() const;

    QStringList m_dragged;
    TestSettings m_settings;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<MainWindow> m_window;
};

void ExchangeTest::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_session = std::make_unique<Session>();
    loadMesh(*m_session, makeHighPolyCube(2.5f));
    m_window = std::make_unique<MainWindow>(*m_session);
    showReady(*m_window);
    addHit();
}

void ExchangeTest::cleanup() {
    m_window.reset();
    m_session.reset();
    QGuiApplication::clipboard()->clear();
}

void ExchangeTest::addHit() {
    Hit hit;
    hit.target = m_session->targets().front()->id;
    hit.point = {0.0f, 2.5f, 0.0f};
    hit.direction = {0.0f, -1.0f, 0.0f};
    QVERIFY(m_session->hits().add(hit).ok());
}

std::unique_ptr<QMimeData> ExchangeTest::draggedHits() const {
    const QAbstractItemModel* model = m_window->findChild<HitTable*>()->model();
    return std::unique_ptr<QMimeData>(model->mimeData({model->index(0, 0)}));
}

QString ExchangeTest::writtenHits() {
    const QString path = m_folder->filePath(QStringLiteral("hits.csv"));
    QFile file(path);
    const QByteArray text = draggedHits()->text().toUtf8();
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() ? path : QString();
}

void ExchangeTest::picturesAreCopied() {
    QTest::keyClick(m_window.get(), Qt::Key_F12, Qt::ControlModifier);
    const QImage copied = QGuiApplication::clipboard()->image();
    QCOMPARE(copied.size(), m_window->viewport().size() * m_window->devicePixelRatioF());
    QVERIFY(m_window->statusBar()->currentMessage().contains(QString::number(copied.width())));
    int colours = 0;
    for (int x = 1; x < copied.width(); ++x) {
        colours += copied.pixel(x, copied.height() / 2) != copied.pixel(x - 1, copied.height() / 2) ? 1 : 0;
    }
    QVERIFY2(colours > 10, qPrintable(QString::number(colours)));  // a mesh, not a plain
}

void ExchangeTest::hitsArePastedAsText() {
    QGuiApplication::clipboard()->setText(draggedHits()->text());
    QTest::keyClick(m_window.get(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(m_session->hits().history().size(), std::size_t{2});
    const std::span<const Hit> hits = m_session->hits().history().hits();
    QVERIFY(sameBits(hits[0].point, hits[1].point));
    m_session->undo();
    QCOMPARE(m_session->hits().history().size(), std::size_t{1});
}

void ExchangeTest::filesArePasted() {
    auto* data = new QMimeData;
    data->setUrls({QUrl::fromLocalFile(writtenHits())});
    QGuiApplication::clipboard()->setMimeData(data);
    QTest::keyClick(m_window.get(), Qt::Key_V, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), std::size_t{2}, kPatience);
}

void ExchangeTest::otherTextIsRefused() {
    QGuiApplication::clipboard()->setText(QStringLiteral("Dear reader"));
    QTest::keyClick(m_window.get(), Qt::Key_V, Qt::ControlModifier);
    const auto box = [this] { return m_window->findChild<QMessageBox*>(); };
    QTRY_VERIFY_WITH_TIMEOUT(box() != nullptr && box()->isVisible(), kPatience);
    QVERIFY2(box()->text().contains(QStringLiteral("no camera, session or mesh, and no hits")),
             qPrintable(box()->text()));
    box()->close();
    QCOMPARE(m_session->hits().history().size(), std::size_t{1});
}

void ExchangeTest::hitsAreDropped() {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(writtenHits())});
    QVERIFY(ExchangeActions::canTake(data));
    QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(m_window.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({100.0, 100.0}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(m_window.get(), &drop);
    QVERIFY(drop.isAccepted());
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), std::size_t{2}, kPatience);
}

void ExchangeTest::hitsAreDraggedOutAsATable() {
    const std::unique_ptr<QMimeData> data = draggedHits();
    QVERIFY(data->hasText());
    QVERIFY(data->hasUrls());
    const QString path = data->urls().value(0).toLocalFile();
    QVERIFY2(path.endsWith(QStringLiteral("/hits.csv")), qPrintable(path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(QString::fromUtf8(file.readAll()), data->text());
    QCOMPARE(data->urls().value(0).toLocalFile(), path);  // asked for twice, it is the same
}

void ExchangeTest::targetsAreDraggedOutAsAFile() {
    const QAbstractItemModel* model = m_window->findChild<ScenePanel*>()->findChild<QTableView*>()->model();
    QVERIFY(model->flags(model->index(0, 0)).testFlag(Qt::ItemIsDragEnabled));
    const std::unique_ptr<QMimeData> data(model->mimeData({model->index(0, 0)}));
    const QString path = data->urls().value(0).toLocalFile();
    QVERIFY2(path.endsWith(QStringLiteral("_deformed.obj")), qPrintable(path));
    const QString said = m_window->statusBar()->currentMessage();
    QVERIFY2(said.contains(QFileInfo(path).fileName()) && !said.contains(path), qPrintable(said));
    const Result<ImportedMesh> read = importMesh(path);
    QVERIFY(read.ok());
    const std::span<const glm::vec3> shown = m_session->targets().front()->deformed.positions();
    QVERIFY(std::equal(shown.begin(), shown.end(), read.value().mesh.positions.begin(),
                       read.value().mesh.positions.end(),
                       [](const glm::vec3& a, const glm::vec3& b) { return sameBits(a, b); }));
    QVERIFY(m_session->targets().front()->deformed.statistics().changedVertices > 0);
}

void ExchangeTest::chooseEntry(const QString& title, const QString& entry) {
    for (const QMenu* menu : m_window->findChildren<QMenu*>()) {
        for (QAction* action : menu->title() == title ? menu->actions() : QList<QAction*>()) {
            if (action->text() == entry) {
                action->trigger();
                return;
            }
        }
    }
    QFAIL("there is no such entry");
}

void ExchangeTest::copiedFilesArePasted_data() {
    QTest::addColumn<QString>("entry");
    QTest::addColumn<QString>("ending");
    QTest::newRow("picture") << QStringLiteral("&Picture") << QStringLiteral(".png");
    QTest::newRow("session") << QStringLiteral("&Session") << QStringLiteral(".hitscope");
    QTest::newRow("mesh") << QStringLiteral("Deformed &Mesh") << QStringLiteral("_deformed.obj");
    QTest::newRow("vertex changes") << QStringLiteral("&Vertex Changes") << QStringLiteral("_deformed.csv");
}

void ExchangeTest::copiedFilesArePasted() {
    QFETCH(QString, entry);
    QFETCH(QString, ending);
    chooseEntry(QStringLiteral("Copy as &File"), entry);
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    const QString path = data->urls().value(0).toLocalFile();
    QVERIFY2(path.endsWith(ending), qPrintable(path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    if (ending == QStringLiteral(".png")) {
        QCOMPARE(QImage(path).width(), m_window->viewport().pictureRequest().width);
    } else if (ending == QStringLiteral(".hitscope")) {
        const Result<SessionDocument> read = readSessionFile(path);
        QVERIFY(read.ok());
        QCOMPARE(read.value().hits.size(), std::size_t{1});
    } else if (ending == QStringLiteral("_deformed.obj")) {
        QCOMPARE(importMesh(path).value().mesh.vertexCount(),
                 m_session->targets().front()->deformed.positions().size());
    } else {
        const DisplacementStatistics moved = m_session->targets().front()->deformed.statistics();
        QCOMPARE(file.readAll().count('\n'), static_cast<qsizetype>(moved.changedVertices) + 1);
    }
}

/// Pasted into the window that it came from: first the session, with its hit, then the mesh, dented already.
void ExchangeTest::copiedTextIsPasted() {
    const QString source = m_folder->filePath(QStringLiteral("cube.obj"));
    writeObj(m_session->targets().front()->deformed.original(), source);
    m_session->undo();  // nothing to ask about
    m_window->openFiles({source});
    QTRY_COMPARE_WITH_TIMEOUT(m_session->targets().front()->sourcePath, source, kPatience);
    addHit();
    chooseEntry(QStringLiteral("Copy as &Text"), QStringLiteral("Deformed &Mesh"));
    const QString mesh = QGuiApplication::clipboard()->text();
    QVERIFY(mesh.contains(QStringLiteral("\nf ")));
    const std::span<const glm::vec3> now = m_session->targets().front()->deformed.positions();
    const std::vector<glm::vec3> shown(now.begin(), now.end());
    chooseEntry(QStringLiteral("Copy as &Text"), QStringLiteral("&Session"));
    m_session->undo();
    QCOMPARE(m_session->hits().history().size(), std::size_t{0});
    QTest::keyClick(m_window.get(), Qt::Key_V, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), std::size_t{1}, kPatience);
    QGuiApplication::clipboard()->setText(mesh);
    m_window->findChild<DiscardGuard*>()->letGo();  // nothing to ask about
    m_window->findChild<ExchangeActions*>()->paste();
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), std::size_t{0}, kPatience);
    const Target& pasted = *m_session->targets().front();
    QVERIFY2(QFileInfo(pasted.sourcePath).isFile(), qPrintable(pasted.sourcePath));
    const std::span<const glm::vec3> read = pasted.deformed.original().positions;
    QVERIFY(std::equal(shown.begin(), shown.end(), read.begin(), read.end(),
                       [](const glm::vec3& a, const glm::vec3& b) { return sameBits(a, b); }));
}

void ExchangeTest::textOfAnyMeshFormatIsTold() {
    QCOMPARE(meshSuffixOf("# a\n\nv 0 0 0\nv 1 0 0\nv 0 1 0\n f 1 2 3\n"), QStringLiteral("obj"));
    QCOMPARE(meshSuffixOf("ply\r\nformat ascii 1.0\r\n"), QStringLiteral("ply"));
    QCOMPARE(meshSuffixOf("COFF\n3 1 0\n"), QStringLiteral("off"));
    QCOMPARE(meshSuffixOf("solid a\nfacet normal 0 0 1\n"), QStringLiteral("stl"));
    QCOMPARE(meshSuffixOf("v for vertex\nf for face\n"), QString());
    QCOMPARE(meshSuffixOf(draggedHits()->text().toUtf8()), QString());
    QCOMPARE(meshSuffixOf({}), QString());
    QVERIFY(!isSessionText("{\"format\": \"hitscope hits\"}"));
}

void ExchangeTest::picturesBringTheirCamera() {
    const Camera before = m_window->viewport().camera();
    QMimeData picture;
    picture.setUrls({QUrl::fromLocalFile(m_folder->filePath(QStringLiteral("a.png")))});
    QVERIFY(ExchangeActions::canTake(picture));
    const Result<Image> drawn = m_window->viewport().drawPicture(m_window->viewport().pictureRequest());
    QVERIFY(drawn.ok() && savePicture(drawn.value(), picture.urls().first().toLocalFile()).ok());
    Camera other = before;
    other.orbit(0.7f, 0.2f);
    m_window->viewport().navigation().setCamera(other);
    QVERIFY(cameraText(m_window->viewport().navigation().goal()) != cameraText(before));
    m_window->findChild<ExchangeActions*>()->take(picture);
    QTRY_COMPARE_WITH_TIMEOUT(cameraText(m_window->viewport().navigation().goal()), cameraText(before),
                              kPatience);
}

void ExchangeTest::picturesReplaceMissingTextures_data() {
    QTest::addColumn<bool>("isPasted");
    QTest::newRow("dropped") << false;
    QTest::newRow("pasted") << true;
}

void ExchangeTest::picturesReplaceMissingTextures() {
    QFETCH(bool, isPasted);
    QImage picture(8, 4, QImage::Format_RGBA8888);
    picture.fill(Qt::red);
    const QString wood = m_folder->filePath(QStringLiteral("pictures/wood.png"));
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("pictures")) && picture.save(wood));
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(wood)});
    auto* exchange = m_window->findChild<ExchangeActions*>();
    QSignalSpy failed(exchange, &ExchangeActions::failed);
    const auto give = [&] {
        if (isPasted) {
            QGuiApplication::clipboard()->setImage(picture);
            exchange->paste();
        } else {
            exchange->take(data);
        }
    };
    give();
    QCOMPARE(failed.size(), 1);  // nothing is missing
    const auto write = [this](const char* name, const QByteArray& text) {
        QFile file(m_folder->filePath(QLatin1String(name)));
        return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
    };
    QVERIFY(write("p.mtl", "newmtl stone\nmap_Kd stone.png\nnewmtl wood\nmap_Kd maps/wood.png\n"));
    QVERIFY(write("p.obj",
                  "mtllib p.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl "
                  "stone\nf 1/1 2/2 3/3\nusemtl wood\nf 2/1 4/2 3/3\n"));
    m_session->undo();  // nothing to ask about
    m_window->openFiles({m_folder->filePath(QStringLiteral("p.obj"))});
    const auto imageOf = [this](std::size_t material) {
        const MeshData& mesh = m_session->targets().front()->deformed.original();
        return mesh.materials.size() == 2 ? mesh.materials[material].diffuseImage : -2;
    };
    QTRY_COMPARE_WITH_TIMEOUT(imageOf(0), -1, kPatience);
    give();
    QVERIFY2(failed.size() == 1, failed.last().first().value<Error>().message().c_str());
    QVERIFY(imageOf(isPasted ? 0 : 1) >= 0);  // the one of its name, or the first
    QCOMPARE(imageOf(isPasted ? 1 : 0), -1);
}

/// A session from a button of the tool bar, and vertex changes from their table's.
void ExchangeTest::buttonsAreDraggedOut() {
    for (QToolButton* button : m_window->findChildren<QToolButton*>()) {
        const QAction* action = button->defaultAction();
        const QString text = action != nullptr ? action->text().remove(u'&') : QString();
        if (text != QStringLiteral("Save Session") && text != QStringLiteral("Save as CSV…")) {
            continue;
        }
        auto* out = button->findChild<DragOut*>(QString(), Qt::FindDirectChildrenOnly);
        QVERIFY2(out != nullptr || text != QStringLiteral("Save Session"), qPrintable(text));
        if (out == nullptr) {
            continue;  // another table's
        }
        const std::unique_ptr<QMimeData> data(out->make());
        const QString path = data->urls().value(0).toLocalFile();
        QVERIFY2(QFileInfo(path).size() > 0, qPrintable(path));
        QVERIFY(path.endsWith(QStringLiteral(".hitscope")) || path.endsWith(QStringLiteral("changes.csv")));
        m_dragged << text;
    }
    QVERIFY(m_dragged.contains(QStringLiteral("Save Session")));
}

void ExchangeTest::whatIsDraggedOutDoesNotComeBack() {
    QMimeData text;
    text.setText(QStringLiteral("no file"));
    QVERIFY(!ExchangeActions::canTake(text));
    QMimeData film;
    film.setUrls({QUrl::fromLocalFile(QStringLiteral("/a.mp4"))});
    QVERIFY(!ExchangeActions::canTake(film));
}

HITSCOPE_TEST(ExchangeTest, QApplication)

}  // namespace hitscope::exchange_test

#include "exchange_test.moc"
