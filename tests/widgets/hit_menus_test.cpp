// SPDX-License-Identifier: GPL-3.0-or-later
// What the window's menus say and do about hits, pipelines and the normals of an export.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QStandardItemModel>
#include <QStatusBar>
#include <QTimer>
#include <functional>

#include "app/dialogs/export_dialog.h"
#include "app/notice_bar.h"
#include "mesh/primitives.h"
#include "session/task_list.h"
#include "support/read_back.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::hit_menus_test {

class HitMenusTest : public QObject {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init();
    void cleanup();
    void undoNamesTheStep();
    void enablesAll();
    void statusBarCountsHits();
    void messagesHaveRoomInANarrowWindow();
    void unavailablePipelinesAreGrey();
    void rememberedPipelineFallsBack();
    void exportOffersEitherNormals();

private:
    void addHits(int count);
    QAction* action(const MainWindow& window, const QString& start) const;
    QByteArray chooseInDialog(MainWindow& window, const std::function<void(ExportDialog&)>& choose) const;

    std::unique_ptr<TestSettings> m_settings;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Session> m_session;
};

void HitMenusTest::init() {
    m_settings = std::make_unique<TestSettings>();
    m_folder = std::make_unique<QTemporaryDir>();
    m_session = std::make_unique<Session>();
    loadMesh(*m_session, makeHighPolyCube(2.5f));
}

void HitMenusTest::cleanup() {
    m_session.reset();
    m_folder.reset();
    m_settings.reset();
}

void HitMenusTest::addHits(int count) {
    for (int i = 0; i < count; ++i) {
        Hit hit;
        hit.target = m_session->targets().front()->id;
        hit.point = {0.1f * static_cast<float>(i), 0.0f, 2.5f};
        hit.direction = {0.6f, 0.0f, -0.8f};
        QVERIFY(m_session->hits().add(hit).ok());
    }
}

QAction* HitMenusTest::action(const MainWindow& window, const QString& start) const {
    for (QAction* action : window.findChildren<QAction*>()) {
        if (action->text().startsWith(start)) {
            return action;
        }
    }
    return nullptr;
}

void HitMenusTest::undoNamesTheStep() {
    MainWindow window(*m_session);
    showReady(window);
    QAction* undo = action(window, QStringLiteral("&Undo"));
    QAction* redo = action(window, QStringLiteral("&Redo"));
    QCOMPARE(undo->text(), QStringLiteral("&Undo"));
    QVERIFY(!undo->isEnabled());
    addHits(5);
    QCOMPARE(undo->text(), QStringLiteral("&Undo Hit 5"));
    m_session->hits().remove(std::vector<std::size_t>{0, 2, 3});
    QCOMPARE(undo->text(), QStringLiteral("&Undo Remove 3 Hits"));
    m_session->hits().move(std::vector<std::size_t>{0}, 2);
    QCOMPARE(undo->text(), QStringLiteral("&Undo Reorder Hit 1"));
    m_session->hits().setEnabled(std::vector<std::size_t>{0, 1}, false);
    QCOMPARE(undo->text(), QStringLiteral("&Undo Disable 2 Hits"));
    DeformationConstants constants;
    constants.power = 0.1f;
    QVERIFY(m_session->settings().setConstants(constants).ok());
    QCOMPARE(undo->text(), QStringLiteral("&Undo Power for Next Hit"));
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(undo->text(), QStringLiteral("&Undo Disable 2 Hits"));
    QCOMPARE(redo->text(), QStringLiteral("&Redo Power for Next Hit"));
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(m_session->hits().disabled(), std::size_t{0});
    QCOMPARE(redo->text(), QStringLiteral("&Redo Disable 2 Hits"));
    QTest::keyClick(&window, Qt::Key_H);
    QVERIFY(!m_session->settings().lights().points[0].on);
    QCOMPARE(undo->text(), QStringLiteral("&Undo Lights"));
    QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(m_session->settings().lights().points[0].on);
}

