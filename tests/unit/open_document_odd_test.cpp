// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions that can be read, with values that nobody would choose.
#include <QCoreApplication>
#include <QTest>
#include <limits>

#include "open_document_support.h"
#include "physics/projectile_settings.h"
#include "session/mesh_steps/mesh_edit.h"
#include "session/primitive_target.h"
#include "support/test_program.h"

namespace hitscope::open_document_odd_test {

using namespace test;

class OpenDocumentOddTest : public QObject {
    Q_OBJECT

    static SessionDocument teapots(int count) {
        Session session;
        loadTeapot(session);
        for (int i = 1; i < count; ++i) {
            session.targets().add({planBuiltIn(BuiltInMesh::Teapot)});
        }
        return captureSession(session, someView());
    }

private Q_SLOTS:
    void aPlacementToInfinityIsTold() {
        SessionDocument document = teapots(2);
        document.targets[1].placement = {{1.0e308, 0.0, 1.0}, 1.0e10};
        const Result<PreparedSession> made = prepareSession(document, {});
        QVERIFY2(made.ok(), qPrintable(messageOf(made)));
        QCOMPARE(made.value().troubles.size(), std::size_t{1});
        QVERIFY(made.value().troubles[0].targets == std::vector<TargetId>{document.targets[1].id});
    }

    /// Whatever is wrong with another target that has no file either.
    void onlyWhatIsWrongIsTold() {
        SessionDocument document = teapots(3);
        document.targets[0].source.mesh = std::monostate();
        const Result<PreparedSession> made = prepareSession(document, {});
        QVERIFY2(made.ok(), qPrintable(messageOf(made)));
        QCOMPARE(made.value().troubles.size(), std::size_t{1});
        QVERIFY(made.value().troubles[0].targets == std::vector<TargetId>{document.targets[0].id});
        QCOMPARE(made.value().scene.targets.size(), std::size_t{2});
    }

    /// As of a hit list from elsewhere, in nanoseconds since 1970: time goes on from there, so it must not be
    /// so long that a step adds nothing.
    void timeGoesOnAfterAHitOfTheFarFuture() {
        SessionDocument document = teapots(1);
        document.hits.push_back(exampleHit(document.targets[0].id.value, 0.0f));
        document.hits.back().triangle = kNoIndex;
        document.hits.back().time = 1.0e300;
        Result<PreparedSession> made = prepareSession(document, {});
        QVERIFY2(made.ok(), qPrintable(messageOf(made)));
        Session session;
        restoreSession(session, made.value());
        const double time = session.simulation().physics().clock().time();
        QVERIFY(time + 1.0e-3 > time);
    }

    void zeroesInNamesAreLeftOut() {
        SessionDocument document = teapots(1);
        document.targets[0].name = QStringLiteral("Löwe");
        QByteArray bytes = writeDocument(document);
        const qsizetype at = bytes.indexOf("Löwe");
        QVERIFY(at > 0);
        bytes.replace(at, static_cast<qsizetype>(qstrlen("Löwe")), "L\\u0000öwe");
        const Result<SessionDocument> read = readDocument(bytes);
        QVERIFY2(read.ok(), qPrintable(messageOf(read)));
        QCOMPARE(read.value().targets[0].name, QStringLiteral("Löwe"));
    }

    void noMoreMeshStepsThanAreRead() {
        Session session;
        loadTeapot(session);
        const TargetId id = session.targets().front()->id;
        const MeshEdit edit = meshEdit(session, id, SmoothOptions{});
        TargetState state = *session.targets().front();
        state.steps.assign(kMostMeshSteps, std::make_shared<const MeshStep>(SmoothOptions{}));
        QVERIFY(takeEdited(session, state, edit).ok());
        state = *session.targets().front();
        state.steps.push_back(state.steps.back());
        const Status refused = takeEdited(session, state, edit);
        QVERIFY(!refused.ok() && !refused.error().advice.empty());
    }

    void noTurntableOfASizeThatIsNotRead() {
        for (const float size : {1.0e-7f, 1.0e9f}) {
            Session session;
            ScenePlan plan;
            plan.targets.push_back(planPrimitive({PrimitiveKind::Cube, 1, size}));
            session.loadScene(std::move(plan));
            const Status put = putOnTurntable(session, session.targets().front()->id);
            QVERIFY(!put.ok());
            QCOMPARE(session.targets().size(), std::size_t{1});
        }
    }
};

HITSCOPE_TEST(OpenDocumentOddTest, QCoreApplication)

}  // namespace hitscope::open_document_odd_test

#include "open_document_odd_test.moc"
