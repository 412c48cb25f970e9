// SPDX-License-Identifier: GPL-3.0-or-later
// The docks' panels on a session, without a window around them.
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGuiApplication>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTableView>
#include <QTest>
#include <QTreeView>

#include "mesh/primitives.h"
#include "panels/deformation_constants/deformation_constants_panel.h"
#include "panels/hit_history/hit_history_panel.h"
#include "panels/icons/themed_icon.h"
#include "panels/lights/lights_panel.h"
#include "panels/mesh_statistics/mesh_statistics_panel.h"
#include "session/hit_editing.h"
#include "session/scene_presets.h"
#include "session/target_plan.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::panels_test {

namespace {

void addHits(Session& session, int count) {
    for (int i = 0; i < count; ++i) {
        Hit hit;
        hit.target = session.targets()[static_cast<std::size_t>(i) % session.targets().size()]->id;
        hit.point = {0.0f, static_cast<float>(i), 2.5f};
        QVERIFY(session.hits().add(hit).ok());
    }
}

}  // namespace

class PanelsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void historySelectsRemovesAndCopies();
    void constantsApplyToThePastOnRequest();
    void constantsShowWhatIsTrue();
    void constantsForTheNextHitCanBeUndone();
    void escapeTakesASlidersDragBack();
    void constantsSliderCoversTheRange();
    void lightsSwitchAndTint();
    void lightsCanBeUndone();
    void statisticsChooseTheTarget();
    void statisticsListManyTargetsAtOnce();
    void iconsAreDrawnInThePalette();
};

void PanelsTest::historySelectsRemovesAndCopies() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    HitHistoryModel model(session);
    HitHistoryPanel panel(session, model);
    panel.show();
    makeActive(panel);
    addHits(session, 5);
    auto* table = panel.findChild<QTableView*>();
    table->selectRow(2);
    QCOMPARE(session.hits().selected(), std::optional<std::size_t>(2));
    QCOMPARE(session.targets().selected(), session.targets()[2]->id);
    session.hits().select(std::nullopt);
    QVERIFY(!table->selectionModel()->hasSelection());
    session.hits().select(3);
    QVERIFY(table->selectionModel()->isRowSelected(3));

    table->setFocus();
    QTest::keyClick(table, Qt::Key_C, Qt::ControlModifier);
    const QString copied = QGuiApplication::clipboard()->text();
    QCOMPARE(copied.count(u'\n'), 2);
    QVERIFY(copied.section(u'\n', 1, 1).startsWith(QStringLiteral("4,")));
    QTest::keyClick(table, Qt::Key_Delete);
    QCOMPARE(session.hits().history().size(), std::size_t{4});
    QCOMPARE(session.hits().history().hits()[3].point.y, 4.0f);

    table->selectAll();
    QTest::keyClick(table, Qt::Key_Delete);
    QCOMPARE(session.hits().history().size(), std::size_t{0});
}

void PanelsTest::constantsApplyToThePastOnRequest() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    addHits(session, 3);
    HitEditing editing(session);
    DeformationConstantsPanel panel(session, editing);
    auto* power = panel.findChild<QDoubleSpinBox*>(QStringLiteral("power"));
    auto* selected = panel.findChild<QPushButton*>(QStringLiteral("applyToSelected"));
    auto* all = panel.findChild<QPushButton*>(QStringLiteral("applyToAll"));
    const auto powerOf = [&session](std::size_t hit) {
        return session.hits().history().hits()[hit].constants.power;
    };
    QCOMPARE(power->value(), 0.2);  // per cent of (5 m)²
    power->setValue(0.4);
    QCOMPARE(session.settings().constants().power, 0.1f);
    QCOMPARE(powerOf(0), 0.05f);
    QVERIFY(!selected->isEnabled());
    editing.select({1});
    QCOMPARE(selected->text(), QStringLiteral("Selected (1)"));
    selected->click();
    QCOMPARE(powerOf(1), 0.1f);
    QCOMPARE(powerOf(0), 0.05f);
    QCOMPARE(all->text(), QStringLiteral("All (3)"));
    all->click();
    QCOMPARE(powerOf(0), 0.1f);
    QCOMPARE(session.steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::HitConstants, 3}));
    session.undo();
    QCOMPARE(powerOf(0), 0.05f);
    QCOMPARE(powerOf(1), 0.1f);
    auto* preset = panel.findChild<QComboBox*>(QStringLiteral("preset"));
    QCOMPARE(preset->currentIndex(), -1);
    QTest::keyClick(preset, Qt::Key_Home);
    QVERIFY(session.settings().constants() == DeformationConstants{});
    QCOMPARE(power->value(), 0.2);
    QCOMPARE(powerOf(1), 0.1f);
    ConstantsSetting smooth = session.settings().constantsSetting();
    smooth.form.profile = DentProfile::Smooth;
    QVERIFY(session.settings().setConstants(smooth).ok());
    QCOMPARE(preset->currentIndex(), -1);  // these are the paper's constants, but not its function
    QTest::keyClick(preset, Qt::Key_Home);
    QCOMPARE(session.settings().constantsSetting().form.profile, DentProfile::Paper);
    QCOMPARE(preset->currentText(), QStringLiteral("Paper"));
}

