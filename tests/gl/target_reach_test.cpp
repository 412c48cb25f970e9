// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "pipeline/target_reach.h"

namespace hitscope {

namespace {

using Ranges = std::vector<VertexRange>;

/// A short way along x, one vertex each tenth of a metre from x on.
std::vector<DynamicVertex> row(float x, std::size_t count) {
    std::vector<DynamicVertex> vertices(count);
    for (std::size_t i = 0; i < count; ++i) {
        vertices[i] = {{x + 0.1f * static_cast<float>(i), 0, 0}, {0, 1, 0}};
    }
    return vertices;
}

Hit hitAt(float x) {
    return Hit{TargetId{1}, {x, 0, 0}, {1, 0, 0}, {}};
}

}  // namespace

class TargetReachTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void followsWhereVerticesAre() {
        TargetReach reach(m_clusters);
        QCOMPARE(reach.advance(hitAt(0)), (Ranges{{0, 4}}));
        QCOMPARE(reach.advance(hitAt(20)), Ranges());
        reach.place(0, row(20, 4));
        reach.update();
        QCOMPARE(reach.advance(hitAt(20)), (Ranges{{0, 4}}));
        QCOMPARE(reach.advance(hitAt(0)), Ranges());
        reach.reset();
        QCOMPARE(reach.advance(hitAt(0)), (Ranges{{0, 4}}));
        QCOMPARE(reach.advance(hitAt(20)), Ranges());
    }

    void drawsGrownSpheresTight() {
        TargetReach reach(m_clusters);
        for (int i = 0; i < 10; ++i) {
            QVERIFY(!reach.advance(hitAt(0.15f + 0.2f * static_cast<float>(i))).empty());
        }
        QCOMPARE(reach.advance(hitAt(2.2f)), (Ranges{{0, 4}}));
        reach.place(0, row(0, 4));
        reach.update();
        QCOMPARE(reach.advance(hitAt(2.2f)), Ranges());
    }

    // Both clusters cut: what arrives of each is found where it is.
    void takesClustersInParts() {
        TargetReach reach(m_clusters);
        reach.place(2, row(30, 3));
        reach.place(5, row(40, 3));
        reach.update();
        QCOMPARE(reach.advance(hitAt(30)), (Ranges{{0, 8}}));
        QCOMPARE(reach.advance(hitAt(40)), (Ranges{{4, 4}}));
    }

private:
    const std::vector<Cluster> m_clusters = {{0, 4, {{0.15f, 0, 0}, 0.16f}}, {4, 4, {{10.15f, 0, 0}, 0.16f}}};
};

}  // namespace hitscope

QTEST_GUILESS_MAIN(hitscope::TargetReachTest)
#include "target_reach_test.moc"
