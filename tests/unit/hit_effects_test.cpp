// SPDX-License-Identifier: GPL-3.0-or-later
// What a session's hits did, computed in the background: the same as computed at once, whatever happens
// between.
#include "analysis/hit_effects.h"
#include "analysis/background_pool.h"
#include "support/test_program.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>
#include <QThreadPool>
#include <algorithm>
#include <random>

namespace hitscope::hit_effects_test {

namespace {

Hit randomHit(const Session& session, std::mt19937& random) {
    std::uniform_real_distribution<float> number(-2.5f, 2.5f);
    const auto& targets = session.targets();
    Hit hit;
    hit.target = targets[random() % std::min<std::size_t>(targets.size(), 3)]->id;
    hit.point = {number(random), number(random), 2.5f};
    hit.time = static_cast<double>(random());
    return hit;
}

void shootRandomly(Session& session, std::mt19937& random, int count) {
    for (int i = 0; i < count; ++i) {
        QVERIFY(session.hits().add(randomHit(session, random)).ok());
    }
}

}  // namespace

class HitEffectsTest : public QObject {
    Q_OBJECT
private:
    /// Against effects that see the session as it is for the first time.
    static void compare(HitEffects& effects, Session& session) {
        effects.finish();
        QVERIFY(effects.isUpToDate());
        HitEffects fresh(session);
        fresh.finish();
        for (std::size_t row = 0; row < session.hits().history().size(); ++row) {
            QCOMPARE(effects.effect(row).has_value(), session.hits().history().hits()[row].enabled);
            QVERIFY(effects.effect(row) == fresh.effect(row));
        }
        for (const std::unique_ptr<Target>& target : session.targets()) {
            QVERIFY(std::ranges::equal(effects.counts(target->id), fresh.counts(target->id)));
        }
    }

private Q_SLOTS:
    void followsASession() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        HitEffects effects(session);
        std::mt19937 random(3);
        std::uint32_t mostHits = 0;
        for (int step = 0; step < 200; ++step) {
            shootRandomly(session, random, static_cast<int>(random() % 5));
            const std::size_t size = session.hits().history().size();
            const std::array<std::size_t, 3> some{random() % (size + 1), random() % (size + 1),
                                                  random() % (size + 1)};
            switch (random() % 10) {
                case 0:
                    session.hits().setEnabled(some, random() % 2 == 0);
                    break;
                case 1:
                    session.hits().move(some, random() % (size + 1));
                    break;
                case 2:
                    session.hits().remove(some);
                    break;
                case 3:
                case 4:
                    session.undo();
                    break;
                case 5:
                    session.redo();
                    break;
                case 6: {
                    DeformationConstants constants;
                    constants.maxDistance = 0.3f + 0.1f * static_cast<float>(random() % 5);
                    QVERIFY(session.settings().setConstants(constants));
                    session.hits().giveConstantsToAll();
                    break;
                }
                case 7: {
                    const std::array<TargetId, 1> id{session.targets()[random() % 2]->id};
                    session.targets().remove(id);
                    session.undo();
                    break;
                }
                default:
                    break;
            }
            if (random() % 3 == 0) {
                QCoreApplication::processEvents();
            }
            if (step % 20 == 0) {
                compare(effects, session);
                for (const std::uint32_t hits : effects.counts(session.targets().front()->id)) {
                    mostHits = std::max(mostHits, hits);
                }
            }
        }
        compare(effects, session);
        QVERIFY(mostHits > 1);
        loadTeapot(session);
        compare(effects, session);
        shootRandomly(session, random, 10);
        compare(effects, session);
    }