void HitMenusTest::enablesAll() {
    MainWindow window(*m_session);
    showReady(window);
    addHits(3);
    QAction* enable = action(window, QStringLiteral("&Enable All"));
    QVERIFY(!enable->isEnabled());
    m_session->hits().setEnabled(std::vector<std::size_t>{0, 2}, false);
    QVERIFY(enable->isEnabled());
    enable->trigger();
    QCOMPARE(m_session->hits().disabled(), std::size_t{0});
    QVERIFY(!enable->isEnabled());
}

void HitMenusTest::statusBarCountsHits() {
    MainWindow window(*m_session);
    showReady(window);
    const auto says = [&window](const QString& text) {
        const QList<QLabel*> labels = window.statusBar()->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* label) { return label->text() == text; });
    };
    addHits(3);
    QVERIFY(says(QStringLiteral("3 hits")));
    m_session->hits().setEnabled(std::vector<std::size_t>{1}, false);
    QVERIFY(says(QStringLiteral("3 hits, 1 disabled")));
    test::readBackOf(*m_session).setCapacity({1, false, 1, {0}});
    QVERIFY(says(QStringLiteral("3 hits of 1, 1 disabled, 1 dropped")));
}

void HitMenusTest::messagesHaveRoomInANarrowWindow() {
    MainWindow window(*m_session);
    showReady(window);
    window.resize(1024, 640);
    QStatusBar& bar = *window.statusBar();
    const QString said = QStringLiteral("WusonOBJ: 3,009 vertices, 3,562 faces now (Ctrl+Z undoes)");
    const auto leftmost = [&bar] {
        int x = bar.width();
        for (const QLabel* label : bar.findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly)) {
            x = label->isVisible() ? std::min(x, label->x()) : x;
        }
        return x;
    };
    QTRY_VERIFY_WITH_TIMEOUT(leftmost() < bar.width() / 2, kPatience);
    const int before = leftmost();
    bar.showMessage(said);
    QTRY_VERIFY_WITH_TIMEOUT(leftmost() > bar.fontMetrics().horizontalAdvance(said), kPatience);
    bar.clearMessage();
    QTRY_COMPARE_WITH_TIMEOUT(leftmost(), before, kPatience);
}

void HitMenusTest::unavailablePipelinesAreGrey() {
    MainWindow window(*m_session);
    showReady(window);
    auto* box = window.findChild<QComboBox*>(QStringLiteral("pipeline"));
    QCOMPARE(static_cast<std::size_t>(box->count()), allPipelines().size());
    const auto* items = qobject_cast<const QStandardItemModel*>(box->model());
    const int row = box->findData(static_cast<int>(PipelineKind::UniformArray));
    QAction* entry = action(window, QStringLiteral("Uniform array"));
    const QString reason = QStringLiteral("It needs OpenGL 9.9.");
    QVERIFY(items->item(row)->isEnabled() && entry->isEnabled());
    test::readBackOf(*m_session).setUnavailablePipelines({{PipelineKind::UniformArray, reason}});
    QVERIFY(!items->item(row)->isEnabled() && !entry->isEnabled());
    QVERIFY(items->item(row)->toolTip().contains(reason) && entry->toolTip().contains(reason));
    const PipelineTraits& traits = pipelineTraits(PipelineKind::UniformArray);
    for (const std::string_view words : {traits.description, traits.needs, traits.keeps}) {
        const QString text = QString::fromUtf8(words);
        QVERIFY2(items->item(row)->toolTip().contains(text.toHtmlEscaped()), qPrintable(text));
    }
    test::readBackOf(*m_session).setUnavailablePipelines({});
    QVERIFY(items->item(row)->isEnabled() && entry->isEnabled());

    entry->trigger();
    QCOMPARE(m_session->settings().pipeline(), PipelineKind::UniformArray);
    QCOMPARE(box->currentIndex(), row);
}

