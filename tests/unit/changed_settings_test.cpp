// SPDX-License-Identifier: GPL-3.0-or-later
// Changed settings are seen at once, and another thread writes them.
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QObject>
#include <QSemaphore>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QThreadPool>
#include <memory>
#include <thread>

#include "analysis/background_pool.h"
#include "analysis/changed_settings.h"
#include "support/test_program.h"

namespace hitscope::changed_settings_test {

namespace {

const QString kKey = QStringLiteral("some/key");

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class ChangedSettingsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        QCoreApplication::setOrganizationName(QStringLiteral("Hitscope"));
        QCoreApplication::setApplicationName(QStringLiteral("hitscope-test"));
        m_folder = std::make_unique<QTemporaryDir>();
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder->path());
    }

    void cleanup() { backgroundPool().waitForDone(); }

    void areSeenBeforeTheyAreWritten() {
        const int threads = backgroundPool().maxThreadCount();
        QSemaphore begun;
        QSemaphore mayEnd;
        for (int i = 0; i < threads; ++i) {  // so that nobody can write
            startInBackground([&] {
                begun.release();
                mayEnd.acquire();
            });
        }
        begun.acquire(threads);
        const QString file = QSettings().fileName();
        ChangedSettings()->setValue(kKey, 7);
        QCoreApplication::processEvents();
        const bool isWritten = QFile::exists(file);
        const bool isSeen = QSettings().value(kKey).toInt() == 7;  // and written, since nobody else did
        mayEnd.release(threads);
        QVERIFY(isSeen);
        QVERIFY(!isWritten);
        backgroundPool().waitForDone();
        QVERIFY2(contentOf(file).contains("key=7"), contentOf(file).constData());
    }

    void tellWhetherTheyWereWritten() {
        for (const bool isThere : {false, true}) {
            QCoreApplication::setApplicationName(isThere ? QStringLiteral("blocked")
                                                         : QStringLiteral("free"));
            const QString file = QSettings().fileName();
            if (isThere) {
                QVERIFY(QDir().mkpath(file));  // a folder in its place
            }
            ChangedSettings settings;
            settings->setValue(kKey, 8);
            bool isWritten = isThere;
            std::jthread([&isWritten, write = settings.writing()] { isWritten = write(); }).join();
            QCOMPARE(isWritten, !isThere);
        }
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

HITSCOPE_TEST(ChangedSettingsTest, QCoreApplication)

}  // namespace hitscope::changed_settings_test

#include "changed_settings_test.moc"
