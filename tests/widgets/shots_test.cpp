// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QKeySequence>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QStatusBar>
#include <QTableView>
#include <algorithm>
#include <cmath>

#include "app/dialogs/shot_series_dialog.h"
#include "app/shot_text.h"
#include "mesh/primitives.h"
#include "models/hit_history_model.h"
#include "session/task_list.h"
#include "support/test_program.h"
#include "viewport/aim_preview.h"
#include "window_support.h"

namespace hitscope::shots_test {

/// The aim preview, the dialog for bursts and sequences, and a target's physics, by mouse and keys.
class ShotsTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init();
    void cleanup() { dropWindow(); }
    void restingCursorForetells();
    void shallowDentsHaveDigitsThatCount();
    void previewCanBeTurnedOff();
    void previewGoesWhereAHandleIs();
    void previewGoesWithAnEdit();
    void fewVerticesAreRefinedAtTheAim();
    void aShotThatMovesNothingSaysSo();
    void whatIsGoneIsNotRefined();
    void burstFromTheDialog();
    void sequenceAlongALine();
    void targetIsMadeDynamicAndBack();

private:
    [[nodiscard]] QLabel& label() const { return *m_window->findChild<QLabel*>("aimPreview"); }
    void moveTo(const QPoint& at);
    ShotSeriesDialog* openDialog(const QString& menuText);
};

void ShotsTest::init() {
    makeWindow();
}

void ShotsTest::moveTo(const QPoint& at) {
    Viewport& viewport = m_window->viewport();
    QMouseEvent move(QEvent::MouseMove, at, viewport.mapToGlobal(QPointF(at)), Qt::NoButton, Qt::NoButton,
                     {});
    QCoreApplication::sendEvent(&viewport, &move);
}

ShotSeriesDialog* ShotsTest::openDialog(const QString& menuText) {
    for (QAction* action : m_window->findChildren<QAction*>()) {
        if (action->text().remove(u'&').startsWith(menuText)) {
            action->trigger();
            break;
        }
    }
    return m_window->findChild<ShotSeriesDialog*>();
}

void ShotsTest::restingCursorForetells() {
    const QPoint centre = m_window->viewport().rect().center();
    QVERIFY(!label().isVisible());
    moveTo(centre);
    QVERIFY(!label().isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(label().isVisible(), kPatience);
    const QString foretold = label().text();
    // It goes with the first move, and there is none beside the target.
    moveTo(centre + QPoint(3, 0));
    QVERIFY(!label().isVisible());
    moveTo({2, 2});
    QTest::qWait(3 * AimPreview::kRest);
    QVERIFY(!label().isVisible());

    moveTo(centre);
    QTRY_COMPARE_WITH_TIMEOUT(label().text(), foretold, kPatience);
    QTest::mouseClick(&m_window->viewport(), Qt::LeftButton, {}, centre);
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), std::size_t{1}, kPatience);
    QVERIFY(m_window->viewport().syncNow().ok());
    const auto made = m_session->targets().front()->deformed.statistics();
    // A second line offers to refine where there are few.
    QCOMPARE(foretold.contains(QStringLiteral("Ctrl+R")), made.changedVertices < AimPreview::kFewVertices);
    QCOMPARE(foretold.section(u'\n', 0, 0), QStringLiteral("Next shot: %1 vertices, %2 m deep")
                                                .arg(made.changedVertices)
                                                .arg(made.maximum, 0, 'f', 3));
}

void ShotsTest::shallowDentsHaveDigitsThatCount() {
    ConstantsSetting setting = m_session->settings().constantsSetting();
    setting.relative = false;
    setting.constants.maxMagnitude = 0.00381f;
    QVERIFY(m_session->settings().setConstants(setting).ok());
    moveTo(m_window->viewport().rect().center());
    QTRY_VERIFY_WITH_TIMEOUT(label().isVisible(), kPatience);
    QVERIFY2(label().text().contains(QStringLiteral(" 0.00381 m deep")), qPrintable(label().text()));
}

void ShotsTest::previewCanBeTurnedOff() {
    auto* preview = m_window->findChild<QAction*>("aimPreviewOn");
    QVERIFY(preview->isChecked());
    preview->trigger();
    moveTo(m_window->viewport().rect().center());
    QTest::qWait(3 * AimPreview::kRest);
    QVERIFY(!label().isVisible());
    preview->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(label().isVisible(), kPatience);
}

/// Moves over a handle do not reach the viewport: it would go on about where the cursor was before.
void ShotsTest::previewGoesWhereAHandleIs() {
    moveTo(m_window->viewport().rect().center());
    QTRY_VERIFY_WITH_TIMEOUT(label().isVisible(), kPatience);
    QWidget handle(&m_window->viewport());
    handle.show();
    QEnterEvent enter({1, 1}, {1, 1}, {1, 1});
    QCoreApplication::sendEvent(&handle, &enter);
    QVERIFY(!label().isVisible());
    Hit hit;
    hit.target = m_session->targets().front()->id;
    QVERIFY(m_session->hits().add(hit).ok());  // what changes the mesh shows it again, but not now
    QVERIFY(m_window->viewport().syncNow().ok());
    QTest::qWait(3 * AimPreview::kRest);
    QVERIFY(!label().isVisible());
    moveTo(m_window->viewport().rect().center());
    QTRY_VERIFY_WITH_TIMEOUT(label().isVisible(), kPatience);
}

