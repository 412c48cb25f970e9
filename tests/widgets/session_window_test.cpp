// SPDX-License-Identifier: GPL-3.0-or-later
// A session as a document in the window: saved, opened, reverted, and recovered after a crash.
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cstdlib>

#include "app/discard_guard.h"
#include "app/journal_picture.h"
#include "app/recovery_bar.h"
#include "app/session_files.h"
#include "deform/fingerprint.h"
#include "document/journal_files.h"
#include "document/session_journal.h"
#include "session/shots/demo_shots.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::session_window_test {

namespace {

constexpr QSize kSmall(32, 20);

/// Of two pictures of the same, however large: levels of a channel, on average.
double difference(const QImage& one, const QImage& other) {
    const auto small = [](const QImage& image) {
        return image.convertToFormat(QImage::Format_RGB888)
            .scaled(kSmall, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    };
    const QImage a = small(one);
    const QImage b = small(other);
    double sum = 0.0;
    for (int y = 0; y < kSmall.height(); ++y) {
        for (int x = 0; x < 3 * kSmall.width(); ++x) {
            sum += std::abs(a.constScanLine(y)[x] - b.constScanLine(y)[x]);
        }
    }
    return sum / (3.0 * kSmall.width() * kSmall.height());
}

}  // namespace

class SessionWindowTest : public QObject, private WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        makeWindow([](Session& session) { loadPaperRow(session, kDefaultPaperRow); });
    }
    void cleanup() { dropWindow(); }

    void comesBackAsItWasSaved();
    void revertGoesBack();
    void undoneOpeningBringsTheFileBack();
    void aBrokenFileChangesNothing();
    void aFileThatIsGoneIsNamed();
    void isRecoveredAfterACrash();
    void targetsWithoutHitsAreRecovered();
    void recoveredIsInItsFile_data();
    void recoveredIsInItsFile();
    void nothingIsLeftAfterAnOrderlyEnd();
    void norOnceItIsAsItWasSaved();

private:
    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    [[nodiscard]] SessionFiles& files() const { return *m_window->findChild<SessionFiles*>(); }
    void shoot(int count, std::uint32_t seed) {
        for (const Ray& ray : demoShots(*m_session, count, seed)) {
            m_session->simulation().hitscan(ray);
        }
    }
    void save(const QString& file) {
        files().save(file);
        QTRY_VERIFY_WITH_TIMEOUT(!files().isBusy(), kPatience);
        QVERIFY(QFile::exists(file));
    }
    /// What it collects for a moment is on the disk.
    void waitForJournal() {
        auto* journal = m_window->findChild<SessionJournal*>();
        journal->flush();
        QVERIFY(journal->isBegun());
        QVERIFY(journal->writer().wait(kPatience));
    }
    /// Hits and positions, as they are now.
    [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> fingerprints() {
        if (!m_window->viewport().syncNow().ok()) {
            return {};
        }
        std::vector<TargetId> ids;
        std::vector<const DeformedMesh*> meshes;
        for (const std::unique_ptr<Target>& target : m_session->targets()) {
            ids.push_back(target->id);
            meshes.push_back(&target->deformed);
        }
        return {hitsFingerprint(m_session->hits().history().hits(), ids), positionsFingerprint(meshes)};
    }
    [[nodiscard]] static std::vector<FoundJournal> leftBehind() { return findJournals(journalFolder()); }
    [[nodiscard]] bool isOffered() const { return m_window->findChild<RecoveryBar*>()->isVisible(); }

    QTemporaryDir m_folder;
};

