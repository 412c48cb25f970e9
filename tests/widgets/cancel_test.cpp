// SPDX-License-Identifier: GPL-3.0-or-later
// The Cancel button of the status bar: what it ends leaves everything as it was.
#include <signal.h>

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QScopeGuard>
#include <QSemaphore>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QThreadPool>
#include <QToolButton>
#include <cerrno>

#include "analysis/background_pool.h"
#include "app/mesh_exporter.h"
#include "app/scene_files.h"
#include "app/session_collector.h"
#include "app/session_files.h"
#include "document/session_file.h"
#include "session/export/export_target.h"
#include "session/sample_scenes.h"
#include "session/task_list.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::cancel_test {

namespace {

/// Keeps background work from beginning.
class HeldPool {
public:
    HeldPool() {
        for (int i = 0; i < backgroundPool().maxThreadCount(); ++i) {
            startInBackground([end = m_end] { end->acquire(); });
        }
    }
    ~HeldPool() { release(); }
    HeldPool(const HeldPool&) = delete;
    HeldPool& operator=(const HeldPool&) = delete;
    void release() { m_end->release(backgroundPool().maxThreadCount()); }

private:
    std::shared_ptr<QSemaphore> m_end = std::make_shared<QSemaphore>();
};

}  // namespace

class CancelTest : public QObject, private WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        makeWindow([](Session& session) { loadMesh(session, makeHighPolyCube(2.5f)); });
        m_folder = std::make_unique<QTemporaryDir>();
        QTRY_COMPARE_WITH_TIMEOUT(m_session->tasks().size(), std::size_t{0}, kPatience);
    }
    void cleanup() { dropWindow(); }

    void anExportLeavesTheFileOfBefore_data();
    void anExportLeavesTheFileOfBefore();
    void anImportLeavesTheScene();
    void aSaveLeavesTheFileOfBefore();
    void whatIsChangedDuringASaveIsNotSaved();
    void anotherSceneIsNotInTheFileThatIsBeingSaved();
    void anotherSaveIsNotLost();
    void closingDuringASaveSavesTheRest();
    void aCollectionSaysHowItEnded_data();
    void aCollectionSaysHowItEnded();

