// SPDX-License-Identifier: GPL-3.0-or-later
// What each hit did, followed through random edits of a history, against a plain loop over everything.
#include "deform/history_effects.h"

#include <QTest>
#include <cmath>
#include <random>

#include "deform/reference.h"
#include "mesh/primitives.h"
#include "support/test_program.h"
#include "unit/deform_support.h"

namespace hitscope::history_effects_test {

namespace {

const std::atomic<bool> kGoOn = false;

struct Truth {
    std::vector<HitEffect> effects;                 // one a hit of the history; disabled: all zero
    std::vector<std::vector<std::uint32_t>> moved;  // file vertices, ascending
    std::map<TargetId, std::vector<std::uint32_t>> counts;
};

/// Every hit on every vertex, in double where lengths are measured.
Truth truthOf(std::span<const Hit> hits, const HistoryEffects::Shapes& shapes) {
    Truth truth;
    std::map<TargetId, std::vector<DynamicVertex>> vertices;
    for (const auto& [id, shape] : shapes) {
        vertices[id].assign(shape->vertices.begin(), shape->vertices.end());
        truth.counts[id].assign(shape->fileVertexStarts.size() - 1, 0);
    }
    for (const Hit& hit : hits) {
        HitEffect& effect = truth.effects.emplace_back();
        std::vector<std::uint32_t>& moved = truth.moved.emplace_back();
        if (!hit.enabled) {
            continue;
        }
        const RenderMesh& shape = *shapes.at(hit.target);
        std::vector<DynamicVertex>& now = vertices[hit.target];
        const std::vector<DynamicVertex> before = now;
        for (DynamicVertex& vertex : now) {
            deform(vertex.position, vertex.normal, hit);
        }
        for (std::uint32_t v = 0; v + 1 < shape.fileVertexStarts.size(); ++v) {
            if (shape.renderVerticesOf(v).empty()) {
                continue;
            }
            const std::uint32_t r = shape.renderVerticesOf(v).back();
            if (now[r].position == before[r].position) {
                continue;
            }
            const glm::dvec3 way = glm::dvec3(now[r].position) - glm::dvec3(before[r].position);
            const auto length = static_cast<float>(std::sqrt(glm::dot(way, way)));
            moved.push_back(v);
            ++truth.counts[hit.target][v];
            ++effect.affected;
            if (length > effect.greatest || effect.deepest == kNoIndex) {
                effect.greatest = length;
                effect.deepest = v;
            }
        }
    }
    return truth;
}

/// Follows a history as someone who only sees the changes.
struct Follower {
    HistoryEffects effects;
    HistoryEffects::Shapes shapes;
    std::vector<std::optional<HitEffect>> rows;
    std::map<TargetId, std::vector<std::uint32_t>> counts;

    void follow(std::span<const HistoryEdit> edits, const HistoryEffects::Shapes& newShapes = {}) {
        for (const HistoryEdit& edit : edits) {
            const auto at = rows.begin() + static_cast<std::ptrdiff_t>(edit.first);
            const auto gap = rows.erase(at, at + static_cast<std::ptrdiff_t>(edit.before.size()));
            rows.insert(gap, edit.after.size(), std::nullopt);
        }
        const HistoryEffects::Changes changes = effects.follow(edits, newShapes, kGoOn);
        for (const auto& changed : changes.rows) {
            rows.at(changed.row) = changed.effect;
        }
        for (const auto& changed : changes.counts) {
            std::vector<std::uint32_t>& known = counts[changed.target];
            if (changed.fromZero) {
                known.assign(shapes.at(changed.target)->fileVertexStarts.size() - 1, 0);
            }
            for (std::size_t i = 0; i < changed.vertices.size(); ++i) {
                known.at(changed.vertices[i]) = changed.counts[i];
            }
        }
    }
};

HistoryEffects::Shapes twoShapes() {
    return {{TargetId{1}, std::make_shared<RenderMesh>(buildRenderMesh(makeCube(16, 1.0f)))},
            {TargetId{2}, std::make_shared<RenderMesh>(buildRenderMesh(makeUvSphere(24, 24, 1.0f)))}};
}

std::vector<Hit> randomHits(std::mt19937& random, std::size_t count) {
    std::vector<Hit> hits;
    for (std::size_t i = 0; i < count; ++i) {
        Hit hit = test::randomHit(random, 1.1f);
        hit.target = TargetId{1 + static_cast<std::uint32_t>(random() % 2)};
        hit.constants.maxDistance = 0.1f + 0.05f * static_cast<float>(random() % 10);
        hit.enabled = random() % 8 != 0;
        hits.push_back(hit);
    }
    return hits;
}

std::vector<HistoryEdit> randomEdits(std::mt19937& random, HitHistory& history) {
    const std::size_t size = history.size();
    const std::size_t first = random() % (size + 1);
    const std::size_t count = std::min<std::size_t>(random() % 4, size - first);
    switch (random() % 6) {
        case 0:
            return {history.splice(first, count, randomHits(random, random() % 4))};
        case 1:
            return size > 0 ? history.move(std::vector{random() % size}, random() % size)
                            : std::vector<HistoryEdit>{};
        case 2: {  // many change places at once
            std::vector<Hit> some(history.hits().begin() + static_cast<std::ptrdiff_t>(size / 3),
                                  history.hits().end());
            std::rotate(some.begin(), some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2),
                        some.end());
            return {history.splice(size / 3, some.size(), some)};
        }
        case 3:
            return size > 2 ? std::vector{history.splice(size - 2, 2, {})} : std::vector<HistoryEdit>{};
        default:
            return {history.append(randomHits(random, 1 + random() % 5))};
    }
}

}  // namespace