void SessionWindowTest::comesBackAsItWasSaved() {
    shoot(30, 3);
    QVERIFY(m_session->hits().history().size() > 10);
    QVERIFY(m_session->targets().rename(m_session->targets()[2]->id, QStringLiteral("The third")).ok());
    m_session->targets().setVisible(std::array{m_session->targets()[5]->id}, false);
    m_session->hits().setEnabled(std::array<std::size_t, 1>{4}, false);
    DeformationConstants constants = m_session->settings().constants();
    constants.power = 0.07f;
    QVERIFY(m_session->settings().setConstants(constants).ok());
    Lights lights = m_session->settings().lights();
    lights.spot.terms.diffuse = 0.123f;
    m_session->settings().setLights(lights);
    m_session->settings().setFlightMode(FlightMode::Paper);
    DisplayOptions display = m_window->viewport().options();
    display.wireframe = WireframeMode::Over;
    display.cut.on = true;
    m_window->viewport().setOptions(display);
    QVERIFY(m_window->windowTitle().endsWith(QStringLiteral("[*]")) && m_window->isWindowModified());
    const auto before = fingerprints();
    const glm::vec3 eye = m_window->viewport().camera().eye();
    save(path("one.hitscope"));
    QVERIFY(!m_window->isWindowModified());
    QVERIFY(m_window->windowTitle().startsWith(QStringLiteral("one.hitscope")));

    makeWindow([](Session& session) { loadTeapot(session); });
    m_window->openFiles({path("one.hitscope")});
    QTRY_COMPARE_WITH_TIMEOUT(m_session->targets().size(), std::size_t{16}, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!files().isBusy(), kPatience);
    QVERIFY(fingerprints() == before);
    QVERIFY(!m_session->steps().canUndo());
    QCOMPARE(m_session->targets()[2]->name, QStringLiteral("The third"));
    QVERIFY(!m_session->targets()[5]->visible);
    QVERIFY(!m_session->hits().history().hits()[4].enabled);
    QCOMPARE(m_session->settings().constants().power, 0.07f);
    QCOMPARE(m_session->settings().lights().spot.terms.diffuse, 0.123f);
    QVERIFY(m_session->settings().flightMode() == FlightMode::Paper);
    QVERIFY(m_window->viewport().options().wireframe == WireframeMode::Over);
    QVERIFY(m_window->viewport().options().cut.on);
    QVERIFY(glm::distance(m_window->viewport().camera().eye(), eye) < 1.0e-3f);
    QVERIFY(!m_window->isWindowModified());
    QCOMPARE(files().path(), path("one.hitscope"));
    // Saved again it is the same file, to the last byte.
    save(path("two.hitscope"));
    QFile one(path("one.hitscope"));
    QFile two(path("two.hitscope"));
    QVERIFY(one.open(QIODevice::ReadOnly) && two.open(QIODevice::ReadOnly));
    QCOMPARE(two.readAll(), one.readAll());
}

void SessionWindowTest::revertGoesBack() {
    shoot(5, 4);
    const std::size_t hits = m_session->hits().history().size();
    save(path("one.hitscope"));
    m_session->hits().clear();
    for (QAction* action : m_window->findChildren<QAction*>()) {
        if (action->text().startsWith(QStringLiteral("Re&vert"))) {
            QVERIFY(action->isEnabled());
            action->trigger();
        }
    }
    auto* box = m_window->findChild<QMessageBox*>(QStringLiteral("revert"));
    QVERIFY(box != nullptr);
    for (QAbstractButton* button : box->buttons()) {
        if (box->buttonRole(button) == QMessageBox::DestructiveRole) {
            button->click();
        }
    }
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), hits, kPatience);
    QVERIFY(!m_window->isWindowModified());
}

/// Opening a mesh leaves the session's file; undone, the scene is that file's again, and saved if it was.
void SessionWindowTest::undoneOpeningBringsTheFileBack() {
    writeObj(makeHighPolyCube(2.5f), path("cube.obj"));
    const auto openCube = [this] {
        m_window->openFiles({path("cube.obj")});
        QTRY_COMPARE_WITH_TIMEOUT(m_session->targets().size(), std::size_t{1}, kPatience);
    };
    for (const bool isChanged : {false, true}) {
        shoot(5, 4);
        save(path("one.hitscope"));
        if (isChanged) {
            m_session->hits().clear();
        }
        openCube();
        QCOMPARE(files().path(), QString());
        QVERIFY(!files().isModified());
        shoot(2, 5);
        while (m_session->hits().history().size() > 0) {
            m_session->undo();
            QCOMPARE(files().path(), QString());
        }
        m_session->undo();
        QVERIFY(m_session->targets().size() > 1);
        QCOMPARE(files().path(), path("one.hitscope"));
        QCOMPARE(files().isModified(), isChanged);
        m_session->redo();
        QCOMPARE(m_session->targets().size(), std::size_t{1});
        QCOMPARE(files().path(), QString());
        QVERIFY(!files().isModified());
        m_session->undo();
        QCOMPARE(files().path(), path("one.hitscope"));
        save(path("two.hitscope"));
        m_session->redo();
        m_session->undo();
        QCOMPARE(files().path(), path("two.hitscope"));
        QVERIFY(!files().isModified());
    }
}

