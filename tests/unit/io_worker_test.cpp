// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "io/import.h"
#include "io/mesh_stream.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_worker_test {

using namespace test;

/// Import workers that misbehave, played by shell scripts: $1 is the input, the answer goes to descriptor 0.
class WorkerTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void cleanup() { setImportWorkerPath({}); }
    void endsBadly_data();
    void endsBadly();
    void doesNotStart();
    void tellsProgressAndNotes();
    void passesItsLimitsOn();
    void hasNoTemporaryFilesToLeaveBehind();
    void stopsAHangingWorker();
    void inheritsNoDescriptors();
    void inheritsNoEnvironment();
    void endsWhatTheWorkerStarted();
    void canBeCancelled();
    void destroyingItEndsTheWorker();
    void emitsOnce();

private:
    QString play(const char* script);
    [[nodiscard]] QString in(const char* name) const { return m_folder->filePath(QString::fromLatin1(name)); }
    [[nodiscard]] bool waitForWorker() const;
    [[nodiscard]] bool workerIsGone() const;

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_mesh;
};

void WorkerTest::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_mesh = writeFile(m_folder->path(), QStringLiteral("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
}

/// Makes a script the worker; it notes its process id beside the mesh first.
QString WorkerTest::play(const char* script) {
    const std::string text = "#!/bin/sh\necho $$ > '" + in("pid").toStdString() + "'\n" + script + "\n";
    const QString path = writeFile(m_folder->path(), QStringLiteral("worker"), text);
    QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    setImportWorkerPath(path);
    return path;
}

bool WorkerTest::waitForWorker() const {
    return QTest::qWaitFor([this] { return readFile(in("pid")).ends_with('\n'); }, kPatience);
}

bool WorkerTest::workerIsGone() const {
    const pid_t worker = std::stoi(readFile(in("pid")));
    return ::kill(worker, 0) != 0 && errno == ESRCH;
}

void WorkerTest::endsBadly_data() {
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* title, const QByteArray& script, const char* message) {
        QTest::newRow(title) << script << message;
    };
    row("segmentation fault", "kill -SEGV $$", "The file makes the reader crash; it is probably damaged.");
    row("abort", "kill -ABRT $$", "The file makes the reader crash");
    row("killed for memory", "kill -KILL $$",
        "The system stopped reading the file, probably because memory ran out.");
    row("too much processor time", "kill -XCPU $$", "took longer than 7 seconds");
    row("exit status", "exit 3", "gave no usable answer (exit status 3)");
    row("nothing", "exit 0", "gave no usable answer");
    row("an error", "echo 'error [\"It hurts.\",\"a.obj, line 3\",\"Rest.\"]'; exit 1",
        "a.obj, line 3: It hurts. Rest.");
    row("no room for its answer", "echo 'error [\"It is full.\",\"<answer>\",\"Make room.\"]'; exit 1",
        qPrintable(QDir::tempPath() + QStringLiteral(": It is full. Make room.")));
    row("an error, then a crash", "echo 'error [\"It hurts.\"]'; kill -SEGV $$", "It hurts.");
    row("garbage in the answer", "echo garbage >&0", "The import worker's answer cannot be used");
    const QByteArray version = QByteArray::number(kMeshStreamVersion, 8);
    row("huge lengths",
        "printf 'HSMESH\\r\\n\\" + version + "\\0\\0\\0\\377\\377\\377\\377\\377\\377\\377\\177' >&0",
        "an array is longer than the rest of it");
    row("garbage on its output", "head -c 30000 /dev/zero; kill -SEGV $$", "The file makes the reader crash");
    row("a line without an end", "exec cat /dev/zero", "cannot be used: it says too much");
    row("lines without an end", "exec yes 'progress 0.5 Reading faces'", "cannot be used: it says too much");
    row("notes without an end", "exec yes 'note Mended.'", "cannot be used: it says too much");
    row("an answer without an end", "exec cat /dev/zero >&0", "takes more room than what is read may take");
    row("a child that stays", "sleep 1000 & exit 0", "gave no usable answer");
}

