// SPDX-License-Identifier: GPL-3.0-or-later
// `hitscope-cli info --renderer` as a person runs it, with no display.
#include <QTest>

#include "cli/run_cli.h"
#include "support/test_program.h"

namespace hitscope::info_renderer_test {

using namespace test;

namespace {

CliRun runInfo(const QStringList& arguments) {
    return runCli(QStringList{QStringLiteral("info")} + arguments);
}

/// Of a row of the report.
QString valueOf(const CliRun& run, const QString& name) {
    const QRegularExpression row(QStringLiteral("^ *%1  +(.*)$").arg(name),
                                 QRegularExpression::MultilineOption);
    return row.match(run.out).captured(1).trimmed();
}

using Environment = std::vector<std::pair<QString, QString>>;

/// Mesa's plainest renderer.
const Environment kSoftpipe{{QStringLiteral("GALLIUM_DRIVER"), QStringLiteral("softpipe")},
                            {QStringLiteral("LIBGL_ALWAYS_SOFTWARE"), QStringLiteral("1")}};
/// llvmpipe without what divides exactly.
const Environment kInexact{{QStringLiteral("GALLIUM_OVERRIDE_CPU_CAPS"), QStringLiteral("nosse")},
                           {QStringLiteral("LIBGL_ALWAYS_SOFTWARE"), QStringLiteral("1")}};

CliRun runInfoOn(const Environment& environment) {
    return runCli({QStringLiteral("info"), QStringLiteral("--renderer")}, environment);
}

}  // namespace

class InfoRendererTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void saysWhatDrawsAndHowExactly() {
        const CliRun run = runInfo({QStringLiteral("--renderer")});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QVERIFY2(run.err.isEmpty(), qPrintable(run.err));
        const auto value = [&run](const QString& name) { return valueOf(run, name); };
        QVERIFY(!value(QStringLiteral("renderer")).isEmpty());
        QVERIFY(!value(QStringLiteral("vendor")).isEmpty());
        QVERIFY(value(QStringLiteral("OpenGL")).at(0).isDigit());
        const int hits =
            value(QStringLiteral("hits in uniform arrays")).section(QLatin1Char(','), 0, 0).toInt();
        QVERIFY(hits >= 4 && hits <= 600);
        QCOMPARE(
            value(QStringLiteral("hits in uniform arrays")).contains(QStringLiteral("what the driver has")),
            hits < 600);
        QVERIFY2(value(QStringLiteral("deformation function")).contains(QStringLiteral("vertices")),
                 qPrintable(run.out));
        QVERIFY(value(QStringLiteral("picking")).startsWith(QStringLiteral("right in ")));
        QVERIFY(value(QStringLiteral("GLSL")).at(0).isDigit());
        for (const char* limit :
             {"uniform components", "uniform blocks", "transform feedback", "texture size"}) {
            QVERIFY2(value(QString::fromLatin1(limit)).at(0).isDigit(), limit);
        }
        for (const char* named :
             {"storage buffers", "compute shaders", "timer queries", "largest difference"}) {
            QVERIFY2(!value(QString::fromLatin1(named)).isEmpty(), named);
        }
        for (const char* pipeline :
             {"Uniform array", "Uniform array, culled", "Transform feedback", "Reference"}) {
            const QString verdict = value(QString::fromLatin1(pipeline));
            QVERIFY2(verdict.contains(QStringLiteral("bit-exact")), qPrintable(run.out));
            QVERIFY2(verdict.contains(QStringLiteral("21,520 vertices")), qPrintable(verdict));
        }
        const QString compute = value(QStringLiteral("Compute"));
        QVERIFY(compute.contains(QStringLiteral("bit-exact")) ||
                compute.contains(QStringLiteral("OpenGL 4.3")));
    }

    // It counts gl_VertexID from the start again after 4,096 vertices and tells no fragment its primitive.
    void softpipeIsWorkedAround() {
        const CliRun run = runInfoOn(kSoftpipe);
        QVERIFY2(run.status == 0, qPrintable(run.err));
        if (!valueOf(run, QStringLiteral("renderer")).contains(QStringLiteral("softpipe"))) {
            QSKIP("softpipe is not here");
        }
        for (const char* pipeline :
             {"Uniform array", "Uniform array, culled", "Transform feedback", "Reference"}) {
            QVERIFY2(valueOf(run, QString::fromLatin1(pipeline)).startsWith(QStringLiteral("bit-exact in ")),
                     qPrintable(run.out));
        }
        QVERIFY2(valueOf(run, QStringLiteral("picking")).endsWith(QStringLiteral("geometry shader")),
                 qPrintable(run.out));
    }

    void inexactRendererIsSaidAndLeft() {
        const CliRun run = runInfoOn(kInexact);
        QVERIFY2(run.status == 0, qPrintable(run.err));
        if (!isMadeInexact() &&
            valueOf(run, QStringLiteral("deformation function")).startsWith(QStringLiteral("bit-exact"))) {
            QSKIP("this renderer cannot be made inexact");
        }
        for (const char* pipeline : {"Uniform array", "Transform feedback"}) {
            QVERIFY2(
                valueOf(run, QString::fromLatin1(pipeline)).startsWith(QStringLiteral("not bit-exact: ")),
                qPrintable(run.out));
        }
        QVERIFY(valueOf(run, QStringLiteral("Reference")).startsWith(QStringLiteral("bit-exact in ")));

        const QStringList shoot{QStringLiteral("shoot"), QStringLiteral("--burst"), QStringLiteral("3")};
        const CliRun usual = runCli(shoot, kInexact);
        QCOMPARE(usual.status, 0);
        QVERIFY2(usual.err.contains(QStringLiteral("Transform feedback: not bit-exact: ")) &&
                     usual.err.contains(QStringLiteral("using Reference instead")),
                 qPrintable(usual.err));
        QVERIFY2(usual.out.contains(QStringLiteral("by Reference")), qPrintable(usual.out));
        const CliRun asked =
            runCli(shoot + QStringList{QStringLiteral("--pipeline"), QStringLiteral("transform-feedback")},
                   kInexact);
        QVERIFY(asked.err.contains(QStringLiteral("not bit-exact: ")));
        QVERIFY(!asked.err.contains(QStringLiteral("instead")));
        QVERIFY2(asked.out.contains(QStringLiteral("by Transform feedback")), qPrintable(asked.out));
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

}  // namespace hitscope::info_renderer_test

#include "info_renderer_test.moc"