void PanelsTest::constantsShowWhatIsTrue() {
    Session session;
    ScenePlan plan;
    plan.targets.push_back(planMesh(prepareMesh(makeUvSphere(16, 8, 0.45f))));
    session.loadScene(plan);
    HitEditing editing(session);
    DeformationConstantsPanel panel(session, editing);
    const auto box = [&panel](const char* name) {
        return panel.findChild<QDoubleSpinBox*>(QString::fromLatin1(name));
    };
    const auto* inForce = panel.findChild<QLabel*>(QStringLiteral("inForce"));
    QCOMPARE(box("max_distance")->text(), QStringLiteral("10 %"));
    QCOMPARE(box("power")->text(), QStringLiteral("0.2 %"));
    QCOMPARE(box("max_magnitude")->text(), QStringLiteral("6 %"));
    QVERIFY2(inForce->text().contains(QStringLiteral("max distance 90 mm")), qPrintable(inForce->text()));
    QVERIFY(inForce->text().contains(QStringLiteral("max magnitude 54 mm")));
    // Of two sizes, and none selected, no number is in force.
    std::vector<TargetPlan> more;
    more.push_back(planMesh(prepareMesh(makeUvSphere(16, 8, 2.5f))));
    session.targets().add(std::move(more));
    QVERIFY(inForce->text().contains(QStringLiteral("max distance 500 mm")));  // the new one is selected
    session.targets().select({});
    QVERIFY2(inForce->text().contains(QStringLiteral("differ in size")), qPrintable(inForce->text()));
    QVERIFY(!inForce->text().contains(QStringLiteral("mm")));
    // In metres the boxes are what is in force.
    auto* size = panel.findChild<QComboBox*>(QStringLiteral("size"));
    QTest::keyClick(size, Qt::Key_End);
    QCOMPARE(box("max_distance")->text(), QStringLiteral("0.5 m"));
    QCOMPARE(box("power")->text(), QStringLiteral("0.05 m²"));
}

void PanelsTest::constantsForTheNextHitCanBeUndone() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    HitEditing editing(session);
    DeformationConstantsPanel panel(session, editing);
    auto* slider = panel.findChildren<QSlider*>().at(0);
    slider->setSliderDown(true);
    for (const int place : {600, 650, 700}) {
        slider->setValue(place);
    }
    slider->setSliderDown(false);
    slider->setSliderDown(true);
    slider->setValue(300);
    slider->setSliderDown(false);
    QVERIFY(session.settings().constants().maxDistance < 0.5f);
    session.undo();
    QVERIFY(session.settings().constants().maxDistance > 0.5f);
    QVERIFY(session.steps().toUndo()->kind == SessionUndo::Kind::Constants);
    session.undo();
    QCOMPARE(session.settings().constants().maxDistance, 0.5f);
    QVERIFY(!session.steps().canUndo());
    QTest::keyClick(panel.findChild<QComboBox*>(QStringLiteral("size")), Qt::Key_End);
    QVERIFY(!session.settings().constantsSetting().relative);
    session.undo();
    QVERIFY(session.settings().constantsSetting().relative);
}

