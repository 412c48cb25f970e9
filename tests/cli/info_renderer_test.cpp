// SPDX-License-Identifier: GPL-3.0-or-later
// `hitscope-cli info --renderer` as a person runs it, with no display.
#include <QTest>

#include "cli/run_cli.h"
#include "support/test_program.h"

using namespace hitscope::test;

namespace {

CliRun runInfo(const QStringList& arguments) {
    return runCli(QStringList{QStringLiteral("info")} + arguments);
}

}  // namespace

class InfoRendererTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void saysWhatDrawsAndHowExactly() {
        const CliRun run = runInfo({QStringLiteral("--renderer")});
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
        QVERIFY(value(QStringLiteral("GLSL")).at(0).isDigit());
        for (const char* limit :
             {"uniform components", "uniform blocks", "transform feedback", "texture size"}) {
            QVERIFY2(value(QString::fromLatin1(limit)).at(0).isDigit(), limit);
        }
        for (const char* named :
             {"storage buffers", "compute shaders", "timer queries", "largest difference"}) {
            QVERIFY2(!value(QString::fromLatin1(named)).isEmpty(), named);
        }
        QVERIFY(value(QStringLiteral("vertices compared")).remove(QLatin1Char(',')).toInt() > 1000);
        QCOMPARE(value(QStringLiteral("Transform feedback")), QStringLiteral("available"));
        const QString compute = value(QStringLiteral("Compute"));
        QVERIFY(compute == QStringLiteral("available") || compute.contains(QStringLiteral("OpenGL 4.3")));
    }

    void helpNamesIt() {
        const CliRun run = runInfo({QStringLiteral("--help")});
        QCOMPARE(run.status, 0);
        QVERIFY(run.out.contains(QStringLiteral("--renderer")));
    }

    void standsAlone() {
        const CliRun run = runInfo({QStringLiteral("--renderer"), QStringLiteral("mesh.obj")});
        QCOMPARE(run.status, 2);
        QVERIFY(run.out.isEmpty());
        QVERIFY(run.err.contains(QStringLiteral("--renderer alone")));
    }
};

HITSCOPE_TEST(InfoRendererTest, QCoreApplication)
#include "info_renderer_test.moc"
