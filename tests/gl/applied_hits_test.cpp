// SPDX-License-Identifier: GPL-3.0-or-later
// What is said about a scene goes by the hits that made what is shown: under every pipeline, with hits
// dropped, and as it was after the first hits.
#include <QTest>
#include <algorithm>

#include "analysis/hit_effects.h"
#include "analysis/mesh_measuring.h"
#include "analysis/pipeline_agreement.h"
#include "deform/attribution.h"
#include "gl/pipeline_rows.h"
#include "mesh/primitives.h"
#include "scene/scene_gpu.h"
#include "session/shots/demo_shots.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::applied_hits_test {

class AppliedHitsTest : public QObject {
    Q_OBJECT
private:
    /// Vertices of the target that the hits that are applied do not bring where the buffer has them, and
    /// those that are not moved by as many of them as counted.
    static std::size_t untrue(const Session& session, const Target& target, const HitEffects& effects) {
        std::size_t count = 0;
        const std::span<const std::uint32_t> counts = effects.counts(target.id);
        for (std::uint32_t v = 0; v < target.deformed.positions().size(); ++v) {
            const std::uint32_t drawn = target.deformed.render().renderVerticesOf(v).front();
            Attribution attribution(target.deformed.render().vertices[drawn]);
            std::uint32_t movedBy = 0;
            for (std::size_t i = 0; i < session.hits().history().size(); ++i) {
                if (session.hits().isApplied(i)) {
                    const glm::vec3 before = attribution.vertex().position;
                    attribution.add(i, session.hits().history().hits()[i]);
                    movedBy += attribution.vertex().position != before ? 1 : 0;
                }
            }
            count += attribution.vertex().position != target.deformed.positions()[v] ? 1 : 0;
            count += (counts.empty() ? 0 : counts[v]) != movedBy ? 1 : 0;
        }
        return count;
    }

private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void everythingGoesByThem_data() { test::addPipelines(); }
    void everythingGoesByThem() {
        QFETCH(int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        Session session;
        loadMesh(session, makeUvSphere(20, 20, 1.0f));
        const Target& target = *session.targets().front();
        session.settings().setPipeline(static_cast<PipelineKind>(kind));
        auto gpu = SceneGpu::create(session);
        QVERIFY(gpu.ok());
        if (!session.readBack().exactness()->isExact()) {
            QSKIP("this renderer's arithmetic is not exact");
        }
        HitEffects effects(session);
        PipelineAgreement agreement(session);
        agreement.setSync([&gpu] { return gpu.value()->sync().ok(); });
        MeshMeasuring measuring(session);
        measuring.setStretchLimit(1.2f);
        measuring.setTargets({target.id}, true);
        shootAll(session, demoShots(session, 700, 21));
        const std::size_t all = session.hits().history().size();
        QVERIFY(all > 620);
        for (const std::optional<std::size_t> shown :
             {std::optional<std::size_t>(), std::optional(all - 1), std::optional<std::size_t>(610),
              std::optional<std::size_t>(40), std::optional<std::size_t>(0), std::optional<std::size_t>()}) {
            session.hits().show(shown);
            QVERIFY(gpu.value()->sync().ok());
            const bool drops =
                shown.value_or(all) > 600 && !pipelineTraits(session.settings().pipeline()).keepsAll;
            QCOMPARE(session.readBack().droppedHits() > 0, drops);
            agreement.compare();
            QTRY_VERIFY_WITH_TIMEOUT(agreement.report() && !agreement.isComparing(), kPatience);
            QCOMPARE(agreement.report()->different, std::size_t{0});
            QCOMPARE(agreement.report()->later, all - shown.value_or(all));
            QCOMPARE(agreement.report()->hits, shown.value_or(all) - session.readBack().droppedHits());
            effects.finish();
            QCOMPARE(untrue(session, target, effects), std::size_t{0});
            for (std::size_t row = 0; row < all; ++row) {
                QCOMPARE(effects.effect(row).has_value(), session.hits().isApplied(row));
            }
            QTRY_VERIFY_WITH_TIMEOUT(measuring.isUpToDate(), kPatience);
            for (const HarmRow& harm : measuring.measurement()->harms) {
                QVERIFY(harm.hit && session.hits().isApplied(*harm.hit));
            }
            QCOMPARE(measuring.measurement()->harms.empty(), shown == std::optional<std::size_t>(0));
        }
    }

private:
    test::GlFixture m_gl;
};

HITSCOPE_TEST(AppliedHitsTest, QCoreApplication)

}  // namespace hitscope::applied_hits_test

#include "applied_hits_test.moc"