class HistoryEffectsTest : public QObject {
    Q_OBJECT
private:
    static void compare(const Follower& follower, const HitHistory& history) {
        const Truth truth = truthOf(history.hits(), follower.shapes);
        QCOMPARE(follower.rows.size(), history.size());
        for (std::size_t row = 0; row < history.size(); ++row) {
            QCOMPARE(follower.rows[row].has_value(), history.hits()[row].enabled);
            if (follower.rows[row]) {
                QVERIFY(*follower.rows[row] == truth.effects[row]);
            }
        }
        for (const auto& [id, shape] : follower.shapes) {
            const TargetEffects* effects = follower.effects.of(id);
            const auto counts = follower.counts.find(id);
            if (effects == nullptr) {
                QVERIFY(history.hitsOn(id).empty());
                continue;
            }
            QVERIFY(std::ranges::equal(effects->counts(), truth.counts.at(id)));
            QVERIFY(counts->second == truth.counts.at(id));
            ReferenceDeformation reference(*shape);
            reference.apply(history.hitsOn(id));
            QVERIFY(std::ranges::equal(effects->vertices(), reference.vertices(),
                                       [](const DynamicVertex& a, const DynamicVertex& b) {
                                           return a.position == b.position && a.normal == b.normal;
                                       }));
        }
        const std::size_t some = history.size() / 2;
        QVERIFY(history.size() == 0 || follower.effects.movedBy(some) == truth.moved[some]);
    }

private Q_SLOTS:
    void randomEdits_data() {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= 4; ++seed) {
            QTest::addRow("seed %u", seed) << seed;
        }
    }
    void randomEdits() {
        QFETCH(unsigned, seed);
        std::mt19937 random(seed);
        Follower follower;
        follower.shapes = twoShapes();
        HitHistory history;
        follower.follow({}, follower.shapes);
        for (int step = 0; step < 60; ++step) {
            std::vector<HistoryEdit> edits;
            for (std::size_t i = random() % 4 + 1; i > 0; --i) {
                for (HistoryEdit& edit : history_effects_test::randomEdits(random, history)) {
                    edits.push_back(std::move(edit));
                }
            }
            follower.follow(edits);
            compare(follower, history);
        }
        follower.follow(std::vector{history.clear()});
        QVERIFY(follower.effects.of(TargetId{1}) == nullptr);
    }

    void hitsThatComeBeforeTheirTarget() {
        std::mt19937 random(7);
        Follower follower;
        follower.shapes = twoShapes();
        HitHistory history;
        follower.follow(std::vector{history.append(randomHits(random, 40))});
        QVERIFY(follower.effects.of(TargetId{1}) == nullptr);
        follower.follow({}, follower.shapes);
        compare(follower, history);
    }

    void aHitThatMovesNothing() {
        Follower follower;
        follower.shapes = twoShapes();
        HitHistory history;
        Hit far;
        far.target = TargetId{1};
        far.point = {50.0f, 0.0f, 0.0f};
        follower.follow(std::vector{history.append(far)}, follower.shapes);
        QVERIFY(follower.rows[0] == HitEffect{});
        Hit powerless;
        powerless.target = TargetId{1};
        powerless.point = {1.0f, 0.01f, 0.0f};
        powerless.constants.power = 0.0f;
        follower.follow(std::vector{history.append(powerless)});
        QCOMPARE(follower.rows[1]->affected, 0u);
    }
};

HITSCOPE_TEST(HistoryEffectsTest, QCoreApplication)

}  // namespace hitscope::history_effects_test

#include "history_effects_test.moc"
