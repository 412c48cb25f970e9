// SPDX-License-Identifier: GPL-3.0-or-later
// The dock "Lights": colours that are tried, and scenes of any size.
#include "panels/lights/lights_panel.h"

#include <QApplication>
#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QListView>
#include <QTest>
#include <QToolButton>

#include "mesh/primitives.h"
#include "support/test_program.h"

namespace hitscope::lights_panel_test {

class LightsPanelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aColourIsOneStep();
    void noneIsLeftByCancelling();
    void scenesOfAnySize_data();
    void scenesOfAnySize();

private:
    static QColorDialog* openColours(const LightsPanel& panel) {
        auto* button = panel.findChild<QToolButton*>(QStringLiteral("colour"));
        button->click();
        return button->findChild<QColorDialog*>();
    }
};

void LightsPanelTest::aColourIsOneStep() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    LightsPanel panel(session);
    panel.show();
    const Lights before = session.settings().lights();
    QColorDialog* colours = openColours(panel);
    QVERIFY(colours != nullptr);
    QVERIFY(colours->windowTitle().contains(QStringLiteral("ight")));
    for (const QColor& tried : {QColor(Qt::red), QColor(Qt::green), QColor(Qt::blue)}) {
        colours->setCurrentColor(tried);
        QVERIFY(!(session.settings().lights() == before));  // followed live
    }
    colours->accept();
    const Lights after = session.settings().lights();
    QCOMPARE(after.directional.terms.colour, glm::vec3(0.0f, 0.0f, 1.0f));
    QCOMPARE(session.steps().size(), std::size_t{1});
    session.undo();
    QVERIFY(session.settings().lights() == before);
    session.redo();
    QVERIFY(session.settings().lights() == after);
}

void LightsPanelTest::noneIsLeftByCancelling() {
    Session session;
    loadPaperRow(session, kDefaultPaperRow);
    LightsPanel panel(session);
    panel.show();
    Lights lights = session.settings().lights();
    lights.spot.on = false;
    session.settings().setLights(lights);
    session.undo();
    const Lights before = session.settings().lights();
    QColorDialog* colours = openColours(panel);
    QVERIFY(colours != nullptr);
    colours->setCurrentColor(Qt::red);
    colours->setCurrentColor(Qt::green);
    colours->reject();
    QVERIFY(session.settings().lights() == before);
    QVERIFY(!session.steps().canUndo() && session.steps().canRedo());
}

void LightsPanelTest::scenesOfAnySize_data() {
    QTest::addColumn<float>("radius");
    QTest::newRow("small") << 1.0e-4f;
    QTest::newRow("usual") << 2.5f;
    QTest::newRow("large") << 1.0e5f;
}

/// Each number is shown and kept, and a step of a position is a part of the scene.
void LightsPanelTest::scenesOfAnySize() {
    QFETCH(float, radius);
    Session session;
    loadMesh(session, makeUvSphere(12, 6, radius));
    const Lights before = session.settings().lights();
    LightsPanel panel(session);
    panel.show();
    auto* list = panel.findChild<QListView*>(QStringLiteral("list"));
    list->setCurrentIndex(list->model()->index(1, 0));
    const PointLight& light = before.points[0];
    const auto box = [&panel](const char* name) {
        return panel.findChild<QDoubleSpinBox*>(QLatin1String(name));
    };
    const std::pair<const char*, float> shown[] = {{"positionX", light.position.x},
                                                   {"positionY", light.position.y},
                                                   {"positionZ", light.position.z},
                                                   {"linear", light.attenuation.linear},
                                                   {"quadratic", light.attenuation.quadratic}};
    for (const auto& [name, value] : shown) {
        QCOMPARE(static_cast<float>(box(name)->value()), value);
        bool isNumber = false;
        const double text = box(name)->locale().toDouble(box(name)->text(), &isNumber);
        QVERIFY2(isNumber && std::abs(text - static_cast<double>(value)) <
                                 0.01 * std::max(std::abs(static_cast<double>(value)), 1.0e-30),
                 qPrintable(QStringLiteral("%1: %2").arg(QLatin1String(name), box(name)->text())));
    }
    box("positionX")->stepBy(1);
    const float way = session.settings().lights().points[0].position.x - light.position.x;
    QVERIFY2(way > 0.001f * radius && way < 0.5f * radius, qPrintable(QString::number(way)));
    box("quadratic")->stepBy(1);
    const Attenuation& now = session.settings().lights().points[0].attenuation;
    QVERIFY(now.quadratic > light.attenuation.quadratic);
    QVERIFY(now.quadratic < 2.0f * light.attenuation.quadratic);
    QCOMPARE(now.linear, light.attenuation.linear);
}

HITSCOPE_TEST(LightsPanelTest, QApplication)

}  // namespace hitscope::lights_panel_test

#include "lights_panel_test.moc"
