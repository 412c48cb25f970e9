// SPDX-License-Identifier: GPL-3.0-or-later
// Files that get another content while they are watched.
#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>

#include "app/file_watch.h"
#include "session/target_plan.h"
#include "support/test_program.h"

namespace hitscope::file_watch_test {

class FileWatchTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_watch = std::make_unique<FileWatch>();
        m_spy = std::make_unique<QSignalSpy>(m_watch.get(), &FileWatch::changed);
        write("a.obj", "one");
        write("b.obj", "one");
    }

    void writtenInPlace() {
        follow({"a.obj", "b.obj"});
        write("a.obj", "two");
        expect({"a.obj"});
        QCOMPARE(m_watch->contentOf(in("a.obj")), meshFileAt(in("a.obj")).sha256);
        write("b.obj", "three");
        expect({"b.obj"});
    }

    /// As most editors save, again and again.
    void anotherFileTakesItsName() {
        follow({"a.obj"});
        for (const char* content : {"two", "three", "four"}) {
            write("a.obj.new", content);
            QVERIFY(std::rename(qPrintable(in("a.obj.new")), qPrintable(in("a.obj"))) == 0);
            expect({"a.obj"});
        }
        // And in place after that.
        write("a.obj", "five");
        expect({"a.obj"});
    }

    void goneAndBack() {
        follow({"a.obj"});
        QVERIFY(QFile::remove(in("a.obj")));
        expect({});
        write("a.obj", "one");
        expect({});  // as it was
        QVERIFY(QFile::remove(in("a.obj")));
        expect({});
        write("a.obj", "two");
        expect({"a.obj"});
    }

    void onlyTouched() {
        follow({"a.obj"});
        QFile file(in("a.obj"));
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(60), QFile::FileModificationTime));
        file.close();
        write("a.obj", "one");
        write("c.obj", "another in the folder");
        expect({});
    }

    /// A large file comes in many pieces: it is told once, when it is whole.
    void writtenSlowly() {
        follow({"a.obj"});
        QFile file(in("a.obj"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QElapsedTimer sincePiece;
        sincePiece.start();
        for (int i = 0; i < 12; ++i) {
            QVERIFY(file.write("piece") > 0 && file.flush());
            if (sincePiece.restart() >= FileWatch::kSettles) {
                QSKIP("this machine pauses for longer than it takes a file to settle");
            }
            QTest::qWait(FileWatch::kSettles / 3);
            QVERIFY(m_spy->isEmpty() || sincePiece.elapsed() >= FileWatch::kSettles);
        }
        file.close();
        expect({"a.obj"});
        QCOMPARE(m_watch->contentOf(in("a.obj")), meshFileAt(in("a.obj")).sha256);
    }

    /// Between reading and watching.
    void changedBefore() {
        const MeshFile before = meshFileAt(in("a.obj"));
        write("a.obj", "longer than it was");
        m_watch->follow({before});
        expect({"a.obj"});
    }

    void withoutAHashItCountsAsItIs() {
        m_watch->follow({MeshFile{in("a.obj")}});
        expect({});
        QVERIFY(!m_watch->contentOf(in("a.obj")).empty());
        write("a.obj", "two");
        expect({"a.obj"});
    }

    void noLongerFollowed() {
        follow({"a.obj", "b.obj"});
        follow({"b.obj"});
        write("a.obj", "two");
        write("b.obj", "two");
        expect({"b.obj"});
        QVERIFY(m_watch->contentOf(in("a.obj")).empty());
    }

    /// However long that takes: an export reads its file back before it has ended.
    void writtenByThisProgram() {
        follow({"a.obj"});
        m_watch->hold(in("a.obj"));
        write("a.obj", "two");
        expect({});
        m_watch->release(in("a.obj"), true);
        expect({});
        QCOMPARE(m_watch->contentOf(in("a.obj")), meshFileAt(in("a.obj")).sha256);
        write("a.obj", "three");
        expect({"a.obj"});
        // What others write while this program tries to in vain is news.
        m_watch->hold(in("a.obj"));
        write("a.obj", "four");
        expect({});
        m_watch->release(in("a.obj"), false);
        expect({"a.obj"});
    }

private:
    [[nodiscard]] QString in(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    void write(const char* name, const QByteArray& content) const {
        QFile file(in(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
    }
    void follow(const std::vector<const char*>& names) {
        std::vector<MeshFile> files;
        for (const char* name : names) {
            files.push_back(meshFileAt(in(name)));
        }
        m_watch->follow(files);
    }
    /// These are told, once each, and nothing else.
    void expect(const QStringList& names) {
        QTRY_VERIFY_WITH_TIMEOUT(m_spy->size() >= names.size(), kPatience);
        QTest::qWait(3 * FileWatch::kSettles);
        QStringList told;
        for (const QList<QVariant>& arguments : *m_spy) {
            told << QFileInfo(arguments[0].toString()).fileName();
        }
        QCOMPARE(told, names);
        m_spy->clear();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<FileWatch> m_watch;
    std::unique_ptr<QSignalSpy> m_spy;
};

HITSCOPE_TEST(FileWatchTest, QApplication)

}  // namespace hitscope::file_watch_test

#include "file_watch_test.moc"
