// SPDX-License-Identifier: GPL-3.0-or-later
// Long histories applied in slices: the picture's state stays as it was until all hits are there, and then
// equals the reference; giving up leaves everything as it was.
#include "scene/reapplication.h"

#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "deform/reference.h"
#include "gl/pipeline_rows.h"
#include "gl/render_target.h"
#include "mesh/primitives.h"
#include "scene/scene_gpu.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::reapplication_test {

namespace {

std::vector<Hit> manyHits(TargetId target, std::size_t count) {
    std::vector<Hit> hits(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float angle = 0.37f * static_cast<float>(i);
        const float height = std::sin(0.11f * static_cast<float>(i));
        hits[i].target = target;
        hits[i].point = 2.5f * glm::normalize(glm::vec3(std::cos(angle), height, std::sin(angle)));
        hits[i].direction = -glm::normalize(hits[i].point);
        hits[i].constants.maxDistance = 0.3f;
        hits[i].constants.power = 0.001f;
        hits[i].constants.maxMagnitude = 0.01f;
    }
    return hits;
}

std::size_t differences(const Session& session, std::span<const Hit> hits) {
    const Target& target = *session.targets().front();
    ReferenceDeformation reference(target.deformed.render());
    reference.apply(hits);
    std::size_t count = 0;
    for (std::size_t i = 0; i < reference.vertices().size(); ++i) {
        count += reference.vertices()[i].position != target.deformed.vertices()[i].position ? 1 : 0;
    }
    return count;
}

}  // namespace

class ReapplicationTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        if (!m_gl.open()) {
            return;
        }
        HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        m_target.emplace(64, 48);
        QVERIFY(m_target->isComplete());
    }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }
    void cleanupTestCase() { m_target.reset(); }

    void aSwitchOfPipelinesKeepsThePictureUntilItIsDone() {
        Session session;
        SetUp scene(*this, session);
        const std::vector<Hit> hits(session.hits().history().hits().begin(),
                                    session.hits().history().hits().end());
        session.settings().setPipeline(PipelineKind::Reference);
        QVERIFY(scene.draw());
        QVERIFY(session.tasks().current() != nullptr);
        QCOMPARE(differences(session, hits), std::size_t{0});  // still the old pipeline's
        int frames = 1;
        while (session.tasks().current() != nullptr && frames < 1000) {
            QVERIFY(scene.gpu->isReadBackPending());
            if (frames == 2) {
                QVERIFY(session.hits().add(hits.front()));  // arrives in between
            }
            QVERIFY(scene.draw());
            ++frames;
        }
        QVERIFY(frames > 3);
        QCOMPARE(session.hits().history().size(), hits.size() + 1);
        QVERIFY(scene.gpu->sync());
        QCOMPARE(differences(session, session.hits().history().hits()), std::size_t{0});
    }

    void givingUpASwitchLeavesEverythingAsItWas() {
        Session session;
        SetUp scene(*this, session);
        session.settings().setPipeline(PipelineKind::Reference);
        QVERIFY(scene.draw());
        QVERIFY(scene.draw());
        const TaskList::Task* task = session.tasks().current();
        QVERIFY(task != nullptr && task->fraction > 0.0 && task->fraction < 1.0);
        session.tasks().cancel(task->id);
        QCOMPARE(session.settings().pipeline(), PipelineKind::TransformFeedback);
        QVERIFY(scene.draw());
        QCOMPARE(session.tasks().current(), nullptr);
        QCOMPARE(differences(session, session.hits().history().hits()), std::size_t{0});
    }

    void anEditOfThousandsOfHitsIsSlicedAndCanBeUndone() {
        Session session;
        SetUp scene(*this, session);
        const std::vector<Hit> before(session.hits().history().hits().begin(),
                                      session.hits().history().hits().end());
        DeformationConstants constants = before.front().constants;
        constants.maxMagnitude = 0.02f;
        constants.power = 0.002f;
        QVERIFY(session.settings().setConstants(constants));
        session.hits().giveConstantsToAll();
        QVERIFY(scene.draw());
        QVERIFY(session.tasks().current() != nullptr);
        QCOMPARE(differences(session, before), std::size_t{0});
        session.tasks().cancel(session.tasks().current()->id);
        QVERIFY(scene.draw());
        QCOMPARE(session.tasks().current(), nullptr);
        QVERIFY(std::equal(before.begin(), before.end(), session.hits().history().hits().begin()));
        QCOMPARE(differences(session, before), std::size_t{0});

        session.redo();
        QVERIFY(scene.draw());
        QVERIFY(session.tasks().current() != nullptr);
        QVERIFY(scene.gpu->sync());  // who needs it now does not wait for frames
        QCOMPARE(session.tasks().current(), nullptr);
        QCOMPARE(differences(session, session.hits().history().hits()), std::size_t{0});
        QVERIFY(differences(session, before) > 0);
        QVERIFY(scene.draw());
        QCOMPARE(session.tasks().current(), nullptr);
    }

    void editsMeanwhileAreFollowed() {
        Session session;
        SetUp scene(*this, session);
        session.settings().setPipeline(PipelineKind::Reference);
        QVERIFY(scene.draw());
        session.hits().remove(3);
        QVERIFY(scene.draw());
        session.hits().remove(session.hits().history().size() - 1);
        for (int frame = 0; frame < 1000 && session.tasks().current() != nullptr; ++frame) {
            QVERIFY(scene.draw());
        }
        QVERIFY(scene.gpu->sync());
        QCOMPARE(differences(session, session.hits().history().hits()), std::size_t{0});
    }

    void targetsThatComeMeanwhileAreFollowed() {
        Session session;
        SetUp scene(*this, session);
        session.settings().setPipeline(PipelineKind::Reference);
        QVERIFY(scene.draw());
        session.targets().duplicate(std::vector<TargetId>{session.targets().front()->id});
        for (int frame = 0; frame < 2000 && (frame < 2 || session.tasks().current() != nullptr); ++frame) {
            QVERIFY(scene.draw());
        }
        QVERIFY(scene.gpu->sync());
        const TargetId first = session.targets().front()->id;
        QCOMPARE(differences(session, session.hits().history().hitsOn(first)), std::size_t{0});
        QVERIFY(std::equal(session.targets()[0]->deformed.positions().begin(),
                           session.targets()[0]->deformed.positions().end(),
                           session.targets()[1]->deformed.positions().begin()));
    }

private:
    /// A sphere with a long history, followed.
    struct SetUp {
        SetUp(ReapplicationTest& test, Session& session) : fbo(test.m_target->framebuffer()) {
            loadMesh(session, makeHighPolySphere(2.5f));
            session.settings().setPipeline(PipelineKind::TransformFeedback);
            gpu = SceneGpu::create(session).value();
            const std::vector<Hit> hits = manyHits(session.targets().front()->id, 3000);
            QVERIFY(session.hits().add(hits));
            QVERIFY(gpu->sync());
        }
        bool draw() {
            SceneGpu::View view;
            view.width = 64;
            view.height = 48;
            return gpu->draw(view, fbo).ok();
        }
        unsigned fbo;
        std::unique_ptr<SceneGpu> gpu;
    };

    test::GlFixture m_gl;
    std::optional<gl::RenderTarget> m_target;
};

HITSCOPE_TEST(ReapplicationTest, QCoreApplication)

}  // namespace hitscope::reapplication_test

#include "reapplication_test.moc"
