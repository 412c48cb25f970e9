// SPDX-License-Identifier: GPL-3.0-or-later
// What is compared comes in through the session's own door for read-back, so that it can be disturbed.
#include "analysis/pipeline_agreement.h"

#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "deform/reference.h"
#include "mesh/primitives.h"
#include "support/read_back.h"
#include "support/test_program.h"

namespace hitscope::pipeline_agreement_test {

namespace {

Hit hitAt(const Target& target, float angle) {
    Hit hit;
    hit.target = target.id;
    hit.point = 2.5f * glm::vec3(std::cos(angle), 0.0f, std::sin(angle));
    hit.direction = -glm::normalize(hit.point);
    return hit;
}

/// What a faultless pipeline would deliver.
void readBack(Session& session) {
    test::readBackOf(session).restart();
    for (const std::unique_ptr<Target>& target : session.targets()) {
        ReferenceDeformation reference(target->deformed.render());
        reference.apply(session.hits().history().hitsOn(target->id));
        test::readBackOf(session).take(target->id, 0, reference.vertices());
    }
    test::readBackOf(session).finish();
}

}  // namespace

class PipelineAgreementTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void agreesAfterHits() {
        Session session;
        loadMesh(session, makeHighPolySphere(2.5f));
        const Target& target = *session.targets().front();
        PipelineAgreement agreement(session);
        for (int i = 0; i < 20; ++i) {
            QVERIFY(session.hits().add(hitAt(target, 0.4f * static_cast<float>(i))));
        }
        readBack(session);
        agreement.compare();
        QVERIFY(agreement.isComparing());
        QTRY_VERIFY_WITH_TIMEOUT(agreement.report(), kPatience);
        QCOMPARE(agreement.report()->different, std::size_t{0});
        QCOMPARE(agreement.report()->largest, 0.0);
        QCOMPARE(agreement.report()->vertices, target.deformed.original().vertexCount());
        QCOMPARE(agreement.report()->hits, std::size_t{20});
        QVERIFY(!agreement.report()->worst);
    }

    void findsTheVertexThatIsWrong() {
        Session session;
        loadMesh(session, makeHighPolySphere(2.5f));
        const Target& target = *session.targets().front();
        QVERIFY(session.hits().add(hitAt(target, 0.0f)));
        readBack(session);
        PipelineAgreement agreement(session);
        agreement.compare();
        QTRY_VERIFY_WITH_TIMEOUT(agreement.report(), kPatience);

        constexpr std::uint32_t kDisturbed = 1234;
        DynamicVertex vertex = target.deformed.vertices()[kDisturbed];
        vertex.position.y += 0.25f;
        test::readBackOf(session).take(target.id, kDisturbed, {&vertex, 1});
        test::readBackOf(session).finish();
        agreement.compare();
        QTRY_COMPARE_WITH_TIMEOUT(agreement.report()->different, std::size_t{1}, kPatience);
        QVERIFY(std::abs(agreement.report()->largest - 0.25) < 1e-6);
        const double count = static_cast<double>(agreement.report()->vertices);
        QVERIFY(std::abs(agreement.report()->rootMeanSquare - 0.25 / std::sqrt(count)) < 1e-7);
        QCOMPARE(agreement.report()->worst->vertex, target.deformed.render().fileVertices[kDisturbed]);
        QCOMPARE(agreement.report()->worst->target, target.id);
        readBack(session);
        agreement.compare();
        QTRY_COMPARE_WITH_TIMEOUT(agreement.report()->different, std::size_t{0}, kPatience);
    }

    void followsContinuouslyThroughEdits() {
        Session session;
        loadMesh(session, makeHighPolySphere(2.5f));
        const Target& target = *session.targets().front();
        PipelineAgreement agreement(session);
        int synced = 0;
        agreement.setSync([&] {
            readBack(session);
            ++synced;
            return true;
        });
        agreement.setContinuous(true);
        for (int i = 0; i < 8; ++i) {
            QVERIFY(session.hits().add(hitAt(target, 0.4f * static_cast<float>(i))));
        }
        QTRY_VERIFY_WITH_TIMEOUT(agreement.report() && agreement.report()->hits == 8, kPatience);
        QCOMPARE(agreement.report()->different, std::size_t{0});
        session.hits().remove(2);
        QTRY_COMPARE_WITH_TIMEOUT(agreement.report()->hits, std::size_t{7}, kPatience);
        QCOMPARE(agreement.report()->different, std::size_t{0});
        QVERIFY(synced >= 2);
        loadMesh(session, makeLowPolyCube(1.0f));
        QTRY_VERIFY_WITH_TIMEOUT(agreement.report() && agreement.report()->vertices == 386, kPatience);
    }

    void hitsThatThePipelineDroppedAreLeftOut() {
        Session session;
        loadMesh(session, makeHighPolySphere(2.5f));
        const Target& target = *session.targets().front();
        QVERIFY(session.hits().add(hitAt(target, 0.0f)));
        CapacityReport report;
        report.capacity = 0;
        report.dropped = {0};
        test::readBackOf(session).setCapacity(report);
        PipelineAgreement agreement(session);
        agreement.compare();
        QTRY_VERIFY_WITH_TIMEOUT(agreement.report(), kPatience);
        QCOMPARE(agreement.report()->different, std::size_t{0});
        QCOMPARE(agreement.report()->dropped, std::size_t{1});
        test::readBackOf(session).setCapacity({});
        agreement.compare();
        QTRY_VERIFY_WITH_TIMEOUT(agreement.report()->different > 0, kPatience);
    }
};

HITSCOPE_TEST(PipelineAgreementTest, QCoreApplication)

}  // namespace hitscope::pipeline_agreement_test

#include "pipeline_agreement_test.moc"
