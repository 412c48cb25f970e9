// SPDX-License-Identifier: GPL-3.0-or-later
// Filtering, sorting, scrubbing and editing in the hit history's panel, by mouse and keys; and what the
// window does with it.
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSlider>
#include <QTableView>
#include <QTimer>
#include <QToolButton>
#include <set>

#include "app/actions/hit_actions.h"
#include "panels/hit_history/hit_history_panel.h"
#include "panels/hit_history/time_scrubber.h"
#include "session/vertex_selection.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::hit_history_tools_test {

class HitHistoryToolsTest : public QObject {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private:
    void addHits(int count) const {
        for (int i = 0; i < count; ++i) {
            const std::size_t made = m_session->hits().history().size();
            Hit hit;
            hit.target = m_session->targets()[made % 4]->id;
            hit.point = {0.1f * static_cast<float>(made % 10), 0.0f, 2.5f};
            hit.speed = static_cast<float>((made * 7) % 13);
            QVERIFY(m_session->hits().add(hit).ok());
        }
    }
    [[nodiscard]] QRect cell(int row, int column) const {
        return m_table->visualRect(m_table->model()->index(row, column));
    }
    template <class Widget>
    [[nodiscard]] Widget* part(const char* name) const {
        return m_panel->findChild<Widget*>(QString::fromLatin1(name));
    }
    [[nodiscard]] QString summary() const { return part<QLabel>("summary")->text(); }
    [[nodiscard]] std::size_t shown() const { return m_session->hits().shown().size(); }
    static void press(QToolButton* button) { QTest::mouseClick(button, Qt::LeftButton); }

    std::unique_ptr<TestSettings> m_settings;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<HitEffects> m_effects;
    std::unique_ptr<HitHistoryModel> m_model;
    std::unique_ptr<HitHistoryPanel> m_panel;
    QTableView* m_table = nullptr;

private Q_SLOTS:
    void init() {
        m_settings = std::make_unique<TestSettings>();
        m_session = std::make_unique<Session>();
        loadPaperRow(*m_session, kDefaultPaperRow);
        m_effects = std::make_unique<HitEffects>(*m_session);
        m_model = std::make_unique<HitHistoryModel>(*m_session, m_effects.get());
        m_panel = std::make_unique<HitHistoryPanel>(*m_session, *m_model);
        m_table = m_panel->findChild<QTableView*>();
        m_panel->resize(900, 300);
        m_panel->show();
        makeActive(*m_panel);
        addHits(12);
        m_table->setFocus();
    }
    void cleanup() {
        m_panel.reset();
        m_model.reset();
        m_effects.reset();
        m_session.reset();
        m_settings.reset();
    }