void HitMenusTest::rememberedPipelineFallsBack() {
    {
        MainWindow window(*m_session);
        showReady(window);
        m_session->settings().setPipeline(PipelineKind::UniformArray);
        window.close();
    }
    MainWindow window(*m_session);
    QCOMPARE(m_session->settings().pipeline(), PipelineKind::UniformArray);
    test::readBackOf(*m_session)
        .setUnavailablePipelines({{PipelineKind::UniformArray, QStringLiteral("Too few uniforms.")}});
    QCOMPARE(m_session->settings().pipeline(), PipelineKind::TransformFeedback);
    const auto* notice = window.findChild<NoticeBar*>();
    QTRY_VERIFY2_WITH_TIMEOUT(notice->text().contains(QStringLiteral("Too few uniforms.")),
                              qPrintable(notice->text()), kPatience);
    QVERIFY(notice->text().contains(QStringLiteral("Uniform array")));
    QVERIFY(notice->text().contains(QStringLiteral("Transform feedback")));
}

/// What Ctrl+E writes when `choose` has been at its dialog.
QByteArray HitMenusTest::chooseInDialog(MainWindow& window,
                                        const std::function<void(ExportDialog&)>& choose) const {
    const QString path = m_folder->filePath(QStringLiteral("dented.obj"));
    QFile::remove(path);
    QTimer timer;
    connect(&timer, &QTimer::timeout, &window, [&] {
        QWidget* const modal = QApplication::activeModalWidget();
        if (auto* options = qobject_cast<ExportDialog*>(modal)) {
            choose(*options);
            options->accept();
        } else if (auto* dialog = qobject_cast<QFileDialog*>(modal)) {
            // As typed; selectFile() leaves the name alone while it has the focus.
            dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path);
            QMetaObject::invokeMethod(dialog, "accept");
        } else if (auto* message = qobject_cast<QMessageBox*>(modal)) {
            message->reject();  // or the dialog behind it would wait for ever
            QFAIL(qPrintable(message->text()));
        }
    });
    timer.start(50);
    QTest::keyClick(&window, Qt::Key_E, Qt::ControlModifier);
    timer.stop();
    // It is written in the background, and is read back and compared once it is there: it stays until then.
    [&] { QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path) && m_session->tasks().size() == 0, kPatience); }();
    makeActive(window);
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void HitMenusTest::exportOffersEitherNormals() {
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    addHits(3);
    const auto written = [this](MainWindow& window, NormalMode mode) {
        const QString path = m_folder->filePath(QStringLiteral("expected.obj"));
        [&] { QVERIFY(window.exportTo(path, mode).ok()); }();
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const auto normalsOf = [](ExportDialog& dialog) {
        return dialog.findChild<QComboBox*>(QStringLiteral("normals"));
    };
    NormalMode preselected{};
    const auto keep = [&](ExportDialog& dialog) { preselected = dialog.options().normals; };
    {
        MainWindow window(*m_session);
        showReady(window);
        const QByteArray withTrue = written(window, NormalMode::True);
        const QByteArray withPapers = written(window, NormalMode::Paper);
        QVERIFY(!withTrue.isEmpty() && withTrue != withPapers);
        QVERIFY(chooseInDialog(window, keep) == withTrue);
        QCOMPARE(preselected, NormalMode::True);
        QTest::keyClick(&window, Qt::Key_N);
        QVERIFY(chooseInDialog(window, keep) == withPapers);
        QCOMPARE(preselected, NormalMode::Paper);
        QTest::keyClick(&window, Qt::Key_N);
        const auto papers = [&](ExportDialog& dialog) { normalsOf(dialog)->setCurrentIndex(1); };
        QVERIFY(chooseInDialog(window, papers) == withPapers);
        window.close();
    }
    MainWindow window(*m_session);
    showReady(window);
    QVERIFY(!chooseInDialog(window, keep).isEmpty());
    QCOMPARE(preselected, NormalMode::Paper);  // as chosen the last time
}

HITSCOPE_TEST(HitMenusTest, QApplication)

}  // namespace hitscope::hit_menus_test

#include "hit_menus_test.moc"
