// SPDX-License-Identifier: GPL-3.0-or-later
// What is done while a session is opened, saved or recovered: nothing is lost, and no file gets another's
// scene.
#include <QAction>
#include <QDir>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/notice_bar.h"
#include "app/recovery_bar.h"
#include "app/scene_files.h"
#include "app/session_files.h"
#include "app/window/journal_keeping.h"
#include "document/journal_files.h"
#include "document/session_journal.h"
#include "session/sample_scenes.h"
#include "session/shots/demo_shots.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::opening_overtaken_test {

class OpeningOvertakenTest : public QObject, private WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private:
    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    [[nodiscard]] SessionFiles& files() const { return *m_window->findChild<SessionFiles*>(); }
    [[nodiscard]] std::size_t hits() const { return m_session->hits().history().size(); }
    [[nodiscard]] bool isOffered() const { return m_window->findChild<RecoveryBar*>()->isVisible(); }
    [[nodiscard]] static QStringList journals() {
        return QDir(journalFolder()).entryList({QStringLiteral("*.journal*")}, QDir::Files);
    }
    void shoot(int count, std::uint32_t seed) {
        for (const Ray& ray : demoShots(*m_session, count, seed)) {
            m_session->simulation().hitscan(ray);
        }
    }
    void waitForFiles() { QTRY_VERIFY_WITH_TIMEOUT(!files().isBusy(), kPatience); }
    void save(const QString& file) {
        files().save(file);
        waitForFiles();
        QVERIFY(QFile::exists(file));
    }
    void openMesh() {
        writeObj(makeHighPolyCube(2.5f), path("cube.obj"));
        m_window->openFiles({path("cube.obj")});
        QTRY_COMPARE_WITH_TIMEOUT(m_session->targets().size(), std::size_t{1}, kPatience);
    }
    /// What it collects for a moment is on the disk.
    void waitForJournal() {
        auto* journal = m_window->findChild<SessionJournal*>();
        journal->flush();
        QVERIFY(journal->isBegun());
        QVERIFY(journal->writer().wait(kPatience));
    }
    /// The window goes without closing, and another one offers what it has left.
    void crash() {
        waitForJournal();
        makeWindow([](Session& session) { loadTeapot(session); });
        m_window->offerRecovery();
        QTRY_VERIFY_WITH_TIMEOUT(isOffered(), kPatience);
    }
    void clickRecover() { m_window->findChild<QPushButton*>(QStringLiteral("recover"))->click(); }

    QTemporaryDir m_folder;