private:
    [[nodiscard]] QString path(const QString& name) const { return m_folder->filePath(name); }
    [[nodiscard]] QString write(const QString& name, const QByteArray& content) const {
        QFile file(path(name));
        return file.open(QIODevice::WriteOnly) && file.write(content) == content.size() ? file.fileName()
                                                                                        : QString();
    }
    [[nodiscard]] static QByteArray contentOf(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    /// Hidden ones, too.
    [[nodiscard]] QStringList allFiles() const {
        return QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden | QDir::System);
    }
    [[nodiscard]] SessionFiles& sessions() const { return *m_window->findChild<SessionFiles*>(); }
    [[nodiscard]] QString said() const { return m_window->statusBar()->currentMessage(); }
    void hit() {
        Hit hit;
        hit.target = m_session->targets().front()->id;
        hit.point = {0.0f, 2.5f, 0.0f};
        hit.direction = {0.0f, -1.0f, 0.0f};
        QVERIFY(m_session->hits().add(hit).ok());
    }
    /// With one hit, and another that is not saved yet.
    void saveThenHit(const QString& file) {
        QSignalSpy saved(&sessions(), &SessionFiles::saved);
        hit();
        sessions().save(file);
        QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, kPatience);
        hit();
    }
    [[nodiscard]] static std::size_t hitsIn(const QString& file) {
        const Result<SessionDocument> read = readSessionFile(file);
        return read ? read.value().hits.size() : 0;
    }
    /// As soon as the status bar shows it.
    void clickCancel() {
        auto* button = m_window->findChild<QToolButton*>(QStringLiteral("cancelTask"));
        QTRY_VERIFY_WITH_TIMEOUT(button->isVisible(), kPatience);
        QTest::mouseClick(button, Qt::LeftButton);
    }
    void waitForNoTask() {
        QTRY_COMPARE_WITH_TIMEOUT(m_session->tasks().size(), std::size_t{0}, kPatience);
        auto* button = m_window->findChild<QToolButton*>(QStringLiteral("cancelTask"));
        QTRY_VERIFY_WITH_TIMEOUT(!button->isVisible(), kPatience);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void CancelTest::anExportLeavesTheFileOfBefore_data() {
    QTest::addColumn<int>("format");
    for (const ExportFormatTraits& traits : exportFormats()) {
        QTest::newRow(traits.key) << static_cast<int>(traits.format);
    }
}

void CancelTest::anExportLeavesTheFileOfBefore() {
    QFETCH(int, format);
    const Target* const target = m_session->targets().front().get();
    SceneExport what = copyForExport(*m_session, {&target, 1}, {.format = static_cast<ExportFormat>(format)});
    const QByteArray before = "what was there\n";
    const QString name = QStringLiteral("old.") + QLatin1String(traitsOf(what.options.format).suffix);
    const QString file = write(name, before);
    QSemaphore isUnderWay;
    QSemaphore goesOn;
    const auto release = qScopeGuard([&goesOn] { goesOn.release(100); });
    what.beforeStep = [&, step = 0]() mutable {
        if (++step == 2) {  // a file is there, under its hidden name
            isUnderWay.release();
            goesOn.acquire();
        }
    };
    auto* const exporter = m_window->findChild<MeshExporter*>();
    exporter->start(std::move(what), QStringLiteral("cube"), file);
    QTRY_VERIFY_WITH_TIMEOUT(isUnderWay.available() > 0, kPatience);
    QCOMPARE(allFiles().size(), 2);
    clickCancel();
    goesOn.release();
    waitForNoTask();
    QVERIFY(!exporter->isRunning());
    QTRY_COMPARE_WITH_TIMEOUT(said(), QStringLiteral("Cancelled. The file is unchanged."), kPatience);
    QCOMPARE(contentOf(file), before);
    QCOMPARE(allFiles(), QStringList(name));
}

void CancelTest::anImportLeavesTheScene() {
    // In the worker's place, for as long as it is let.
    const QString worker =
        write(QStringLiteral("worker"), "#!/bin/sh\necho $$ > \"$0.pid\"\nexec sleep 1000\n");
    QVERIFY(QFile::setPermissions(worker, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
    const QByteArray usual = qgetenv("HITSCOPE_IMPORT_WORKER");
    const auto restore = qScopeGuard([&usual] { qputenv("HITSCOPE_IMPORT_WORKER", usual); });
    qputenv("HITSCOPE_IMPORT_WORKER", QFile::encodeName(worker));
    writeObj(makeLowPolyCube(1.0f), path(QStringLiteral("new.obj")));
    hit();
    const TargetId target = m_session->targets().front()->id;
    m_window->findChild<SceneFiles*>()->open({path(QStringLiteral("new.obj"))});
    QCOMPARE(m_session->tasks().current()->what, QStringLiteral("Opening new.obj"));
    const QString pidFile = worker + QStringLiteral(".pid");
    QTRY_VERIFY_WITH_TIMEOUT(contentOf(pidFile).endsWith('\n'), kPatience);
    const auto pid = static_cast<pid_t>(contentOf(pidFile).trimmed().toLongLong());
    QVERIFY(pid > 1);
    clickCancel();
    waitForNoTask();
    QCOMPARE(said(), QStringLiteral("Cancelled. The scene is unchanged."));
    QCOMPARE(m_session->targets().size(), std::size_t{1});
    QCOMPARE(m_session->targets().front()->id, target);
    QCOMPARE(m_session->hits().history().size(), std::size_t{1});
    QTRY_VERIFY_WITH_TIMEOUT(::kill(pid, 0) != 0 && errno == ESRCH, kPatience);
}

void CancelTest::aSaveLeavesTheFileOfBefore() {
    const QByteArray before = "what was there\n";
    const QString file = write(QStringLiteral("old.hitscope"), before);
    hit();
    QSignalSpy saved(&sessions(), &SessionFiles::saved);
    QSignalSpy ended(&sessions(), &SessionFiles::saveEnded);
    HeldPool held;
    sessions().save(file);
    clickCancel();
    QVERIFY(sessions().isBusy());
    held.release();
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatience);
    waitForNoTask();
    QCOMPARE(said(), QStringLiteral("Cancelled. The file is unchanged."));
    QCOMPARE(saved.size(), 0);
    QCOMPARE(contentOf(file), before);
    QCOMPARE(allFiles(), QStringList(QStringLiteral("old.hitscope")));
    QVERIFY(m_window->isWindowModified());
    QVERIFY(sessions().path().isEmpty());
    sessions().save(file);
    QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, kPatience);
    QVERIFY(contentOf(file).contains("hitscope session"));
    QVERIFY(!m_window->isWindowModified());
}

void CancelTest::whatIsChangedDuringASaveIsNotSaved() {
    hit();
    QSignalSpy saved(&sessions(), &SessionFiles::saved);
    HeldPool held;
    sessions().save(path(QStringLiteral("a.hitscope")));
    hit();
    held.release();
    QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, kPatience);
    QVERIFY(sessions().isModified());
    QVERIFY(m_window->isWindowModified());
    m_session->undo();
    QVERIFY(!sessions().isModified());  // as it was when it was saved
}

