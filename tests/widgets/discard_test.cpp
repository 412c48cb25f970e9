// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing is lost by surprise: what replaces the scene or ends the program asks before it discards hits.
#include <QApplication>
#include <QDropEvent>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QUrl>

#include "app/actions/hit_actions.h"
#include "app/discard_guard.h"
#include "app/session_files.h"
#include "session/sample_scenes.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::discard_test {

namespace {

/// As the desktop's session manager asks at a log-out.
struct Manager {
    bool interacts = true;
    int cancelled = 0;
    int released = 0;
    [[nodiscard]] bool allowsInteraction() const { return interacts; }
    void cancel() { ++cancelled; }
    void release() { ++released; }
};

QAction* actionNamed(const QWidget& window, const QString& text) {
    for (QAction* action : window.findChildren<QAction*>()) {
        if (action->text().remove(u'&') == text) {
            return action;
        }
    }
    return nullptr;
}

}  // namespace

class DiscardTest : public QObject, private WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        m_settings = std::make_unique<TestSettings>();
        QSettings().setValue(QStringLiteral("recentFiles"), QStringList{path("cube.obj")});
        makeWindow([](Session& session) {
            MeshData sphere = makeHighPolySphere(2.5f);
            place(sphere, 4.0f);
            loadMesh(session, std::move(sphere));
        });
        writeObj(makeLowPolyCube(1.0f), path("cube.obj"));
    }
    void cleanup() { dropWindow(); }

    void asks_data();
    void asks();
    void doesNotAskForNothing();
    void asksForTargets();
    void doesNotAskForTheFirstScene();
    void closingAsks();
    void savesElsewhereWhereTheFolderIsGone();
    void placingIsUndone();
    void saveGoesOnWhenItIsWritten();
    void staysWhenASaveFails();
    void aSavedSessionAsksForAnyChange();
    void logOutAsks();

private:
    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    void hit() {
        Hit hit;
        hit.target = m_session->targets().back()->id;
        hit.point = {0.0f, 0.1f * static_cast<float>(m_session->hits().history().size()), 2.5f};
        QVERIFY(m_session->hits().add(hit).ok());
    }
    void drop(const QString& file) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(file)});
        QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(m_window.get(), &enter);
        QDropEvent event({100.0, 100.0}, Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(m_window.get(), &event);
    }
    void trigger(const char* name) {
        QAction* action = actionNamed(*m_window, QString::fromUtf8(name));
        QVERIFY2(action != nullptr, name);
        action->trigger();
    }
    /// Answers the next file dialog.
    void chooseNext(const QString& file) {
        QTimer::singleShot(0, m_window.get(), [this, file] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr) {
                chooseNext(file);
            } else if (file.isEmpty()) {
                dialog->reject();
            } else {
                // As typed; selectFile() leaves the name alone while it has the focus.
                dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(file);
                QMetaObject::invokeMethod(dialog, "accept");
            }
        });
    }

    QTemporaryDir m_folder;
};

void DiscardTest::asks_data() {
    QTest::addColumn<std::function<void()>>("act");
    QTest::addColumn<QString>("scene");
    const auto row = [](const char* name, const QString& scene, const std::function<void()>& act) {
        QTest::newRow(name) << act << scene;
    };
    row("teapot", QStringLiteral("teapot"), [this] { trigger("Utah Teapot"); });
    row("paper row", {}, [this] {
        for (QAction* action : m_window->findChildren<QAction*>()) {
            if (action->text().startsWith(QStringLiteral("Row 3"))) {
                action->trigger();
            }
        }
    });
    row("sample", {}, [this] { actionNamed(*m_window, sampleSceneName(allSampleScenes()[0]))->trigger(); });
    row("drop", QStringLiteral("cube"), [this] { drop(path("cube.obj")); });
    row("open", QStringLiteral("cube"), [this] {
        chooseNext(path("cube.obj"));
        trigger("Open…");
    });
    row("recent", QStringLiteral("cube"), [this] {
        auto* menu = qobject_cast<QMenu*>(actionNamed(*m_window, QStringLiteral("Open Recent"))->menu());
        Q_EMIT menu->aboutToShow();
        menu->actions().constFirst()->trigger();
    });
    row("new", QStringLiteral("teapot"), [this] { trigger("New Session"); });
}

