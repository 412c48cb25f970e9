// SPDX-License-Identifier: GPL-3.0-or-later
// Settings are kept when they change, and however the program ends; keys of habit say what is there.
#include <QApplication>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "app/end_signals.h"
#include "app/notice_bar.h"
#include "app/session_files.h"
#include "app/settings/settings_keeper.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::keeping_test {

class KeepingTest : public QObject, private WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void cleanup() { dropWindow(); }

    void settingsAreSavedWhenTheyChange();
    void nothingIsWrittenWithoutAChange();
    void anotherWindowsSettingsStay();
    void recentFilesOfAllWindowsStay();
    void saysThatSettingsCannotBeSaved();
    void habitKeysSaveAndStartAnew();
    void aNewSessionBeginsWithTheFirstView();
    void signalsEndInOrder_data();
    void signalsEndInOrder();
    void platformsWithoutWindowsAreNamed();
    void aDisplayThatIsNotThereIsNamed();
};

void KeepingTest::settingsAreSavedWhenTheyChange() {
    makeWindow();
    QVERIFY(QSettings().value(QStringLiteral("display/wireframe")).toInt() !=
            static_cast<int>(WireframeMode::Over));
    QTest::keyClick(&m_window->viewport(), Qt::Key_L);
    QTRY_COMPARE_WITH_TIMEOUT(QSettings().value(QStringLiteral("display/wireframe")).toInt(),
                              static_cast<int>(WireframeMode::Over), kPatience);
    // What a killed window leaves behind.
    makeWindow();
    QCOMPARE(m_window->viewport().options().wireframe, WireframeMode::Over);
}

void KeepingTest::nothingIsWrittenWithoutAChange() {
    makeWindow();
    auto* keeper = m_window->findChild<SettingsKeeper*>();
    keeper->saveNow();
    const QString file = QSettings().fileName();
    QVERIFY(QFile::remove(file));
    keeper->saveNow();
    QVERIFY(!QFile::exists(file));
    QTest::keyClick(&m_window->viewport(), Qt::Key_L);
    keeper->saveNow();
    QVERIFY(QFile::exists(file));
}

/// What it has changed, and not what was changed in this one.
void KeepingTest::anotherWindowsSettingsStay() {
    m_settings = std::make_unique<TestSettings>();
    const QString power = QStringLiteral("constants/power");
    const QString floor = QStringLiteral("display/floor");
    const QString bookmark = QStringLiteral("camera/bookmark1");
    makeWindow();
    const bool hadFloor = m_window->viewport().options().floor;
    {
        QSettings other;
        other.setValue(power, QStringLiteral("3.5"));
        other.setValue(floor, !hadFloor);
        other.setValue(bookmark, QStringLiteral("elsewhere"));
    }
    auto* keeper = m_window->findChild<SettingsKeeper*>();
    QTest::keyClick(&m_window->viewport(), Qt::Key_L);
    QTRY_COMPARE_WITH_TIMEOUT(QSettings().value(QStringLiteral("display/wireframe")).toInt(),
                              static_cast<int>(WireframeMode::Over), kPatience);
    QTest::keyClick(&m_window->viewport(), Qt::Key_L);
    keeper->saveNow();
    const QSettings now;
    QVERIFY(now.value(QStringLiteral("display/wireframe")).toInt() != static_cast<int>(WireframeMode::Over));
    QCOMPARE(now.value(power).toString(), QStringLiteral("3.5"));
    QCOMPARE(now.value(floor).toBool(), !hadFloor);
    QCOMPARE(now.value(bookmark).toString(), QStringLiteral("elsewhere"));
}

void KeepingTest::recentFilesOfAllWindowsStay() {
    const QString key = QStringLiteral("recentFiles");
    m_settings = std::make_unique<TestSettings>();
    QSettings().setValue(key, QStringList{QStringLiteral("/old.obj")});
    makeWindow();
    QSettings().setValue(key, QStringList{QStringLiteral("/other.obj"), QStringLiteral("/old.obj")});
    QTemporaryDir folder;
    const QString mine = folder.filePath(QStringLiteral("mine.obj"));
    writeObj(makeLowPolyCube(1.0f), mine);
    m_window->openFiles({mine});
    QTRY_COMPARE_WITH_TIMEOUT(QSettings().value(key).toStringList(),
                              (QStringList{mine, QStringLiteral("/other.obj"), QStringLiteral("/old.obj")}),
                              kPatience);
}

void KeepingTest::saysThatSettingsCannotBeSaved() {
    m_settings = std::make_unique<TestSettings>();
    const QString file = QSettings().fileName();
    QVERIFY(!QFile::exists(file) || QFile::remove(file));
    QVERIFY(QDir().mkpath(file));  // a folder is in its place
    makeWindow();
    auto* notice = m_window->findChild<NoticeBar*>();
    QTest::keyClick(&m_window->viewport(), Qt::Key_L);
    QTRY_VERIFY_WITH_TIMEOUT(notice->text().contains(file), kPatience);
    notice->clear();
    QTest::keyClick(&m_window->viewport(), Qt::Key_L);
    m_window->findChild<SettingsKeeper*>()->saveNow();
    QVERIFY(notice->text().isEmpty());  // once
}

