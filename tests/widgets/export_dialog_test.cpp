// SPDX-License-Identifier: GPL-3.0-or-later
// What the export dialog offers, and the export without one.
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QSpinBox>
#include <QStatusBar>
#include <QTest>
#include <QTimer>

#include "app/actions/export_actions.h"
#include "app/dialogs/export_dialog.h"
#include "panels/help/help_text.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::export_dialog_test {

class ExportDialogTest : public QObject {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void offersWhatTheFormatHolds();
    void putsAllTargetsIntoTheScene();
    void proposesWhatIsSelected();
    void readsLargeFilesBackOnlyWhenAsked();
    void remembersTheLastChoice();
    void offersTheSelectedTargets();
    void exportsAgainWithoutAsking();
    void exportsTheSelectedTargets();

private:
    template <class Part>
    [[nodiscard]] static Part& part(ExportDialog& dialog, const char* name) {
        return *dialog.findChild<Part*>(QLatin1String(name));
    }
    static void choose(ExportDialog& dialog, ExportFormat format) {
        part<QComboBox>(dialog, "format").setCurrentIndex(static_cast<int>(format));
    }

    TestSettings m_settings;
    QTemporaryDir m_folder;
};

void ExportDialogTest::offersWhatTheFormatHolds() {
    ExportDialog dialog({.target = QStringLiteral("one"), .targets = 1, .hits = 3});
    QVERIFY(!part<QComboBox>(dialog, "what").isEnabled());
    for (const ExportFormatTraits& traits : exportFormats()) {
        choose(dialog, traits.format);
        QCOMPARE(dialog.options().format, traits.format);
        QCOMPARE(part<QComboBox>(dialog, "normals").isEnabled(), traits.hasNormals);
        QCOMPARE(part<QCheckBox>(dialog, "hasSteps").isEnabled(), traits.hasSteps);
        QCOMPARE(part<QCheckBox>(dialog, "readBack").isEnabled(), traits.format != ExportFormat::Csv);
        for (const char* name : {"hasSteps", "readBack", "allNormals"}) {
            const auto& box = part<QCheckBox>(dialog, name);
            QCOMPARE(whyDisabled(box).isEmpty(), box.isEnabled());
        }
    }
    choose(dialog, ExportFormat::Glb);
    QCOMPARE(dialog.options().steps, std::size_t{0});
    part<QCheckBox>(dialog, "hasSteps").setChecked(true);
    part<QSpinBox>(dialog, "steps").setValue(5);
    QCOMPARE(dialog.options().steps, std::size_t{5});
    QCOMPARE(dialog.options().stepOf, MorphUnit::Hit);
    choose(dialog, ExportFormat::Stl);
    QCOMPARE(dialog.options().steps, std::size_t{0});
    ExportDialog noHits({.target = QStringLiteral("one"), .targets = 1, .hits = 0});
    choose(noHits, ExportFormat::Glb);
    QCOMPARE(whyDisabled(part<QCheckBox>(noHits, "hasSteps")), QStringLiteral("There are no hits yet."));
}

void ExportDialogTest::putsAllTargetsIntoTheScene() {
    ExportDialog dialog({.target = QStringLiteral("one"), .targets = 3, .hits = 0});
    QVERIFY(dialog.scope() == ExportScope::OneTarget);
    QVERIFY(!dialog.options().inWorld);
    part<QComboBox>(dialog, "what").setCurrentIndex(1);
    QVERIFY(dialog.scope() == ExportScope::AllTargets);
    QVERIFY(dialog.options().inWorld);
    QVERIFY(!part<QComboBox>(dialog, "frame").isEnabled());
}

void ExportDialogTest::proposesWhatIsSelected() {
    const auto proposed = [](std::size_t selected) {
        ExportDialog dialog({.target = QStringLiteral("one"), .targets = 3, .selected = selected, .hits = 0});
        dialog.load(QSettings());
        return dialog.scope();
    };
    QCOMPARE(proposed(0), ExportScope::AllTargets);
    QCOMPARE(proposed(1), ExportScope::OneTarget);
    QCOMPARE(proposed(2), ExportScope::SelectedTargets);
    QCOMPARE(proposed(3), ExportScope::AllTargets);
}