/// The next picture shows the hit: what a shot would have made before is not over it.
void ShotsTest::previewGoesWithAnEdit() {
    const SceneDecorations& decorations = m_window->viewport().decorations();
    Hit hit;
    hit.target = m_session->targets().front()->id;
    for (const bool isUndo : {false, true}) {
        moveTo(m_window->viewport().rect().center());
        QTRY_VERIFY_WITH_TIMEOUT(decorations.ghost() != nullptr, kPatience);
        if (isUndo) {
            m_session->undo();
        } else {
            QVERIFY(m_session->hits().add(hit).ok());
        }
        QVERIFY(decorations.ghost() == nullptr);
        QVERIFY(!label().isVisible());
    }
}

void ShotsTest::aShotThatMovesNothingSaysSo() {
    dropWindow();
    makeWindow([](Session& session) { loadMesh(session, makeLowPolyCube(2.5f)); });
    m_session->settings().setFlightMode(FlightMode::Instant);
    const auto shootWithin = [this](float distance) {
        ConstantsSetting setting = m_session->settings().constantsSetting();
        setting.constants.maxDistance = distance;
        QVERIFY(m_session->settings().setConstants(setting).ok());
        QTest::mouseClick(&m_window->viewport(), Qt::LeftButton, {}, m_window->viewport().rect().center());
    };
    const auto said = [this] { return m_window->statusBar()->currentMessage(); };
    shootWithin(0.001f);
    QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("moved no vertex")), kPatience);
    QVERIFY2(said().contains(QStringLiteral("Ctrl+R")), qPrintable(said()));
    shootWithin(10.0f);
    QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("The shot hit")), kPatience);
    const auto* table = m_window->findChild<QDockWidget*>("hitHistory")->findChild<QTableView*>("table");
    const auto isKnown = [&] {
        const QModelIndex moved = table->model()->index(1, HitHistoryModel::AffectedColumn);
        return moved.data(HitHistoryModel::RawValueRole).isValid();
    };
    QTRY_VERIFY_WITH_TIMEOUT(isKnown(), kPatience);
    QCOMPARE(m_session->hits().history().size(), std::size_t{2});
    QVERIFY2(!said().contains(QStringLiteral("vertex")), qPrintable(said()));
    ConstantsSetting setting = m_session->settings().constantsSetting();
    setting.constants.power = 0.0f;
    QVERIFY(m_session->settings().setConstants(setting).ok());
    shootWithin(10.0f);
    QTRY_VERIFY2_WITH_TIMEOUT(said().endsWith(QStringLiteral("moved no vertex: power is 0.")),
                              qPrintable(said()), kPatience);
    Hit hit = m_session->hits().history().hits().back();
    hit.constants.power = 1.0e-30f;
    const Target& target = *m_session->targets().front();
    QVERIFY(idleHitText(hit, target).contains(QStringLiteral("too weak")));
    hit.constants.maxMagnitude = 0.0f;
    QVERIFY(idleHitText(hit, target).endsWith(QStringLiteral("max magnitude is 0.")));
}

