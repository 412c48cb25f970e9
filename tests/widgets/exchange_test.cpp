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
#include <QStatusBar>
#include <QTableView>
#include <QTest>
#include <QUrl>

#include "app/actions/exchange_actions.h"
#include "document/session_file.h"
#include "io/import.h"
#include "mesh/same_bits.h"
#include "panels/hit_history/hit_table.h"
#include "panels/scene/scene_panel.h"
#include "support/test_program.h"
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
    void whatIsDraggedOutDoesNotComeBack();

private:
    void addHit();
    [[nodiscard]] QString writtenHits();
    /// As the panel drags them.
    [[nodiscard]] std::unique_ptr<QMimeData> draggedHits() const;

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
    QVERIFY2(box()->text().contains(QStringLiteral("no camera, and no hits")), qPrintable(box()->text()));
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
    const Result<ImportedMesh> read = importMesh(path);
    QVERIFY(read.ok());
    const std::span<const glm::vec3> shown = m_session->targets().front()->deformed.positions();
    QVERIFY(std::equal(shown.begin(), shown.end(), read.value().mesh.positions.begin(),
                       read.value().mesh.positions.end(),
                       [](const glm::vec3& a, const glm::vec3& b) { return sameBits(a, b); }));
    QVERIFY(m_session->targets().front()->deformed.statistics().changedVertices > 0);
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
    QMenu* menu = nullptr;
    for (QMenu* candidate : m_window->findChildren<QMenu*>()) {
        if (candidate->title() == QStringLiteral("Copy as &File")) {
            menu = candidate;
        }
    }
    QVERIFY(menu != nullptr);
    for (QAction* action : menu->actions()) {
        if (action->text() == entry) {
            action->trigger();
        }
    }
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

void ExchangeTest::whatIsDraggedOutDoesNotComeBack() {
    QMimeData text;
    text.setText(QStringLiteral("no file"));
    QVERIFY(!ExchangeActions::canTake(text));
    QMimeData picture;
    picture.setUrls({QUrl::fromLocalFile(QStringLiteral("/a.png"))});
    QVERIFY(!ExchangeActions::canTake(picture));
}

HITSCOPE_TEST(ExchangeTest, QApplication)

}  // namespace hitscope::exchange_test

#include "exchange_test.moc"
