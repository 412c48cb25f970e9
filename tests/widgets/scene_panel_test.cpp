// SPDX-License-Identifier: GPL-3.0-or-later
// The Scene panel under real mouse and keys.
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <array>

#include "mesh/primitives.h"
#include "panels/scene/scene_panel.h"
#include "support/test_program.h"
#include "widgets/scene_panel_rig.h"

namespace hitscope::scene_panel_test {

class ScenePanelTest : public ScenePanelRig {
    Q_OBJECT
private Q_SLOTS:
    void init() { setUp(); }
    void selectionIsOneWithTheSessions();
    void eyeHidesByMouse();
    void spaceHidesTheSelection();
    void nameIsEditedInPlace();
    void aNameIsEditedWhileItsTargetMoves();
    void closesWhileANameIsEdited();
    void duplicateAndRemoveByKey();
    void removingAllLeavesAnEmptyPanel();
    void removingSelectsTheOthersNotAnew();
    void resetIsOfferedWhereThereAreHits();
    void primitiveIsAskedFor();
    void whatCannotBeHitHasAWarning();
};

void ScenePanelTest::selectionIsOneWithTheSessions() {
    click(2);
    QCOMPARE(m_session->targets().selected(), id(2));
    QTest::keyClick(m_table, Qt::Key_Down);
    QCOMPARE(m_session->targets().selected(), id(3));
    m_session->targets().select(id(9));
    QCOMPARE(m_table->currentIndex().row(), 9);
    QVERIFY(m_table->selectionModel()->isRowSelected(9));
    m_session->targets().select({});
    QVERIFY(!m_table->selectionModel()->hasSelection());
    QVERIFY(!child<QDoubleSpinBox>("positionX").isEnabled());
    // A hit selects what it is on.
    Hit hit;
    hit.target = id(4);
    QVERIFY(m_session->hits().add(hit).ok());
    QVERIFY(m_table->selectionModel()->isRowSelected(4));
}

void ScenePanelTest::eyeHidesByMouse() {
    click(1, SceneModel::VisibleColumn);
    QVERIFY(!m_session->targets()[1]->visible);
    click(1, SceneModel::VisibleColumn);
    QVERIFY(m_session->targets()[1]->visible);
    QTest::mouseClick(m_table->viewport(), Qt::RightButton, {}, place(1, SceneModel::VisibleColumn));
    QVERIFY(m_session->targets()[1]->visible);
}

void ScenePanelTest::spaceHidesTheSelection() {
    click(1);
    click(3, SceneModel::NameColumn, Qt::ShiftModifier);
    QTest::keyClick(m_table, Qt::Key_Space);
    for (const std::size_t row : {1, 2, 3}) {
        QVERIFY(!m_session->targets()[row]->visible);
    }
    QCOMPARE(m_panel->findChild<QAction*>(QStringLiteral("toggleTargets"))->text(), QStringLiteral("Show"));
    m_session->undo();
    QVERIFY(m_session->targets()[2]->visible);
    QVERIFY(!m_session->steps().canUndo());
}

void ScenePanelTest::nameIsEditedInPlace() {
    click(2);
    QTest::keyClick(m_table, Qt::Key_F2);
    auto* editor = m_table->findChild<QLineEdit*>();
    QVERIFY(editor != nullptr);
    QTest::keyClicks(editor, QStringLiteral("Bonnet"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(m_session->targets()[2]->name, QStringLiteral("Bonnet"), kPatience);
    click(3);
    QTest::mouseDClick(m_table->viewport(), Qt::LeftButton, {}, place(3, SceneModel::NameColumn));
    const auto openEditor = [this]() -> QLineEdit* {
        for (auto* line : m_table->findChildren<QLineEdit*>()) {
            if (line->isVisible() && line->text() == QStringLiteral("High-poly cube 1")) {
                return line;
            }
        }
        return nullptr;
    };
    QTRY_VERIFY_WITH_TIMEOUT(openEditor() != nullptr, kPatience);
    QTest::keyClick(openEditor(), Qt::Key_Escape);
    QCOMPARE(m_session->steps().toUndo(), (SessionUndo::Name{SessionUndo::Kind::RenameTarget, 1}));
    m_session->undo();
    QCOMPARE(m_session->targets()[2]->name, QStringLiteral("Low-poly cube 3"));
}

/// As of targets that are knocked about.
void ScenePanelTest::aNameIsEditedWhileItsTargetMoves() {
    click(2);
    QTest::keyClick(m_table, Qt::Key_F2);
    auto* editor = m_table->findChild<QLineEdit*>();
    for (const QChar letter : QStringLiteral("Fall")) {
        QTest::keyClick(editor, letter.toLatin1());
        RigidTransform lower = m_session->targets()[2]->transform;
        lower.position.y += 0.1f;
        QVERIFY(m_session->targets().setTransform(id(2), lower).ok());
    }
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(m_session->targets()[2]->name, QStringLiteral("Fall"), kPatience);
}

void ScenePanelTest::closesWhileANameIsEdited() {
    click(2);
    QTest::keyClick(m_table, Qt::Key_F2);
    QTest::keyClicks(m_table->findChild<QLineEdit*>(), QStringLiteral("Half"));
    m_panel.reset();
    QCOMPARE(m_session->targets()[2]->name, QStringLiteral("Half"));
}

void ScenePanelTest::duplicateAndRemoveByKey() {
    click(3);
    // To the window, so that Ctrl is held for all who ask.
    QTest::keyClick(m_panel->windowHandle(), Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(m_session->targets().size(), std::size_t{17});
    QCOMPARE(m_table->currentIndex().row(), 16);
    QCOMPARE(m_table->selectionModel()->selectedRows().size(), 1);
    QCOMPARE(m_session->targets().selected(), id(16));
    click(0);
    click(2, SceneModel::NameColumn, Qt::ControlModifier);
    QTest::keyClick(m_table, Qt::Key_Delete);
    QCOMPARE(m_session->targets().size(), std::size_t{15});
    QCOMPARE(m_table->currentIndex().row(), 0);  // the arrow keys go on from there
    QCOMPARE(child<QLabel>("summary").text(), QStringLiteral("15 targets"));
    m_session->undo();
    m_session->undo();
    QCOMPARE(m_model->rowCount(), 16);
}

void ScenePanelTest::removingAllLeavesAnEmptyPanel() {
    QTest::keyClick(m_table, Qt::Key_A, Qt::ControlModifier);
    child<QToolButton>("remove").click();
    QCOMPARE(m_session->targets().size(), std::size_t{0});
    QCOMPARE(child<QLabel>("summary").text(), QStringLiteral("No targets yet"));
    QVERIFY(!child<QToolButton>("remove").isEnabled());
    QVERIFY(child<QPushButton>("add").isEnabled());
    m_session->undo();
    QCOMPARE(m_model->rowCount(), 16);
}

void ScenePanelTest::removingSelectsTheOthersNotAnew() {
    std::vector<TargetId> some;
    for (std::size_t i = 0; i < 12; ++i) {
        some.push_back(id(i));
    }
    m_session->targets().select(some.front(), some);
    QCOMPARE(m_table->selectionModel()->selection().size(), 1);  // one range
    const QSignalSpy changed(m_table->selectionModel(), &QItemSelectionModel::selectionChanged);
    m_session->targets().remove(some);
    QCOMPARE(m_model->rowCount(), 4);
    QVERIFY(!m_table->selectionModel()->hasSelection());
    QVERIFY2(changed.size() <= 14, qPrintable(QString::number(changed.size())));
}

void ScenePanelTest::resetIsOfferedWhereThereAreHits() {
    click(5);
    QVERIFY(!child<QToolButton>("reset").isEnabled());
    Hit hit;
    hit.target = id(5);
    QVERIFY(m_session->hits().add(hit).ok());
    QVERIFY(child<QToolButton>("reset").isEnabled());
    QTest::mouseClick(&child<QToolButton>("reset"), Qt::LeftButton);
    QCOMPARE(m_session->hits().history().size(), std::size_t{0});
    QVERIFY(!child<QToolButton>("reset").isEnabled());
}

void ScenePanelTest::primitiveIsAskedFor() {
    QSignalSpy files(m_panel.get(), &ScenePanel::filesWanted);
    QString name;
    TargetPlan plan;
    connect(m_panel.get(), &ScenePanel::targetWanted, this,
            [&](const QString& wanted, const std::function<TargetPlan()>& make) {
                name = wanted;
                plan = make();
            });
    QTimer::singleShot(0, this, [] {
        auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        QVERIFY(dialog != nullptr);
        QCOMPARE(dialog->findChild<QComboBox*>()->currentText(), QStringLiteral("Torus"));
        auto* resolution = dialog->findChild<QSpinBox*>(QStringLiteral("resolution"));
        resolution->setValue(60);
        QCOMPARE(dialog->findChild<QLabel*>(QStringLiteral("vertices"))->text(), QStringLiteral("1,200"));
        QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok),
                          Qt::LeftButton);
    });
    const QList<QAction*> actions = m_panel->addMenu()->actions();
    actions[static_cast<qsizetype>(PrimitiveKind::Torus)]->trigger();
    QCOMPARE(name, QStringLiteral("Torus"));
    QCOMPARE(plan.shape.mesh->vertexCount(), std::size_t{1200});
    actions[actions.size() - 2]->trigger();
    QCOMPARE(name, QStringLiteral("Utah teapot"));
    QCOMPARE(plan.source, TargetSource(BuiltInMesh::Teapot));  // or a session could not make it again
    actions.last()->trigger();
    QCOMPARE(files.count(), 1);
}

void ScenePanelTest::whatCannotBeHitHasAWarning() {
    const auto picture = [this](int row) {
        const QRect cell = m_table->visualRect(m_model->index(row, SceneModel::NameColumn));
        return m_table->viewport()->grab({cell.topLeft(), QSize(2 * cell.height(), cell.height())}).toImage();
    };
    const QString name = QStringLiteral("Same");
    MeshData ball = makeHighPolySphere(1.0f);
    loadMesh(*m_session, ball);
    QVERIFY(m_session->targets().rename(id(0), name).ok());
    m_session->targets().select({});
    m_table->clearFocus();
    QVERIFY(
        m_model->index(0, SceneModel::NameColumn).data(SceneModel::WhyNotHittableRole).toString().isEmpty());
    const QImage without = picture(0);
    // All of it in one point: nothing has an area.
    ball.positions.assign(ball.positions.size(), glm::vec3(0.0f, 1.0f, 0.0f));
    loadMesh(*m_session, ball);
    QVERIFY(m_session->targets().rename(id(0), name).ok());
    m_session->targets().select({});
    const QModelIndex index = m_model->index(0, SceneModel::NameColumn);
    const QString reason = index.data(SceneModel::WhyNotHittableRole).toString();
    QVERIFY(!reason.isEmpty());
    QVERIFY(index.data(Qt::ToolTipRole).toString().contains(reason));
    const QImage with = picture(0);
    QCOMPARE(with.size(), without.size());
    QVERIFY(with != without);
}

HITSCOPE_TEST(ScenePanelTest, QApplication)

}  // namespace hitscope::scene_panel_test

#include "scene_panel_test.moc"
