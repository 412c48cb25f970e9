// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of the Scene panel under real mouse and keys.
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QTest>
#include <utility>

#include "support/test_program.h"
#include "widgets/scene_panel_rig.h"

namespace hitscope::scene_fields_test {

class SceneFieldsTest : public ScenePanelRig {
    Q_OBJECT
private Q_SLOTS:
    void init() { setUp(); }
    void positionIsTyped();
    void stepsInOneFieldAreOneStep();
    void anglesStayAsTyped();
    void severalMoveAndTurnTogether();
    void saysWhosePlaceIsShown();
    void severalGetOnePhysics();
    void aMassIsTypedWhileItsTargetMoves();
    void severalAreSelectedOutside();
};

void SceneFieldsTest::positionIsTyped() {
    click(0);
    const glm::vec3 before = m_session->targets()[0]->transform.position;
    typeInto("positionX", QStringLiteral("1.25"));
    QCOMPARE(m_session->targets()[0]->transform.position, glm::vec3(1.25f, before.y, before.z));
    typeInto("positionX", QStringLiteral("2.5"));
    m_session->undo();  // two numbers typed are two steps
    QCOMPARE(m_session->targets()[0]->transform.position.x, 1.25f);
    QCOMPARE(child<QDoubleSpinBox>("positionX").value(), 1.25);
    m_session->undo();
    QCOMPARE(m_session->targets()[0]->transform.position, before);
    QVERIFY(!m_session->steps().canUndo());
}

void SceneFieldsTest::stepsInOneFieldAreOneStep() {
    click(0);
    auto& box = child<QDoubleSpinBox>("positionY");
    const double before = box.value();
    box.setFocus();
    for (int i = 0; i < 5; ++i) {
        QTest::keyClick(&box, Qt::Key_Up);
    }
    QCOMPARE(m_session->targets()[0]->transform.position.y, static_cast<float>(before + 0.5));
    m_session->undo();
    QCOMPARE(m_session->targets()[0]->transform.position.y, static_cast<float>(before));
    QVERIFY(!m_session->steps().canUndo());
}

void SceneFieldsTest::anglesStayAsTyped() {
    click(0);
    typeInto("rotationY", QStringLiteral("120"));
    typeInto("rotationX", QStringLiteral("200"));
    QCOMPARE(child<QDoubleSpinBox>("rotationY").value(), 120.0);
    QCOMPARE(child<QDoubleSpinBox>("rotationX").value(), 200.0);
    QCOMPARE(m_session->steps().toUndo()->kind, SessionUndo::Kind::RotateTarget);
    m_session->undo();
    m_session->undo();
    QCOMPARE(child<QDoubleSpinBox>("rotationY").value(), 0.0);
}

void SceneFieldsTest::severalMoveAndTurnTogether() {
    const glm::vec3 first = m_session->targets()[1]->transform.position;
    const glm::vec3 second = m_session->targets()[2]->transform.position;
    click(1);
    click(2, SceneModel::NameColumn, Qt::ControlModifier);
    QCOMPARE(m_session->targets().selected(), id(2));
    QCOMPARE(m_session->targets().allSelected(), (std::vector{id(1), id(2)}));
    QCOMPARE(child<QLabel>("summary").text(), QStringLiteral("2 of 16 targets selected"));
    typeInto("positionY", QString::number(static_cast<double>(second.y) + 2.0));
    QCOMPARE(m_session->targets()[1]->transform.position, glm::vec3(first.x, first.y + 2.0f, first.z));
    QCOMPARE(m_session->targets()[2]->transform.position, glm::vec3(second.x, second.y + 2.0f, second.z));
    m_session->undo();
    QCOMPARE(m_session->targets()[1]->transform.position, first);
    QCOMPARE(m_session->targets()[2]->transform.position, second);
    QVERIFY(!m_session->steps().canUndo());
    typeInto("rotationY", QStringLiteral("30"));
    const glm::quat turned = m_session->targets()[1]->transform.rotation;
    QVERIFY(std::abs(glm::degrees(glm::angle(turned)) - 30.0f) < 0.01f);
    QCOMPARE(m_session->targets()[2]->transform.rotation, turned);
    QCOMPARE(m_session->targets()[3]->transform.rotation, glm::quat(1.0f, 0.0f, 0.0f, 0.0f));
    m_session->undo();
    m_table->setFocus();
    QTest::keyClick(m_table, Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(m_session->targets().size(), std::size_t{18});
    QCOMPARE(m_session->targets().allSelected(), (std::vector{id(16), id(17)}));
}

void SceneFieldsTest::saysWhosePlaceIsShown() {
    const auto& whose = child<QLabel>("whose");
    const auto name = [this](std::size_t target) { return m_session->targets()[target]->name; };
    click(1);
    QVERIFY(!whose.isVisible());
    click(2, SceneModel::NameColumn, Qt::ControlModifier);
    QVERIFY(whose.isVisible());
    QVERIFY2(whose.text().contains(name(2)) && whose.text().contains(QStringLiteral("all 2")),
             qPrintable(whose.text()));
    click(3, SceneModel::NameColumn, Qt::ControlModifier);
    QVERIFY(whose.text().contains(name(3)) && whose.text().contains(QStringLiteral("all 3")));
    QVERIFY(m_session->targets().rename(id(3), QString(200, QLatin1Char('W'))).ok());
    QCoreApplication::processEvents();
    QVERIFY(whose.heightForWidth(whose.width()) <= whose.height());
    QVERIFY(m_panel->width() <= 350);
    click(0);
    QVERIFY(!whose.isVisible());
}

void SceneFieldsTest::severalGetOnePhysics() {
    click(4);
    typeInto("friction", QStringLiteral("0.25"));
    click(3);
    click(4, SceneModel::NameColumn, Qt::ShiftModifier);
    QTest::mouseClick(&child<QCheckBox>("dynamic"), Qt::LeftButton, {}, QPoint(8, 8));
    typeInto("mass", QStringLiteral("7"));
    for (const std::size_t row : {3, 4}) {
        QVERIFY(m_session->targets()[row]->physics.isDynamic);
        QCOMPARE(m_session->targets()[row]->physics.mass, 7.0f);
    }
    QCOMPARE(m_session->targets()[4]->physics.friction, 0.25f);  // was not changed for both
    QVERIFY(m_session->targets()[3]->physics.friction != 0.25f);
    QCOMPARE(child<QDoubleSpinBox>("friction").text(), QStringLiteral("differ"));
    typeInto("friction", QStringLiteral("0,5"));
    QCOMPARE(m_session->targets()[3]->physics.friction, 0.5f);
    QCOMPARE(m_session->targets()[4]->physics.friction, 0.5f);
    m_session->undo();
    QVERIFY(!m_session->targets()[3]->physics.isDynamic);
    QVERIFY(!m_session->targets()[4]->physics.isDynamic);
}

/// While its target moves, the fields are shown anew.
void SceneFieldsTest::aMassIsTypedWhileItsTargetMoves() {
    click(0);
    child<QCheckBox>("dynamic").click();
    const RigidTransform still = m_session->targets()[0]->transform;
    for (const auto& [field, text] : {std::pair("mass", "42"), std::pair("rotationX", "1e1")}) {
        auto& box = child<QDoubleSpinBox>(field);
        box.setFocus();
        box.selectAll();
        QTest::keyClicks(&box, QString::fromLatin1(text));
        RigidTransform moved = still;
        moved.position.y += 0.1f;
        QVERIFY(m_session->targets().setTransform(id(0), moved).ok());
        QTest::keyClick(&box, Qt::Key_Return);
    }
    QCOMPARE(m_session->targets()[0]->physics.mass, 42.0f);
    QVERIFY(std::abs(glm::degrees(glm::angle(m_session->targets()[0]->transform.rotation)) - 10.0f) < 0.01f);
    typeInto("positionX", QStringLiteral("5 mm"));
    QCOMPARE(m_session->targets()[0]->transform.position.x, 0.005f);
}

void SceneFieldsTest::severalAreSelectedOutside() {
    const std::vector<TargetId> beside{id(3), id(6), TargetId{900}};
    m_session->targets().select(id(5), beside);
    QCOMPARE(m_table->currentIndex().row(), 5);
    QCOMPARE(m_table->selectionModel()->selectedRows().size(), 3);
    QVERIFY(m_table->selectionModel()->isRowSelected(3));
    const TargetId six = id(6);
    m_session->targets().remove({&six, 1});
    QCOMPARE(m_session->targets().allSelected(), (std::vector{id(3), id(5)}));
    m_session->targets().select(id(5));
    QCOMPARE(m_table->selectionModel()->selectedRows().size(), 1);
    const TargetId five = id(5);
    m_session->targets().remove({&five, 1});
    QVERIFY(m_session->targets().allSelected().empty());
}

HITSCOPE_TEST(SceneFieldsTest, QApplication)

}  // namespace hitscope::scene_fields_test

#include "scene_fields_test.moc"