void PanelsTest::escapeTakesASlidersDragBack() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    HitEditing editing(session);
    DeformationConstantsPanel panel(session, editing);
    panel.show();
    auto* slider = panel.findChildren<QSlider*>().at(0);
    const int before = slider->value();
    slider->setSliderDown(true);
    slider->setValue(700);
    QVERIFY(session.settings().constants().maxDistance > 0.5f);
    QTest::keyClick(slider, Qt::Key_Escape);
    QCOMPARE(session.settings().constants().maxDistance, 0.5f);
    QCOMPARE(slider->value(), before);
    QVERIFY(!slider->isSliderDown());
    QVERIFY(!session.steps().canUndo());
}

void PanelsTest::constantsSliderCoversTheRange() {
    Session session;
    HitEditing editing(session);
    DeformationConstantsPanel panel(session, editing);
    const QList<QSlider*> sliders = panel.findChildren<QSlider*>();
    QCOMPARE(sliders.size(), 3);
    const ParameterDescriptor& distance = deformationParameters()[kMaxDistance];
    QCOMPARE(sliders[0]->value(), (sliders[0]->maximum() + 1) / 2);
    sliders[0]->setValue(sliders[0]->maximum());
    QCOMPARE(session.settings().constants().maxDistance, static_cast<float>(distance.maximum));
    sliders[0]->setValue(0);
    QCOMPARE(session.settings().constants().maxDistance, static_cast<float>(distance.minimum));
}

void PanelsTest::lightsSwitchAndTint() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    LightsPanel panel(session);
    auto* list = panel.findChild<QListView*>(QStringLiteral("list"));
    QCOMPARE(list->model()->rowCount(), 6);
    QVERIFY(list->model()->setData(list->model()->index(2, 0), Qt::Unchecked, Qt::CheckStateRole));
    QVERIFY(session.settings().lights().points[0].on && !session.settings().lights().points[1].on);
    QVERIFY(session.settings().lights().directional.on);

    const auto box = [&panel](const char* name) {
        return panel.findChild<QDoubleSpinBox*>(QLatin1String(name));
    };
    list->setCurrentIndex(list->model()->index(1, 0));
    const PointLight before = session.settings().lights().points[0];
    QVERIFY(box("positionX")->isVisibleTo(&panel) && !box("directionX")->isVisibleTo(&panel));
    box("positionY")->setValue(7.25);
    QCOMPARE(session.settings().lights().points[0].position,
             glm::vec3(before.position.x, 7.25f, before.position.z));  // and nothing else is rounded
    box("linear")->setValue(0.5);
    QCOMPARE(session.settings().lights().points[0].attenuation.linear, 0.5f);

    list->setCurrentIndex(list->model()->index(5, 0));
    box("diffuse")->setValue(0.5);
    QCOMPARE(session.settings().lights().spot.terms.diffuse, 0.5f);
    QVERIFY(!box("directionX")->isVisibleTo(&panel));
    panel.findChild<QCheckBox*>(QStringLiteral("atEye"))->click();
    QVERIFY(!session.settings().lights().spot.atEye && box("directionX")->isVisibleTo(&panel));
    box("innerAngle")->setValue(40.0);
    QVERIFY(session.settings().lights().spot.outerAngle > session.settings().lights().spot.innerAngle);

    Lights lights = session.settings().lights();
    lights.directional.on = false;
    session.settings().setLights(lights);
    QCOMPARE(list->model()->index(0, 0).data(Qt::CheckStateRole).toInt(), int{Qt::Unchecked});
    panel.findChild<QPushButton*>(QStringLiteral("reset"))->click();
    QVERIFY(session.settings().lights().directional.on && session.settings().lights().points[1].on);
    QVERIFY(session.settings().lights().spot.atEye);
    QCOMPARE(session.settings().lights().points[0].position, before.position);
}

