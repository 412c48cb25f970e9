// SPDX-License-Identifier: GPL-3.0-or-later
// `hitscope-cli shoot` as a person runs it, with no display.
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include "support/test_program.h"

namespace {

struct Run {
    int status = -1;
    QString out;
    QString err;

    [[nodiscard]] QString fingerprint() const {
        return QRegularExpression(QStringLiteral("fingerprint ([0-9a-f]{16})")).match(out).captured(1);
    }
};

Run shoot(const QStringList& arguments) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("DISPLAY"));
    environment.remove(QStringLiteral("WAYLAND_DISPLAY"));
    process.setProcessEnvironment(environment);
    process.start(qEnvironmentVariable("HITSCOPE_CLI"), QStringList{QStringLiteral("shoot")} + arguments);
    Run run;
    if (process.waitForFinished(100000) && process.exitStatus() == QProcess::NormalExit) {
        run.status = process.exitCode();
    }
    run.out = QString::fromUtf8(process.readAllStandardOutput());
    run.err = QString::fromUtf8(process.readAllStandardError());
    return run;
}

}  // namespace

class ShootTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void burstsAndTheirScriptsHitTheSame() {
        const QTemporaryDir folder;
        const QString script = folder.filePath(QStringLiteral("shots.json"));
        const QStringList burst{"--burst", "60", "--cone", "12", "--seed", "3", "--every", "0.02"};
        const Run first = shoot(burst + QStringList{"--save", script});
        QVERIFY2(first.status == 0, qPrintable(first.err));
        QVERIFY2(first.out.startsWith(QStringLiteral("60 shots, ")), qPrintable(first.out));
        QVERIFY(!first.fingerprint().isEmpty());
        QCOMPARE(shoot(burst).out, first.out);
        QCOMPARE(shoot({"--script", script}).out, first.out);
        const Run other = shoot({"--burst", "60", "--cone", "12", "--seed", "4", "--every", "0.02"});
        QVERIFY(other.fingerprint() != first.fingerprint());
    }

    void wrongUsageIsSaid() {
        QCOMPARE(shoot({"--burst", "0"}).status, 2);
        QCOMPARE(shoot({"--cone", "400"}).status, 2);
        QCOMPARE(shoot({"--script", "a", "--burst", "3"}).status, 2);
        const Run missing = shoot({"--script", "/nowhere/shots.json"});
        QCOMPARE(missing.status, 1);
        QVERIFY(missing.err.contains(QStringLiteral("/nowhere/shots.json")));
    }
};

HITSCOPE_TEST(ShootTest, QCoreApplication)
#include "shoot_test.moc"
