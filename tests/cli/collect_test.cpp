// SPDX-License-Identifier: GPL-3.0-or-later
// A session put into a folder by hitscope-cli.
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include "cli/run_cli.h"
#include "support/test_program.h"

namespace hitscope::collect_test {

using namespace test;

class CollectCommandTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("work/meshes")));
        write("work/meshes/rock.obj",
              "mtllib rock.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\n");
        write("work/meshes/rock.mtl", "newmtl stone\nKd 1 0 0\n");
        session("meshes/rock.obj", "");
    }

    /// By the path from the session's folder, wherever that is.
    void collects() {
        const CliRun run = collect({in("work/one.hitscope"), in("out")});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QVERIFY(run.err.isEmpty());
        QCOMPARE(read("out/meshes/rock/rock.obj"), read("work/meshes/rock.obj"));
        QCOMPARE(read("out/meshes/rock/rock.mtl"), read("work/meshes/rock.mtl"));
        QVERIFY(QDir(in("work")).removeRecursively());
        QVERIFY(QDir(m_folder->path()).rename(QStringLiteral("out"), QStringLiteral("moved")));
        const CliRun again = collect({in("moved/one.hitscope"), in("third")});
        QVERIFY2(again.status == 0, qPrintable(again.err));
        QVERIFY(QFileInfo(in("third/meshes/rock/rock.obj")).isFile());
    }

    void saysWhatIsWrong() {
        QCOMPARE(collect({in("work/one.hitscope")}).status, 2);
        QVERIFY(collect({in("work/one.hitscope"), in("out")}).status == 0);
        const CliRun again = collect({in("work/one.hitscope"), in("out")});
        QCOMPARE(again.status, 3);
        QVERIFY2(again.err.contains(in("out/one.hitscope")), qPrintable(again.err));
        session("meshes/gone.obj", "");
        const CliRun gone = collect({in("work/one.hitscope"), in("other")});
        QCOMPARE(gone.status, 3);
        QVERIFY2(gone.err.contains(QStringLiteral("gone.obj")), qPrintable(gone.err));
        session("meshes/rock.obj", "\"sha256\": \"" + QByteArray(64, 'a') + "\", ");
        const CliRun changed = collect({in("work/one.hitscope"), in("other")});
        QCOMPARE(changed.status, 3);
        QVERIFY2(changed.err.contains(QStringLiteral("have changed")), qPrintable(changed.err));
        QVERIFY(!QFileInfo::exists(in("other")));
    }

private:
    [[nodiscard]] QString in(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    void write(const char* name, const QByteArray& content) const {
        QFile file(in(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
    }
    [[nodiscard]] QByteArray read(const char* name) const {
        QFile file(in(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void session(const QByteArray& mesh, const QByteArray& more) const {
        write("work/one.hitscope",
              "{\"format\": \"hitscope session\", \"version\": 1, \"targets\": [{\"id\": 1, \"name\": "
              "\"Rock\", "
              "\"source\": {\"kind\": \"file\", " +
                  more + "\"path\": \"/nowhere/" + mesh + "\", \"relative_path\": \"" + mesh + "\"}}]}\n");
    }
    static CliRun collect(const QStringList& arguments) {
        return runCli(QStringList{QStringLiteral("collect")} + arguments);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

HITSCOPE_TEST(CollectCommandTest, QCoreApplication)

}  // namespace hitscope::collect_test

#include "collect_test.moc"
