// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/attribution_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include "models/read_back_support.h"
#include "support/read_back.h"
#include "support/test_program.h"

namespace hitscope::attribution_model_test {

using namespace test;
using Column = AttributionModel::Column;

class AttributionModelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_tester.reset();
        m_model.reset();
        m_session = std::make_unique<Session>();
        loadPaperRow(*m_session, kDefaultPaperRow);
        m_model = std::make_unique<AttributionModel>(*m_session);
        m_tester = std::make_unique<QAbstractItemModelTester>(
            m_model.get(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    }
    void cleanup() { m_tester.reset(); }

    void isEmptyWithoutVertex() {
        hit(20, 1);
        QCOMPARE(m_model->rowCount(), 0);
        QVERIFY(m_model->summary().isEmpty());
        m_session->selection().setPicked(VertexRef{target().id, 0});
        QVERIFY(!m_model->summary().isEmpty());
        m_session->selection().setPicked(std::nullopt);
        QVERIFY(m_model->summary().isEmpty());
    }

    void addsUpToWhatTheBufferHolds() {
        hit(200, 2);
        int reached = 0;
        for (std::uint32_t vertex = 0; vertex < target().deformed.positions().size(); ++vertex) {
            m_session->selection().setPicked(VertexRef{target().id, vertex});
            QVERIFY(m_model->isBuffers());
            // Each row's own part, added float by float.
            glm::vec3 sum = target().deformed.original().positions[vertex];
            std::size_t last = 0;
            for (const VertexContribution& row : m_model->contributions()) {
                QVERIFY(row.hit >= last);
                last = row.hit;
                QVERIFY(row.contribution.distance <= 0.5f);
                QCOMPARE(row.contribution.isCapped, row.contribution.magnitude == 0.3f);
                sum += row.contribution.displacement;
                QCOMPARE(sum, row.position);
                ++reached;
            }
            QCOMPARE(sum, target().deformed.positions()[vertex]);
        }
        QVERIFY(reached > 100);
    }

    void followsTheHistory() {
        hit(100, 3);
        m_session->selection().setPicked(VertexRef{target().id, changedMost()});
        const int before = m_model->rowCount();
        QVERIFY(before > 0);
        QSignalSpy reset(m_model.get(), &QAbstractItemModel::modelReset);
        Hit again = m_session->hits().history().hits()[row(0).hit];
        again.point = m_model->position() + glm::vec3(0.0f, 0.1f, 0.0f);
        QVERIFY(m_session->hits().add(again).ok());
        QCOMPARE(m_model->rowCount(), before + 1);
        QCOMPARE(reset.count(), 0);
        readBack(*m_session);
        QVERIFY(m_model->isBuffers());
        QSignalSpy said(m_model.get(), &AttributionModel::summaryChanged);
        QVERIFY(said.wait());

        const std::size_t disabled = row(0).hit;
        m_session->hits().setEnabled({&disabled, 1}, false);
        readBack(*m_session);
        QTRY_VERIFY_WITH_TIMEOUT(m_model->rowCount() == 0 || row(0).hit != disabled, kPatience);
        QVERIFY(m_model->isBuffers());
        m_session->undo();
        m_session->undo();
        readBack(*m_session);
        QTRY_VERIFY_WITH_TIMEOUT(m_model->rowCount() == before && m_model->isBuffers(), kPatience);
    }

    void leavesOutWhatThePipelineDropped() {
        hit(100, 4);
        const std::uint32_t vertex = changedMost();
        m_session->selection().setPicked(VertexRef{target().id, vertex});
        const std::size_t first = row(0).hit;
        CapacityReport report;
        report.capacity = 100 - first - 1;
        for (std::size_t i = 0; i <= first; ++i) {
            report.dropped.push_back(i);
        }
        const int before = m_model->rowCount();
        test::readBackOf(*m_session).setCapacity(report);
        test::readBackOf(*m_session).restart();
        readBack(*m_session);
        QTRY_COMPARE_WITH_TIMEOUT(m_model->rowCount() == before, false, kPatience);
        QVERIFY(m_model->rowCount() == 0 || row(0).hit > first);
        QVERIFY(m_model->isBuffers());
        QVERIFY(m_model->summary().contains(m_model->rowCount() == 0 ? QStringLiteral("No hit")
                                                                     : QStringLiteral("same")));
    }

    /// From one that has no room for it to one that has, both of which have a capacity.
    void takesBackWhatAnotherPipelineKeeps() {
        hit(100, 4);
        m_session->selection().setPicked(VertexRef{target().id, changedMost()});
        const int before = m_model->rowCount();
        QVERIFY(before > 0);
        CapacityReport report;
        report.capacity = 50;
        for (std::size_t i = 0; i <= row(0).hit; ++i) {
            report.dropped.push_back(i);
        }
        test::readBackOf(*m_session).setCapacity(report);
        QTRY_COMPARE_WITH_TIMEOUT(m_model->rowCount(), before - 1, kPatience);
        report.dropped.clear();
        report.perTarget = true;
        test::readBackOf(*m_session).setCapacity(report);
        QTRY_COMPARE_WITH_TIMEOUT(m_model->rowCount(), before, kPatience);
    }

    void followsWhatIsShown() {
        hit(100, 4);
        m_session->selection().setPicked(VertexRef{target().id, changedMost()});
        const int all = m_model->rowCount();
        QVERIFY(all > 0);
        const std::size_t first = row(0).hit;
        m_session->hits().show(first);
        readBack(*m_session);
        QTRY_COMPARE_WITH_TIMEOUT(m_model->rowCount(), 0, kPatience);
        QVERIFY(m_model->isBuffers());
        m_session->hits().show(first + 1);
        QTRY_COMPARE_WITH_TIMEOUT(m_model->rowCount(), 1, kPatience);
        QVERIFY(!m_model->isBuffers());
        QVERIFY(m_model->summary().contains(QStringLiteral("not been read back yet")));
        readBack(*m_session);
        QVERIFY(m_model->isBuffers());
        m_session->hits().show(std::nullopt);
        readBack(*m_session);
        QTRY_COMPARE_WITH_TIMEOUT(m_model->rowCount(), all, kPatience);
        QVERIFY(m_model->isBuffers());
    }

    void saysWhenTheBufferDiffers() {
        hit(50, 5);
        const std::uint32_t vertex = changedMost();
        m_session->selection().setPicked(VertexRef{target().id, vertex});
        QVERIFY(m_model->summary().contains(QStringLiteral("same")));
        const std::uint32_t render = target().deformed.render().renderVerticesOf(vertex)[0];
        DynamicVertex off = target().deformed.vertices()[render];
        off.position.x = std::nextafter(off.position.x, 100.0f);
        test::readBackOf(*m_session).take(target().id, render, {&off, 1});
        test::readBackOf(*m_session).finish();
        QVERIFY(!m_model->isBuffers());
        QVERIFY(!m_model->summary().contains(QStringLiteral("same")));
    }

    void tenThousandHits() {
        std::vector<Hit> hits = randomHits(target(), 10'000, 6);
        for (Hit& hit : hits) {
            hit.constants.power = 0.0005f;
        }
        QVERIFY(m_session->hits().add(hits).ok());
        readBack(*m_session);
        m_session->selection().setPicked(VertexRef{target().id, changedMost()});
        QVERIFY(m_model->rowCount() > 20);
        QVERIFY(m_model->isBuffers());
    }

private:
    [[nodiscard]] const Target& target() const { return *m_session->targets()[10]; }
    [[nodiscard]] const VertexContribution& row(std::size_t at) const { return m_model->contributions()[at]; }
    void hit(std::size_t count, unsigned seed) {
        QVERIFY(m_session->hits().add(randomHits(target(), count, seed)).ok());
        readBack(*m_session);
    }
    [[nodiscard]] std::uint32_t changedMost() const {
        std::uint32_t most = 0;
        for (std::uint32_t v = 0; v < target().deformed.positions().size(); ++v) {
            if (glm::length(target().deformed.displacement(v)) >
                glm::length(target().deformed.displacement(most))) {
                most = v;
            }
        }
        return most;
    }

    std::unique_ptr<Session> m_session;
    std::unique_ptr<AttributionModel> m_model;
    std::unique_ptr<QAbstractItemModelTester> m_tester;
};

HITSCOPE_TEST(AttributionModelTest, QCoreApplication)

}  // namespace hitscope::attribution_model_test

#include "attribution_model_test.moc"