void DiscardTest::asks() {
    QFETCH(std::function<void()>, act);
    QFETCH(QString, scene);
    hit();
    hit();
    const Target* before = m_session->targets().front().get();
    act();
    QTRY_VERIFY_WITH_TIMEOUT(discardQuestion(*m_window) != nullptr, kPatience);
    QVERIFY(discardQuestion(*m_window)->text().contains(QStringLiteral("2 hits")));
    QTest::keyClick(discardQuestion(*m_window), Qt::Key_Return);  // the default is to cancel
    QTRY_VERIFY_WITH_TIMEOUT(discardQuestion(*m_window) == nullptr, kPatience);
    QTest::qWait(100);
    QVERIFY(m_session->targets().front().get() == before);
    QCOMPARE(m_session->hits().history().size(), std::size_t{2});
    QVERIFY(m_window->isVisible());
    act();
    QTRY_VERIFY_WITH_TIMEOUT(discardQuestion(*m_window) != nullptr, kPatience);
    answerQuestion(*m_window, QMessageBox::DestructiveRole);
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), std::size_t{0}, kPatience);
    if (!scene.isEmpty()) {
        QCOMPARE(m_session->sceneName().toLower(), scene.toLower());
    }
}

void DiscardTest::doesNotAskForNothing() {
    trigger("Utah Teapot");
    QVERIFY(discardQuestion(*m_window) == nullptr);
    QCOMPARE(m_session->sceneName().toLower(), QStringLiteral("teapot"));
    hit();
    QVERIFY(m_window->exportTo(path("kept.obj")).ok());
    // As it was exported.
    Manager manager;
    m_window->findChild<DiscardGuard*>()->answer(manager);
    QVERIFY(manager.released == 0 && manager.cancelled == 0);
    // A hit more, or one changed.
    auto* guard = m_window->findChild<DiscardGuard*>();
    QVERIFY(!guard->isAtRisk());
    hit();
    QVERIFY(guard->isAtRisk());
    m_session->undo();
    QVERIFY(!guard->isAtRisk());
    m_session->hits().setEnabled(std::vector<std::size_t>{0}, false);
    QVERIFY(guard->isAtRisk());
    // A file of all hits keeps them as well.
    auto* hits = m_window->findChild<HitActions*>();
    hits->exportTo(path("hits.csv"));
    QTRY_VERIFY_WITH_TIMEOUT(!hits->isBusy(), kPatience);
    QVERIFY(!guard->isAtRisk());
    hit();
    QVERIFY(guard->isAtRisk());
    m_session->hits().clear();
    QVERIFY(!guard->isAtRisk());
    m_window->close();
    QVERIFY(!m_window->isVisible());
}

/// Targets that were added or moved are work, too; what is shown of them is not.
void DiscardTest::asksForTargets() {
    auto* guard = m_window->findChild<DiscardGuard*>();
    QVERIFY(!guard->isAtRisk());
    const TargetId first = m_session->targets().front()->id;
    m_session->targets().setVisible({&first, 1}, false);
    QVERIFY(!guard->isAtRisk());
    m_session->targets().duplicate({&first, 1});
    QVERIFY(guard->isAtRisk());
    m_window->close();
    QVERIFY(m_window->isVisible());
    auto* box = discardQuestion(*m_window);
    QVERIFY(box != nullptr);
    QCOMPARE(box->text(), QStringLiteral("Changes of this scene's targets are not saved."));
    box->reject();
    m_session->undo();
    QVERIFY(!guard->isAtRisk());
    QVERIFY(m_session->targets().setTransform(first, RigidTransform{{1.0f, 2.0f, 3.0f}}).ok());
    QVERIFY(guard->isAtRisk());
    trigger("Utah Teapot");
    box = discardQuestion(*m_window);
    QVERIFY(box != nullptr);
    box->reject();
    QVERIFY(m_window->exportTo(path("kept.obj")).ok());
    QVERIFY(!guard->isAtRisk());
    QVERIFY(m_session->targets().setTransform(first, RigidTransform{{2.0f, 2.0f, 3.0f}}).ok());
    QVERIFY(guard->isAtRisk());  // moved since
    m_session->undo();
    QVERIFY(!guard->isAtRisk());
}

