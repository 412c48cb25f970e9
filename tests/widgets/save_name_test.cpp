// SPDX-License-Identifier: GPL-3.0-or-later
// What is saved from the window replaces nothing that the person did not mean.
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "app/actions/export_actions.h"
#include "app/dialogs/export_dialog.h"
#include "app/mesh_reloader.h"
#include "app/notice_bar.h"
#include "app/session_files.h"
#include "session/mesh_steps/mesh_edit.h"
#include "session/target_plan.h"
#include "session/task_list.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::save_name_test {

namespace {

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class SaveNameTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        m_folder = std::make_unique<QTemporaryDir>();
        writeObj(makeHighPolySphere(2.5f), at("ball.obj"));
        makeWindow([this](Session& session) { loadMesh(session, makeHighPolySphere(2.5f), at("ball.obj")); });
        Hit hit;
        hit.target = m_session->targets().front()->id;
        hit.point = {0.0f, 0.0f, 2.5f};
        hit.direction = {0.0f, 0.0f, -1.0f};
        QVERIFY(m_session->hits().add(hit).ok());
        m_asked.clear();
    }
    void cleanup() { dropWindow(); }

    void aSessionHasItsSuffix();
    void whatExistsIsNamed();
    void aSessionThatOthersChangedIsNotReplacedUnasked();
    void anExportOverItsMeshSaysWhatComesOfIt();
    void aRefinedMeshIsExportedAgain();
    void aKnownSuffixDecidesTheFormat();

