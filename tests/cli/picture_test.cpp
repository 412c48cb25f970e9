// SPDX-License-Identifier: GPL-3.0-or-later
// hitscope-cli picture and sequence as a person runs them.
#include <QDir>
#include <QImage>
#include <QImageReader>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <vector>

#include "cli/run_cli.h"
#include "support/test_program.h"

namespace hitscope::picture_test {

using namespace test;

namespace {

QStringList words(const char* line) {
    return QString::fromUtf8(line).split(u' ', Qt::SkipEmptyParts);
}

}  // namespace

class PictureTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void sizeAndBackground();
    void cameraTakesText();
    void cutsTargetsOpen();
    void dressesTargets();
    void changeHasAColourBar();
    void changeHasPointsInEveryLocale();
    void sequences();
    void wrongUsage_data();
    void wrongUsage();
    void errorsSayWhatToDo();
    void suffixTellsTheFormat();

private:
    [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }
    QTemporaryDir m_folder;
};

void PictureTest::sizeAndBackground() {
    const QString file = path(QStringLiteral("a.png"));
    const CliRun run = runCli(words("picture --size 321x123 --transparent --no-floor --shots 3") << file);
    QVERIFY2(run.status == 0, qPrintable(run.err));
    const QImage image(file);
    QVERIFY(image.text(QStringLiteral("Software")).startsWith(QStringLiteral("Hitscope ")));
    QVERIFY(image.text(QStringLiteral("Renderer")).contains(QStringLiteral("OpenGL ")));
    // Of the pipeline that made it, what `info` says of it.
    const auto verdictIn = [this](const QString& pipeline) {
        const QString made = path(QStringLiteral("by.png"));
        const CliRun by = runCli(words("picture --size 64x48 --pipeline") << pipeline << made);
        return by.status == 0 ? QImage(made).text(QStringLiteral("Pipeline")) : by.err;
    };
    const CliRun info = runCli(words("info --renderer"));
    const auto verdictOf = [&info](const QString& pipeline) {
        const QRegularExpression row(QStringLiteral("^ *%1  +(.*)$").arg(pipeline),
                                     QRegularExpression::MultilineOption);
        return pipeline + QStringLiteral(": ") + row.match(info.out).captured(1).trimmed();
    };
    QCOMPARE(verdictIn(QStringLiteral("uniform-array")), verdictOf(QStringLiteral("Uniform array")));
    QCOMPARE(verdictIn(QStringLiteral("reference")), verdictOf(QStringLiteral("Reference")));
    QCOMPARE(image.size(), QSize(321, 123));
    QCOMPARE(qAlpha(image.pixel(0, 0)), 0);
    int opaque = 0;
    for (int x = 0; x < image.width(); ++x) {
        opaque += qAlpha(image.pixel(x, image.height() / 2)) == 255 ? 1 : 0;
    }
    QVERIFY(opaque > 20);
}

void PictureTest::cameraTakesText() {
    const QString camera =
        QStringLiteral("camera pivot 0 3 0 yaw 0 pitch 90 distance 30 fov 50 orthographic");
    const QString top = path(QStringLiteral("top.png"));
    const QString side = path(QStringLiteral("side.png"));
    QCOMPARE(runCli(words("picture --size 200x200 --camera") << camera << top).status, 0);
    QCOMPARE(runCli(words("picture --size 200x200") << side).status, 0);
    QVERIFY(QImage(top).size() == QImage(side).size() && QImage(top) != QImage(side));
}

void PictureTest::cutsTargetsOpen() {
    const auto covered = [this](const QString& name, const QStringList& cut) {
        const QString file = path(name);
        const CliRun run = runCli(words("picture --size 240x160 --transparent --no-floor") << cut << file);
        int pixels = 0;
        const QImage image(file);
        for (int y = 0; run.status == 0 && y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                pixels += qAlpha(image.pixel(x, y)) > 0 ? 1 : 0;
            }
        }
        return pixels;
    };
    const int whole = covered(QStringLiteral("whole.png"), {});
    const int low = covered(QStringLiteral("low.png"), {QStringLiteral("--cut=x=-15")});
    const int high = covered(QStringLiteral("high.png"), {QStringLiteral("--cut=-x=-15")});
    QVERIFY2(low > 50 && low < whole / 2 && high > whole / 2 && high < whole,
             qPrintable(QStringLiteral("%1, %2 of %3").arg(low).arg(high).arg(whole)));
    const int slanted = covered(QStringLiteral("slanted.png"),
                                {QStringLiteral("--cut=1,0,1=0"), QStringLiteral("--fill-cut")});
    QVERIFY(slanted > whole / 4 && slanted < whole);
}