/// The hits that the program opens with are not the person's.
void DiscardTest::doesNotAskForTheFirstScene() {
    makeWindow([](Session& session) {
        loadSphere(session);
        Hit first;
        first.target = session.targets().front()->id;
        first.point = {0.0f, 0.0f, 2.5f};
        QVERIFY(session.hits().add(first).ok());
    });
    QCOMPARE(m_session->hits().history().size(), std::size_t{1});
    m_window->close();
    QVERIFY(!m_window->isVisible());
}

void DiscardTest::closingAsks() {
    hit();
    m_window->close();
    QVERIFY(m_window->isVisible() && discardQuestion(*m_window) != nullptr);
    QVERIFY(discardQuestion(*m_window)->text().contains(QStringLiteral("1 hit ")));
    m_window->close();  // one question is enough
    QCOMPARE(m_window->findChildren<QMessageBox*>().size(), 1);
    QTest::keyClick(discardQuestion(*m_window), Qt::Key_Escape);
    QVERIFY(m_window->isVisible());
    trigger("Quit");
    answerQuestion(*m_window, QMessageBox::DestructiveRole);
    QVERIFY(!m_window->isVisible());
}

void DiscardTest::savesElsewhereWhereTheFolderIsGone() {
    const QString gone = m_folder.filePath(QStringLiteral("gone"));
    QVERIFY(QDir().mkpath(gone));
    SessionFiles& files = *m_window->findChild<SessionFiles*>();
    QSignalSpy saved(&files, &SessionFiles::saved);
    files.save(gone + QStringLiteral("/a.hitscope"));
    QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, kPatience);
    QVERIFY(QDir(gone).removeRecursively());
    hit();
    trigger("Save Session");
    const auto box = [this] { return m_window->findChild<QMessageBox*>(QStringLiteral("notSaved")); };
    QTRY_VERIFY_WITH_TIMEOUT(box() != nullptr && box()->isVisible(), kPatience);
    QVERIFY2(box()->informativeText().contains(QStringLiteral("a.hitscope")),
             qPrintable(box()->informativeText()));
    const QString elsewhere = m_folder.filePath(QStringLiteral("elsewhere.hitscope"));
    chooseNext(elsewhere);
    QTest::keyClick(box(), Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 2, kPatience);
    QCOMPARE(files.path(), elsewhere);
    QVERIFY(!files.isModified());
}

/// Placing a mesh takes its hits; they come back.
void DiscardTest::placingIsUndone() {
    hit();
    hit();
    trigger("File's Own Coordinates");
    QCOMPARE(m_session->hits().history().size(), std::size_t{0});
    QTimer::singleShot(0, m_window.get(), [] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        QVERIFY(dialog != nullptr);
        dialog->accept();
    });
    trigger("Centre and Scale…");
    QVERIFY(discardQuestion(*m_window) == nullptr);
    m_session->undo();
    m_session->undo();
    QCOMPARE(m_session->hits().history().size(), std::size_t{2});
}