    void headerSorts() {
        QHeaderView* header = m_table->horizontalHeader();
        const auto click = [header](int column) {
            QTest::mouseClick(header->viewport(), Qt::LeftButton, {},
                              {header->sectionViewportPosition(column) + 20, header->height() / 2});
        };
        const auto speed = [this](int row) {
            return m_table->model()->index(row, HitHistoryModel::SpeedColumn).data().toString();
        };
        click(HitHistoryModel::SpeedColumn);
        QCOMPARE(speed(0), QStringLiteral("0.00"));
        click(HitHistoryModel::SpeedColumn);
        QCOMPARE(speed(0), QStringLiteral("12.00"));
        // The row that is chosen is the hit that is.
        QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, cell(0, 2).center());
        const std::size_t hit = *m_session->hits().selected();
        QCOMPARE(m_session->hits().history().hits()[hit].speed, 12.0f);
        QTest::keyClick(m_table, Qt::Key_Space);
        QVERIFY(!m_session->hits().history().hits()[hit].enabled);
        const std::vector<Hit> before(m_session->hits().history().hits().begin(),
                                      m_session->hits().history().hits().end());
        QTest::keyClick(m_table, Qt::Key_Up, Qt::AltModifier);
        QVERIFY(std::ranges::equal(m_session->hits().history().hits(), before));
        click(HitHistoryModel::SpeedColumn);  // a third time: the history's order again
        QCOMPARE(m_table->model()->index(0, 0).data().toString(), QStringLiteral("1"));
        QTest::keyClick(m_table, Qt::Key_Delete);
        QCOMPARE(m_session->hits().history().size(), std::size_t{11});
        for (const Hit& left : m_session->hits().history().hits()) {
            QVERIFY(left.speed != 12.0f);
        }
    }

    void filterByKeys() {
        auto* text = part<QLineEdit>("filterText");
        QVERIFY(!text->isVisible());
        QTest::keyClick(m_table, Qt::Key_F, Qt::ControlModifier);
        QVERIFY(text->isVisible());
        QVERIFY(text->hasFocus());
        QTest::keyClicks(text, m_session->targets()[2]->name);
        QCOMPARE(m_table->model()->rowCount(), 3);
        QCOMPARE(summary(), QStringLiteral("3 of 12 listed"));
        m_session->hits().setEnabled(std::vector<std::size_t>{2}, false);
        QTest::mouseClick(part<QCheckBox>("filterEnabled"), Qt::LeftButton, {}, {8, 8});
        QCOMPARE(m_table->model()->rowCount(), 2);
        QTest::keyClick(text, Qt::Key_Escape);
        QVERIFY(!text->isVisible());
        QCOMPARE(m_table->model()->rowCount(), 12);
        QCOMPARE(summary(), QStringLiteral("12 hits, 1 disabled"));
        QVERIFY(m_table->hasFocus());
        QTest::keyClick(m_table, Qt::Key_F, Qt::ControlModifier);
        text->clear();
        part<QComboBox>("filterTarget")->setFocus();
        QTest::keyClick(part<QComboBox>("filterTarget"), Qt::Key_Down);
        part<QCheckBox>("filterEnabled")->setChecked(false);
        QCOMPARE(m_table->model()->rowCount(), 3);
    }

    void scrubbing() {
        auto* slider = part<QSlider>("time");
        QCOMPARE(slider->maximum(), 12);
        QCOMPARE(slider->value(), 12);
        press(part<QToolButton>("stepBack"));
        QCOMPARE(shown(), std::size_t{11});
        QCOMPARE(summary(), QStringLiteral("After hit 11 of 12"));
        QCOMPARE(m_model->index(11, 0).data(HitHistoryModel::HitStateRole).toInt(),
                 static_cast<int>(HitHistoryModel::Later));
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_Left);
        QCOMPARE(shown(), std::size_t{10});
        QTest::keyClick(slider, Qt::Key_Home);
        QCOMPARE(shown(), std::size_t{0});
        QVERIFY(!part<QToolButton>("stepBack")->isEnabled());
        press(part<QToolButton>("stepOn"));
        QCOMPARE(shown(), std::size_t{1});
        QCOMPARE(m_session->hits().history().size(), std::size_t{12});
        QVERIFY(m_session->steps().toUndo()->kind == SessionUndo::Kind::Hit);  // nothing of it can be undone
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_Escape);
        QVERIFY(m_session->hits().showsAll());
        QCOMPARE(summary(), QStringLiteral("12 hits"));
        QTest::keyClick(slider, Qt::Key_PageUp);
        QTest::keyClick(slider, Qt::Key_Home);
        QTest::keyClick(slider, Qt::Key_End);
        QVERIFY(m_session->hits().showsAll());
    }

    void playing() {
        const auto* scrubber = m_panel->findChild<TimeScrubber*>();
        std::vector<std::size_t> seen;
        connect(&m_session->hits(), &SessionHits::shownChanged, this, [&] { seen.push_back(shown()); });
        press(part<QToolButton>("play"));
        QVERIFY(scrubber->isPlaying());
        QTRY_VERIFY_WITH_TIMEOUT(!scrubber->isPlaying(), kPatience);
        QVERIFY(m_session->hits().showsAll());
        QCOMPARE(seen.size(), std::size_t{13});
        QVERIFY(std::is_sorted(seen.begin(), seen.end()));
        press(part<QToolButton>("play"));
        QTRY_VERIFY_WITH_TIMEOUT(shown() > 1, kPatience);
        press(part<QToolButton>("play"));
        QVERIFY(!scrubber->isPlaying());
        const std::size_t stopped = shown();
        QVERIFY(stopped < 12);
        press(part<QToolButton>("play"));  // from there
        QVERIFY(shown() >= stopped);
        addHits(1);  // who shoots wants to see it
        QVERIFY(!scrubber->isPlaying());
        QVERIFY(m_session->hits().showsAll());
    }

    void editingIsAskedFor() {
        QSignalSpy wanted(m_panel.get(), &HitHistoryPanel::editWanted);
        QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, cell(5, 2).center());
        QTest::keyClick(m_table, Qt::Key_F2);
        QCOMPARE(wanted.size(), 1);
        QCOMPARE(m_session->hits().selected(), std::optional<std::size_t>(5));
    }

    void doubleClickFlies() {
        QSignalSpy flown(m_panel.get(), &HitHistoryPanel::flyWanted);
        QTest::mouseClick(m_table->viewport(), Qt::LeftButton, {}, cell(3, 2).center());
        QTest::mouseDClick(m_table->viewport(), Qt::LeftButton, {}, cell(3, 2).center());
        QCOMPARE(flown.size(), 1);
        const auto part = flown[0][0].value<Bounds>();
        const Hit& hit = m_session->hits().history().hits()[3];
        const glm::vec3 point = m_session->targets().find(hit.target)->transform.toWorld(hit.point);
        QVERIFY(glm::length(part.centre() - point) < 1e-3f);
        QTest::keyClick(m_table, Qt::Key_Return);
        QCOMPARE(flown.size(), 2);
    }

    void columnsAreShownAndKept() {
        QHeaderView* header = m_table->horizontalHeader();
        QVERIFY(header->isSectionHidden(HitHistoryModel::PipelineColumn));
        QTimer::singleShot(0, this, [] {
            QMenu* menu = nullptr;
            QTRY_VERIFY_WITH_TIMEOUT(
                (menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())) != nullptr, kPatience);
            for (QAction* action : menu->actions()) {
                if (action->text() == QStringLiteral("Pipeline")) {
                    // By key: Qt 6.8 passes over a click right after the menu has opened.
                    menu->setActiveAction(action);
                    QTest::keyClick(menu, Qt::Key_Return);
                    return;
                }
            }
            menu->close();
        });
        QContextMenuEvent event(QContextMenuEvent::Mouse, {30, 5},
                                header->viewport()->mapToGlobal(QPoint(30, 5)));
        QCoreApplication::sendEvent(header->viewport(), &event);
        QTRY_VERIFY_WITH_TIMEOUT(!header->isSectionHidden(HitHistoryModel::PipelineColumn), kPatience);
        header->resizeSection(HitHistoryModel::TargetColumn, 173);
        const QByteArray kept = m_panel->columns();
        HitHistoryPanel other(*m_session, *m_model);
        const QHeaderView* restored = other.findChild<QTableView*>()->horizontalHeader();
        QVERIFY(restored->isSectionHidden(HitHistoryModel::PipelineColumn));
        other.setColumns(kept);
        QVERIFY(!restored->isSectionHidden(HitHistoryModel::PipelineColumn));
        QCOMPARE(restored->sectionSize(HitHistoryModel::TargetColumn), 173);
        other.setColumns("nonsense");
        QCOMPARE(restored->sectionSize(HitHistoryModel::TargetColumn), 173);
    }

    /// Only what is in view is asked for, and nothing twice while hits stream in elsewhere.
    void manyRowsCostWhatIsInView() {
        class Counting : public HitHistoryModel {
        public:
            using HitHistoryModel::HitHistoryModel;
            QVariant data(const QModelIndex& index, int role) const override {
                ++calls;
                rows.insert(index.row());
                return HitHistoryModel::data(index, role);
            }
            mutable std::size_t calls = 0;
            mutable std::set<int> rows;
        };
        std::vector<Hit> hits(100'000, m_session->hits().history().hits()[0]);
        QVERIFY(m_session->hits().add(hits).ok());
        Counting model(*m_session);
        HitHistoryPanel panel(*m_session, model);
        panel.resize(900, 300);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel, kPatience));
        auto* table = panel.findChild<QTableView*>();
        QScrollBar* bar = table->verticalScrollBar();
        const int inView = table->viewport()->height() / table->rowHeight(0) + 2;
        model.calls = 0;
        model.rows.clear();
        constexpr int kSteps = 20;
        for (int step = 1; step <= kSteps; ++step) {
            bar->setValue(bar->maximum() / kSteps * step);
            table->viewport()->repaint();
        }
        QVERIFY(!model.rows.empty());
        QVERIFY2(model.rows.size() <= static_cast<std::size_t>(inView * (kSteps + 2)),
                 qPrintable(QString::number(model.rows.size())));
        const std::size_t cells = static_cast<std::size_t>(inView) * kSteps * HitHistoryModel::ColumnCount;
        QVERIFY2(model.calls <= 20 * cells, qPrintable(QString::number(model.calls)));
        bar->setValue(0);
        table->viewport()->repaint();
        model.rows.clear();
        for (int i = 0; i < 50; ++i) {
            QVERIFY(m_session->hits().add(hits[0]).ok());
            QCoreApplication::processEvents();
        }
        for (const int row : model.rows) {
            QVERIFY(row < inView);
        }
    }

    void inTheWindow() {
        m_panel->hide();
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        {
            MainWindow window(session);
            showReady(window);
            for (int i = 0; i < 5; ++i) {
                Hit hit;
                hit.target = session.targets()[0]->id;
                hit.point = {0.2f * static_cast<float>(i), 0.0f, 2.5f};
                QVERIFY(session.hits().add(hit).ok());
            }
            auto* table = window.findChild<HitHistoryPanel*>()->findChild<QTableView*>();
            const auto text = [table](int row, int column) {
                return table->model()->index(row, column).data().toString();
            };
            QTRY_VERIFY_WITH_TIMEOUT(text(4, HitHistoryModel::AffectedColumn).toInt() > 0, kPatience);
            QTRY_VERIFY_WITH_TIMEOUT(!text(4, HitHistoryModel::CpuCostColumn).isEmpty(), kPatience);
            // The chosen hit's vertices light up.
            table->selectRow(2);
            QTRY_COMPARE_WITH_TIMEOUT(QString::number(session.selection().count()),
                                      text(2, HitHistoryModel::AffectedColumn), kPatience);
            table->clearSelection();
            QTRY_COMPARE_WITH_TIMEOUT(session.selection().count(), std::size_t{0}, kPatience);
            // The camera goes there.
            const glm::vec3 eye = window.viewport().camera().eye();
            table->selectRow(0);
            table->setFocus();
            QTest::keyClick(table, Qt::Key_Return);
            QTRY_VERIFY_WITH_TIMEOUT(window.viewport().camera().eye() != eye, kPatience);
            goOutAndInAgain(*window.findChild<HitActions*>(), session);
            // Undo and redo by their keys.
            makeActive(window);
            window.viewport().setFocus();
            QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier);
            QCOMPARE(session.hits().history().size(), std::size_t{0});
            QTest::keyClick(&window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
            QCOMPARE(session.hits().history().size(), std::size_t{5});
            table->horizontalHeader()->resizeSection(HitHistoryModel::TargetColumn, 181);
            closeAndDiscard(window);
        }
        MainWindow again(session);
        const auto* table = again.findChild<HitHistoryPanel*>()->findChild<QTableView*>();
        QCOMPARE(table->horizontalHeader()->sectionSize(HitHistoryModel::TargetColumn), 181);
    }