void PictureTest::dressesTargets() {
    const auto draw = [this](const char* line) {
        const QString file = path(QStringLiteral("dressed.png"));
        const CliRun run = runCli(words("picture --shots 3 --size 160x100") + words(line) << file);
        return run.status == 0 ? QImage(file) : QImage();
    };
    const QImage plain = draw("--samples 1");
    QVERIFY(!plain.isNull());
    QCOMPARE(draw("--material file"), plain);
    std::vector<QImage> others{plain};
    for (const char* const line :
         {"--material matcap", "--material clay", "--material metal", "--environment", "--samples 4"}) {
        const QImage other = draw(line);
        QCOMPARE(other.size(), plain.size());
        QVERIFY2(std::find(others.begin(), others.end(), other) == others.end(), line);
        others.push_back(other);
    }
}

void PictureTest::changeHasAColourBar() {
    const auto draw = [this](const char* line) {
        const QString file = path(QStringLiteral("change.png"));
        const CliRun run = runCli(words("picture --shots 5") + words(line) << file);
        return run.status == 0 ? QImage(file) : QImage();
    };
    const QImage plain = draw("--size 640x360");
    const QImage bare = draw("--size 640x360 --change displacement --no-labels");
    const QImage labelled = draw("--size 640x360 --change displacement");
    QVERIFY(!plain.isNull() && !bare.isNull() && !labelled.isNull());
    QVERIFY(bare != plain);
    // It is in the lower left corner, and nowhere else.
    constexpr int kWidth = 220;
    const QRect rest(kWidth, 0, 640 - kWidth, 360);
    QCOMPARE(labelled.copy(rest), bare.copy(rest));
    int brightest = 0;  // of viridis, its yellow end
    for (int y = 0; y < 360; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const QColor colour = labelled.pixelColor(x, y);
            brightest += colour.red() > 240 && colour.green() > 220 && colour.blue() < 60 ? 1 : 0;
        }
    }
    QVERIFY(brightest >= 10);
    // Where there is no room there is none.
    QCOMPARE(draw("--size 64x48 --change displacement"),
             draw("--size 64x48 --change displacement --no-labels"));
    QVERIFY(draw("--size 640x360 --change hits") != bare);
}

void PictureTest::changeHasPointsInEveryLocale() {
    const auto draw = [this](const QString& locale) {
        const QString file = path(QStringLiteral("locale.png"));
        const CliRun run = runCli(words("picture --shots 5 --size 640x360 --change displacement") << file,
                                  {{QStringLiteral("LC_ALL"), locale}});
        return run.status == 0 ? QImage(file) : QImage();
    };
    const QImage plain = draw(QStringLiteral("C"));
    QVERIFY(!plain.isNull());
    QCOMPARE(draw(QStringLiteral("de_DE.UTF-8")), plain);
}

void PictureTest::sequences() {
    const QString turn = path(QStringLiteral("turn"));
    QCOMPARE(runCli(words("sequence --turntable 3 --size 96x64") << turn).status, 0);
    QCOMPARE(QDir(turn).entryList(QDir::Files),
             (QStringList{QStringLiteral("turntable-0001.png"), QStringLiteral("turntable-0002.png"),
                          QStringLiteral("turntable-0003.png")}));
    const QString replay = path(QStringLiteral("replay"));
    QCOMPARE(runCli(words("sequence --replay --shots 2 --size 96x64") << replay).status, 0);
    QVERIFY(QDir(replay).entryList(QDir::Files).size() >= 2);
    const QString session = path(QStringLiteral("five.hitscope"));
    QCOMPARE(runCli(words("shoot --random 5 --pipeline reference --session") << session).status, 0);
    const QString first = path(QStringLiteral("first"));
    QCOMPARE(runCli(words("sequence --replay --until 2 --size 96x64") << first << session).status, 0);
    QCOMPARE(QDir(first).entryList(QDir::Files).size(), 3);
}

