// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/shots/shot_script_file.h"
#include "support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace hitscope::shot_script_file_test {

namespace {

ShotScript usual() {
    ShotScript script;
    script.isInstant = true;
    script.projectile.speed = 77.7f;
    script.projectile.mass = 0.3f;
    script.projectile.bouncesCount = true;
    script.shots = burst({{0.1f, 1.0f / 3.0f, -7.7e3f}, {0, 0, -1}}, 200, 0.3f, 9, 0.1);
    return script;
}

}  // namespace

class ShotScriptFileTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatIsSavedIsReadBack() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("shots.json"));
        const ShotScript script = usual();
        QVERIFY(writeShotScript(script, path).ok());
        const Result<ShotScript> read = readShotScript(path);
        QVERIFY(read.ok());
        QVERIFY(read.value().shots == script.shots);  // in every bit
        QVERIFY(read.value().projectile == script.projectile);
        QCOMPARE(read.value().isInstant, true);
    }

    void formsAreReadBack_data() {
        QTest::addColumn<int>("profile");
        QTest::addColumn<int>("direction");
        for (std::size_t profile = 0; profile < kDentProfileKeys.size(); ++profile) {
            for (std::size_t direction = 0; direction < kDentDirectionKeys.size(); ++direction) {
                QTest::addRow("%d, %d", static_cast<int>(profile), static_cast<int>(direction))
                    << static_cast<int>(profile) << static_cast<int>(direction);
            }
        }
    }
    void formsAreReadBack() {
        QFETCH(const int, profile);
        QFETCH(const int, direction);
        DentForm form;
        form.profile = static_cast<DentProfile>(profile);
        form.direction = static_cast<DentDirection>(direction);
        if (form.profile == DentProfile::Curve) {
            form.curve = {0.1f, -1.0f, 1.0f / 3.0f, 1.0f, 0.0f, 0.7f, 1e-6f, 0.3f};
        }
        ShotScript script = usual();
        QVERIFY(!formatShotScript(script).contains("dent"));
        script.projectile.form = form;
        const Result<ShotScript> read = parseShotScript(formatShotScript(script));
        QVERIFY(read.ok());
        QVERIFY(read.value().projectile.form == form);
    }

    void littleIsNeeded() {
        const Result<ShotScript> read = parseShotScript(R"({"hitscope-shots": 1, "shots": [
            {"time": 0.5, "from": [0, 1, 2], "direction": [0, 0, -4]}]})");
        QVERIFY(read.ok());
        QVERIFY(read.value().projectile == ProjectileSettings());
        QVERIFY(!read.value().isInstant);
        QVERIFY(read.value().shots.front().ray.direction == glm::vec3(0, 0, -1));
        QCOMPARE(read.value().duration(), 0.5);
    }

    void whatIsWrongIsRefused_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("says");
        const auto shots = [](const QByteArray& list) {
            return QByteArray(R"({"hitscope-shots": 1, "shots": [)") + list + "]}";
        };
        const QByteArray good(R"({"time": 1, "from": [0, 0, 0], "direction": [1, 0, 0]})");
        QTest::newRow("nothing") << QByteArray() << "not JSON";
        QTest::newRow("cut short") << QByteArray(R"({"hitscope-shots": 1, "sho)") << "byte";
        QTest::newRow("a list") << QByteArray("[]") << "JSON object";
        QTest::newRow("another file") << QByteArray("{}") << "hitscope-shots";
        QTest::newRow("newer") << QByteArray(R"({"hitscope-shots": 2, "shots": []})") << "has to be 1";
        QTest::newRow("no shots") << QByteArray(R"({"hitscope-shots": 1})") << "shots: It has to be a list";
        QTest::newRow("unknown member")
            << QByteArray(R"({"hitscope-shots": 1, "shots": [], "sped": 1})") << "\"sped\"";
        QTest::newRow("instant") << QByteArray(R"({"hitscope-shots": 1, "shots": [], "instant": 1})")
                                 << "instant";
        QTest::newRow("projectile")
            << QByteArray(R"({"hitscope-shots": 1, "shots": [], "projectile": {"mass": -1}})")
            << "projectile.mass";
        QTest::newRow("projectile member")
            << QByteArray(R"({"hitscope-shots": 1, "shots": [], "projectile": {"rate_of_fire": 1}})")
            << "rate_of_fire";
        const auto dent = [](const QByteArray& members) {
            return QByteArray(R"({"hitscope-shots": 1, "shots": [], "dent": )") + members + "}";
        };
        QTest::newRow("dent") << dent("1") << "dent";
        QTest::newRow("profile") << dent(R"({"profile": "paprika"})") << "dent.profile";
        QTest::newRow("direction") << dent(R"({"direction": "up"})") << "dent.direction";
        QTest::newRow("seven points") << dent(R"({"curve": [1, 1, 1, 1, 1, 1, 0]})") << "dent.curve";
        QTest::newRow("a point too high") << dent(R"({"curve": [1, 1, 1, 2, 1, 1, 1, 0]})") << "dent.curve";
        QTest::newRow("shot") << shots("7") << "shots[0]";
        QTest::newRow("shot member") << shots(R"({"time": 0, "form": [0, 0, 0]})") << "form";
        QTest::newRow("time") << shots(R"({"time": "0", "from": [0, 0, 0], "direction": [1, 0, 0]})")
                              << "shots[0].time";
        QTest::newRow("negative time")
            << shots(R"({"time": -1, "from": [0, 0, 0], "direction": [1, 0, 0]})") << "shots[0].time";
        QTest::newRow("back in time")
            << shots(good + ',' + R"({"time": 0.5, "from": [0, 0, 0], "direction": [1, 0, 0]})")
            << "shots[1].time";
        QTest::newRow("two numbers") << shots(R"({"time": 0, "from": [0, 0], "direction": [1, 0, 0]})")
                                     << "shots[0].from";
        QTest::newRow("far away") << shots(R"({"time": 0, "from": [0, 0, 1e30], "direction": [1, 0, 0]})")
                                  << "shots[0].from";
        QTest::newRow("no direction")
            << shots(R"({"time": 0, "from": [0, 0, 0], "direction": [0, 0, 0]})") << "shots[0].direction";
    }
    void whatIsWrongIsRefused() {
        QFETCH(QByteArray, text);
        QFETCH(QString, says);
        const Result<ShotScript> read = parseShotScript(text);
        QVERIFY(!read.ok());
        const QString message = QString::fromStdString(read.error().message());
        QVERIFY2(message.contains(says), qPrintable(message));
    }

    void filesThatAreNone() {
        const QTemporaryDir folder;
        QVERIFY(!readShotScript(folder.filePath(QStringLiteral("missing.json"))).ok());
        QVERIFY(!readShotScript(folder.path()).ok());
        QVERIFY(!writeShotScript(usual(), folder.filePath(QStringLiteral("no/such/folder.json"))).ok());
    }
};

HITSCOPE_TEST(ShotScriptFileTest, QCoreApplication)

}  // namespace hitscope::shot_script_file_test

#include "shot_script_file_test.moc"
