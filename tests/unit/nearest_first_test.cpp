// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which a software renderer draws a target's triangles.
#include <QTest>
#include <algorithm>
#include <glm/geometric.hpp>

#include "mesh/primitives.h"
#include "render/seen/visible_runs.h"
#include "support/test_program.h"

namespace hitscope::nearest_first_test {

using Groups = std::vector<std::vector<IndexRun>>;

class NearestFirstTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void hasEachIndexOnce_data() {
        QTest::addColumn<QList<int>>("seen");  // first, end, first, ...
        const int all = static_cast<int>(m_mesh.triangles.size());
        QTest::newRow("all") << QList<int>{0, all};
        QTest::newRow("nothing") << QList<int>{};
        QTest::newRow("within a cluster") << QList<int>{3, 9};
        QTest::newRow("runs that share a cluster") << QList<int>{3, 9, 12, 30, 999, all / 2, all - 6, all};
    }
    void hasEachIndexOnce() {
        QFETCH(QList<int>, seen);
        std::vector<bool> wanted(m_mesh.triangles.size());
        for (qsizetype i = 0; i < seen.size(); i += 2) {
            std::fill(wanted.begin() + seen[i], wanted.begin() + seen[i + 1], true);
        }
        std::vector<bool> drawn(wanted.size());
        for (const std::vector<IndexRun>& group : grouped(runsOf(seen), glm::vec3(0, 0, -1))) {
            std::uint32_t last = 0;
            for (const IndexRun& run : group) {
                QVERIFY(run.first < run.end && run.first >= last);
                for (std::uint32_t i = run.first; i < run.end; ++i) {
                    QVERIFY(!drawn[i]);
                    drawn[i] = true;
                }
                last = run.end;
            }
        }
        QVERIFY(drawn == wanted);
    }

    void whatIsNearerComesFirst() {
        const glm::vec3 forward = glm::normalize(glm::vec3(1.0f, -0.5f, -2.0f));
        const Groups groups = grouped(runsOf({0, static_cast<int>(m_mesh.triangles.size())}), forward);
        QCOMPARE(groups.size(), kGroups);
        for (std::size_t group = 0; group < kGroups; ++group) {
            QVERIFY(!groups[group].empty() || group < 2 || group >= kGroups - 2);  // the box has corners
            // A slab's clusters reach into its neighbours by half their size at most.
            const Bounds& all = m_mesh.bounds;
            const float reach = 0.5f * glm::dot(all.size(), glm::abs(forward));
            const float slab = 2.0f * reach / kGroups;
            for (const IndexRun& run : groups[group]) {
                const glm::vec3 corner = m_mesh.vertices[m_mesh.triangles[run.first]].position;
                const float depth = glm::dot(corner - all.centre(), forward) + reach;
                const auto order = static_cast<float>(group);
                QVERIFY(depth > (order - 2.0f) * slab && depth < (order + 3.0f) * slab);
            }
        }
    }

    /// The same cluster is in the same group, whatever else is drawn.
    void partsAreGroupedAsTheWhole() {
        const glm::vec3 forward(0.0f, 0.0f, -1.0f);
        const Groups whole = grouped(runsOf({0, static_cast<int>(m_mesh.triangles.size())}), forward);
        for (std::size_t group = 0; group < kGroups; ++group) {
            for (const IndexRun& run : whole[group]) {
                const Groups part = grouped({run}, forward);
                QCOMPARE(countOf(part[group]), std::size_t{run.end - run.first});
            }
        }
    }

    void withoutClustersThereIsOneGroup() {
        const std::vector<IndexRun> seen{{0, 30}, {60, 90}};
        const Groups groups = render::nearestFirst(seen, ClusterRuns(), m_mesh.bounds, {0, 0, -1}, kGroups);
        QCOMPARE(groups.size(), std::size_t{1});
        QCOMPARE(countOf(groups.front()), std::size_t{60});
    }

    /// Of a size that no number has, and of none.
    void strangeSizes() {
        const std::vector<IndexRun> seen{{0, 300}};
        Bounds huge;
        huge.add(glm::vec3(-3.0e38f));
        huge.add(glm::vec3(3.0e38f));
        Bounds point;
        point.add(glm::vec3(0.0f));
        for (const Bounds& bounds : {huge, point}) {
            const Groups groups =
                render::nearestFirst(seen, m_mesh.triangleRuns, bounds, {0, 0, -1}, kGroups);
            QCOMPARE(countOf(groups.front()), std::size_t{300});
        }
    }

private:
    static constexpr std::size_t kGroups = 8;

    static std::vector<IndexRun> runsOf(const QList<int>& ends) {
        std::vector<IndexRun> runs;
        for (qsizetype i = 0; i < ends.size(); i += 2) {
            runs.push_back({static_cast<std::uint32_t>(ends[i]), static_cast<std::uint32_t>(ends[i + 1])});
        }
        return runs;
    }
    [[nodiscard]] Groups grouped(const std::vector<IndexRun>& seen, const glm::vec3& forward) const {
        return render::nearestFirst(seen, m_mesh.triangleRuns, m_mesh.bounds, forward, kGroups);
    }

    const RenderMesh m_mesh = buildRenderMesh(makeUvSphere(128, 80, 2.5f));
};

HITSCOPE_TEST(NearestFirstTest, QCoreApplication)

}  // namespace hitscope::nearest_first_test

#include "nearest_first_test.moc"
