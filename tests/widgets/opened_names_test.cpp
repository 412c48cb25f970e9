// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of opened files: of their size, and by their names, whatever is in those.
#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTextDocument>
#include <QTextDocumentFragment>

#include "app/dialogs/dialogs.h"
#include "app/dialogs/go_to_vertex.h"
#include "app/dialogs/mesh_step_dialog.h"
#include "app/notice_bar.h"
#include "app/status_line.h"
#include "session/primitive_target.h"
#include "session/task_list.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::opened_names_test {

class OpenedNamesTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        makeWindow();
    }
    void cleanup() {
        dropWindow();
        m_folder.reset();
    }

    void theOfferToScaleGoesWithItsReason_data() {
        QTest::addColumn<std::function<void(Session&)>>("act");
        const auto row = [](const char* name, const std::function<void(Session&)>& act) {
            QTest::newRow(name) << act;
        };
        row("added", [](Session& session) { session.targets().add({planBuiltIn(BuiltInMesh::Teapot)}); });
        row("removed", [](Session& session) {
            const TargetId id = session.targets().front()->id;
            session.targets().remove({&id, 1});
        });
        row("scaled", [](Session& session) {
            TargetState larger = *session.targets().front();
            larger.shape = prepareMesh(makeUvSphere(12, 6, 2.0f));
            session.targets().replaceMeshes({&larger, 1}, [](const Hit& hit) { return hit; });
        });
        row("fits", [](Session& session) {
            ConstantsSetting setting = session.settings().constantsSetting();
            setting.relative = true;
            QVERIFY(session.settings().setConstants(setting).ok());
            session.settings().setFlightMode(FlightMode::Instant);
        });
    }
    void theOfferToScaleGoesWithItsReason() {
        QFETCH(std::function<void(Session&)>, act);
        ConstantsSetting setting = m_session->settings().constantsSetting();
        setting.relative = false;
        QVERIFY(m_session->settings().restoreConstants(setting).ok());
        open({QStringLiteral("small.obj")}, 0.01f);
        const auto* notice = m_window->findChild<NoticeBar*>();
        const auto* offer = notice->findChild<QPushButton*>();
        QVERIFY(notice->isVisible() && offer->isVisible() &&
                offer->text().startsWith(QStringLiteral("Scale to")));
        // It is as small under another name.
        QVERIFY(m_session->targets().rename(m_session->targets().front()->id, QStringLiteral("pea")).ok());
        QVERIFY(notice->isVisible());
        act(*m_session);
        QVERIFY2(!notice->isVisible(), qPrintable(notice->text()));
    }

    void recentFilesAreNamedInFull() {
        open({QStringLiteral("R&D.obj")});
        QMenu* recent = nullptr;
        for (const QAction* action : m_window->findChildren<QAction*>()) {
            recent = action->text() == QStringLiteral("Open &Recent") ? action->menu() : recent;
        }
        QVERIFY(recent != nullptr);
        Q_EMIT recent->aboutToShow();
        QCOMPARE(recent->actions().constFirst()->text(), QStringLiteral("R&&D.obj"));
    }

    void namesAreNoPlaces() {
        open({QStringLiteral("a%2.obj"), QStringLiteral("b.obj")});
        QCOMPARE(m_session->sceneName(), QStringLiteral("a%2 and 1 more"));
        const TargetId id = m_session->targets().front()->id;
        m_session->targets().duplicate({&id, 1});
        QCOMPARE(m_session->targets().back()->name, QStringLiteral("a%2 2"));
    }

    void namesAreNoMarkup() {
        open({QStringLiteral("plain.obj")});
        const QString name = QStringLiteral("<b>x</b>");
        QVERIFY(m_session->targets().rename(m_session->targets().front()->id, name).ok());
        const MeshStepDialog refine(MeshStepDialog::Kind::Refine, m_session->targets().front()->shape.mesh,
                                    name, {}, m_window.get());
        const QList<QLabel*> labels = refine.findChildren<QLabel*>();
        const auto named = std::find_if(labels.begin(), labels.end(),
                                        [&name](const QLabel* label) { return label->text() == name; });
        QVERIFY(named != labels.end());
        QCOMPARE((*named)->textFormat(), Qt::PlainText);
        const GoToVertexDialog vertex(*m_session, m_window.get());
        QCOMPARE(vertex.findChild<QLabel*>(QStringLiteral("range"))->textFormat(), Qt::PlainText);
    }

    void pathsAreNoMarkup() {
        const QString name = QStringLiteral("<i>x.obj");
        open({name});
        const QString path = m_folder->filePath(name);
        const auto shown = [](const QString& text) {
            return Qt::mightBeRichText(text) ? QTextDocumentFragment::fromHtml(text).toPlainText() : text;
        };
        QTRY_VERIFY2_WITH_TIMEOUT(shown(m_window->statusBar()->toolTip()).contains(name),
                                  qPrintable(m_window->statusBar()->toolTip()), kPatience);
        const std::unique_ptr<QMessageBox> box(
            makeErrorBox(m_window.get(), {"It is not there.", path.toStdString(), ""}, QMessageBox::Ok));
        QCOMPARE(shown(box->informativeText()), path);
        QCOMPARE(box->textFormat(), Qt::PlainText);
        for (const char* label : {"subject", "inForce", "attributionTitle", "problem", "report", "words"}) {
            const auto* found = m_window->findChild<QLabel*>(QLatin1String(label));
            QVERIFY2(found != nullptr && found->textFormat() == Qt::PlainText, label);
        }
    }

private:
    void open(const QStringList& names, float radius = 1.0f) {
        QStringList paths;
        for (const QString& name : names) {
            paths << m_folder->filePath(name);
            writeObj(makeUvSphere(12, 6, radius), paths.back());
        }
        m_window->openFiles(paths);
        QTRY_VERIFY_WITH_TIMEOUT(
            !m_session->targets().empty() && m_session->targets().front()->sourcePath == paths.front(),
            kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(m_session->tasks().current() == nullptr, kPatience);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

HITSCOPE_TEST(OpenedNamesTest, QApplication)

}  // namespace hitscope::opened_names_test

#include "opened_names_test.moc"
