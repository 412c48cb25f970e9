// SPDX-License-Identifier: GPL-3.0-or-later
// Command lines that say something other than what was meant are refused before anything is done.
#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "cli/run_cli.h"
#include "cli/scene_files.h"
#include "support/test_program.h"

namespace hitscope::arguments_test {

using namespace test;

class ArgumentsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void wrong_data();
    void wrong();
    void planesMayHaveAMinus();

private:
    [[nodiscard]] QString in(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    QTemporaryDir m_folder;
};

void ArgumentsTest::initTestCase() {
    writeBytes(in("ball.obj"), ballObj());
    const CliRun made = runCli({"shoot", "--pipeline", "reference", "--at", "0,0,0", "--session",
                                in("one.hitscope"), in("ball.obj")});
    QVERIFY2(made.status == 0, qPrintable(made.err));
}

/// In a line, @ stands for the tests' folder and '' for an empty word.
void ArgumentsTest::wrong_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* line, const char* says) {
        QTest::newRow(line) << QString::fromLatin1(line) << QString::fromLatin1(says);
    };
    // An empty word: as a rule a shell's variable that is not set.
    row("shoot --random 1 --out @d.obj ''", "the argument MESH|SESSION of shoot is empty");
    row("shoot --random 1 --hits '' @ball.obj", "--hits is empty");
    row("shoot --random 1 --out '' @ball.obj", "--out is empty");
    row("shoot --random 1 --session= @ball.obj", "--session is empty");
    row("shoot --random 1 --session @a.hitscope --session= @ball.obj", "--session is empty");
    row("shoot --max-distance= @ball.obj", "--max-distance is empty");
    row("export --target '' --out @a.obj @one.hitscope", "--target is empty");
    row("compare @ball.obj ''", "the argument B of compare is empty");
    row("compare '' @ball.obj", "the argument A of compare is empty; give it a value.");
    row("collect @one.hitscope ''", "the argument FOLDER of collect is empty");
    row("sequence --turntable 2 '' @ball.obj", "the argument FOLDER|FILM of sequence is empty");
    row("picture @a.png ''", "the argument MESH|SESSION of picture is empty");
    row("demo --out '' @ball.obj", "--out is empty");
    row("info @ball.obj ''", "the argument MESH|SESSION of info is empty");
    row("sweep --out '' @plan.json", "--out is empty");
    row("help ''", "the argument VERB of help is empty");
    // What has no effect.
    row("export --check --format csv --out @a.csv @one.hitscope", "--check goes with");
    row("shoot --script @s.json --speed 5", "--speed is not for --script");
    row("shoot --script @s.json --flight instant", "--flight is not for --script");
    row("shoot --at 0,0,0 --every 1 @ball.obj", "--every is not for --at");
    row("shoot --scatter 5 --mass 2 @ball.obj", "--mass goes with shots");
    row("sequence --turntable 2 @new.png @ball.obj", "new.png names a picture");
    row("shoot --randm 3 @ball.obj", "Did you mean --random?");
    row("shoot -random 3 @ball.obj", "Did you mean --random?");
    row("shoot --max_distance=3 @ball.obj", "Did you mean --max-distance?");
    row("export --steps 3 --out @a.obj @one.hitscope", "--steps goes with");
    row("export --all-normals --out @a.ply @one.hitscope", "--all-normals goes with");
    row("convert --all-normals @ball.obj @a.glb", "--all-normals goes with");
    for (const char* const option : {"--range 0,1", "--colour-map cividis", "--isolines", "--no-labels"}) {
        row(qPrintable(QStringLiteral("picture %1 @a.png @ball.obj").arg(option)), "goes with --change");
        row(qPrintable(QStringLiteral("picture %1 @a.png @one.hitscope").arg(option)), "goes with --change");
    }
    row("picture --fill-cut @a.png @ball.obj", "--fill-cut goes with --cut");
    row("picture --fill-cut @a.png @one.hitscope", "--fill-cut goes with --cut");
    row("picture --seed 3 @a.png @ball.obj", "--seed goes with --shots");
    row("sequence --turntable 2 --fill-cut @frames @ball.obj", "--fill-cut goes with --cut");
    // No usable numbers.
    for (const char* const range :
         {"0,inf", "-inf,inf", "nan,1", "0,1e39", "-3e38,3e38", "1,0", "1", "0,1,5"}) {
        row(qPrintable(QStringLiteral("picture --change x --range=%1 @a.png @one.hitscope").arg(range)),
            "--range takes two numbers, the lower first");
    }
    for (const char* const scale : {"1e-320", "0", "nan", "inf", "1e400", "1,5"}) {
        row(qPrintable(QStringLiteral("convert --scale %1 @ball.obj @a.obj").arg(scale)),
            "--scale takes a number from 1e-30 to 1e+09.");
    }
    // A folder is no stream.
    row("demo --out - @ball.obj", "--out cannot be the standard output");
    row("sweep --out - @plan.json", "--out cannot be the standard output");
    row("sequence --turntable 2 - @ball.obj", "FOLDER|FILM cannot be the standard output");
    row("collect @one.hitscope -", "FOLDER cannot be the standard output");
}

void ArgumentsTest::wrong() {
    QFETCH(QString, line);
    QFETCH(QString, says);
    QStringList arguments = line.split(u' ');
    for (QString& argument : arguments) {
        argument.replace(u'@', m_folder.path() + u'/').remove(QStringLiteral("''"));
    }
    const QDir::Filters all = QDir::AllEntries | QDir::NoDotAndDotDot;
    const QStringList before = QDir(m_folder.path()).entryList(all);
    const CliRun run = runCli(arguments);
    QVERIFY2(run.status == 2, qPrintable(QString::number(run.status) + u'\n' + run.out + run.err));
    QVERIFY2(run.err.contains(says), qPrintable(run.err));
    QCOMPARE(QDir(m_folder.path()).entryList(all), before);
}

void ArgumentsTest::planesMayHaveAMinus() {
    const auto profile = [this](const QStringList& plane) {
        return runCli(QStringList{"section", "--csv", "-"} + plane + QStringList{in("one.hitscope")});
    };
    const CliRun plain = profile({"--plane", "x=0.25"});
    QVERIFY2(plain.status == 0, qPrintable(plain.err));
    QVERIFY(plain.out.count(u'\n') > 10);
    for (const QStringList& plane : {QStringList{"--plane", "-x=0.25"}, QStringList{"--plane=-x=0.25"}}) {
        const CliRun run = profile(plane);
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QCOMPARE(run.out, plain.out);
    }
    QVERIFY(profile({"--plane", "x=-0.25"}).out != plain.out);
    for (const char* const verb : {"section", "picture"}) {
        const QString help = runCli({verb, "--help"}).out.simplified();
        QVERIFY2(help.contains(QStringLiteral("-x=0.1")), qPrintable(help));
    }
}

HITSCOPE_TEST(ArgumentsTest, QCoreApplication)

}  // namespace hitscope::arguments_test

#include "arguments_test.moc"