void PanelsTest::lightsCanBeUndone() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    const Lights before = session.settings().lights();
    LightsPanel panel(session);
    auto* list = panel.findChild<QListView*>(QStringLiteral("list"));
    auto* diffuse = panel.findChild<QDoubleSpinBox*>(QStringLiteral("diffuse"));
    QVERIFY(list->model()->setData(list->model()->index(2, 0), Qt::Unchecked, Qt::CheckStateRole));
    diffuse->setValue(0.4);
    diffuse->setValue(0.3);  // of one run of edits
    QTest::keyClick(diffuse, Qt::Key_Return);
    diffuse->setValue(0.2);
    session.undo();
    QCOMPARE(session.settings().lights().directional.terms.diffuse, 0.3f);
    QCOMPARE(diffuse->value(), 0.3);
    session.undo();
    QCOMPARE(session.settings().lights().directional.terms.diffuse, before.directional.terms.diffuse);
    QVERIFY(!session.settings().lights().points[1].on);
    QVERIFY(session.steps().toUndo()->kind == SessionUndo::Kind::Lights);
    session.undo();
    QVERIFY(session.settings().lights() == before);
    QVERIFY(!session.steps().canUndo());
    session.redo();
    QVERIFY(!session.settings().lights().points[1].on);
}

void PanelsTest::statisticsChooseTheTarget() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    MeshStatisticsModel model(session);
    MeshStatisticsPanel panel(session, model);
    auto* box = panel.findChild<QComboBox*>(QStringLiteral("target"));
    QCOMPARE(box->count(), 18);  // a line and all together below them
    session.targets().select(session.targets()[7]->id);
    QCOMPARE(box->currentIndex(), 7);
    Q_EMIT box->activated(3);
    QCOMPARE(session.targets().selected(), session.targets()[3]->id);
    Q_EMIT box->activated(17);
    QVERIFY(model.showsAll());
    QCOMPARE(panel.title(), QStringLiteral("All targets"));
    Q_EMIT box->activated(2);
    QVERIFY(!model.showsAll());
    auto* numbers = panel.findChild<QTreeView*>(QStringLiteral("numbers"));
    QVERIFY(numbers->isFirstColumnSpanned(0, {}));
    QVERIFY(numbers->isExpanded(model.index(0, 0)));
}

void PanelsTest::statisticsListManyTargetsAtOnce() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    MeshStatisticsModel model(session);
    MeshStatisticsPanel panel(session, model);
    const auto* box = panel.findChild<QComboBox*>(QStringLiteral("target"));
    QCoreApplication::processEvents();
    std::vector<TargetId> all;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        all.push_back(target->id);
    }
    const QSignalSpy filled(box->model(), &QAbstractItemModel::rowsAboutToBeRemoved);
    session.targets().duplicate(all);
    session.undo();
    session.redo();
    QTRY_COMPARE_WITH_TIMEOUT(box->count(), 34, kPatience);
    QCOMPARE(box->currentData().toUInt(), session.targets().selected().value);
    QVERIFY2(filled.size() <= 2, qPrintable(QString::number(filled.size())));
    // One is listed at once.
    QCoreApplication::processEvents();
    session.targets().remove({&all[3], 1});
    QCOMPARE(box->count(), 33);
    QVERIFY(session.targets().rename(all[1], QStringLiteral("Other")).ok());
    QTRY_COMPARE_WITH_TIMEOUT(box->itemText(1), QStringLiteral("Other"), kPatience);
    // What only moves is called as before.
    QCoreApplication::processEvents();
    const auto before = filled.size();
    QVERIFY(session.targets().setTransform(all[1], {{1.0f, 2.0f, 3.0f}}).ok());
    QCoreApplication::processEvents();
    QCOMPARE(filled.size(), before);
}

void PanelsTest::iconsAreDrawnInThePalette() {
    const QColor ink(10, 200, 30);
    const QPalette before = QGuiApplication::palette();
    QPalette palette = before;
    palette.setColor(QPalette::Active, QPalette::WindowText, ink);
    QGuiApplication::setPalette(palette);
    for (const char* name : {"open", "export", "undo", "redo", "wireframe", "frame", "remove", "copy",
                             "reset", "continuous", "close"}) {
        const QImage image = themedIcon(QLatin1String(name)).pixmap(64, 64).toImage();
        bool inked = false;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                inked = inked || image.pixelColor(x, y) == ink;
            }
        }
        QVERIFY2(inked, name);
    }
    QGuiApplication::setPalette(before);
}

HITSCOPE_TEST(PanelsTest, QApplication)

}  // namespace hitscope::panels_test

#include "panels_test.moc"