void PictureTest::wrongUsage_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* line, const char* says) {
        QTest::newRow(line) << QString::fromUtf8(line) << QString::fromUtf8(says);
    };
    row("picture", "PICTURE [MESH|SESSION]");
    row("picture a.png b.obj c.obj", "2 files at most");
    row("picture --size 12 a.png", "--size takes");
    row("picture --size 0x5 a.png", "--size takes");
    row("picture --size 5x5x5 a.png", "--size takes");
    row("picture --cut a.png b.obj", "--cut takes");
    row("picture --cut x a.png", "--cut takes");
    row("picture --cut 0,0,0=1 a.png", "--cut takes");
    row("picture --cut w=1 a.png", "--cut takes");
    row("picture --cut x=1=2 a.png", "--cut takes");
    row("picture --theme pink a.png", "light, dark");
    row("picture --wireframe some a.png", "off, over, only");
    row("picture --pipeline magic a.png", "transform-feedback");
    row("picture --shots -1 a.png", "--shots takes");
    row("picture --change colour a.png", "displacement");
    row("picture --change difference a.png", "--change takes");
    row("picture --samples 0 a.png", "--samples takes");
    row("picture --samples many a.png", "--samples takes");
    row("picture --samples 9999999 a.png", "--samples takes");
    row("picture --material wood a.png", "file, matcap, clay, metal");
    row("picture --environment=garden a.png", "environment");
    row("picture --fast a.png", "fast");
    row("sequence out", "--turntable or --replay");
    row("sequence --turntable 3 --replay out", "--turntable or --replay");
    row("sequence --turntable 0 out", "--turntable takes");
    row("sequence --replay", "FOLDER");
}

void PictureTest::wrongUsage() {
    QFETCH(QString, line);
    QFETCH(QString, says);
    const CliRun run = runCli(line.split(u' '));
    QCOMPARE(run.status, 2);
    QVERIFY2(run.err.contains(says), qPrintable(run.err));
}

void PictureTest::errorsSayWhatToDo() {
    CliRun run = runCli(words("picture --size 900000x10") << path(QStringLiteral("huge.png")));
    QCOMPARE(run.status, 4);
    QVERIFY2(run.err.contains(QStringLiteral("900000 x 10")) && run.err.contains(QStringLiteral("smaller")),
             qPrintable(run.err));
    QVERIFY(!QFile::exists(path(QStringLiteral("huge.png"))));
    run = runCli(words("picture --camera nowhere") << path(QStringLiteral("b.png")));
    QCOMPARE(run.status, 2);
    QVERIFY2(run.err.contains(QStringLiteral("--camera")), qPrintable(run.err));
    run = runCli(words("picture") << path(QStringLiteral("no/such/folder.png")));
    QCOMPARE(run.status, 3);
    QVERIFY2(run.err.contains(QStringLiteral("folder.png")), qPrintable(run.err));
}

void PictureTest::suffixTellsTheFormat() {
    const QString jpeg = path(QStringLiteral("a.jpg"));
    CliRun run = runCli(words("picture --size 96x64") << jpeg);
    QVERIFY2(run.status == 0, qPrintable(run.err));
    QCOMPARE(QImageReader::imageFormat(jpeg), QByteArray("jpeg"));
    QCOMPARE(QImage(jpeg).size(), QSize(96, 64));
    run = runCli(words("picture --size 96x64 --transparent") << path(QStringLiteral("b.jpg")));
    QVERIFY2(run.status == 3 && run.err.contains(QStringLiteral("transparent")), qPrintable(run.err));
    for (const char* const name : {"c.gif", "c.psd", "c"}) {
        run = runCli(words("picture --size 96x64") << path(QString::fromLatin1(name)));
        QVERIFY2(run.status == 2 && run.err.contains(QStringLiteral(".png, .jpg")), qPrintable(run.err));
        QVERIFY(!QFile::exists(path(QString::fromLatin1(name))));
    }
    run = runCli(words("picture --size 96x64 /dev/full"));
    QVERIFY2(run.status == 3 && run.err.contains(QStringLiteral("No space left on device")),
             qPrintable(run.err));
}

HITSCOPE_TEST(PictureTest, QCoreApplication)

}  // namespace hitscope::picture_test

#include "picture_test.moc"
