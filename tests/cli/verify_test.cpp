// SPDX-License-Identifier: GPL-3.0-or-later
// Hits and meshes in and out of hitscope-cli, and what it says of a renderer that does not deform exactly.
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <numbers>

#include "cli/run_cli.h"
#include "support/test_program.h"

namespace hitscope::verify_test {

using namespace test;

namespace {

/// Mesa's llvmpipe without the instructions that divide and take roots exactly.
const std::vector<std::pair<QString, QString>> kInexact{
    {QStringLiteral("LIBGL_ALWAYS_SOFTWARE"), QStringLiteral("1")},
    {QStringLiteral("GALLIUM_OVERRIDE_CPU_CAPS"), QStringLiteral("nosse")}};

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QString printOf(const CliRun& run, const QString& what) {
    return QRegularExpression(QStringLiteral("fingerprint ([0-9a-f]{16}) of the ") + what)
        .match(run.out)
        .captured(1);
}

}  // namespace

class VerifyTest : public QObject {
    Q_OBJECT

private:
    const QTemporaryDir m_folder;

    QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    CliRun run(QStringList arguments, bool isInexact = false) const {
        return runCli(arguments << path("ball.obj"),
                      isInexact ? kInexact : std::vector<std::pair<QString, QString>>());
    }
    CliRun burst(const QStringList& more) const {
        return run(QStringList{"shoot", "--burst", "30", "--cone", "9", "--seed", "4"} + more);
    }

private Q_SLOTS:
    void initTestCase() {
        constexpr int kAround = 40;
        constexpr int kDown = 24;
        QFile file(path("ball.obj"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QTextStream out(&file);
        for (int j = 1; j < kDown; ++j) {
            for (int i = 0; i < kAround; ++i) {
                const double a = 2.0 * std::numbers::pi * i / kAround;
                const double b = std::numbers::pi * j / kDown;
                out << "v " << 2.0 * std::cos(a) * std::sin(b) << ' ' << 2.0 * std::cos(b) << ' '
                    << 2.0 * std::sin(a) * std::sin(b) << '\n';
            }
        }
        for (int j = 0; j + 2 < kDown; ++j) {
            for (int i = 0; i < kAround; ++i) {
                const int a = j * kAround + i + 1;
                const int b = j * kAround + (i + 1) % kAround + 1;
                out << "f " << a << ' ' << b << ' ' << b + kAround << ' ' << a + kAround << '\n';
            }
        }
    }

    // What was shot, saved as hits and applied again, is the same mesh with the same fingerprints.
    void hitsComeBack() {
        const CliRun shot = burst({"--hits-out", path("hits.csv"), "--out", path("shot.obj")});
        QVERIFY2(shot.status == 0, qPrintable(shot.err));
        QVERIFY(shot.out.startsWith(QStringLiteral("30 shots, 30 hits\n")));
        const CliRun again = run(
            {"shoot", "--hits", path("hits.csv"), "--hits-out", path("hits.json"), "--out", path("b.obj")});
        QVERIFY2(again.status == 0, qPrintable(again.err));
        QVERIFY(again.out.startsWith(QStringLiteral("0 shots, 30 hits\n")));
        const CliRun fromJson =
            run({"shoot", "--hits", path("hits.json"), "--hits-out", path("c.csv"), "--out", path("c.obj")});
        QVERIFY2(fromJson.status == 0, qPrintable(fromJson.err));
        for (const char* what : {"hits", "positions"}) {
            const QString name = QString::fromLatin1(what);
            QVERIFY(!printOf(shot, name).isEmpty());
            QCOMPARE(printOf(again, name), printOf(shot, name));
            QCOMPARE(printOf(fromJson, name), printOf(shot, name));
        }
        QVERIFY(contentOf(path("shot.obj")).contains("\nf "));
        QCOMPARE(contentOf(path("b.obj")), contentOf(path("shot.obj")));
        QCOMPARE(contentOf(path("c.obj")), contentOf(path("shot.obj")));
        QVERIFY(contentOf(path("hits.json")).startsWith('{'));
        QCOMPARE(contentOf(path("c.csv")), contentOf(path("hits.csv")));
    }

    // Hits of a file come first, and shots after them.
    void shotsFollowHits() {
        QVERIFY(burst({"--hits-out", path("first.csv")}).status == 0);
        const CliRun both = burst({"--hits", path("first.csv"), "--hits-out", path("both.csv")});
        QVERIFY2(both.status == 0, qPrintable(both.err));
        QVERIFY(both.out.startsWith(QStringLiteral("30 shots, 30 hits; 60 hits in all\n")));
        const auto pointsOf = [](const QByteArray& table, int first) {
            return table.split('\n').mid(first, 30);
        };
        QCOMPARE(pointsOf(contentOf(path("both.csv")), 1), pointsOf(contentOf(path("first.csv")), 1));
    }

    void everyPipelineHasALine() {
        QVERIFY(burst({"--hits-out", path("all.csv")}).status == 0);
        const CliRun verified = run({"verify", "--hits", path("all.csv")});
        const CliRun shot = burst({});
        QCOMPARE(verified.status, verified.out.contains(QStringLiteral("differ from the reference")) ? 1 : 0);
        for (const char* name :
             {"Uniform array", "Uniform array, culled", "Transform feedback", "Compute", "Reference"}) {
            const QRegularExpression line(
                QStringLiteral("^%1: (.*; positions [0-9a-f]{16}|not here\\. .+)$").arg(QLatin1String(name)),
                QRegularExpression::MultilineOption);
            QVERIFY2(line.match(verified.out).hasMatch(), qPrintable(verified.out));
        }
        QVERIFY(verified.out.contains(
            QStringLiteral("Reference: as every hit at every vertex, in every bit; positions ")));
        QVERIFY(verified.out.contains(QStringLiteral("30 hits, fingerprint ") +
                                      printOf(shot, QStringLiteral("hits"))));
    }

    void hitsComeFromTheStandardInput() {
        QVERIFY(burst({"--hits-out", path("piped.csv")}).status == 0);
        const auto piped = [this](const char* file) {
            QProcess process;
            process.setStandardInputFile(path(file));
            process.start(qEnvironmentVariable("HITSCOPE_CLI"), {"verify", "--hits", "-", path("ball.obj")});
            process.waitForFinished(100'000);
            return process.readAllStandardOutput() + process.readAllStandardError();
        };
        const CliRun named = run({"verify", "--hits", path("piped.csv")});
        QCOMPARE(QString::fromUtf8(piped("piped.csv")), named.out + named.err);
        QVERIFY(piped("ball.obj").contains("standard input, line 1"));
    }

    // Shots at a session that has hits: these are no hits of the shots.
    void hitsOfASessionAreNotThoseOfShots() {
        QVERIFY(burst({"--session", path("dents.hitscope")}).status == 0);
        const auto shootAt = [this](const char* at) {
            const QStringList shot{"shoot", "--at", at, "--direction", "0,0,-1", path("dents.hitscope")};
            const CliRun made = runCli(shot + QStringList{"--report", path("r.json")});
            const QJsonObject report = QJsonDocument::fromJson(contentOf(path("r.json"))).object();
            return std::pair(made, QList<int>{report["shots"].toInt(), report["new_hits"].toInt(),
                                              report["hits"].toInt()});
        };
        const auto [missed, none] = shootAt("50,50,50");
        QVERIFY2(missed.out.startsWith(QStringLiteral("1 shot, 0 hits; 30 hits in all\n")),
                 qPrintable(missed.out));
        QVERIFY2(missed.err.contains(QStringLiteral("No shot hit a target.")), qPrintable(missed.err));
        QCOMPARE(none, (QList<int>{1, 0, 30}));
        const auto [struck, one] = shootAt("0,0,0");
        QVERIFY2(struck.out.startsWith(QStringLiteral("1 shot, 1 hit; 31 hits in all\n")),
                 qPrintable(struck.out));
        QVERIFY(!struck.err.contains(QStringLiteral("No shot")));
        QCOMPARE(one, (QList<int>{1, 1, 31}));
    }

    void pipelineIsChosen() {
        const CliRun byReference = burst({"--pipeline", "reference"});
        QVERIFY2(byReference.status == 0, qPrintable(byReference.err));
        QVERIFY(byReference.out.contains(QStringLiteral("of the positions, by Reference\n")));
        const CliRun byUniforms = burst({"--pipeline", "uniform-array"});
        QCOMPARE(printOf(byUniforms, QStringLiteral("hits")), printOf(byReference, QStringLiteral("hits")));
        QCOMPARE(burst({"--pipeline", "magic"}).status, 2);
    }

    // The files are written, and the exit status and one line say that they are not the reference's.
    void inexactResultsFail() {
        QVERIFY(burst({"--hits-out", path("in.csv"), "--pipeline", "reference", "--out", path("right.obj")})
                    .status == 0);
        const CliRun verified = run({"verify", "--hits", path("in.csv")}, true);
        if (verified.status == 0 && !isMadeInexact()) {
            QSKIP("no renderer here deforms inexactly");
        }
        QCOMPARE(verified.status, 1);
        QVERIFY2(verified.err.contains(QStringLiteral("Transform feedback")), qPrintable(verified.err));
        QVERIFY2(
            verified.out.contains(QRegularExpression(
                QStringLiteral(
                    "^Transform feedback: [0-9]+ of 920 vertices differ from the reference, by [0-9.e-]+ m"),
                QRegularExpression::MultilineOption)),
            qPrintable(verified.out));
        // Nobody gets it unasked.
        const CliRun unasked = run({"shoot", "--hits", path("in.csv"), "--out", path("unasked.obj")}, true);
        QVERIFY2(unasked.status == 0, qPrintable(unasked.err));
        QCOMPARE(contentOf(path("unasked.obj")), contentOf(path("right.obj")));
        const CliRun shot = run({"shoot", "--hits", path("in.csv"), "--pipeline", "transform-feedback",
                                 "--out", path("wrong.obj")},
                                true);
        QCOMPARE(shot.status, 1);
        QCOMPARE(shot.err.count(QLatin1Char('\n')), 2);  // what the pipeline is here, and what was written
        QVERIFY2(shot.err.contains(QStringLiteral("wrong.obj: The mesh is not what the reference makes")),
                 qPrintable(shot.err));
        QVERIFY(!contentOf(path("wrong.obj")).isEmpty());
        QVERIFY(contentOf(path("wrong.obj")) != contentOf(path("right.obj")));
        const CliRun right =
            run({"shoot", "--hits", path("in.csv"), "--pipeline", "reference", "--out", path("r.obj")}, true);
        QVERIFY2(right.status == 0, qPrintable(right.err));
        QCOMPARE(contentOf(path("r.obj")), contentOf(path("right.obj")));
        const CliRun demo =
            run({"demo", "--shots", "30", "--pipeline", "transform-feedback", "--out", path("demo")}, true);
        QCOMPARE(demo.status, 1);
        QVERIFY2(demo.err.contains(QStringLiteral("deformed.obj: The mesh is not what the reference makes")),
                 qPrintable(demo.err));
        QVERIFY(!contentOf(path("demo/deformed.obj")).isEmpty());
        QVERIFY(demo.out.contains(QStringLiteral("fingerprint ")));
    }

    void wrongUsageIsSaid() {
        QCOMPARE(run({"verify"}).status, 2);
        QCOMPARE(run({"verify", "--hits", "a.csv", "two.obj"}).status, 2);
        const CliRun missing = run({"verify", "--hits", "/nowhere/hits.csv"});
        QCOMPARE(missing.status, 3);
        QVERIFY(missing.err.contains(QStringLiteral("/nowhere/hits.csv")));
        QFile other(path("other.csv"));
        QVERIFY(other.open(QIODevice::WriteOnly));
        other.write("not hits\n");
        other.close();
        const CliRun unread = run({"shoot", "--hits", other.fileName()});
        QCOMPARE(unread.status, 3);
        QVERIFY2(unread.err.contains(QStringLiteral("other.csv, line 1")), qPrintable(unread.err));
    }
};

HITSCOPE_TEST(VerifyTest, QCoreApplication)

}  // namespace hitscope::verify_test

#include "verify_test.moc"