void DiscardTest::saveGoesOnWhenItIsWritten() {
    hit();
    drop(path("cube.obj"));
    QTRY_VERIFY_WITH_TIMEOUT(discardQuestion(*m_window) != nullptr, kPatience);
    chooseNext({});  // no file: nothing happens
    answerQuestion(*m_window, QMessageBox::AcceptRole);
    QTest::qWait(100);
    QCOMPARE(m_session->hits().history().size(), std::size_t{1});
    drop(path("cube.obj"));
    QTRY_VERIFY_WITH_TIMEOUT(discardQuestion(*m_window) != nullptr, kPatience);
    answerQuestion(*m_window, QMessageBox::RejectRole);
    drop(path("cube.obj"));
    QTRY_VERIFY_WITH_TIMEOUT(discardQuestion(*m_window) != nullptr, kPatience);
    chooseNext(path("gone_on.hitscope"));
    answerQuestion(*m_window, QMessageBox::AcceptRole);
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), std::size_t{0}, kPatience);
    QVERIFY(QFile::exists(path("gone_on.hitscope")));
    QTRY_COMPARE_WITH_TIMEOUT(m_session->sceneName(), QStringLiteral("cube"), kPatience);
}

void DiscardTest::staysWhenASaveFails() {
    hit();
    m_window->close();
    chooseNext(path("cube.obj/no_folder.hitscope"));
    answerQuestion(*m_window, QMessageBox::AcceptRole);
    QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeModalWidget() != nullptr, kPatience);
    qobject_cast<QDialog*>(QApplication::activeModalWidget())->reject();
    QTest::qWait(100);
    QVERIFY(m_window->isVisible());
    QCOMPARE(m_session->hits().history().size(), std::size_t{1});
}

void DiscardTest::aSavedSessionAsksForAnyChange() {
    hit();
    auto* files = m_window->findChild<SessionFiles*>();
    files->save(path("kept.hitscope"));
    QTRY_VERIFY_WITH_TIMEOUT(!files->isBusy(), kPatience);
    auto* guard = m_window->findChild<DiscardGuard*>();
    QVERIFY(!guard->isAtRisk() && !m_window->isWindowModified());
    m_session->settings().setFlightMode(FlightMode::Instant);
    QVERIFY(guard->isAtRisk() && m_window->isWindowModified());
    m_window->close();
    QTRY_VERIFY_WITH_TIMEOUT(discardQuestion(*m_window) != nullptr, kPatience);
    QVERIFY(discardQuestion(*m_window)->text().contains(QStringLiteral("kept.hitscope")));
    answerQuestion(*m_window, QMessageBox::RejectRole);
    m_session->undo();
    QVERIFY(!guard->isAtRisk() && !m_window->isWindowModified());
    hit();
    m_window->close();
    answerQuestion(*m_window, QMessageBox::AcceptRole);  // to the same file, without asking where
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->isVisible(), kPatience);
}

void DiscardTest::logOutAsks() {
    auto* guard = m_window->findChild<DiscardGuard*>();
    hit();
    Manager silent;
    silent.interacts = false;
    guard->answer(silent);
    QVERIFY(silent.cancelled == 0 && discardQuestion(*m_window) == nullptr);
    const auto answerSoon = [this](QMessageBox::ButtonRole role) {
        QTimer::singleShot(0, m_window.get(), [this, role] { answerQuestion(*m_window, role); });
    };
    Manager manager;
    answerSoon(QMessageBox::RejectRole);
    guard->answer(manager);
    QVERIFY(manager.cancelled == 1 && manager.released == 0);
    chooseNext(path("log_out.hitscope"));
    answerSoon(QMessageBox::AcceptRole);
    guard->answer(manager);
    QVERIFY(manager.cancelled == 1 && manager.released == 1 && QFile::exists(path("log_out.hitscope")));
    hit();
    answerSoon(QMessageBox::DestructiveRole);
    guard->answer(manager);
    QVERIFY(manager.cancelled == 1 && manager.released == 2);
    m_window->close();  // as it then happens; it is not asked again
    QVERIFY(!m_window->isVisible());
}

HITSCOPE_TEST(DiscardTest, QApplication)

}  // namespace hitscope::discard_test

#include "discard_test.moc"