private:
    /// To a file and back, in both formats; what is no table of hits is refused with a message.
    void goOutAndInAgain(HitActions& actions, Session& session) {
        const QTemporaryDir folder;
        QSignalSpy failed(&actions, &HitActions::failed);
        const std::vector<Hit> before(session.hits().history().hits().begin(),
                                      session.hits().history().hits().end());
        for (const char* name : {"hits.csv", "hits.json"}) {
            const QString path = folder.filePath(QString::fromLatin1(name));
            actions.exportTo(path);
            QVERIFY(actions.isBusy());
            QTRY_VERIFY_WITH_TIMEOUT(!actions.isBusy(), kPatience);
            session.hits().clear();
            actions.importFrom(path);
            QTRY_VERIFY_WITH_TIMEOUT(!actions.isBusy(), kPatience);
            QCOMPARE(failed.size(), 0);
            QVERIFY(std::ranges::equal(session.hits().history().hits(), before));
        }
        QFile bad(folder.filePath(QStringLiteral("bad.csv")));
        QVERIFY(bad.open(QIODevice::WriteOnly));
        bad.write("nonsense\n");
        bad.close();
        QTimer::singleShot(0, this, [] {
            QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeModalWidget() != nullptr, kPatience);
            QApplication::activeModalWidget()->close();
        });
        actions.importFrom(bad.fileName());
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience);
        const auto error = failed[0][0].value<Error>();
        QVERIFY(error.message().find("bad.csv, line 1") != std::string::npos);
        QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeModalWidget() == nullptr, kPatience);
    }
};

HITSCOPE_TEST(HitHistoryToolsTest, QApplication)

}  // namespace hitscope::hit_history_tools_test

#include "hit_history_tools_test.moc"