void CancelTest::anotherSceneIsNotInTheFileThatIsBeingSaved() {
    hit();
    QSignalSpy saved(&sessions(), &SessionFiles::saved);
    QSignalSpy ended(&sessions(), &SessionFiles::saveEnded);
    const QString file = path(QStringLiteral("a.hitscope"));
    HeldPool held;
    sessions().save(file);
    loadMesh(*m_session, makeLowPolySphere(1.0f));
    sessions().leave();
    QVERIFY(!sessions().isBusy());
    held.release();
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatience);
    QCOMPARE(saved.size(), 0);
    QVERIFY(contentOf(file).contains("hitscope session"));  // it was asked for
    QVERIFY(sessions().path().isEmpty());
    QVERIFY(!sessions().isModified());
    hit();
    QVERIFY(sessions().isModified());
}

/// Nor is what the first has written already taken for another program's.
void CancelTest::anotherSaveIsNotLost() {
    const QString file = path(QStringLiteral("a.hitscope"));
    saveThenHit(file);
    QSignalSpy saved(&sessions(), &SessionFiles::saved);
    QSignalSpy notSaved(&sessions(), &SessionFiles::notSaved);
    sessions().save(file);
    backgroundPool().waitForDone();
    QCOMPARE(hitsIn(file), std::size_t{2});
    QVERIFY(!sessions().isChangedByOthers());
    hit();
    QTest::keyClick(&m_window->viewport(), Qt::Key_S, Qt::ControlModifier);
    QTest::keyClick(&m_window->viewport(), Qt::Key_S, Qt::ControlModifier);
    QCOMPARE(notSaved.size(), 0);
    QTRY_VERIFY_WITH_TIMEOUT(!sessions().isBusy(), kPatience);
    QCOMPARE(saved.size(), 1);  // when all of it is
    QCOMPARE(hitsIn(file), std::size_t{3});
    QVERIFY(!sessions().isModified());
    QVERIFY(!sessions().isChangedByOthers());
}

void CancelTest::closingDuringASaveSavesTheRest() {
    const QString file = path(QStringLiteral("a.hitscope"));
    saveThenHit(file);
    QSignalSpy notSaved(&sessions(), &SessionFiles::notSaved);
    HeldPool held;
    sessions().save(file);
    hit();
    m_window->close();
    answerQuestion(*m_window, QMessageBox::AcceptRole);
    QCoreApplication::processEvents();  // the save begins when the box has ended
    QCOMPARE(notSaved.size(), 0);
    QVERIFY(m_window->isVisible());
    held.release();
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->isVisible(), kPatience);
    QCOMPARE(hitsIn(file), std::size_t{3});
}

void CancelTest::aCollectionSaysHowItEnded_data() {
    QTest::addColumn<bool>("isLate");
    QTest::newRow("cancelled in time") << false;
    QTest::newRow("cancelled when it was written") << true;
}

void CancelTest::aCollectionSaysHowItEnded() {
    QFETCH(bool, isLate);
    loadTeapot(*m_session);
    waitForNoTask();
    auto* const collector = m_window->findChild<SessionCollector*>();
    const QSignalSpy collected(collector, &SessionCollector::collected);
    const QSignalSpy cancelled(collector, &SessionCollector::cancelled);
    const QString folder = path(QStringLiteral("shared"));
    HeldPool held;
    collector->collect(folder);
    if (isLate) {
        held.release();
        backgroundPool().waitForDone();
        QVERIFY(QFile::exists(folder));
    }
    m_session->tasks().cancel(m_session->tasks().current()->id);
    QVERIFY(cancelled.isEmpty());  // it is not known yet
    held.release();
    waitForNoTask();
    QCOMPARE(QFile::exists(folder), isLate);
    QCOMPARE(collected.size(), isLate ? 1 : 0);
    QCOMPARE(cancelled.size(), isLate ? 0 : 1);
    QVERIFY2(said().startsWith(isLate ? QStringLiteral("Collected in ")
                                      : QStringLiteral("Cancelled. Nothing was written.")),
             qPrintable(said()));
}

HITSCOPE_TEST(CancelTest, QApplication)

}  // namespace hitscope::cancel_test

#include "cancel_test.moc"
