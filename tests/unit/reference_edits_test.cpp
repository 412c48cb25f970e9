// SPDX-License-Identifier: GPL-3.0-or-later
// The reference follows edits of the hits, at once or in parts: what comes out is what the hits make from the
// start, in every bit.
#include <QTest>
#include <algorithm>
#include <cstring>
#include <random>

#include "deform/reference.h"
#include "deform_support.h"
#include "mesh/grid_primitives.h"
#include "mesh/teapot.h"
#include "support/test_program.h"

namespace hitscope::reference_edits_test {

namespace {

bool isSame(std::span<const DynamicVertex> a, std::span<const DynamicVertex> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

/// Hits, and a reference that is told of every change of them.
class Edited {
public:
    explicit Edited(const RenderMesh& mesh) : m_mesh(mesh), reference(mesh) {}

    void editAtRandom(std::mt19937& random) {
        const auto below = [&random](std::size_t end) { return end == 0 ? 0 : random() % end; };
        TargetHitsEdit edit;
        const bool appends = m_hits.empty() || below(3) > 0;
        edit.first = appends ? m_hits.size() : below(m_hits.size());
        if (!appends) {
            const auto at = m_hits.begin() + static_cast<std::ptrdiff_t>(edit.first);
            const std::size_t removed = below(std::min<std::size_t>(m_hits.size() - edit.first, 6) + 1);
            edit.before.assign(at, at + static_cast<std::ptrdiff_t>(removed));
        }
        const std::size_t added = edit.before.empty() ? 1 + below(6) : below(6);
        for (std::size_t i = 0; i < added; ++i) {
            Hit hit = test::randomHit(random, 0.25f);
            hit.point += m_mesh.vertices[below(m_mesh.vertices.size())].position;
            edit.after.push_back(hit);
        }
        const auto at =
            m_hits.erase(m_hits.begin() + static_cast<std::ptrdiff_t>(edit.first),
                         m_hits.begin() + static_cast<std::ptrdiff_t>(edit.first + edit.before.size()));
        m_hits.insert(at, edit.after.begin(), edit.after.end());
        reference.edit(edit);
    }
    [[nodiscard]] std::vector<DynamicVertex> fromTheStart() const {
        test::BruteForce all(m_mesh);
        for (const Hit& hit : m_hits) {
            all.apply(hit);
        }
        return all.vertices;
    }

private:
    const RenderMesh& m_mesh;
    std::vector<Hit> m_hits;

public:
    ReferenceDeformation reference;
};

}  // namespace

class ReferenceEditsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void editsEndWhereTheHitsEnd_data() {
        QTest::addColumn<int>("slices");  // between edits; -1: as many as it takes
        QTest::newRow("each edit at once") << -1;
        QTest::newRow("none between edits") << 0;
        QTest::newRow("one between edits") << 1;
        QTest::newRow("some between edits") << 7;
    }
    void editsEndWhereTheHitsEnd() {
        QFETCH(int, slices);
        const RenderMesh mesh = buildRenderMesh(makeTeapot(12));
        Edited edited(mesh);
        std::mt19937 random(5);
        std::vector<DynamicVertex> known(mesh.vertices.begin(), mesh.vertices.end());
        for (int round = 0; round < 60; ++round) {
            for (int edit = 0; edit < 4; ++edit) {
                edited.editAtRandom(random);
                if (slices < 0) {
                    QVERIFY(edited.reference.advance());
                }
                for (int i = 0; i < slices; ++i) {
                    edited.reference.advance([] { return true; });
                }
            }
            QVERIFY(edited.reference.advance());
            QVERIFY(edited.reference.isUpToDate());
            QVERIFY(isSame(edited.reference.vertices(), edited.fromTheStart()));
            // Whoever copies what is named has all of it.
            for (const VertexRange& range : edited.reference.takeChanged()) {
                const auto from = edited.reference.vertices().subspan(range.first, range.count);
                std::copy(from.begin(), from.end(), known.begin() + range.first);
            }
            QVERIFY(isSame(known, edited.reference.vertices()));
        }
    }

    void aSliceIsSmallHoweverMuchThereIsToDo() {
        const RenderMesh mesh = buildRenderMesh(makeSheet(300, 300, 3.0f, 3.0f));
        ReferenceDeformation reference(mesh);
        Hit hit;
        hit.direction = {0, 0, -1};
        hit.constants.maxDistance = 1000.0f;
        TargetHitsEdit edit;
        edit.after.assign(5, hit);
        reference.edit(edit);
        std::size_t slices = 0;
        while (!reference.advance([] { return true; })) {
            QVERIFY(vertexCount(reference.takeChanged()) <= std::size_t{2 * 64} * kClusterVertices);
            ++slices;
        }
        QVERIFY2(slices >= 5 * mesh.clusters.size() / 64, qPrintable(QString::number(slices)));
    }
};

HITSCOPE_TEST(ReferenceEditsTest, QCoreApplication)

}  // namespace hitscope::reference_edits_test

#include "reference_edits_test.moc"