void SessionWindowTest::aBrokenFileChangesNothing() {
    shoot(5, 5);
    const std::size_t hits = m_session->hits().history().size();
    QFile broken(path("broken.hitscope"));
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("{\"format\": \"hitscope session\", \"version\": 1, \"hits\": [");
    broken.close();
    QSignalSpy failed(&files(), &SessionFiles::failed);
    files().open(path("broken.hitscope"));
    QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience);
    QCOMPARE(m_session->hits().history().size(), hits);
    QVERIFY(files().path().isEmpty() && !files().isBusy());
    QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeModalWidget() != nullptr, kPatience);
    QApplication::activeModalWidget()->close();
}

void SessionWindowTest::aFileThatIsGoneIsNamed() {
    QSignalSpy failed(&files(), &SessionFiles::failed);
    files().open(path("gone.hitscope"));
    QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience);
    const auto error = failed[0][0].value<Error>();
    QVERIFY(QString::fromStdString(error.message()).contains(QStringLiteral("gone.hitscope")));
    QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeModalWidget() != nullptr, kPatience);
    QApplication::activeModalWidget()->close();
}

void SessionWindowTest::isRecoveredAfterACrash() {
    shoot(12, 6);
    m_session->settings().setFlightMode(FlightMode::Instant);
    m_session->hits().remove(3);
    shoot(3, 7);
    m_session->undo();
    const auto before = fingerprints();
    const std::size_t hits = m_session->hits().history().size();
    QVERIFY(hits > 8);
    waitForJournal();
    QVERIFY(leftBehind().empty());  // this window has it
    m_window->findChild<JournalPicture*>()->take();
    QVERIFY(m_window->findChild<SessionJournal*>()->writer().wait(kPatience));
    const QImage shown = m_window->viewport().surface().grab();

    // Its window goes without closing: what is on the disk is what a crash leaves.
    makeWindow([](Session& session) { loadTeapot(session); });
    QCOMPARE(leftBehind().size(), std::size_t{1});
    m_window->offerRecovery();
    QTRY_VERIFY_WITH_TIMEOUT(isOffered(), kPatience);
    const auto* picture = m_window->findChild<QLabel*>(QStringLiteral("recoveryPicture"));
    QVERIFY(picture->isVisible());
    QVERIFY2(difference(picture->pixmap().toImage(), shown) < 6.0,
             qPrintable(QString::number(difference(picture->pixmap().toImage(), shown))));
    m_window->findChild<QPushButton*>(QStringLiteral("recover"))->click();
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), hits, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!files().isBusy(), kPatience);
    QVERIFY(fingerprints() == before);
    QVERIFY(m_session->settings().flightMode() == FlightMode::Instant);
    QVERIFY(!isOffered());
    // The journal goes once the next one is on the disk, which may be slow.
    QTRY_COMPARE_WITH_TIMEOUT(QDir(journalFolder()).entryList(QDir::Files).size(), 1, kPatience);
    QVERIFY(m_window->isWindowModified());  // it is in no file
    QVERIFY(m_window->findChild<DiscardGuard*>()->isAtRisk());
    QVERIFY(leftBehind().empty());
    // A second crash loses nothing either.
    makeWindow([](Session& session) { loadTeapot(session); });
    m_window->offerRecovery();
    QTRY_VERIFY_WITH_TIMEOUT(isOffered(), kPatience);
    m_window->findChild<QPushButton*>(QStringLiteral("discardRecovery"))->click();
    auto* box = m_window->findChild<QMessageBox*>(QStringLiteral("confirmDiscard"));
    QVERIFY(box != nullptr);
    for (QAbstractButton* button : box->buttons()) {
        if (box->buttonRole(button) == QMessageBox::DestructiveRole) {
            button->click();
        }
    }
    QVERIFY(!isOffered());
    QVERIFY(QDir(journalFolder()).entryList(QDir::Files).isEmpty());
}

