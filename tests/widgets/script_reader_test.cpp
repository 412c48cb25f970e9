// SPDX-License-Identifier: GPL-3.0-or-later
// Shot scripts are read beside the window, and dropped files that are none are taken for hits.
#include "app/script_reader.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

#include "app/actions/shot_actions.h"
#include "session/shots/shot_script_file.h"
#include "session/task_list.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::script_reader_test {

class ScriptReaderTest : public QObject {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private:
    /// A script of so many shots, long after one another.
    QString script(int shots) {
        ShotScript script;
        for (int i = 0; i < shots; ++i) {
            script.shots.push_back({1000.0 + i, {{0.0f, 1.0f, 20.0f}, {0.0f, 0.0f, -1.0f}}});
        }
        const QString path = m_folder.filePath(QStringLiteral("shots.json"));
        return writeShotScript(script, path) ? path : QString();
    }

    TestSettings m_settings;
    QTemporaryDir m_folder;

private Q_SLOTS:
    void readsBeside() {
        Session session;
        loadTeapot(session);
        MainWindow window(session);
        auto& shots = *window.findChild<ShotActions*>();
        shots.run(script(20'000));
        QCOMPARE(session.simulation().shotsToCome(), std::size_t{0});  // it has not waited for them
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().shotsToCome(), std::size_t{20'000}, kPatience);
        QCOMPARE(session.tasks().size(), std::size_t{0});
        bool isNone = false;
        shots.run(m_folder.filePath(QStringLiteral("none.json")), [&isNone] { isNone = true; });
        QTRY_VERIFY_WITH_TIMEOUT(isNone, kPatience);
    }

    void whatTakesLongIsCancelled() {
        Session session;
        loadTeapot(session);
        ScriptReader reader(session, nullptr, 0);
        bool isRead = false;
        const QString path = script(20'000);
        reader.read(path, [&isRead](const Result<ShotScript>&) { isRead = true; });
        QTRY_COMPARE_WITH_TIMEOUT(session.tasks().size(), std::size_t{1}, kPatience);
        QCOMPARE(session.tasks().current()->what, QStringLiteral("Reading shots.json"));
        session.tasks().cancel(session.tasks().current()->id);
        QVERIFY(!reader.isReading());
        QCOMPARE(session.tasks().size(), std::size_t{0});
        bool isNextRead = false;
        reader.read(path, [&isNextRead](const Result<ShotScript>&) { isNextRead = true; });
        QTRY_VERIFY_WITH_TIMEOUT(isNextRead, kPatience);
        QVERIFY(!isRead);
    }

    void anotherSceneHasNoShotsOfIt() {
        Session session;
        loadTeapot(session);
        ScriptReader reader(session);
        reader.read(script(10), [](const Result<ShotScript>&) { QFAIL("it was for the scene before"); });
        loadTeapot(session);
        QVERIFY(!reader.isReading());
        bool isRead = false;
        reader.read(script(10), [&isRead](const Result<ShotScript>& script) { isRead = script.ok(); });
        QTRY_VERIFY_WITH_TIMEOUT(isRead, kPatience);
    }
};

HITSCOPE_TEST(ScriptReaderTest, QApplication)

}  // namespace hitscope::script_reader_test

#include "script_reader_test.moc"
