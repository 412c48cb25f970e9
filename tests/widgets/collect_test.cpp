// SPDX-License-Identifier: GPL-3.0-or-later
// A session put into a folder by the window, and opened from elsewhere.
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "app/session_collector.h"
#include "app/session_files.h"
#include "deform/fingerprint.h"
#include "session/shots/demo_shots.h"
#include "session/task_list.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::collect_test {

class CollectTest : public QObject, private WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("meshes")));
        writeObj(makeUvSphere(24, 12, 1.0f), in("meshes/rock.obj"));
        makeWindow();
        m_window->openFiles({in("meshes/rock.obj")});
        QTRY_COMPARE_WITH_TIMEOUT(m_session->targets().front()->name, QStringLiteral("rock"), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(m_session->tasks().current() == nullptr, kPatience);
        for (const Ray& ray : demoShots(*m_session, 12, 3)) {
            m_session->simulation().hitscan(ray);
        }
    }
    void cleanup() {
        dropWindow();
        m_folder.reset();
    }

    void opensElsewhere() {
        const std::uint64_t before = positions();
        QSignalSpy collected(&collector(), &SessionCollector::collected);
        collector().collect(in("shared"));
        QTRY_COMPARE_WITH_TIMEOUT(collected.size(), 1, kPatience);
        QVERIFY(m_window->isWindowModified());  // collecting is not saving
        QVERIFY(m_session->tasks().current() == nullptr);
        QVERIFY(QDir(in("meshes")).removeRecursively());
        QVERIFY(QDir(m_folder->path()).rename(QStringLiteral("shared"), QStringLiteral("moved")));
        makeWindow();
        QSignalSpy differs(m_window->findChild<SessionFiles*>(), &SessionFiles::differs);
        m_window->openFiles({in("moved/rock.hitscope")});
        QTRY_COMPARE_WITH_TIMEOUT(m_session->targets().front()->name, QStringLiteral("rock"), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(m_session->tasks().current() == nullptr, kPatience);
        QCOMPARE(m_session->targets().front()->sourcePath, in("moved/meshes/rock/rock.obj"));
        QCOMPARE(positions(), before);
        QTest::qWait(200);
        QVERIFY(differs.isEmpty());  // as the file says itself
    }

    void aMeshThatIsGoneIsNamed() {
        QVERIFY(QFile::remove(in("meshes/rock.obj")));
        QSignalSpy failed(&collector(), &SessionCollector::failed);
        collector().collect(in("shared"));
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience);
        QVERIFY(
            QString::fromStdString(failed[0][0].value<Error>().message()).contains(in("meshes/rock.obj")));
        QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeModalWidget() != nullptr, kPatience);
        QApplication::activeModalWidget()->close();
        QVERIFY(!QFileInfo::exists(in("shared")));
    }

    /// The dialog proposes a folder that is not there, beside the session.
    void proposesANewFolder() {
        auto* files = m_window->findChild<SessionFiles*>();
        files->save(in("one.hitscope"));
        QTRY_VERIFY_WITH_TIMEOUT(!files->isBusy(), kPatience);
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("one")));
        QSignalSpy collected(&collector(), &SessionCollector::collected);
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        QTimer::singleShot(500, this, [] {
            if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
                dialog->accept();
            }
        });
        for (QAction* action : m_window->findChildren<QAction*>()) {
            if (action->text().contains(QStringLiteral("for Sharing"))) {
                action->trigger();
            }
        }
        QTRY_COMPARE_WITH_TIMEOUT(collected.size(), 1, kPatience);
        QVERIFY(QFileInfo(in("one 2/one.hitscope")).isFile());
        QVERIFY(QFileInfo(in("one 2/meshes/rock/rock.obj")).isFile());
    }

private:
    [[nodiscard]] QString in(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    [[nodiscard]] SessionCollector& collector() const { return *m_window->findChild<SessionCollector*>(); }
    [[nodiscard]] std::uint64_t positions() const {
        const DeformedMesh* mesh = &m_session->targets().front()->deformed;
        return m_window->viewport().syncNow().ok() ? positionsFingerprint({&mesh, 1}) : 0;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

HITSCOPE_TEST(CollectTest, QApplication)

}  // namespace hitscope::collect_test

#include "collect_test.moc"