/// After a second crash too, and it is not closed without a question.
void SessionWindowTest::targetsWithoutHitsAreRecovered() {
    const RigidTransform put{{1.0f, 2.0f, 3.0f}};
    QVERIFY(m_session->targets().setTransform(m_session->targets().front()->id, put).ok());
    waitForJournal();
    for (int crash = 0; crash < 2; ++crash) {
        makeWindow([](Session& session) { loadTeapot(session); });
        QVERIFY(!m_window->findChild<DiscardGuard*>()->isAtRisk());
        m_window->offerRecovery();
        QTRY_VERIFY_WITH_TIMEOUT(isOffered(), kPatience);
        m_window->findChild<QPushButton*>(QStringLiteral("recover"))->click();
        QTRY_VERIFY_WITH_TIMEOUT(m_session->targets().front()->transform == put, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(!files().isBusy(), kPatience);
        QVERIFY(m_window->findChild<DiscardGuard*>()->isAtRisk());
    }
}

void SessionWindowTest::recoveredIsInItsFile_data() {
    QTest::addColumn<bool>("isNewer");
    QTest::newRow("as it was saved") << false;
    QTest::newRow("written since") << true;
}

/// It is saved to the file that it was in, unless somebody wrote that since.
void SessionWindowTest::recoveredIsInItsFile() {
    QFETCH(bool, isNewer);
    const QString file = path("kept.hitscope");
    shoot(4, 6);
    save(file);
    shoot(3, 7);
    const std::size_t hits = m_session->hits().history().size();
    QVERIFY(m_window->isWindowModified());
    waitForJournal();
    if (isNewer) {
        QFile touched(file);
        QVERIFY(touched.open(QIODevice::ReadWrite));
        QVERIFY(touched.setFileTime(QDateTime::currentDateTime().addSecs(60), QFile::FileModificationTime));
    }
    makeWindow([](Session& session) { loadTeapot(session); });
    m_window->offerRecovery();
    QTRY_VERIFY_WITH_TIMEOUT(isOffered(), kPatience);
    bool isNamed = false;
    for (const QLabel* label : m_window->findChild<RecoveryBar*>()->findChildren<QLabel*>()) {
        isNamed = isNamed || label->text().contains(QStringLiteral("kept.hitscope"));
    }
    QVERIFY(isNamed);
    m_window->findChild<QPushButton*>(QStringLiteral("recover"))->click();
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), hits, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!files().isBusy(), kPatience);
    QCOMPARE(files().path(), isNewer ? QString() : file);
    QVERIFY(m_window->isWindowModified());
    if (!isNewer) {
        m_session->hits().remove(0);
        save(file);
        QVERIFY(!m_window->isWindowModified());
    }
}

void SessionWindowTest::nothingIsLeftAfterAnOrderlyEnd() {
    shoot(5, 8);
    closeAndDiscard(*m_window);
    makeWindow([](Session& session) { loadPaperRow(session, kDefaultPaperRow); });
    QVERIFY(leftBehind().empty());
    shoot(5, 9);
    save(path("one.hitscope"));
    QVERIFY(m_window->findChild<SessionJournal*>()->writer().wait(kPatience));
    makeWindow();
    QVERIFY(leftBehind().empty());
}

void SessionWindowTest::norOnceItIsAsItWasSaved() {
    const auto isKept = [] { return !QDir(journalFolder()).entryList(QDir::Files).isEmpty(); };
    shoot(2, 11);
    save(m_folder.filePath(QStringLiteral("undone.hitscope")));
    QTRY_VERIFY_WITH_TIMEOUT(!isKept(), kPatience);
    shoot(1, 12);
    QTRY_VERIFY_WITH_TIMEOUT(isKept(), kPatience);
    m_session->undo();
    QTRY_VERIFY_WITH_TIMEOUT(!isKept(), kPatience);
    QTest::qWait(2 * SessionJournal::kSoon);  // whatever was still to be noted
    QVERIFY(!isKept());
    m_session->redo();
    QTRY_VERIFY_WITH_TIMEOUT(isKept(), kPatience);
}

HITSCOPE_TEST(SessionWindowTest, QApplication)

}  // namespace hitscope::session_window_test

#include "session_window_test.moc"
