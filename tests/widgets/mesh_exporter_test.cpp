// SPDX-License-Identifier: GPL-3.0-or-later
// Exports in the background: what is written, and what is not when they are cancelled.
#include <QApplication>
#include <QFile>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>

#include "app/discard_guard.h"
#include "app/mesh_exporter.h"
#include "mesh/primitives.h"
#include "session/task_list.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::mesh_exporter_test {

namespace {

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class MeshExporterTest : public QObject {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private:
    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    [[nodiscard]] static const Target& target(const Session& session) { return *session.targets().front(); }

    static SceneExport copied(const Session& session, NormalMode normals) {
        const Target* const one = &target(session);
        return copyForExport(session, {&one, 1}, {.normals = normals});
    }

    TestSettings m_settings;
    QTemporaryDir m_folder;

private Q_SLOTS:
    void writesWhatWasThere() {
        Session session;
        loadMesh(session, makeHighPolyCube(2.5f));
        QVERIFY(exportTarget(session, target(session), path("at_once.obj"), {}).ok());
        MeshExporter exporter(session.tasks());
        QSignalSpy exported(&exporter, &MeshExporter::exported);
        std::vector<double> fractions;
        connect(&session.tasks(), &TaskList::changed, this, [&] {
            if (session.tasks().current() != nullptr) {
                fractions.push_back(session.tasks().current()->fraction);
            }
        });
        exporter.start(copied(session, NormalMode::True), QStringLiteral("cube"), path("beside.obj"));
        QCOMPARE(session.tasks().size(), std::size_t{1});
        QCOMPARE(session.tasks().current()->what, QStringLiteral("Exporting beside.obj"));
        loadPaperRow(session, kDefaultPaperRow);  // the file is of what there was
        QTRY_COMPARE_WITH_TIMEOUT(exported.size(), 1, kPatience);
        QCOMPARE(exported[0][0].toString(), QStringLiteral("cube"));
        QCOMPARE(session.tasks().size(), std::size_t{0});
        QVERIFY(!contentOf(path("at_once.obj")).isEmpty());
        QCOMPARE(contentOf(path("beside.obj")), contentOf(path("at_once.obj")));
        QVERIFY(std::is_sorted(fractions.begin(), fractions.end()));
        QCOMPARE(fractions.back(), 1.0);
    }

    void givenUpLeavesTheOldFile() {
        Session session;
        loadMesh(session, makeHighPolyCube(2.5f));
        const QByteArray old = "# what was there\n";
        QFile file(path("old.obj"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(old);
        file.close();
        MeshExporter exporter(session.tasks());
        QSignalSpy cancelled(&exporter, &MeshExporter::cancelled);
        QSignalSpy exported(&exporter, &MeshExporter::exported);
        // The second waits for the first, so it cannot be over before it is given up.
        for (const char* name : {"first.obj", "old.obj"}) {
            exporter.start(copied(session, NormalMode::Paper), QStringLiteral("cube"), path(name));
        }
        session.tasks().cancel(session.tasks().current()->id + 1);
        QTRY_VERIFY_WITH_TIMEOUT(!exporter.isRunning(), kPatience);
        QCOMPARE(cancelled.size(), 1);
        QCOMPARE(exported.size(), 1);
        QCOMPARE(contentOf(path("old.obj")), old);
        QCOMPARE(session.tasks().size(), std::size_t{0});
    }

    void whatCannotBeWrittenIsSaid() {
        Session session;
        loadMesh(session, makeHighPolyCube(2.5f));
        MeshExporter exporter(session.tasks());
        QSignalSpy failed(&exporter, &MeshExporter::failed);
        exporter.start(copied(session, NormalMode::True), QStringLiteral("cube"),
                       path("no such folder/a.obj"));
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience);
        QVERIFY(failed[0][0].value<Error>().message().find("no such folder") != std::string::npos);
    }

    void isFinishedBeforeItGoes() {
        Session session;
        loadMesh(session, makeHighPolyCube(2.5f));
        {
            MeshExporter exporter(session.tasks());
            exporter.start(copied(session, NormalMode::True), QStringLiteral("cube"), path("last.obj"));
        }
        QVERIFY(!contentOf(path("last.obj")).isEmpty());
        QCOMPARE(session.tasks().size(), std::size_t{0});
    }

    void theWindowSaysHowItEnded() {
        Session session;
        loadMesh(session, makeHighPolyCube(2.5f));
        MainWindow window(session);
        showReady(window);
        Hit hit;
        hit.target = target(session).id;
        hit.point = {0.0f, 2.5f, 0.0f};
        hit.direction = {0.0f, -1.0f, 0.0f};
        QVERIFY(session.hits().add(hit).ok());  // no frame has shown it yet
        window.beginExport(path("window.obj"));
        QTRY_VERIFY_WITH_TIMEOUT(window.statusBar()->currentMessage().contains(path("window.obj")),
                                 kPatience);
        QVERIFY(window.exportTo(path("again.obj")).ok());
        QVERIFY(!contentOf(path("again.obj")).isEmpty());
        QCOMPARE(contentOf(path("window.obj")), contentOf(path("again.obj")));
    }

    /// The first file does not stand for what a second of the same name was to hold.
    void eachExportOfAFileIsOneOfItsOwn() {
        Session session;
        loadMesh(session, makeHighPolyCube(2.5f));
        MainWindow window(session);
        auto& guard = *window.findChild<DiscardGuard*>();
        Hit hit;
        hit.target = target(session).id;
        QVERIFY(session.hits().add(hit).ok());
        guard.exportBegins({&target(session)}, path("same.obj"));
        QVERIFY(session.hits().add(hit).ok());
        guard.exportBegins({&target(session)}, path("same.obj"));
        guard.exportEnds(path("same.obj"), true);
        QVERIFY(guard.isAtRisk());
        guard.exportEnds(path("same.obj"), false);
        QVERIFY(guard.isAtRisk());
        session.undo();
        QVERIFY(!guard.isAtRisk());
        session.targets().duplicate({&target(session).id, 1});
        const Target& copy = *session.targets().back();
        guard.exportBegins({&target(session), &copy}, path("both.obj"));
        guard.exportEnds(path("both.obj"), true);
        QVERIFY(!guard.isAtRisk());
        guard.exportBegins({&copy}, path("both.obj"));
        guard.exportEnds(path("both.obj"), true);
        QVERIFY(guard.isAtRisk());  // the file of the first is gone
    }

    void theJobThatEndsIsNamed() {
        Session session;
        loadMesh(session, makeHighPolyCube(2.5f));
        MeshExporter exporter(session.tasks());
        QSignalSpy ended(&exporter, &MeshExporter::ended);
        std::vector<int> jobs;
        for (int job = 0; job < 2; ++job) {
            jobs.push_back(
                exporter.start(copied(session, NormalMode::True), QStringLiteral("cube"), path("twice.obj")));
        }
        QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 2, kPatience);
        QCOMPARE(ended[0][2].toInt(), jobs[0]);
        QCOMPARE(ended[1][2].toInt(), jobs[1]);
        QVERIFY(jobs[0] != jobs[1]);
    }
};

HITSCOPE_TEST(MeshExporterTest, QApplication)

}  // namespace hitscope::mesh_exporter_test

#include "mesh_exporter_test.moc"