void WorkerTest::endsBadly() {
    QFETCH(QByteArray, script);
    QFETCH(QString, message);
    play(script.constData());
    ImportLimits limits;
    limits.seconds = 7;
    limits.memoryBytes = 1 << 20;
    const Result<ImportedMesh> result = importMesh(m_mesh, limits);
    QVERIFY2(messageOf(result).contains(message), qPrintable(messageOf(result)));
    QVERIFY(!result.error().where.empty() || message == QStringLiteral("It hurts."));
}

void WorkerTest::doesNotStart() {
    const QString path = writeFile(m_folder->path(), QStringLiteral("worker"),
                                   "\x7f"
                                   "no program");
    QFile::setPermissions(path, QFile::ReadOwner | QFile::ExeOwner);
    setImportWorkerPath(path);
    const Result<ImportedMesh> result = importMesh(m_mesh);
    QVERIFY2(messageOf(result).contains(QStringLiteral("does not start")), qPrintable(messageOf(result)));
}

void WorkerTest::tellsProgressAndNotes() {
    MeshData mesh;
    mesh.name = "made elsewhere";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faceStarts = {0, 3};
    mesh.cornerVertices = {0, 1, 2};
    QVERIFY(writeMeshStream(mesh, in("ready")).ok());
    play(("echo 'progress 0.5 Reading faces'; echo nonsense; echo 'note Mended.'; cat '" +
          in("ready").toStdString() + "' >&0")
             .c_str());
    MeshImport import(m_mesh);
    std::vector<std::pair<double, QString>> told;
    connect(&import, &MeshImport::progressed, this,
            [&](double fraction, const QString& doing) { told.emplace_back(fraction, doing); });
    std::shared_ptr<ImportedMesh> result;
    connect(&import, &MeshImport::finished, this,
            [&](const std::shared_ptr<ImportedMesh>& mesh_) { result = mesh_; });
    import.start();
    QVERIFY(QTest::qWaitFor([&] { return result != nullptr; }, kPatience));
    QCOMPARE(result->notes, QStringList{QStringLiteral("Mended.")});
    QCOMPARE(result->mesh.name, mesh.name);
    QCOMPARE(told.front().second, QStringLiteral("Reading faces"));
    QVERIFY(told.front().first > 0.0 && told.front().first < 0.5);
    QCOMPARE(told.back().first, 1.0);
}

void WorkerTest::passesItsLimitsOn() {
    play("echo \"error [\\\"$2 $3 $#\\\"]\"; exit 1");
    ImportLimits limits;
    limits.seconds = 42;
    limits.memoryBytes = 123456789;
    QCOMPARE(messageOf(importMesh(m_mesh, limits)), QStringLiteral("42 123456789 3"));
}

/// Killed at any moment, it leaves nothing: while it runs there is nothing that has a name.
void WorkerTest::hasNoTemporaryFilesToLeaveBehind() {
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("temporary")));
    const QByteArray usual = qgetenv("TMPDIR");
    qputenv("TMPDIR", QFile::encodeName(in("temporary")));
    play("echo something >&0; exec sleep 1000");
    MeshImport import(m_mesh);
    import.start();
    qputenv("TMPDIR", usual);
    QVERIFY(waitForWorker());
    QCOMPARE(QDir(in("temporary")).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
             QStringList());
}

void WorkerTest::stopsAHangingWorker() {
    play("exec sleep 1000");
    ImportLimits limits;
    limits.seconds = 1;
    const Result<ImportedMesh> result = importMesh(m_mesh, limits);
    QVERIFY2(messageOf(result).contains(QStringLiteral("took longer than 1 seconds and was stopped")),
             qPrintable(messageOf(result)));
    QVERIFY(workerIsGone());
}

