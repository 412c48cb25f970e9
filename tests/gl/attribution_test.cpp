// SPDX-License-Identifier: GPL-3.0-or-later
// What attribution adds up to, against what every pipeline's buffers hold.
#include "deform/attribution.h"

#include <QTest>
#include <cstring>

#include "gl/pipeline_rows.h"
#include "scene/scene_gpu.h"
#include "session/shots/demo_shots.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::attribution_test {

class AttributionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void addsUpToTheBuffersBits_data() { test::addPipelines(); }
    void addsUpToTheBuffersBits() {
        QFETCH(int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        Session session;
        loadTeapot(session);
        session.settings().setPipeline(static_cast<PipelineKind>(kind));
        auto gpu = SceneGpu::create(session);
        QVERIFY(gpu.ok());
        if (!session.readBack().exactness()->isExact()) {
            QSKIP("this renderer's arithmetic is not exact");
        }
        // More than the uniform arrays hold, so that some are dropped. How the projectiles fly does not
        // matter.
        for (const Ray& shot : demoShots(session, 1200, 21)) {
            session.simulation().hitscan(shot);
        }
        QVERIFY(session.hits().history().size() > 600);
        QVERIFY(gpu.value()->sync().ok());
        QCOMPARE(session.readBack().isDropped(0), !pipelineTraits(static_cast<PipelineKind>(kind)).keepsAll);
        const Target& target = *session.targets().front();
        std::size_t contributions = 0;
        for (std::size_t v = 0; v < target.deformed.vertices().size(); ++v) {
            Attribution attribution(target.deformed.render().vertices[v]);
            for (std::size_t i = 0; i < session.hits().history().size(); ++i) {
                if (!session.readBack().isDropped(i)) {
                    attribution.add(i, session.hits().history().hits()[i]);
                }
            }
            contributions += attribution.contributions().size();
            // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): to the last bit
            const int order =
                std::memcmp(&attribution.vertex(), &target.deformed.vertices()[v], sizeof(DynamicVertex));
            QCOMPARE(order, 0);
            glm::vec3 sum = target.deformed.render().vertices[v].position;
            for (const VertexContribution& row : attribution.contributions()) {
                sum += row.contribution.displacement;
                QCOMPARE(sum, row.position);
            }
        }
        QVERIFY(contributions > 5000);
    }

private:
    test::GlFixture m_gl;
};

HITSCOPE_TEST(AttributionTest, QCoreApplication)

}  // namespace hitscope::attribution_test

#include "attribution_test.moc"