void KeepingTest::habitKeysSaveAndStartAnew() {
    makeWindow();
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("kept.hitscope"));
    auto* sessions = m_window->findChild<SessionFiles*>();
    sessions->save(file);
    QTRY_VERIFY_WITH_TIMEOUT(!sessions->isBusy(), kPatience);
    QVERIFY(QFile::remove(file));
    QTest::keyClick(&m_window->viewport(), Qt::Key_S, Qt::ControlModifier);  // there again, without asking
    QTRY_VERIFY_WITH_TIMEOUT(!sessions->isBusy() && QFile::exists(file), kPatience);
    QTest::keyClick(&m_window->viewport(), Qt::Key_N, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(m_session->sceneName().toLower(), QStringLiteral("teapot"), kPatience);
    QVERIFY(sessions->path().isEmpty());
}

void KeepingTest::aNewSessionBeginsWithTheFirstView() {
    makeWindow([](Session& session) { loadTeapot(session); });
    Viewport& viewport = m_window->viewport();
    const Camera first = viewport.camera();
    Camera below = first;
    below.orbit(1.0f, -1.5f);
    viewport.navigation().setCamera(below, Navigation::Arrival::AtOnce);
    QVERIFY(viewport.camera().eye().y < m_session->targets().floorHeight());
    QTest::keyClick(&viewport, Qt::Key_N, Qt::ControlModifier);
    const Camera& now = viewport.camera();
    QTRY_COMPARE_WITH_TIMEOUT(now.pitch(), first.pitch(), kPatience);
    QCOMPARE(now.yaw(), first.yaw());
    QCOMPARE(now.distance(), first.distance());
    QVERIFY(now.pivot() == first.pivot());
    viewport.navigation().setProjection(Projection::Orthographic);
    QTest::keyClick(&viewport, Qt::Key_N, Qt::ControlModifier);
    QVERIFY(viewport.camera().isOrthographic());  // the lens is a habit
}

void KeepingTest::signalsEndInOrder_data() {
    QTest::addColumn<int>("number");
    QTest::newRow("SIGTERM") << SIGTERM;
    QTest::newRow("SIGINT") << SIGINT;
    QTest::newRow("SIGHUP") << SIGHUP;
}

/// The program itself, its settings in a folder of their own.
void KeepingTest::signalsEndInOrder() {
    QFETCH(int, number);
    const QTemporaryDir home;
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), home.path());
    program.setProcessEnvironment(environment);
    program.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    program.start(qEnvironmentVariable("HITSCOPE_WINDOW"), QStringList());
    QVERIFY(program.waitForStarted());
    // It is caught as soon as the window is there: before, the program ends as any does.
    QTRY_VERIFY_WITH_TIMEOUT(
        [&program] {
            QFile status(QStringLiteral("/proc/%1/status").arg(program.processId()));
            if (!status.open(QIODevice::ReadOnly)) {
                return false;
            }
            const QByteArray text = status.readAll();
            const qsizetype at = text.indexOf("SigCgt:");
            return at >= 0 &&
                   (text.mid(at + 7, 18).trimmed().toULongLong(nullptr, 16) & (1ull << (SIGTERM - 1))) != 0;
        }(),
        kPatience);
    ::kill(static_cast<pid_t>(program.processId()), number);
    QVERIFY(program.waitForFinished(kPatience));
    QCOMPARE(program.exitStatus(), QProcess::NormalExit);
    QCOMPARE(program.exitCode(), 128 + number);
    QVERIFY(QFile::exists(home.filePath(QStringLiteral("Hitscope/hitscope.conf"))));
}

void KeepingTest::platformsWithoutWindowsAreNamed() {
    for (const char* const platform : {"offscreen", "minimal"}) {
        QProcess program;
        program.start(qEnvironmentVariable("HITSCOPE_WINDOW"),
                      {QStringLiteral("-platform"), QString::fromLatin1(platform)});
        QVERIFY(program.waitForFinished(kPatience));
        QCOMPARE(program.exitStatus(), QProcess::NormalExit);
        QCOMPARE(program.exitCode(), 1);
        const QByteArray said = program.readAllStandardError();
        QVERIFY2(said.contains(platform) && said.contains("QT_QPA_PLATFORM"), said.constData());
    }
}

/// In one line, and not by a signal.
void KeepingTest::aDisplayThatIsNotThereIsNamed() {
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("DISPLAY"), QStringLiteral(":65535"));
    environment.remove(QStringLiteral("WAYLAND_DISPLAY"));
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("xcb"));
    program.setProcessEnvironment(environment);
    program.start(qEnvironmentVariable("HITSCOPE_WINDOW"), QStringList());
    QVERIFY(program.waitForFinished(kPatience));
    QCOMPARE(program.exitStatus(), QProcess::NormalExit);
    QCOMPARE(program.exitCode(), 1);
    const QByteArray said = program.readAllStandardError();
    QVERIFY2(said.startsWith("hitscope: no window can be opened: ") && said.contains(":65535") &&
                 said.count('\n') == 1,
             said.constData());
}

HITSCOPE_TEST(KeepingTest, QApplication)

}  // namespace hitscope::keeping_test

#include "keeping_test.moc"
