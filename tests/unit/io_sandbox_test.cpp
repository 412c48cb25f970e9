// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <linux/bpf.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <functional>
#include <thread>
#include <vector>

#include "core/sanitizers.h"
#include "io/worker/call_filter.h"
#include "io/worker/sandbox.h"
#include "io/worker_location.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::io_sandbox_test {

using namespace test;

namespace {

enum class Needs { Nothing, Files, Calls };

/// Whether it could be done.
using Deed = std::function<bool()>;

bool opens(const QString& path, int flags = O_RDONLY) {
    return ::open(QFile::encodeName(path).constData(), flags | O_CLOEXEC, 0600) >= 0;
}

template <class... Arguments>
bool calls(long number, Arguments... arguments) {
    return ::syscall(number, arguments...) >= 0;
}

enum Outcome { Could, CouldNot, NotLocked };

/// In a process of its own, which locks itself first; by the filter of calls alone where that is asked for,
/// since the other lock would hide what it lets through.
Outcome tryLocked(const QString& mesh, Needs needs, const Deed& deed) {
    const pid_t child = ::fork();
    if (child == 0) {
        loadWhatComesLate();
        const Lock lock = needs == Needs::Calls ? Lock{false, filterCalls()} : lockThisProcess(mesh);
        if ((needs == Needs::Files && !lock.files) || (needs == Needs::Calls && !lock.calls)) {
            ::_exit(NotLocked);
        }
        ::_exit(deed() ? Could : CouldNot);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? static_cast<Outcome>(WEXITSTATUS(status)) : CouldNot;
}

bool startsProgram() {
    const char* const arguments[] = {"true", nullptr};
    const char* const environment[] = {nullptr};
    ::execve("/bin/true", const_cast<char**>(arguments), const_cast<char**>(environment));
    return false;  // else it is `true` that ends with 0
}

bool forks() {
    const pid_t child = ::fork();
    if (child == 0) {
        ::_exit(0);
    }
    return child > 0;
}

bool makesThread() {
    int made = 0;
    std::thread([&made] { made = 1; }).join();
    return made == 1;
}

bool decodes(const QByteArray& picture) {
    return QImage::fromData(picture).width() == 3000;
}

}  // namespace

/// What the import worker can still do once it has locked itself.
class SandboxTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void forbidden_data();
    void forbidden();
    void allowed_data();
    void allowed();
    void workerIsLocked();

private:
    [[nodiscard]] QString in(const char* name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    [[nodiscard]] QString mesh() const { return in("meshes/a.obj"); }
    void prepare();
    void forbiddenFiles();
    void forbiddenCalls();

    QTemporaryDir m_folder;
};

void SandboxTest::init() {
#ifdef HITSCOPE_SANITIZED
    QSKIP("Builds with a sanitizer are not locked.");
#endif
}

/// Tables are made before init(), and only once each.
void SandboxTest::prepare() {
    QVERIFY(QDir(m_folder.path()).mkpath(QStringLiteral("meshes/below")));
    writeFile(m_folder.path(), QStringLiteral("meshes/a.obj"), "v 0 0 0\n");
    writeFile(m_folder.path(), QStringLiteral("meshes/below/b.mtl"), "newmtl b\n");
    writeFile(m_folder.path(), QStringLiteral("outside.mtl"), "newmtl c\n");
    QFile::link(in("outside.mtl"), in("meshes/link.mtl"));
}

void SandboxTest::forbiddenFiles() {
    const auto row = [](const char* title, Needs needs, const Deed& deed) {
        QTest::newRow(title) << needs << deed;
    };
    const QByteArray meshName = QFile::encodeName(mesh());
    row("a file of the system", Needs::Files, [] { return opens(QStringLiteral("/etc/passwd")); });
    row("a file beside the folder", Needs::Files, [this] { return opens(in("outside.mtl")); });
    row("a link that leads out", Needs::Files, [this] { return opens(in("meshes/link.mtl")); });
    row("a folder that is not the mesh's", Needs::Files, [this] { return opens(m_folder.path()); });
    row("other processes", Needs::Files, [] { return opens(QStringLiteral("/proc/self/environ")); });
    for (const Needs needs : {Needs::Files, Needs::Calls}) {  // each of them forbids it
        row(needs == Needs::Files ? "a new file" : "a new file, by its call", needs,
            [this] { return opens(in("meshes/new"), O_WRONLY | O_CREAT); });
        row(needs == Needs::Files ? "writing to the mesh" : "writing to the mesh, by its call", needs,
            [this] { return opens(mesh(), O_RDWR); });
    }
    row("cutting the mesh", Needs::Calls, [this] { return opens(mesh(), O_TRUNC); });
    row("cutting the mesh by name", Needs::Calls,
        [meshName] { return ::truncate(meshName.constData(), 0) == 0; });
    row("removing the mesh", Needs::Calls, [meshName] { return ::unlink(meshName.constData()) == 0; });
    row("renaming the mesh", Needs::Calls,
        [meshName] { return ::rename(meshName.constData(), (meshName + "x").constData()) == 0; });
    row("its permissions", Needs::Calls, [meshName] { return ::chmod(meshName.constData(), 0600) == 0; });
    row("a new folder", Needs::Calls,
        [this] { return ::mkdir(QFile::encodeName(in("meshes/new")).constData(), 0700) == 0; });
}

void SandboxTest::forbiddenCalls() {
    const auto row = [](const char* title, const Deed& deed) {
        QTest::newRow(title) << Needs::Calls << deed;
    };
    row("network", [] { return ::socket(AF_INET, SOCK_STREAM, 0) >= 0; });
    row("network of IPv6", [] { return ::socket(AF_INET6, SOCK_DGRAM, 0) >= 0; });
    row("local socket", [] { return ::socket(AF_UNIX, SOCK_STREAM, 0) >= 0; });
    row("kernel's socket", [] { return ::socket(AF_NETLINK, SOCK_RAW, 0) >= 0; });
    row("program", startsProgram);
    row("process", forks);
    row("process by clone3", [] {
        std::uint64_t arguments[8] = {};
        arguments[4] = SIGCHLD;
        const long child = ::syscall(SYS_clone3, arguments, sizeof arguments);
        if (child == 0) {
            ::_exit(0);
        }
        return child > 0;
    });
    row("signal", [] { return ::kill(::getppid(), 0) == 0; });
    row("signal to a thread", [] { return calls(SYS_tgkill, ::getppid(), ::getppid(), 0); });
    row("another's memory", [] {
        char byte = 0;
        iovec part{&byte, 1};
        return ::syscall(SYS_process_vm_readv, ::getpid(), &part, 1, &part, 1, 0) >= 0;
    });
    row("tracing", [] { return ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0; });
    row("open by openat2", [this] {
        std::uint64_t how[3] = {O_RDONLY, 0, 0};
        return calls(SYS_openat2, AT_FDCWD, QFile::encodeName(mesh()).constData(), how, sizeof how);
    });
    row("rings of calls", [] {
        char parameters[256] = {};
        return calls(SYS_io_uring_setup, 1, parameters);
    });
    row("programs of the kernel", [] {
        bpf_attr attributes{};
        attributes.map_type = BPF_MAP_TYPE_ARRAY;
        attributes.key_size = 4;
        attributes.value_size = 4;
        attributes.max_entries = 1;
        return calls(SYS_bpf, BPF_MAP_CREATE, &attributes, sizeof attributes);
    });
    row("mount", [this] {
        return ::mount("none", QFile::encodeName(in("meshes")).constData(), "tmpfs", 0, nullptr) == 0;
    });
    row("page faults of one's own", [] { return calls(SYS_userfaultfd, O_CLOEXEC | 1); });
    row("keys", [] { return calls(SYS_keyctl, 0, -3, 1); });
    row("name spaces", [] { return ::unshare(CLONE_NEWUSER) == 0; });
    row("more room", [] {
        rlimit now{};
        return ::getrlimit(RLIMIT_NOFILE, &now) == 0 && ::setrlimit(RLIMIT_NOFILE, &now) == 0;
    });
}

void SandboxTest::forbidden_data() {
    QTest::addColumn<Needs>("needs");
    QTest::addColumn<Deed>("deed");
    prepare();
    forbiddenFiles();
    forbiddenCalls();
}

void SandboxTest::forbidden() {
    QFETCH(Needs, needs);
    QFETCH(Deed, deed);
    const Outcome outcome = tryLocked(mesh(), needs, deed);
    if (outcome == NotLocked) {
        QSKIP("This kernel has no such lock.");
    }
    QCOMPARE(outcome, CouldNot);
    QCOMPARE(readFile(mesh()), std::string("v 0 0 0\n"));
}

void SandboxTest::allowed_data() {
    QTest::addColumn<Deed>("deed");
    prepare();
    const auto row = [](const char* title, const Deed& deed) { QTest::newRow(title) << deed; };
    row("the mesh", [this] { return readFile(mesh()) == "v 0 0 0\n"; });
    row("a file below", [this] { return readFile(in("meshes/below/b.mtl")) == "newmtl b\n"; });
    row("the folder's list", [this] { return QDir(in("meshes")).entryList(QDir::Files).size() >= 1; });
    row("what is open", [] {
        int ends[2] = {};
        return ::pipe(ends) == 0 && ::write(ends[1], "x", 1) == 1;
    });
    row("memory", [] { return std::vector<char>(100'000'000, 'x').back() == 'x'; });
    row("a thread", makesThread);
    row("a clock", [] { return ::clock() >= 0 && ::time(nullptr) > 0; });
    QImage picture(3000, 100, QImage::Format_RGB32);
    picture.fill(Qt::red);
    for (const char* const format : {"png", "jpg", "bmp"}) {
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        picture.save(&buffer, format);
        row(format, [bytes = buffer.data()] { return decodes(bytes); });
    }
}

void SandboxTest::allowed() {
    QFETCH(Deed, deed);
    QCOMPARE(tryLocked(mesh(), Needs::Nothing, deed), Could);
}

/// It waits for somebody to read its answer from a pipe, long enough to be looked at.
void SandboxTest::workerIsLocked() {
    if (tryLocked(mesh(), Needs::Calls, [] { return true; }) == NotLocked) {
        QSKIP("This kernel has no filter for system calls.");
    }
    std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    for (int v = 0; v < 20000; ++v) {
        obj += "v 1 2 3\n";
    }
    int ends[2] = {};
    QCOMPARE(::pipe2(ends, O_CLOEXEC), 0);
    QProcess worker;
    worker.setChildProcessModifier([&ends] { ::dup2(ends[1], STDIN_FILENO); });
    worker.start(importWorkerPath(), {writeFile(m_folder.path(), QStringLiteral("large.obj"), obj),
                                      QStringLiteral("100"), QString::number(1 << 30)});
    QVERIFY(worker.waitForStarted());
    char first = 0;
    QCOMPARE(::read(ends[0], &first, 1), 1);
    QCOMPARE(first, 'H');
    const std::string status = readFile(QStringLiteral("/proc/%1/status").arg(worker.processId()));
    QVERIFY2(status.find("NoNewPrivs:\t1") != std::string::npos, status.c_str());
    QVERIFY2(status.find("Seccomp:\t2") != std::string::npos, status.c_str());
    worker.kill();
    worker.waitForFinished();
    ::close(ends[0]);
    ::close(ends[1]);
}

HITSCOPE_TEST(SandboxTest, QCoreApplication)

}  // namespace hitscope::io_sandbox_test

#include "io_sandbox_test.moc"
