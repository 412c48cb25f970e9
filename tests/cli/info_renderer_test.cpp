// SPDX-License-Identifier: GPL-3.0-or-later
// `hitscope-cli info --renderer` as a person runs it, with no display.
#include <QProcess>
#include <QtTest>

#include "support/test_program.h"

namespace {

struct Run {
    int status = -1;
    QString out;
    QString err;
};

Run runInfo(const QStringList& arguments) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("DISPLAY"));
    environment.remove(QStringLiteral("WAYLAND_DISPLAY"));
    process.setProcessEnvironment(environment);
    process.start(qEnvironmentVariable("HITSCOPE_CLI"), QStringList{QStringLiteral("info")} + arguments);
    Run run;
    if (process.waitForFinished(100000) && process.exitStatus() == QProcess::NormalExit) {
        run.status = process.exitCode();
    }
    run.out = QString::fromUtf8(process.readAllStandardOutput());
    run.err = QString::fromUtf8(process.readAllStandardError());
    return run;
}

}  // namespace

class InfoRendererTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void saysWhatDrawsAndHowExactly() {
        const Run run = runInfo({QStringLiteral("--renderer")});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QVERIFY2(run.err.isEmpty(), qPrintable(run.err));
        const auto value = [&run](const QString& name) {
            const QRegularExpression row(QStringLiteral("^ *%1  +(.*)$").arg(name),
                                         QRegularExpression::MultilineOption);
            return row.match(run.out).captured(1).trimmed();
        };
        QVERIFY(!value(QStringLiteral("renderer")).isEmpty());
        QVERIFY(!value(QStringLiteral("vendor")).isEmpty());
        QVERIFY(value(QStringLiteral("OpenGL")).at(0).isDigit());
        const int hits = value(QStringLiteral("hits in uniform arrays")).toInt();
        QVERIFY(hits >= 4 && hits <= 600);
        QVERIFY2(value(QStringLiteral("deformation")).contains(QStringLiteral("bit-exact: ")),
                 qPrintable(run.out));
        QCOMPARE(run.out.count(QLatin1Char('\n')), 5);
    }

    void helpNamesIt() {
        const Run run = runInfo({QStringLiteral("--help")});
        QCOMPARE(run.status, 0);
        QVERIFY(run.out.contains(QStringLiteral("--renderer")));
    }

    void standsAlone() {
        const Run run = runInfo({QStringLiteral("--renderer"), QStringLiteral("mesh.obj")});
        QCOMPARE(run.status, 2);
        QVERIFY(run.out.isEmpty());
        QVERIFY(run.err.contains(QStringLiteral("--renderer alone")));
    }
};

HITSCOPE_TEST(InfoRendererTest, QCoreApplication)
#include "info_renderer_test.moc"