private:
    [[nodiscard]] QString at(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    /// Chooses that name in file dialogs, and clicks that button in questions; dialogs after the first
    /// question that is answered by Cancel are closed.
    void answer(const QString& name, const QString& button) {
        auto* timer = new QTimer(m_window.get());
        connect(timer, &QTimer::timeout, m_window.get(), [this, name, button] {
            QWidget* modal = QApplication::activeModalWidget();
            if (auto* box = qobject_cast<QMessageBox*>(modal)) {
                m_asked << box->text() + u' ' + box->informativeText();
                for (QAbstractButton* choice : box->buttons()) {
                    if (choice->text().remove(u'&') == button) {
                        choice->click();
                        return;
                    }
                }
                box->reject();
            } else if (auto* options = qobject_cast<ExportDialog*>(modal)) {
                options->accept();
            } else if (auto* dialog = qobject_cast<QFileDialog*>(modal)) {
                if (!m_asked.isEmpty() && button == QLatin1String("Cancel")) {
                    dialog->reject();
                    return;
                }
                dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(name);
                QMetaObject::invokeMethod(dialog, "accept");
            }
        });
        timer->start(30);
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
        makeActive(*m_window);
        QTest::keyClick(m_window.get(), key, modifiers);
        QTRY_VERIFY_WITH_TIMEOUT(!files().isBusy() && m_session->tasks().size() == 0, kPatience);
    }
    [[nodiscard]] SessionFiles& files() const { return *m_window->findChild<SessionFiles*>(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    QStringList m_asked;
};

/// A refined mesh is another target.
void SaveNameTest::aRefinedMeshIsExportedAgain() {
    auto& exports = *m_window->findChild<ExportActions*>();
    const auto* again = m_window->findChild<QAction*>(QStringLiteral("exportAgain"));
    QSignalSpy ended(&exports, &ExportActions::ended);
    answer(at("dented.obj"), QStringLiteral("Replace"));
    key(Qt::Key_E, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatience);
    const TargetId before = m_session->targets().front()->id;
    const MeshEdit edit = meshEdit(*m_session, before, SmoothOptions{});
    const Target& target = *m_session->targets().front();
    Result<EditedMesh> smooth = edited(*target.shape.mesh, edit);
    QVERIFY(smooth.ok());
    QVERIFY(takeEdited(*m_session, stateWith(target, std::move(smooth).value()), edit).ok());
    QVERIFY(m_session->targets().front()->id != before);
    QVERIFY(again->isEnabled());
    key(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 2, kPatience);
}

/// The name of the mesh would make the mesh a session.
void SaveNameTest::aSessionHasItsSuffix() {
    const QByteArray mesh = contentOf(at("ball.obj"));
    answer(at("ball.obj"), QStringLiteral("Replace"));
    key(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE_WITH_TIMEOUT(files().path(), at("ball.obj.hitscope"), kPatience);
    QVERIFY(m_asked.isEmpty());
    QCOMPARE(contentOf(at("ball.obj")), mesh);
}

/// With the suffix that is added.
void SaveNameTest::whatExistsIsNamed() {
    QFile other(at("other.hitscope"));
    QVERIFY(other.open(QIODevice::WriteOnly));
    other.write("kept");
    other.close();
    answer(at("other"), QStringLiteral("Cancel"));
    key(Qt::Key_S, Qt::ControlModifier);
    QCOMPARE(m_asked.size(), 1);
    QVERIFY2(m_asked.front().startsWith(QStringLiteral("other.hitscope already exists")),
             qPrintable(m_asked.front()));
    QCOMPARE(contentOf(at("other.hitscope")), QByteArray("kept"));
}

void SaveNameTest::aSessionThatOthersChangedIsNotReplacedUnasked() {
    const QString path = at("s.hitscope");
    files().save(path);
    QTRY_COMPARE_WITH_TIMEOUT(files().path(), path, kPatience);
    const auto isKnown = [&] { return knownContentOf(*m_window, path) == meshFileAt(path).sha256; };
    QTRY_VERIFY_WITH_TIMEOUT(isKnown(), kPatience);
    QVERIFY(m_session->hits().add(m_session->hits().history().hits().front()).ok());
    key(Qt::Key_S, Qt::ControlModifier);  // as it was left: no question
    QVERIFY(!files().isChangedByOthers());
    QTRY_VERIFY_WITH_TIMEOUT(isKnown(), kPatience);  // what is saved here is no news
    QVERIFY(m_window->findChild<NoticeBar*>()->text().isEmpty());
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Append));
    file.write("\n");
    file.close();
    QVERIFY(files().isChangedByOthers());
    const auto& notice = *m_window->findChild<NoticeBar*>();
    QTRY_VERIFY2_WITH_TIMEOUT(notice.text().startsWith(QStringLiteral("s.hitscope was changed by another")),
                              qPrintable(notice.text()), kPatience);
    const QByteArray theirs = contentOf(path);
    answer({}, QStringLiteral("Cancel"));
    key(Qt::Key_S, Qt::ControlModifier);
    QCOMPARE(m_asked.size(), 1);
    QVERIFY2(m_asked.front().contains(QStringLiteral("another program")), qPrintable(m_asked.front()));
    QCOMPARE(contentOf(path), theirs);
    delete m_window->findChild<QTimer*>(QString(), Qt::FindDirectChildrenOnly);
}

void SaveNameTest::anExportOverItsMeshSaysWhatComesOfIt() {
    auto& exports = *m_window->findChild<ExportActions*>();
    const auto& reloader = *m_window->findChild<MeshReloader*>();
    const QByteArray mesh = contentOf(at("ball.obj"));
    answer(at("ball.obj"), QStringLiteral("Replace"));
    QSignalSpy ended(&exports, &ExportActions::ended);
    key(Qt::Key_E, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatience);
    QCOMPARE(m_asked.size(), 1);
    QVERIFY2(m_asked.front().contains(QStringLiteral("applies the hits to it again")),
             qPrintable(m_asked.front()));
    QVERIFY(contentOf(at("ball.obj")) != mesh);
    const QString written = at("ball.obj");
    QTRY_COMPARE_WITH_TIMEOUT(knownContentOf(*m_window, written), meshFileAt(written).sha256, kPatience);
    QVERIFY(reloader.changedFiles().isEmpty());
}

/// What is named is written, in the format that its name says.
void SaveNameTest::aKnownSuffixDecidesTheFormat() {
    auto& exports = *m_window->findChild<ExportActions*>();
    const auto written = [&](const char* name) {
        QSignalSpy ended(&exports, &ExportActions::ended);
        answer(at(name), QStringLiteral("Cancel"));
        key(Qt::Key_E, Qt::ControlModifier);
        const bool isEnded = QTest::qWaitFor([&] { return ended.size() == 1; }, kPatience);
        delete m_window->findChild<QTimer*>(QString(), Qt::FindDirectChildrenOnly);
        return isEnded;
    };
    QVERIFY(written("dented.PLY"));  // the dialog is for OBJ
    QVERIFY2(contentOf(at("dented.PLY")).startsWith("ply\nformat binary"), "no PLY");
    QVERIFY(written("dented.csv"));
    QVERIFY(!contentOf(at("dented.csv")).isEmpty());
    QVERIFY(written("dented.fbx"));  // Hitscope writes none
    QVERIFY(contentOf(at("dented.fbx.obj")).contains("\nv "));
    QCOMPARE(QDir(m_folder->path()).entryList({QStringLiteral("dented*")}, QDir::Files, QDir::Name),
             QStringList({QStringLiteral("dented.PLY"), QStringLiteral("dented.csv"),
                          QStringLiteral("dented.fbx.obj")}));
    QVERIFY2(m_asked.isEmpty(), qPrintable(m_asked.join(u' ')));
}

HITSCOPE_TEST(SaveNameTest, QApplication)

}  // namespace hitscope::save_name_test

#include "save_name_test.moc"
