// SPDX-License-Identifier: GPL-3.0-or-later
// `hitscope-cli shoot` as a person runs it, with no display.
#include <QTemporaryDir>
#include <QTest>

#include "cli/run_cli.h"
#include "support/test_program.h"

using namespace hitscope::test;

namespace {

CliRun shoot(const QStringList& arguments) {
    return runCli(QStringList{QStringLiteral("shoot")} + arguments);
}

QString fingerprintOf(const CliRun& run) {
    return QRegularExpression(QStringLiteral("fingerprint ([0-9a-f]{16})")).match(run.out).captured(1);
}

}  // namespace

class ShootTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void burstsAndTheirScriptsHitTheSame() {
        const QTemporaryDir folder;
        const QString script = folder.filePath(QStringLiteral("shots.json"));
        const QStringList burst{"--burst", "60", "--cone", "12", "--seed", "3", "--every", "0.02"};
        const CliRun first = shoot(burst + QStringList{"--save", script});
        QVERIFY2(first.status == 0, qPrintable(first.err));
        QVERIFY2(first.out.startsWith(QStringLiteral("60 shots, ")), qPrintable(first.out));
        QVERIFY(!fingerprintOf(first).isEmpty());
        QCOMPARE(shoot(burst).out, first.out);
        QCOMPARE(shoot({"--script", script}).out, first.out);
        const CliRun other = shoot({"--burst", "60", "--cone", "12", "--seed", "4", "--every", "0.02"});
        QVERIFY(fingerprintOf(other) != fingerprintOf(first));
    }

    void wrongUsageIsSaid() {
        QCOMPARE(shoot({"--burst", "0"}).status, 2);
        QCOMPARE(shoot({"--cone", "400"}).status, 2);
        QCOMPARE(shoot({"--script", "a", "--burst", "3"}).status, 2);
        const CliRun missing = shoot({"--script", "/nowhere/shots.json"});
        QCOMPARE(missing.status, 1);
        QVERIFY(missing.err.contains(QStringLiteral("/nowhere/shots.json")));
    }
};

HITSCOPE_TEST(ShootTest, QCoreApplication)
#include "shoot_test.moc"
