// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes without a GPU, held against every hit at every vertex.
#include "analysis/reference_scene.h"

#include <QTest>
#include <array>

#include "analysis/reference_agreement.h"
#include "session/sample_scenes.h"
#include "session/shots/demo_shots.h"
#include "support/test_program.h"

namespace hitscope::reference_scene_test {

class ReferenceSceneTest : public QObject {
    Q_OBJECT

    /// Two overlapping targets' worth of hits.
    static void loadAndShoot(Session& session) {
        loadTeapot(session);
        session.settings().setPipeline(PipelineKind::Reference);
        session.targets().duplicate(std::array{session.targets()[0]->id});
        shootAll(session, demoShots(session, 40, 3));
    }

    static void checkAll(const Session& session) {
        const ReferenceAgreement agreement = agreementWithReference(session, ReferenceMethod::Everywhere);
        QVERIFY(agreement.vertices > 0);
        QCOMPARE(agreement.different, std::size_t{0});
        QCOMPARE(agreement.differentNormal, std::size_t{0});
        QVERIFY(session.readBack().isUpToDate());
    }

    static std::size_t changedOf(const Session& session) {
        std::size_t changed = 0;
        for (const std::unique_ptr<Target>& target : session.targets()) {
            changed += target->deformed.statistics().changedVertices;
        }
        return changed;
    }

private Q_SLOTS:
    void followsEdits() {
        Session session;
        loadAndShoot(session);
        ReferenceScene scene(session);
        scene.sync();
        checkAll(session);
        const std::size_t all = changedOf(session);
        QVERIFY(all > 100);

        session.hits().show(5);
        scene.sync();
        checkAll(session);
        QVERIFY(changedOf(session) < all);
        session.hits().show(std::nullopt);
        session.hits().remove(3);
        scene.sync();
        checkAll(session);
        session.hits().setEnabled(std::array{std::size_t{0}, std::size_t{7}}, false);
        scene.sync();
        checkAll(session);
        session.undo();
        session.undo();
        scene.sync();
        checkAll(session);
        QCOMPARE(changedOf(session), all);
    }

    void followsTargets() {
        Session session;
        loadAndShoot(session);
        ReferenceScene scene(session);
        scene.sync();
        const std::size_t all = changedOf(session);
        session.targets().remove(std::array{session.targets()[0]->id});
        scene.sync();
        checkAll(session);
        QVERIFY(changedOf(session) < all);
        session.undo();
        scene.sync();
        checkAll(session);
        QCOMPARE(changedOf(session), all);

        session.targets().duplicate(std::array{session.targets()[0]->id});
        shootAll(session, demoShots(session, 10, 5));
        scene.sync();
        checkAll(session);
    }

    void followsANewScene() {
        Session session;
        loadAndShoot(session);
        ReferenceScene scene(session);
        scene.sync();
        loadPaperRow(session, kDefaultPaperRow);
        scene.sync();
        checkAll(session);
        QCOMPARE(changedOf(session), std::size_t{0});
        shootAll(session, demoShots(session, 20, 9));
        scene.sync();
        checkAll(session);
        QVERIFY(changedOf(session) > 0);
    }
};

HITSCOPE_TEST(ReferenceSceneTest, QCoreApplication)

}  // namespace hitscope::reference_scene_test

#include "reference_scene_test.moc"
