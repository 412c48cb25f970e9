// SPDX-License-Identifier: GPL-3.0-or-later
// A scene that comes back with its hits is what it was, in every bit, in every pipeline.
#include <QTest>

#include "deform/fingerprint.h"
#include "gl/pipeline_rows.h"
#include "scene/scene_gpu.h"
#include "session/shots/demo_shots.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::scene_undo_test {

namespace {

std::vector<DynamicVertex> all(const Session& session) {
    std::vector<DynamicVertex> vertices;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const auto some = target->deformed.vertices();
        vertices.insert(vertices.end(), some.begin(), some.end());
    }
    return vertices;
}

bool same(const std::vector<DynamicVertex>& a, const std::vector<DynamicVertex>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const DynamicVertex& one, const DynamicVertex& other) {
                          return one.position == other.position && one.normal == other.normal;
                      });
}

}  // namespace

class SceneUndoGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void comesBack_data() { test::addPipelines(); }
    void comesBack() {
        QFETCH(int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        session.settings().setPipeline(static_cast<PipelineKind>(kind));
        Result<std::unique_ptr<SceneGpu>> made = SceneGpu::create(session);
        QVERIFY(made);
        SceneGpu& gpu = *made.value();
        shootAll(session, demoShots(session, 40, 3));
        QVERIFY(gpu.sync().ok());
        const std::vector<DynamicVertex> first = all(session);
        loadTeapot(session);
        shootAll(session, demoShots(session, 10, 4));
        QVERIFY(gpu.sync().ok());
        const std::vector<DynamicVertex> second = all(session);
        const std::size_t steps = session.steps().done();
        while (session.targets().size() == 1) {
            session.undo();
        }
        QVERIFY(gpu.sync().ok());
        QVERIFY(same(all(session), first));
        session.goToStep(steps);
        QVERIFY(gpu.sync().ok());
        QVERIFY(same(all(session), second));
    }

private:
    test::GlFixture m_gl;
};

HITSCOPE_TEST(SceneUndoGlTest, QCoreApplication)

}  // namespace hitscope::scene_undo_test

#include "scene_undo_test.moc"