void ExportDialogTest::readsLargeFilesBackOnlyWhenAsked() {
    std::uint64_t bytes = 99'000'000;
    ExportDialog::Choice choice{.target = QStringLiteral("one"), .targets = 2, .hits = 0};
    choice.estimate = [&bytes](ExportScope scope, const ExportOptions&) {
        return ExportEstimate{1000, 2000, scope == ExportScope::AllTargets ? 2 * bytes : bytes};
    };
    ExportDialog dialog(choice);
    QVERIFY(dialog.options().readBack);
    QVERIFY(part<QLabel>(dialog, "preview").text().contains(QStringLiteral("99")));
    part<QComboBox>(dialog, "what").setCurrentIndex(1);
    QVERIFY(!dialog.options().readBack);
    part<QCheckBox>(dialog, "readBack").setChecked(true);
    part<QComboBox>(dialog, "what").setCurrentIndex(0);
    part<QCheckBox>(dialog, "readBack").setChecked(false);
    part<QComboBox>(dialog, "what").setCurrentIndex(1);
    QVERIFY(dialog.options().readBack);
}

void ExportDialogTest::remembersTheLastChoice() {
    QSettings settings;
    {
        ExportDialog dialog({.target = QStringLiteral("one"), .targets = 1, .hits = 2});
        choose(dialog, ExportFormat::Gltf);
        part<QCheckBox>(dialog, "hasSteps").setChecked(true);
        part<QSpinBox>(dialog, "steps").setValue(9);
        part<QComboBox>(dialog, "stepOf").setCurrentIndex(1);
        part<QComboBox>(dialog, "frame").setCurrentIndex(1);
        part<QCheckBox>(dialog, "readBack").setChecked(false);
        dialog.save(settings);
    }
    ExportDialog dialog({.target = QStringLiteral("one"), .targets = 1, .hits = 2});
    dialog.load(settings);
    QCOMPARE(dialog.options().format, ExportFormat::Gltf);
    QCOMPARE(dialog.options().steps, std::size_t{9});
    QCOMPARE(dialog.options().stepOf, MorphUnit::Group);
    QVERIFY(dialog.options().inWorld);
    QVERIFY(!dialog.options().readBack);
    // Of several targets it is remembered which, and the coordinates of one are those that one had.
    for (const bool inWorld : {true, false}) {
        ExportDialog several({.target = QStringLiteral("one"), .targets = 3, .hits = 2});
        several.load(settings);
        part<QComboBox>(several, "what").setCurrentIndex(0);
        part<QComboBox>(several, "frame").setCurrentIndex(inWorld ? 1 : 0);
        part<QComboBox>(several, "what").setCurrentIndex(1);
        QVERIFY(several.options().inWorld);
        several.save(settings);
        ExportDialog again({.target = QStringLiteral("one"), .targets = 3, .hits = 2});
        again.load(settings);
        QVERIFY(again.scope() == ExportScope::AllTargets);
        part<QComboBox>(again, "what").setCurrentIndex(0);
        QCOMPARE(again.options().inWorld, inWorld);
    }
}

void ExportDialogTest::offersTheSelectedTargets() {
    QSettings settings;
    for (const std::size_t selected : {0, 1, 2, 3}) {
        ExportDialog dialog({.target = QStringLiteral("one"), .targets = 3, .selected = selected});
        dialog.load(settings);
        const bool isOffered = selected == 2;
        QCOMPARE(part<QComboBox>(dialog, "what").count(), isOffered ? 3 : 2);
        QCOMPARE(dialog.scope() == ExportScope::SelectedTargets, isOffered);
        QCOMPARE(dialog.options().inWorld, dialog.scope() != ExportScope::OneTarget);
    }
}

