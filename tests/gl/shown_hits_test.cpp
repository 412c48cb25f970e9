// SPDX-License-Identifier: GPL-3.0-or-later
// Going back and forth through the history: every pipeline shows what the first hits alone make of the
// targets, in every bit, and all of it again in the end.
#include <QSignalSpy>
#include <QTest>
#include <array>
#include <limits>

#include "deform/reference.h"
#include "gl/pipeline_rows.h"
#include "scene/scene_gpu.h"
#include "session/shots/demo_shots.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::shown_hits_test {

class ShownHitsTest : public QObject {
    Q_OBJECT
private:
    /// Vertices that are not where the first `hits` hits alone put them.
    static std::size_t differences(const Session& session, std::size_t hits) {
        std::size_t count = 0;
        for (const std::unique_ptr<Target>& target : session.targets()) {
            std::vector<Hit> first;
            for (const Hit& hit : session.hits().history().hits().first(hits)) {
                if (hit.enabled && hit.target == target->id) {
                    first.push_back(hit);
                }
            }
            ReferenceDeformation reference(target->deformed.render());
            reference.apply(first);
            for (std::size_t i = 0; i < reference.vertices().size(); ++i) {
                const DynamicVertex& is = target->deformed.vertices()[i];
                const DynamicVertex& should = reference.vertices()[i];
                count += is.position != should.position || is.normal != should.normal ? 1 : 0;
            }
        }
        return count;
    }
    static void shoot(Session& session, std::uint32_t seed) {
        shootAll(session, demoShots(session, 40, seed));
    }

private Q_SLOTS:
    void initTestCase() {
        if (m_gl.open()) {
            HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        }
    }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void backAndForth_data() { test::addPipelines(); }
    void backAndForth() {
        QFETCH(int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        session.settings().setPipeline(static_cast<PipelineKind>(kind));
        Result<std::unique_ptr<SceneGpu>> made = SceneGpu::create(session);
        QVERIFY(made);
        SceneGpu& gpu = *made.value();
        const auto shows = [&](std::size_t hits) {
            return gpu.sync().ok() && session.hits().shown().size() == hits &&
                   differences(session, hits) == 0;
        };
        shoot(session, 3);
        const std::size_t all = session.hits().history().size();
        QVERIFY(all > 30);
        QVERIFY(shows(all));
        for (const std::size_t at : {all - 1, all - 2, all - 1, std::size_t{0}, all / 2, all / 2 + 1, all}) {
            session.hits().show(at);
            QVERIFY(shows(at));
        }
        // The history changes meanwhile.
        session.hits().show(all / 2);
        session.hits().setEnabled(std::array<std::size_t, 3>{1, all / 2, all - 1}, false);
        QVERIFY(shows(all / 2));
        session.hits().remove(std::array<std::size_t, 2>{2, all - 2});
        QVERIFY(shows(all / 2));
        session.undo();
        QVERIFY(shows(all / 2));
        session.settings().setPipeline(PipelineKind::Reference);
        QVERIFY(shows(all / 2));
        session.settings().setPipeline(static_cast<PipelineKind>(kind));
        QVERIFY(shows(all / 2));
        session.hits().show(std::nullopt);
        QVERIFY(shows(all));
        // Hits that come end it.
        session.hits().show(5);
        QVERIFY(shows(5));
        const QSignalSpy shown(&session.hits(), &SessionHits::shownChanged);
        shoot(session, 4);
        QCOMPARE(shown.size(), 1);
        QVERIFY(session.hits().showsAll());
        QVERIFY(shows(session.hits().history().size()));
        session.hits().show(7);
        loadPaperRow(session, kDefaultPaperRow);
        QVERIFY(session.hits().showsAll());
        QVERIFY(shows(0));
    }

    void aHitIsEdited() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        Result<std::unique_ptr<SceneGpu>> made = SceneGpu::create(session);
        QVERIFY(made);
        shoot(session, 3);
        const std::vector<Hit> before(session.hits().history().hits().begin(),
                                      session.hits().history().hits().end());
        session.hits().select(4);
        Hit hit = before[4];
        hit.point += glm::vec3(0.2f, 0.0f, 0.0f);
        hit.direction = {0.0f, -3.0f, 0.0f};
        hit.constants.maxDistance = 0.9f;
        const QSignalSpy rearranged(&session.hits(), &SessionHits::rearranged);
        QVERIFY(session.hits().replace(4, hit).ok());
        QVERIFY(session.hits().history().hits()[4].direction == glm::vec3(0.0f, -1.0f, 0.0f));
        QCOMPARE(rearranged.size(), 0);
        QVERIFY(session.hits().selected() == std::optional<std::size_t>(4));
        QVERIFY(made.value()->sync().ok());
        QCOMPARE(differences(session, before.size()), std::size_t{0});
        session.undo();  // one step
        QVERIFY(std::ranges::equal(session.hits().history().hits(), before));
        QVERIFY(made.value()->sync().ok());
        QCOMPARE(differences(session, before.size()), std::size_t{0});
        hit.point.x = std::numeric_limits<float>::quiet_NaN();
        QVERIFY(!session.hits().replace(4, hit).ok());
        QVERIFY(!session.hits().replace(before.size(), before[0]).ok());
    }

private:
    test::GlFixture m_gl;
};

HITSCOPE_TEST(ShownHitsTest, QCoreApplication)

}  // namespace hitscope::shown_hits_test

#include "shown_hits_test.moc"
