// SPDX-License-Identifier: GPL-3.0-or-later
// A session's hits, applied again by hitscope-cli.
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "cli/run_cli.h"
#include "support/test_program.h"

namespace hitscope::replay_test {

using namespace test;

namespace {

QString printOf(const CliRun& run, const QString& what) {
    return QRegularExpression(QStringLiteral("fingerprint ([0-9a-f]{16}) of the ") + what)
        .match(run.out)
        .captured(1);
}

}  // namespace

class ReplayTest : public QObject {
    Q_OBJECT

private:
    const QTemporaryDir m_folder;
    QByteArray m_session;

    QString write(const char* name, const QByteArray& content) const {
        const QString path = m_folder.filePath(QLatin1String(name));
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) {
            qFatal("%s", qPrintable(file.errorString()));
        }
        return path;
    }
    /// With what is known of the positions; empty: nothing.
    QString session(const QByteArray& print) const {
        QByteArray bytes = m_session;
        return write("a.hitscope",
                     bytes.replace("POSITIONS", print.isEmpty()
                                                    ? QByteArray()
                                                    : "{\"target\": 4, \"fingerprint\": \"" + print + "\"}"));
    }
    static CliRun replay(const QStringList& arguments) { return runCli(QStringList{"replay"} + arguments); }

private Q_SLOTS:
    void initTestCase() {
        QByteArray hits;
        for (int i = 0; i < 25; ++i) {
            const QByteArray x = QByteArray::number(-0.9 + 0.07 * i);
            hits += (i == 0 ? "" : ",\n") + QByteArray("{\"target\": 4, \"point\": [") + x +
                    ", 0.3, 0.9], \"direction\": [0, 0, -1]}";
        }
        m_session =
            "{\"format\": \"hitscope session\", \"version\": 1,\n"
            "\"targets\": [{\"id\": 4, \"name\": \"Ball\", \"source\": {\"kind\": \"primitive\", "
            "\"shape\": \"uv-sphere\", \"resolution\": 40, \"size\": 2}}],\n"
            "\"positions\": [POSITIONS],\n\"hits\": [" +
            hits + "]}\n";
    }

    void samePositionsByEveryPipeline() {
        const CliRun first = replay({session({}), "--pipeline", "reference"});
        QVERIFY2(first.status == 0, qPrintable(first.err));
        QVERIFY(first.out.contains("25 of 25 hits on 1 target\n"));
        QVERIFY(first.out.contains("no positions of these hits to compare with"));
        const QString positions = printOf(first, "positions");
        QCOMPARE(positions.size(), 16);
        const QString file = session(positions.toLatin1());
        for (const char* pipeline :
             {"reference", "transform-feedback", "uniform-array", "uniform-array-culled"}) {
            const CliRun run = replay({file, "--pipeline", pipeline});
            if (run.status != 0) {
                // Only where this renderer is not exact.
                QVERIFY2(run.err.contains("not exact on this renderer"), qPrintable(run.err));
                continue;
            }
            QVERIFY(run.out.contains("the positions are those that were saved"));
            QCOMPARE(printOf(run, "hits"), printOf(first, "hits"));
        }
    }

    void otherPositionsAreAnError() {
        const CliRun run = replay({session("0123456789abcdef"), "--pipeline", "reference"});
        for (const QStringList& more :
             {QStringList{"changes"}, {"export", "--out", m_folder.filePath("differs.obj")}}) {
            const CliRun noted =
                runCli(more + QStringList{"--pipeline", "reference", m_folder.filePath("a.hitscope")});
            QCOMPARE(noted.status, 0);
            QVERIFY2(noted.err.contains(QStringLiteral("not those that were saved, on Ball")),
                     qPrintable(noted.err));
        }
        QCOMPARE(run.status, 1);
        QVERIFY2(run.err.contains("The positions are not those that were saved, on Ball."),
                 qPrintable(run.err));
    }

    void untilAndOut() {
        const QString file = session("0123456789abcdef");
        const QString out = m_folder.filePath("out.obj");
        const CliRun some = replay({file, "--until", "10", "--pipeline", "reference", "--out", out});
        QVERIFY2(some.status == 0, qPrintable(some.err));  // others were saved: nothing to compare with
        QVERIFY(some.out.contains("10 of 25 hits"));
        QVERIFY(QFile(out).size() > 1000);
        const CliRun none = replay({file, "--until", "0", "--pipeline", "reference"});
        QCOMPARE(none.status, 0);
        QVERIFY(printOf(none, "positions") != printOf(some, "positions"));
        QCOMPARE(replay({file, "--until", "26"}).status, 3);
    }

    void meshFile() {
        write("rock.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
        const QByteArray bytes =
            "{\"format\": \"hitscope session\", \"version\": 1, \"targets\": [{\"id\": 1, \"source\": "
            "{\"kind\": "
            "\"file\", \"path\": \"/nowhere/rock.obj\", \"relative_path\": \"rock.obj\", \"sha256\": \"" +
            QByteArray(64, '0') + "\"}}]}";
        const CliRun beside = replay({write("b.hitscope", bytes), "--pipeline", "reference"});
        QVERIFY2(beside.status == 0, qPrintable(beside.err));
        QVERIFY(beside.err.contains("The mesh has changed since the session was saved"));
        QVERIFY(QFile::remove(m_folder.filePath("rock.obj")));
        const CliRun gone = replay({m_folder.filePath("b.hitscope")});
        QCOMPARE(gone.status, 3);
        QVERIFY2(gone.err.contains("/nowhere/rock.obj: The mesh of this session is not there."),
                 qPrintable(gone.err));
    }

    void wrongUsage() {
        QCOMPARE(replay({}).status, 2);
        QCOMPARE(replay({"a", "b"}).status, 2);
        QCOMPARE(replay({"a", "--pipeline", "magic"}).status, 2);
        QCOMPARE(replay({"a", "--until", "-1"}).status, 2);
        QVERIFY(replay({m_folder.filePath("none.hitscope")}).err.contains("There is no such file."));
        const CliRun bad = replay({write("bad.hitscope", "{\n\"format\": 3}")});
        QCOMPARE(bad.status, 3);
        QVERIFY2(bad.err.contains("bad.hitscope, line 2, format: It has to be a text."), qPrintable(bad.err));
    }
};

HITSCOPE_TEST(ReplayTest, QCoreApplication)

}  // namespace hitscope::replay_test

#include "replay_test.moc"