void ExportDialogTest::exportsTheSelectedTargets() {
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QSettings().clear();
    Session session;
    loadMesh(session, makeHighPolyCube(2.5f));
    session.targets().add({planMesh(makeLowPolyCube()), planMesh(makeLowPolyCube())});
    session.targets().select(session.targets()[2]->id, std::vector{session.targets()[1]->id});
    MainWindow window(session);
    showReady(window);
    const QString path = m_folder.filePath(QStringLiteral("two.obj"));
    const auto objects = [&path] {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll().count("\no ") : -1;
    };
    QTimer timer;
    connect(&timer, &QTimer::timeout, &window, [&] {
        QWidget* const modal = QApplication::activeModalWidget();
        if (auto* options = qobject_cast<ExportDialog*>(modal)) {
            choose(*options, ExportFormat::Obj);
            options->accept();
        } else if (auto* dialog = qobject_cast<QFileDialog*>(modal)) {
            timer.stop();
            dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path);
            QMetaObject::invokeMethod(dialog, "accept");
        }
    });
    timer.start(50);
    QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(objects(), 2, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(window.statusBar()->currentMessage().contains(QStringLiteral("2 targets")),
                             kPatience);
    // Again: those, whatever is selected now; not where one of them is gone.
    session.targets().select(session.targets()[0]->id);
    QVERIFY(QFile::remove(path));
    makeActive(window);
    QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE_WITH_TIMEOUT(objects(), 2, kPatience);
    const TargetId last = session.targets()[2]->id;
    session.targets().remove({&last, 1});
    QVERIFY(!window.findChild<QAction*>(QStringLiteral("exportAgain"))->isEnabled());
}

void ExportDialogTest::exportsAgainWithoutAsking() {
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QSettings().clear();
    Session session;
    loadMesh(session, makeHighPolyCube(2.5f));
    MainWindow window(session);
    showReady(window);
    auto* again = window.findChild<QAction*>(QStringLiteral("exportAgain"));
    QVERIFY(again != nullptr);
    QVERIFY(!again->isEnabled());
    QCOMPARE(whyDisabled(*again), QStringLiteral("Nothing was exported yet."));
    const QString path = m_folder.filePath(QStringLiteral("again.glb"));
    QTimer timer;
    connect(&timer, &QTimer::timeout, &window, [&] {
        QWidget* const modal = QApplication::activeModalWidget();
        if (auto* options = qobject_cast<ExportDialog*>(modal)) {
            choose(*options, ExportFormat::Glb);
            options->accept();
        } else if (auto* dialog = qobject_cast<QFileDialog*>(modal)) {
            timer.stop();
            dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path);
            QMetaObject::invokeMethod(dialog, "accept");
        }
    });
    timer.start(50);
    QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(path), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(window.statusBar()->currentMessage().contains(QStringLiteral("read back")),
                             kPatience);
    makeActive(window);
    const qint64 before = QFileInfo(path).size();
    Hit hit;
    hit.target = session.targets().front()->id;
    hit.point = {0.0f, 2.5f, 0.0f};
    hit.direction = {0.0f, -1.0f, 0.0f};
    QVERIFY(session.hits().add(hit).ok());
    QVERIFY(again->isEnabled());
    QVERIFY2(again->text().contains(QStringLiteral("again.glb")), qPrintable(again->text()));
    QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo(path).size() > before, kPatience);
    session.hits().show(0);  // of a part of the history it says so
    QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(
        window.statusBar()->currentMessage().contains(QStringLiteral("after hit 0 of 1")), kPatience);
    session.hits().show(std::nullopt);
    const TargetId first = session.targets().front()->id;
    session.targets().add({planMesh(makeLowPolyCube())});
    session.targets().remove({&first, 1});
    QCOMPARE(session.targets().size(), std::size_t{1});  // which the file is not of
    QVERIFY(!again->isEnabled());
    QCOMPARE(whyDisabled(*again), QStringLiteral("What was exported last is not in the scene."));
}

HITSCOPE_TEST(ExportDialogTest, QApplication)

}  // namespace hitscope::export_dialog_test

#include "export_dialog_test.moc"