void ShotsTest::fewVerticesAreRefinedAtTheAim() {
    dropWindow();
    makeWindow([](Session& session) { loadMesh(session, makeLowPolyCube(2.5f)); });
    const QPoint centre = m_window->viewport().rect().center();
    const auto target = [this]() -> const Target& { return *m_session->targets().front(); };
    const PageVector<glm::vec3> before = target().shape.mesh->positions;
    QAction* refine = nullptr;
    for (QAction* action : m_window->findChildren<QAction*>()) {
        refine = action->shortcut() == QKeySequence(QStringLiteral("Ctrl+R")) ? action : refine;
    }
    QVERIFY(refine != nullptr && !refine->isEnabled());  // the cursor rested nowhere yet
    moveTo(centre);
    QTRY_VERIFY_WITH_TIMEOUT(label().isVisible(), kPatience);
    QVERIFY2(label().text().contains(QStringLiteral("Ctrl+R")), qPrintable(label().text()));
    QVERIFY(refine->isEnabled());
    moveTo({2, 2});
    QTRY_VERIFY_WITH_TIMEOUT(!refine->isEnabled(), kPatience);  // beside the target
    moveTo(centre);
    QTRY_VERIFY_WITH_TIMEOUT(refine->isEnabled(), kPatience);
    makeActive(*m_window);
    QTest::keyClick(m_window.get(), Qt::Key_R, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(target().shape.mesh->positions.size() > before.size(), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(m_session->tasks().current() == nullptr, kPatience);
    const PageVector<glm::vec3>& after = target().shape.mesh->positions;
    QVERIFY(std::equal(before.begin(), before.end(), after.begin()));
    // The same shot has enough of them now, and the offer goes.
    moveTo(centre + QPoint(1, 0));
    moveTo(centre);
    QTRY_VERIFY_WITH_TIMEOUT(label().isVisible() && !label().text().contains(QStringLiteral("Ctrl+R")),
                             kPatience);
    QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(target().shape.mesh->positions.size(), before.size(), kPatience);
}

void ShotsTest::whatIsGoneIsNotRefined() {
    const Target& target = *m_session->targets().front();
    auto* mesh = m_window->findChild<QAction*>("refineAtAim");
    QVERIFY(mesh != nullptr);
    moveTo(m_window->viewport().rect().center());
    QTRY_VERIFY_WITH_TIMEOUT(mesh->isEnabled(), kPatience);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&m_window->viewport(), &leave);
    QVERIFY(mesh->isEnabled());
    const std::vector<TargetState> same{target};
    m_session->targets().replaceMeshes(same, [](const Hit& hit) { return hit; });
    QVERIFY(!mesh->isEnabled());
    m_session->undo();
    QVERIFY(mesh->isEnabled());
    loadTeapot(*m_session);
    QVERIFY(!mesh->isEnabled());
}

void ShotsTest::burstFromTheDialog() {
    ShotSeriesDialog* dialog = openDialog(QStringLiteral("Burst"));
    QVERIFY(dialog != nullptr && dialog->isVisible());
    auto* count = dialog->findChild<QSpinBox*>("count");
    count->setFocus();
    count->selectAll();
    QTest::keyClicks(count, "30");
    dialog->findChild<QDoubleSpinBox*>("angle")->setValue(3.0);
    auto* instant = dialog->findChild<QCheckBox*>("instant");
    QTest::mouseClick(instant, Qt::LeftButton, {}, {8, instant->height() / 2});
    QVERIFY(instant->isChecked());
    QTest::mouseClick(dialog->findChild<QPushButton*>("shoot"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), std::size_t{30}, kPatience);
    const std::vector<Hit> first(m_session->hits().history().hits().begin(),
                                 m_session->hits().history().hits().end());
    // Again from here onto the whole target: the same.
    m_session->hits().clear();
    QVERIFY(m_window->viewport().syncNow().ok());
    QTest::mouseClick(dialog->findChild<QPushButton*>("shoot"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), std::size_t{30}, kPatience);
    for (std::size_t i = 0; i < first.size(); ++i) {
        QVERIFY(m_session->hits().history().hits()[i].point == first[i].point);
        QVERIFY(m_session->hits().history().hits()[i].direction == first[i].direction);
    }
}

void ShotsTest::sequenceAlongALine() {
    ShotSeriesDialog* dialog = openDialog(QStringLiteral("Sequence"));
    QVERIFY(dialog != nullptr);
    QCOMPARE(dialog->series().pattern, ShotSeries::Pattern::Line);
    QVERIFY(dialog->findChild<QDoubleSpinBox*>("fromX")->isEnabled());
    QVERIFY(!dialog->findChild<QSpinBox*>("seed")->isEnabled());
    dialog->findChild<QSpinBox*>("count")->setValue(5);
    dialog->findChild<QDoubleSpinBox*>("fromX")->setValue(45.0);
    dialog->findChild<QDoubleSpinBox*>("toX")->setValue(55.0);
    dialog->findChild<QPushButton*>("shoot")->click();
    QVERIFY(m_window->findChild<QAction*>("stopShots")->isEnabled());
    QVERIFY(m_window->findChild<QLabel*>("timeBadge")->text().contains(QStringLiteral("5 pending shots")));
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), std::size_t{5}, kPatience);
    QVERIFY(!m_window->findChild<QAction*>("stopShots")->isEnabled());
    // A tenth of a second apart, and from left to right.
    const std::span<const Hit> hits = m_session->hits().history().hits();
    const glm::vec3 right = m_window->viewport().camera().right();
    for (std::size_t i = 1; i < hits.size(); ++i) {
        QVERIFY(std::abs(hits[i].time - hits[i - 1].time - 0.1) < 0.05);
        QVERIFY(glm::dot(hits[i].point - hits[i - 1].point, right) > 0.0f);
    }
}

void ShotsTest::targetIsMadeDynamicAndBack() {
    const Target& target = *m_session->targets().front();
    m_session->targets().select(target.id);
    auto* dynamic = m_window->findChild<QCheckBox*>("dynamic");
    auto* mass = m_window->findChild<QDoubleSpinBox*>("mass");
    QVERIFY(!dynamic->isChecked() && !mass->isEnabled());
    dynamic->click();
    QVERIFY(target.physics.isDynamic && mass->isEnabled());
    mass->setValue(7.0);
    QCOMPARE(target.physics.mass, 7.0f);
    m_session->undo();
    QVERIFY(!target.physics.isDynamic);
    QVERIFY(!dynamic->isChecked());
    m_session->redo();
    QVERIFY(target.physics.isDynamic && dynamic->isChecked());
}

HITSCOPE_TEST(ShotsTest, QApplication)

}  // namespace hitscope::shots_test

#include "shots_test.moc"