    void tellsByTheEventLoop() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        HitEffects effects(session);
        QSignalSpy changed(&effects, &HitEffects::effectsChanged);
        QSignalSpy counts(&effects, &HitEffects::countsChanged);
        std::mt19937 random(5);
        shootRandomly(session, random, 1);
        QCOMPARE(changed.size(), 0);
        QVERIFY(!effects.effect(0));
        QTRY_COMPARE_WITH_TIMEOUT(changed.size(), 1, kPatience);
        QCOMPARE(changed.first(), (QVariantList{0, 0}));
        QCOMPARE(counts.size(), 1);
        QVERIFY(effects.effect(0)->affected > 0);
        QVERIFY(effects.isUpToDate());
        QVERIFY(!effects.effect(1));
    }

    void resultsFollowHitsThatMoveMeanwhile() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        HitEffects effects(session);
        std::mt19937 random(6);
        Hit other = randomHit(session, random);
        other.target = session.targets().back()->id;
        QVERIFY(session.hits().add(std::vector<Hit>(3, other)).ok());
        shootRandomly(session, random, 20);
        backgroundPool().waitForDone();  // worked out, not told yet
        session.hits().remove(1);
        compare(effects, session);
        shootRandomly(session, random, 20);
        backgroundPool().waitForDone();
        session.undo();
        session.hits().remove(std::vector<std::size_t>{0, 21, 22, 30});
        compare(effects, session);
    }

    /// Of a target that went and came back the thread, asked late, sees that nothing has changed. Its counts
    /// went all the same.
    void targetThatComesBackMeanwhile() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        HitEffects effects(session);
        const std::array<TargetId, 1> id{session.targets().front()->id};
        std::mt19937 random(7);
        for (int i = 0; i < 20; ++i) {
            Hit hit = randomHit(session, random);
            hit.target = id.front();
            QVERIFY(session.hits().add(hit).ok());
        }
        compare(effects, session);
        QVERIFY(!effects.counts(id.front()).empty());
        QThreadPool& pool = backgroundPool();
        const int threads = pool.maxThreadCount();
        QSemaphore mayGoOn;
        for (int i = 0; i < threads; ++i) {
            pool.start([&mayGoOn] { mayGoOn.acquire(); });
        }
        session.targets().remove(id);
        const bool went = effects.counts(id.front()).empty();
        session.undo();
        mayGoOn.release(threads);
        pool.waitForDone();
        QVERIFY(went);
        compare(effects, session);
        QVERIFY(!effects.counts(id.front()).empty());
    }

    void findsTheVerticesOfAHit() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        HitEffects effects(session);
        std::vector<std::uint32_t> found;
        TargetId on;
        connect(&effects, &HitEffects::verticesFound, this,
                [&](TargetId target, const std::vector<std::uint32_t>& vertices) {
                    on = target;
                    found = vertices;
                });
        std::mt19937 random(9);
        shootRandomly(session, random, 60);
        // The earlier question is answered by the thread before the later one is asked.
        effects.finish();
        effects.findVertices(30);
        QVERIFY(backgroundPool().waitForDone());
        effects.findVertices(40);
        QTRY_VERIFY_WITH_TIMEOUT(!found.empty(), kPatience);
        QVERIFY(on == session.hits().history().hits()[40].target);
        QCOMPARE(found.size(), static_cast<std::size_t>(effects.effect(40)->affected));
        QVERIFY(std::binary_search(found.begin(), found.end(), effects.effect(40)->deepest));
        const std::span<const std::uint32_t> counts = effects.counts(on);
        QVERIFY(std::all_of(found.begin(), found.end(), [counts](std::uint32_t v) { return counts[v] > 0; }));
        // An answer about rows that are others by now is not given.
        effects.findVertices(10);
        session.hits().remove(0);
        found.clear();
        effects.finish();
        QCoreApplication::processEvents();
        QVERIFY(found.empty());
    }

    void goesWhileAtWork() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        std::mt19937 random(11);
        for (int i = 0; i < 20; ++i) {
            HitEffects effects(session);
            std::vector<Hit> hits(500);
            std::generate(hits.begin(), hits.end(), [&] { return randomHit(session, random); });
            QVERIFY(session.hits().add(hits).ok());
            if (i % 2 == 0) {
                loadPaperRow(session, kDefaultPaperRow);
            }
        }
    }

    void tenThousandHitsOneByOne() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        HitEffects effects(session);
        std::mt19937 random(13);
        shootRandomly(session, random, 10'000);
        compare(effects, session);
    }
};

HITSCOPE_TEST(HitEffectsTest, QCoreApplication)

}  // namespace hitscope::hit_effects_test

#include "hit_effects_test.moc"
