// SPDX-License-Identifier: GPL-3.0-or-later
// The floor and what lies on it.
#include <QTest>

#include "refined_scene.h"
#include "render/refined/refined_picture.h"
#include "support/baseline.h"
#include "support/test_program.h"

namespace hitscope::floor_test {

using namespace test;

namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

}  // namespace

class FloorTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_scene.open(); }
    void cleanup() { QCOMPARE(m_scene.gl.errors(), QStringList()); }
    void cleanupTestCase() { m_scene.close(); }
    void whatLiesOnTheFloorHidesIt();

private:
    RefinedScene m_scene;
};

/// A surface in the floor's plane: half of the samples would see the floor before it.
void FloorTest::whatLiesOnTheFloorHidesIt() {
    TestScene scene;
    scene.add(*m_scene.renderer, makeCube(8, 2.0f), glm::vec3(0.0f));
    scene.showTrueNormals({});
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, {});
    const auto top = [&](bool floor) {
        Frame view = frameOf(scene, kWidth, kHeight);
        view.floorHeight = scene.bounds().max.y;
        view.options = {.floor = floor, .shadows = false};
        RefinedPicture refined;
        while (refined.samples() < 8) {
            if (!m_scene.renderer->refine(view, *pipeline, refined).ok()) {
                return QImage();
            }
        }
        const glm::vec4 middle = view.camera.projection(float(kWidth) / kHeight) * view.camera.view() *
                                 glm::vec4(0.0f, view.floorHeight, 0.0f, 1.0f);
        const QPoint at(static_cast<int>((0.5f + 0.5f * middle.x / middle.w) * kWidth),
                        static_cast<int>((0.5f - 0.5f * middle.y / middle.w) * kHeight));
        return m_scene.shown(view, refined).copy(QRect(at - QPoint(8, 3), QSize(16, 6)));
    };
    const QImage with = top(true);
    QVERIFY(!with.isNull());
    const double off = meanDifference(with, top(false));
    QVERIFY2(off < 1.0, qPrintable(QString::number(off)));
}

HITSCOPE_TEST(FloorTest, QCoreApplication)

}  // namespace hitscope::floor_test

#include "floor_test.moc"