private Q_SLOTS:
    void init() {
        makeWindow([](Session& session) { loadPaperRow(session, kDefaultPaperRow); });
    }
    void cleanup() { dropWindow(); }

    void aRecoveryThatIsOvertakenIsOfferedAgain() {
        save(path("other.hitscope"));
        shoot(5, 1);
        const std::size_t before = hits();
        crash();
        const QStringList left = journals();
        QCOMPARE(left.size(), 1);
        clickRecover();
        QVERIFY(files().isBusy());
        m_window->openFiles({path("other.hitscope")});
        QTRY_COMPARE_WITH_TIMEOUT(files().path(), path("other.hitscope"), kPatience);
        QCOMPARE(journals(), left);
        QVERIFY(isOffered());
        clickRecover();
        QTRY_COMPARE_WITH_TIMEOUT(hits(), before, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(!journals().contains(left[0]), kPatience);
        QVERIFY(!isOffered());
    }

    void theJournalStaysUntilAnotherIsThere() {
        shoot(5, 1);
        const std::size_t before = hits();
        crash();
        const QStringList left = journals();
        // Nothing can be written beside it: a folder has the place of the journal's next name.
        auto* journal = m_window->findChild<SessionJournal*>();
        const QFileDevice::Permissions usual = QFile::permissions(journalFolder());
        QVERIFY(QFile::setPermissions(journalFolder(), QFile::ReadOwner | QFile::ExeOwner));
        QFile probe(QDir(journalFolder()).filePath(QStringLiteral("probe")));
        if (probe.open(QIODevice::WriteOnly)) {
            QVERIFY(probe.remove());
            QVERIFY(QFile::setPermissions(journalFolder(), usual));
            QSKIP("This user may write into any folder.");
        }
        clickRecover();
        QTRY_COMPARE_WITH_TIMEOUT(hits(), before, kPatience);
        waitForFiles();
        QTest::qWait(1'200);
        QCOMPARE(journals(), left);
        QVERIFY(QFile::setPermissions(journalFolder(), usual));
        journal->keep();
        QTRY_VERIFY_WITH_TIMEOUT(!journals().contains(left[0]), kPatience);
        QCOMPARE(journals().size(), 1);
    }

    void aDamagedJournalIsSetAside() {
        shoot(3, 1);
        waitForJournal();
        shoot(3, 2);
        waitForJournal();
        shoot(3, 3);
        waitForJournal();
        m_window.reset();
        QCOMPARE(journals().size(), 1);
        QFile file(QDir(journalFolder()).filePath(journals()[0]));
        QVERIFY(file.open(QIODevice::ReadWrite));
        const QByteArray bytes = file.readAll();
        const qsizetype edit = bytes.indexOf("{\"hits\":", bytes.indexOf('\n', bytes.indexOf('\n') + 1));
        QVERIFY(edit > 0 && bytes.indexOf('\n', edit) < bytes.size() - 1);
        QVERIFY(file.seek(edit + 3) && file.write("?") == 1);
        file.close();
        makeWindow([](Session& session) { loadTeapot(session); });
        m_window->offerRecovery();
        QTRY_VERIFY_WITH_TIMEOUT(isOffered(), kPatience);
        clickRecover();
        QTRY_VERIFY_WITH_TIMEOUT(!isOffered() && !files().isBusy() && hits() > 0, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(
            !QDir(journalFolder()).entryList({QStringLiteral("*.damaged")}, QDir::Files).isEmpty(),
            kPatience);
    }

    /// It is the only copy of what is on them.
    void theJournalOfMissingMeshesIsOfferedAgain() {
        openMesh();
        shoot(5, 1);
        const std::size_t before = hits();
        QVERIFY(before > 0);
        crash();
        const QStringList left = journals();
        QCOMPARE(left.size(), 1);
        QVERIFY(QFile::rename(path("cube.obj"), path("away.obj")));
        const QSignalSpy kept(m_window->findChild<JournalKeeping*>(), &JournalKeeping::recoveredKept);
        clickRecover();
        const auto question = [this] {
            return m_window->findChild<QMessageBox*>(QStringLiteral("meshTroubles"));
        };
        QTRY_VERIFY_WITH_TIMEOUT(question() != nullptr && question()->isVisible(), kPatience);
        for (QAbstractButton* button : question()->buttons()) {
            if (question()->buttonRole(button) == QMessageBox::AcceptRole) {
                button->click();
                break;
            }
        }
        QTRY_COMPARE_WITH_TIMEOUT(kept.size(), 1, kPatience);
        QCOMPARE(hits(), std::size_t{0});
        QVERIFY(journals().contains(left[0]));
        QVERIFY(!isOffered());
        const QString told = m_window->findChild<NoticeBar*>()->text();
        QVERIFY2(told.contains(QStringLiteral("cube.obj")) && told.contains(QStringLiteral("next start")),
                 qPrintable(told));
        m_window->offerRecovery();  // not in this window again
        QTest::qWait(100);
        QVERIFY(!isOffered());

        QVERIFY(QFile::rename(path("away.obj"), path("cube.obj")));
        m_window.reset();
        for (const QString& other : journals()) {
            QVERIFY(left.contains(other) || QFile::remove(QDir(journalFolder()).filePath(other)));
        }
        makeWindow([](Session& session) { loadTeapot(session); });
        m_window->offerRecovery();
        QTRY_VERIFY_WITH_TIMEOUT(isOffered(), kPatience);
        clickRecover();
        QTRY_COMPARE_WITH_TIMEOUT(hits(), before, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(!journals().contains(left[0]), kPatience);
    }

    void aJumpAcrossScenesFindsTheFile() {
        shoot(2, 1);
        save(path("a.hitscope"));
        openMesh();
        save(path("b.hitscope"));
        const std::size_t scene = m_session->steps().done();
        shoot(3, 2);
        m_session->goToStep(scene - 1);
        QCOMPARE(files().path(), path("a.hitscope"));
        QVERIFY(!files().isModified());
        m_session->redo();
        QCOMPARE(files().path(), path("b.hitscope"));
        QVERIFY(!files().isModified());
        m_session->redo();
        QVERIFY(files().isModified());
    }

    void aSaveThatEndsAfterAnUndoIsOfItsScene() {
        save(path("a.hitscope"));
        openMesh();
        files().save(path("b.hitscope"));
        m_session->undo();
        waitForFiles();
        QCOMPARE(files().path(), path("a.hitscope"));
        m_session->redo();
        QCOMPARE(files().path(), path("b.hitscope"));
        QVERIFY(!files().isModified());
    }

    void shotsMeanwhileAreAskedAbout_data() {
        QTest::addColumn<bool>("isDiscarded");
        QTest::newRow("kept") << false;
        QTest::newRow("discarded") << true;
    }

    void shotsMeanwhileAreAskedAbout() {
        QFETCH(bool, isDiscarded);
        save(path("empty.hitscope"));
        shoot(2, 1);
        save(path("mine.hitscope"));
        const std::size_t before = hits();
        QSignalSpy cancelled(&files(), &SessionFiles::cancelled);
        m_window->openFiles({path("empty.hitscope")});
        shoot(3, 2);
        const std::size_t now = hits();
        QVERIFY(now > before);
        QTRY_VERIFY_WITH_TIMEOUT(discardQuestion(*m_window) != nullptr, kPatience);
        QCOMPARE(hits(), now);
        answerQuestion(*m_window, isDiscarded ? QMessageBox::DestructiveRole : QMessageBox::RejectRole);
        QTRY_COMPARE_WITH_TIMEOUT(hits(), isDiscarded ? std::size_t{0} : now, kPatience);
        QCOMPARE(cancelled.size(), isDiscarded ? 0 : 1);
        QCOMPARE(files().path(), path(isDiscarded ? "empty.hitscope" : "mine.hitscope"));
        QCOMPARE(files().isModified(), !isDiscarded);
        QVERIFY(!files().isBusy());
    }

    void shotsAreAskedAboutBeforeMeshesToo_data() {
        QTest::addColumn<bool>("isSample");
        QTest::addColumn<QMessageBox::ButtonRole>("answer");
        for (const bool isSample : {false, true}) {
            const QByteArray what = isSample ? "sample scene" : "mesh";
            QTest::newRow((what + ", kept").constData()) << isSample << QMessageBox::RejectRole;
            QTest::newRow((what + ", saved").constData()) << isSample << QMessageBox::AcceptRole;
            QTest::newRow((what + ", discarded").constData()) << isSample << QMessageBox::DestructiveRole;
        }
    }

    void shotsAreAskedAboutBeforeMeshesToo() {
        QFETCH(bool, isSample);
        QFETCH(QMessageBox::ButtonRole, answer);
        shoot(2, 1);
        save(path("mine.hitscope"));
        auto* meshes = m_window->findChild<SceneFiles*>();
        const QSignalSpy ended(meshes, &SceneFiles::ended);
        const QSignalSpy cancelled(meshes, &SceneFiles::cancelled);
        if (isSample) {
            for (QAction* action : m_window->findChildren<QAction*>()) {
                if (action->text().remove(u'&') == sampleSceneName(SampleScene::Wall)) {
                    action->trigger();
                }
            }
        } else {
            writeObj(makeHighPolyCube(2.5f), path("cube.obj"));
            m_window->openFiles({path("cube.obj")});
        }
        QVERIFY(meshes->isOpening());
        shoot(3, 2);
        const std::size_t now = hits();
        const QString scene = m_session->sceneName();
        QTRY_VERIFY_WITH_TIMEOUT(discardQuestion(*m_window) != nullptr, kPatience);
        QCOMPARE(hits(), now);
        answerQuestion(*m_window, answer);
        QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatience);
        const bool isReplaced = answer != QMessageBox::RejectRole;
        QCOMPARE(cancelled.size(), isReplaced ? 0 : 1);
        QCOMPARE(hits(), isReplaced ? std::size_t{0} : now);
        QCOMPARE(m_session->sceneName() != scene, isReplaced);
        QVERIFY(!meshes->isOpening());
        QCOMPARE(files().path(), isReplaced ? QString() : path("mine.hitscope"));
        m_session->undo();  // of the new scene, or of the last shot
        QCOMPARE(files().path(), path("mine.hitscope"));
        QCOMPARE(files().isModified(), answer != QMessageBox::AcceptRole);
    }

    /// However long it takes from the file's new name until the window hears of it.
    void aSlowSaveIsNoChangeByOthers() {
        shoot(2, 1);
        save(path("a.hitscope"));
        QTRY_VERIFY_WITH_TIMEOUT(!knownContentOf(*m_window, path("a.hitscope")).empty(), kPatience);
        shoot(2, 2);
        QObject context;
        connect(&files(), &SessionFiles::changed, &context, [&context, this] {
            disconnect(&files(), nullptr, &context, nullptr);
            QTest::qWait(4 * FileWatch::kSettles);
        });
        save(path("a.hitscope"));
        QTest::qWait(2 * FileWatch::kSettles);
        const QString told = m_window->findChild<NoticeBar*>()->text();
        QVERIFY2(!told.contains(QStringLiteral("a.hitscope")), qPrintable(told));
        QFile other(path("a.hitscope"));
        QVERIFY(other.open(QIODevice::Append) && other.write("\n") == 1);
        other.close();
        QTRY_VERIFY_WITH_TIMEOUT(
            m_window->findChild<NoticeBar*>()->text().contains(QStringLiteral("a.hitscope")), kPatience);
    }

    void aNewSessionGivesUpWhatIsOpened() {
        save(path("a.hitscope"));
        m_window->openFiles({path("a.hitscope")});
        QVERIFY(files().isBusy());
        QTest::keyClick(&m_window->viewport(), Qt::Key_N, Qt::ControlModifier);
        QVERIFY(!files().isBusy());
        QTest::qWait(200);
        QCOMPARE(m_session->targets().size(), std::size_t{1});
        QCOMPARE(files().path(), QString());
    }
};

HITSCOPE_TEST(OpeningOvertakenTest, QApplication)

}  // namespace hitscope::opening_overtaken_test

#include "opening_overtaken_test.moc"
