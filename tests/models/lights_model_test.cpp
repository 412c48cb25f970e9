// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/lights_model.h"
#include "support/test_program.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

namespace hitscope::lights_model_test {

class LightsModelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void showsAndSwitchesAll() {
        Session session;
        loadTeapot(session);
        LightsModel model(session);
        const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QCOMPARE(model.rowCount(), int{LightRowCount});
        const QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
        for (int row = 0; row < LightRowCount; ++row) {
            const QModelIndex index = model.index(row);
            QVERIFY(!index.data().toString().isEmpty());
            QCOMPARE(index.data(Qt::CheckStateRole).toInt(), int{Qt::Checked});
            QVERIFY(model.setData(index, Qt::Unchecked, Qt::CheckStateRole));
            QCOMPARE(index.data(Qt::CheckStateRole).toInt(), int{Qt::Unchecked});
            QCOMPARE(changed.count(), row + 1);
        }
        QVERIFY(!session.settings().lights().directional.on && !session.settings().lights().points[3].on);
        QVERIFY(!session.settings().lights().spot.on);
        Lights lights = session.settings().lights();
        lights.points[2].terms.colour = linearColour(1.0f, 0.5f, 0.0f);
        session.settings().setLights(lights);
        QCOMPARE(model.index(FirstPointRow + 2).data(LightsModel::ColourRole).toString(),
                 QStringLiteral("#ff8000"));
    }

    void lightsStandAroundAnyScene() {
        // What is set by one scene is at the same place of another.
        Session session;
        loadTeapot(session);
        Lights lights = session.settings().lights();
        lights.points[0].position = session.settings().lightSpace().centre;
        lights.points[1].position.y += session.settings().lightSpace().extent;
        session.settings().setLights(lights);
        const float left =
            1.0f / (1.0f + lights.points[1].attenuation.linear * session.settings().lightSpace().extent);
        loadPaperRow(session, kDefaultPaperRow);
        const LightSpace& space = session.settings().lightSpace();
        QVERIFY(space.extent > 20.0f);
        QVERIFY(glm::length(session.settings().lights().points[0].position - space.centre) <
                1.0e-3f * space.extent);
        const PointLight& second = session.settings().lights().points[1];
        const Lights placed = defaultLights(space);
        QVERIFY(std::abs(second.position.y - placed.points[1].position.y - space.extent) <
                1.0e-3f * space.extent);
        QVERIFY(std::abs(1.0f / (1.0f + second.attenuation.linear * space.extent) - left) < 1.0e-4f);
    }
};

HITSCOPE_TEST(LightsModelTest, QCoreApplication)

}  // namespace hitscope::lights_model_test

#include "lights_model_test.moc"