void WorkerTest::inheritsNoDescriptors() {
    const int folder = ::open("/", O_RDONLY | O_CLOEXEC);
    const int forgotten = ::fcntl(folder, F_DUPFD, 77);  // nobody said that it is not to be inherited
    play("cd /proc/$$/fd; echo \"error [\\\" $(echo *) \\\"]\"; exit 1");
    const QString descriptors = messageOf(importMesh(m_mesh));
    ::close(forgotten);
    ::close(folder);
    const QStringList list = descriptors.simplified().split(' ');
    QVERIFY2(list.contains(QStringLiteral("0")), qPrintable(descriptors));
    QVERIFY2(!list.contains(QString::number(forgotten)), qPrintable(descriptors));
    for (const QString& each : list) {  // the shell has some of its own, of low numbers
        QVERIFY2(each.toInt() < 20, qPrintable(descriptors));
    }
}

void WorkerTest::inheritsNoEnvironment() {
    qputenv("HITSCOPE_SECRET", "x");
    play("echo \"error [\\\"$(env | sed 's/=.*//' | sort | tr '\\n' ' ')\\\"]\"; exit 1");
    const QString names = messageOf(importMesh(m_mesh));
    qunsetenv("HITSCOPE_SECRET");
    QStringList list = names.simplified().split(' ');
    QVERIFY2(list.contains(QStringLiteral("LANG")), qPrintable(names));
    for (const char* const known :
         {"LANG", "LD_LIBRARY_PATH", "QT_PLUGIN_PATH", "ASAN_OPTIONS", "LSAN_OPTIONS", "TSAN_OPTIONS",
          "UBSAN_OPTIONS", "PWD", "OLDPWD", "SHLVL", "_"}) {
        list.removeAll(QString::fromLatin1(known));
    }
    QCOMPARE(list, QStringList());
}

void WorkerTest::endsWhatTheWorkerStarted() {
    play(("sleep 1000 & echo $! > '" + in("child").toStdString() + "'; wait").c_str());
    MeshImport import(m_mesh);
    import.start();
    QVERIFY(QTest::qWaitFor([&] { return readFile(in("child")).ends_with('\n'); }, kPatience));
    const pid_t child = std::stoi(readFile(in("child")));
    import.cancel();
    QVERIFY(QTest::qWaitFor(
        [&] {  // gone, or dead and waiting for whoever reaps orphans here
            const std::string state = readFile(QStringLiteral("/proc/%1/stat").arg(child));
            return state.empty() || state.find(") Z") != std::string::npos;
        },
        kPatience));
}

void WorkerTest::canBeCancelled() {
    play("exec sleep 1000");
    MeshImport import(m_mesh);
    std::string what;
    connect(&import, &MeshImport::failed, this, [&](const Error& error) { what = error.what; });
    import.start();
    QVERIFY(waitForWorker());
    import.cancel();
    QVERIFY(QTest::qWaitFor([&] { return !what.empty(); }, kPatience));
    QCOMPARE(what, std::string("Opening the file was cancelled."));
    QVERIFY(QTest::qWaitFor([&] { return workerIsGone(); }, kPatience));
}

void WorkerTest::destroyingItEndsTheWorker() {
    play("exec sleep 1000");
    auto import = std::make_unique<MeshImport>(m_mesh);
    import->start();
    QVERIFY(waitForWorker());
    import.reset();
    QVERIFY(QTest::qWaitFor([&] { return workerIsGone(); }, kPatience));
}

void WorkerTest::emitsOnce() {
    play("exec sleep 1000");
    MeshImport import(m_mesh);
    int ends = 0;
    connect(&import, &MeshImport::failed, this, [&] { ++ends; });
    connect(&import, &MeshImport::finished, this, [&] { ++ends; });
    import.start();
    import.start();
    QCOMPARE(ends, 0);
    QVERIFY(waitForWorker());
    import.cancel();
    import.cancel();
    QCOMPARE(ends, 0);  // later, from the event loop
    QVERIFY(QTest::qWaitFor([&] { return workerIsGone(); }, kPatience));
    QTest::qWait(50);
    QCOMPARE(ends, 1);
}

HITSCOPE_TEST(WorkerTest, QCoreApplication)

}  // namespace hitscope::io_worker_test

#include "io_worker_test.moc"
