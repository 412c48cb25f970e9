// SPDX-License-Identifier: GPL-3.0-or-later
// Every example of the manual page, as a shell runs it.
#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "cli/run_cli.h"
#include "cli/scene_files.h"
#include "support/test_program.h"

namespace hitscope::examples_test {

using namespace test;

namespace {

/// The lines between .EX and .EE, as they are read.
QStringList examplesOf(const QString& page) {
    QStringList examples;
    bool isExample = false;
    for (QString line : page.split(u'\n')) {
        if (line == QStringLiteral(".EX") || line == QStringLiteral(".EE")) {
            isExample = line == QStringLiteral(".EX");
        } else if (isExample) {
            examples << line.replace(QStringLiteral("\\-"), QStringLiteral("-"))
                            .replace(QStringLiteral("\\(aq"), QStringLiteral("'"))
                            .replace(QStringLiteral("\\e"), QStringLiteral("\\"));
        }
    }
    return examples;
}

}  // namespace

class ExamplesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void examples_data();
    void examples();
    void pagesAreWellFormed();

private:
    CliRun shell(const QString& line) const;
    QTemporaryDir m_folder;
};

/// What examples name lies in their folder.
void ExamplesTest::initTestCase() {
    const auto in = [this](const char* name) { return m_folder.filePath(QLatin1String(name)); };
    writeBytes(in("bunny.obj"), ballObj());
    QVERIFY(QDir().mkpath(in("bin")));
    QVERIFY(QFile::link(qEnvironmentVariable("HITSCOPE_CLI"), in("bin/hitscope-cli")));
    writeBytes(in("plan.json"),
               "{\"hitscope-sweep\": 1, \"scenes\": [\"bunny.obj\"], \"options\": {\"random\": 3, \"seed\": "
               "[1, 2]}}");
    for (const QStringList& arguments :
         {QStringList{"convert", in("bunny.obj"), in("bunny.ply")},
          QStringList{"convert", in("bunny.obj"), in("part.ply")},
          QStringList{"convert", in("bunny.obj"), in("part.stl")},
          QStringList{"bench", "session", "--quick", "--hits", "50", "--quiet", "--report",
                      in("before.json")},
          QStringList{"bench", "session", "--quick", "--hits", "50", "--quiet", "--report", in("after.json")},
          QStringList{"shoot", "--random", "5", "--session", in("dents.hitscope"), "--hits-out",
                      in("hits.csv"), in("bunny.obj")}}) {
        const CliRun run = runCli(arguments);
        QVERIFY2(run.status == 0, qPrintable(run.err));
    }
}

CliRun ExamplesTest::shell(const QString& line) const {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("PATH"),
                       m_folder.filePath(QStringLiteral("bin:")) + environment.value(QStringLiteral("PATH")));
    environment.remove(QStringLiteral("DISPLAY"));
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(m_folder.path());
    process.start(QStringLiteral("bash"),
                  {QStringLiteral("-o"), QStringLiteral("pipefail"), QStringLiteral("-c"), line});
    CliRun run;
    if (process.waitForFinished(600'000) && process.exitStatus() == QProcess::NormalExit) {
        run.status = process.exitCode();
    }
    run.out = QString::fromUtf8(process.readAllStandardOutput());
    run.err = QString::fromUtf8(process.readAllStandardError());
    return run;
}

void ExamplesTest::examples_data() {
    QTest::addColumn<QString>("line");
    const QStringList lines = examplesOf(runCli({"help", "--man"}).out);
    QVERIFY(lines.size() > 20);
    for (const QString& line : lines) {
        QTest::newRow(qPrintable(line)) << line;
    }
}

void ExamplesTest::examples() {
    QFETCH(QString, line);
    for (const char* const program : {"parallel", "snakemake", "ffmpeg"}) {
        const bool needsIt =
            line.contains(QLatin1String(program)) ||
            (line.contains(QStringLiteral(".mp4")) && QLatin1String(program) == QLatin1String("ffmpeg"));
        if (needsIt && QStandardPaths::findExecutable(QLatin1String(program)).isEmpty()) {
            QSKIP(qPrintable(QStringLiteral("%1 is not installed here.").arg(QLatin1String(program))));
        }
    }
    const CliRun run = shell(line);
    // Two runs of a benchmark may differ, and where this renderer is not exact the verbs that compare say so.
    const bool mayDiffer =
        line.contains(QStringLiteral("bench compare")) ||
        (rendererReport().contains(QStringLiteral("not bit-exact")) &&
         (line.contains(QStringLiteral("compare")) || line.contains(QStringLiteral("verify"))));
    QVERIFY2(run.status == 0 || (mayDiffer && run.status == 1),
             qPrintable(QString::number(run.status) + u'\n' + run.err));
}

void ExamplesTest::pagesAreWellFormed() {
    if (QStandardPaths::findExecutable(QStringLiteral("man")).isEmpty()) {
        QSKIP("man is not installed here.");
    }
    for (const char* const program : {"hitscope", "hitscope-cli"}) {
        const CliRun run = shell(
            QStringLiteral("hitscope-cli help --man --program %1 > page.1 && man --warnings -l page.1 2>&1 "
                           ">/dev/null | cat")
                .arg(QLatin1String(program)));
        QVERIFY2(run.status == 0 && run.out.isEmpty(), qPrintable(run.out + run.err));
    }
}

HITSCOPE_TEST(ExamplesTest, QCoreApplication)

}  // namespace hitscope::examples_test

#include "examples_test.moc"
