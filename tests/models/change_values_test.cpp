// SPDX-License-Identifier: GPL-3.0-or-later
// What the change of vertices that are drawn with several normals amounts to.
#include "analysis/change_values.h"

#include <QTest>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "mesh/primitives.h"
#include "models/read_back_support.h"
#include "support/test_program.h"

namespace hitscope::change_values_test {

class ChangeValuesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_session = std::make_unique<Session>();
        loadMesh(*m_session, makeCube(8, 1.0f));
    }
    void cleanup() { m_session.reset(); }

    /// A corner pushed along one of its three normals moved along that one, whichever comes first.
    void cornersCountByTheirLargestValue_data() {
        QTest::addColumn<int>("axis");
        QTest::newRow("x") << 0;
        QTest::newRow("y") << 1;
        QTest::newRow("z") << 2;
    }
    void cornersCountByTheirLargestValue() {
        QFETCH(const int, axis);
        hitCorner(axis, 0.01f);
        ChangeValues values(*m_session);
        values.setQuantity(ChangeQuantity::AlongNormal);
        values.finish();
        QCOMPARE(values.summary().count, m_session->targets()[0]->deformed.statistics().changedVertices);
        QVERIFY2(std::abs(values.summary().low + kDepth) < 1.0e-6,
                 qPrintable(QString::number(values.summary().low)));
    }

    /// Neither of the front one of the render vertices, but of all.
    void spansAreThoseOfAllNormals() {
        hitCorner(1, 0.4f);
        const DeformedMesh& mesh = m_session->targets()[0]->deformed;
        const TrueNormals& normals = m_session->targets()[0]->trueNormals;
        for (const ChangeQuantity quantity :
             {ChangeQuantity::AlongNormal, ChangeQuantity::NormalRotation, ChangeQuantity::TrueNormalError}) {
            ChangeValues values(*m_session);
            values.setHistogramWanted(true);
            values.setQuantity(quantity);
            values.finish();
            double largest = 0.0;
            for (std::size_t v = 0; v < mesh.vertices().size(); ++v) {
                largest = std::max(largest, std::abs(changeOf(quantity, mesh.render().vertices[v],
                                                              mesh.vertices()[v], normals.normals()[v])));
            }
            const Summary all = values.summary();
            QCOMPARE(std::max(std::abs(all.low), std::abs(all.high)), largest);
            const std::vector<std::uint32_t>& counts = values.histogram().counts;
            QCOMPARE(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), all.count);
            QVERIFY(counts.front() > 0 && counts.back() > 0);
        }
    }

private:
    static constexpr double kDepth = 0.05;

    /// Along an axis, into the body.
    void hitCorner(int axis, float reach) {
        Hit hit;
        hit.target = m_session->targets()[0]->id;
        hit.point = glm::vec3(1.0f);
        hit.constants = {.maxDistance = reach, .power = 1.0f, .maxMagnitude = static_cast<float>(kDepth)};
        for (int other = 0; other < 3; ++other) {
            hit.direction[other] = other == axis ? -1.0f : 0.0f;
        }
        QVERIFY(m_session->hits().add(hit).ok());
        test::readBack(*m_session);
        QVERIFY(!m_session->targets()[0]->deformed.onceChanged().empty());
    }

    std::unique_ptr<Session> m_session;
};

HITSCOPE_TEST(ChangeValuesTest, QCoreApplication)

}  // namespace hitscope::change_values_test

#include "change_values_test.moc"
