// SPDX-License-Identifier: GPL-3.0-or-later
// Where sequences of pictures are written, and what is left of those that come to nothing.
#include <QDir>
#include <QFileDialog>
#include <QSignalSpy>
#include <QTimer>

#include "app/actions/picture_actions.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::sequence_folders_test {

class SequenceFoldersTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        makeWindow();
        QSettings settings;
        settings.setValue(QStringLiteral("picture/folder"), m_folder->path());
        settings.setValue(QStringLiteral("picture/samples"), 1);
        settings.setValue(QStringLiteral("picture/size"), QSize(64, 48));
        settings.setValue(QStringLiteral("picture/turntable"), 3);
        m_name = pictures().turntablePlan().base;
        m_name.chop(QStringLiteral("-turntable").size());
    }
    void cleanup() {
        dropWindow();
        m_folder.reset();
    }

    void sequencesReplaceNothing() {
        const QString first = filesIn({}).filePath(m_name + QStringLiteral("-0001.png"));
        QTest::keyClick(&m_window->viewport(), Qt::Key_F12);
        const QByteArray before = contentOf(first);
        QVERIFY(!before.isEmpty());
        const QSignalSpy ended(&pictures().sequences(), &SequenceWriter::ended);
        const QSignalSpy said(&pictures(), &PictureActions::said);
        for (const QString& own : {QStringLiteral("-sequence"), QStringLiteral("-sequence-2")}) {
            chooseSequence();
            QTRY_VERIFY_WITH_TIMEOUT(!pictures().sequences().isRunning(), kPatience);
            QCOMPARE(filesIn(m_name + own).count(), 3u);
            QVERIFY(said.last()[0].toString().contains(m_name + own));
        }
        QCOMPARE(ended.size(), 2);
        QCOMPARE(contentOf(first), before);
        // Nor do later pictures.
        makeActive(*m_window);
        QTest::keyClick(&m_window->viewport(), Qt::Key_F12);
        QCOMPARE(filesIn({}).entryList(QDir::Files).size(), 2);
        QCOMPARE(filesIn(m_name + QStringLiteral("-sequence")).count(), 3u);
    }

    void whatFailsLeavesNoFolder() {
        QSettings().setValue(QStringLiteral("picture/size"), QSize(65'536, 65'536));
        const QSignalSpy failed(&pictures().sequences(), &SequenceWriter::failed);
        chooseSequence();
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience);
        QVERIFY(left().isEmpty());
    }

    void whatIsCancelledAtOnceLeavesNoFolder() {
        chooseSequence();
        pictures().sequences().cancel();
        QVERIFY(left().isEmpty());
        pictures().saveTurntable();
        QCOMPARE(left().size(), 1);
        pictures().sequences().cancel();
        QVERIFY(left().isEmpty());
    }

    /// Pictures that are drawn are not written yet.
    void aCancelledOneSaysWhatIsWritten() {
        QSettings().setValue(QStringLiteral("picture/size"), QSize(1600, 1200));
        QSettings().setValue(QStringLiteral("picture/turntable"), 5000);
        int written = -1;
        uint files = 0;
        connect(&pictures().sequences(), &SequenceWriter::ended, this, [&](int count) {
            written = count;
            files = filesIn(m_name + QStringLiteral("-sequence")).count();
        });
        chooseSequence();
        QTRY_VERIFY_WITH_TIMEOUT(filesIn(m_name + QStringLiteral("-sequence")).count() > 1, kPatience);
        pictures().sequences().cancel();
        QVERIFY(!pictures().sequences().isRunning());
        QTRY_VERIFY_WITH_TIMEOUT(written > 0, kPatience);
        QCOMPARE(static_cast<uint>(written), files);
    }

private:
    PictureActions& pictures() { return *m_window->findChild<PictureActions*>(); }
    QDir filesIn(const QString& name) const {
        QDir folder(m_folder->filePath(name));
        folder.setFilter(QDir::Files);
        return folder;
    }
    QStringList left() const {
        return QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot);
    }
    static QByteArray contentOf(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    /// In the menu, and through its dialogs with what they suggest.
    void chooseSequence() {
        QAction* chosen = nullptr;
        for (QAction* action : m_window->findChildren<QAction*>()) {
            chosen = action->text() == QStringLiteral("Save Picture Seq&uence…") ? action : chosen;
        }
        QVERIFY(chosen != nullptr);
        QTimer answering;
        connect(&answering, &QTimer::timeout, this, [] {
            if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
                dialog->accept();
            }
        });
        answering.start(20);
        chosen->trigger();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_name;  ///< of the scene, as files have it
};

HITSCOPE_TEST(SequenceFoldersTest, QApplication)

}  // namespace hitscope::sequence_folders_test

#include "sequence_folders_test.moc"
