// SPDX-License-Identifier: GPL-3.0-or-later
// Undo of what is not about hits or single targets: other scenes, projectiles, flight, texture.
#include <QCoreApplication>
#include <QSignalSpy>
#include <QTest>
#include <array>

#include "deform/fingerprint.h"
#include "session/session.h"
#include "session/shots/demo_shots.h"
#include "support/test_program.h"

namespace hitscope::scene_undo_test {

namespace {

/// All that a person sees of a scene.
struct Seen {
    QString name;
    float floor = 0.0f;
    std::vector<TargetId> ids;
    std::vector<QString> names;
    std::vector<glm::vec3> positions;
    std::vector<bool> visible;
    std::vector<Hit> hits;
    std::size_t disabled = 0;
    TargetId selected;
    Lights lights;

    bool operator==(const Seen&) const = default;
};

Seen see(const Session& session) {
    Seen seen;
    seen.name = session.sceneName();
    seen.floor = session.targets().floorHeight();
    for (const std::unique_ptr<Target>& target : session.targets()) {
        seen.ids.push_back(target->id);
        seen.names.push_back(target->name);
        seen.positions.push_back(target->transform.position);
        seen.visible.push_back(target->visible);
    }
    const std::span<const Hit> hits = session.hits().history().hits();
    seen.hits.assign(hits.begin(), hits.end());
    seen.disabled = session.hits().disabled();
    seen.selected = session.targets().selected();
    seen.lights = session.settings().lights();
    return seen;
}

}  // namespace

class SceneUndoTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void scenesAreTold() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        const std::uint64_t first = session.steps().scene();
        const auto add = [&session] {
            Hit hit;
            hit.target = session.targets().front()->id;
            QVERIFY(session.hits().add(hit));
        };
        add();
        QCOMPARE(session.steps().scene(), first);
        loadTeapot(session);
        const std::uint64_t second = session.steps().scene();
        QVERIFY(second != first);
        add();
        add();
        QCOMPARE(session.steps().scene(), second);
        session.goToStep(1);
        QCOMPARE(session.steps().scene(), first);
        session.goToStep(3);
        QCOMPARE(session.steps().scene(), second);
        session.undo();
        session.undo();
        QCOMPARE(session.steps().scene(), first);
    }

    /// It can be undone to what was before the last target went.
    void aSceneAfterNoTargetsIsAStep() {
        Session session;
        loadTeapot(session);
        session.targets().remove(std::vector{session.targets().front()->id});
        QVERIFY(session.targets().empty());
        loadPaperRow(session, kDefaultPaperRow);
        session.undo();
        QVERIFY(session.targets().empty());
        session.undo();
        QCOMPARE(session.targets().size(), std::size_t{1});
    }

    void anotherSceneIsOneStep() {
        Session session;
        loadPaperRow(session, kDefaultPaperRow);
        QVERIFY(!session.steps().canUndo());
        shootAll(session, demoShots(session, 30, 5));
        session.targets().setVisible(std::array{session.targets()[3]->id}, false);
        session.hits().setEnabled(std::array<std::size_t, 2>{1, 4}, false);
        const Seen before = see(session);
        const Ray ray = demoShots(session, 1, 9).front();
        const std::optional<Hit> aimed = session.simulation().predictedHit(ray, true);

        loadTeapot(session);
        QVERIFY(session.steps().toUndo()->kind == SessionUndo::Kind::LoadScene);
        QCOMPARE(session.hits().history().size(), std::size_t{0});
        Hit hit;
        hit.target = session.targets().front()->id;
        QVERIFY(session.hits().add(hit).ok());
        const Seen after = see(session);

        const QSignalSpy replaced(&session, &Session::sceneReplaced);
        const QSignalSpy came(&session.hits(), &SessionHits::appended);
        session.undo();
        session.undo();
        QCOMPARE(replaced.size(), 1);
        QCOMPARE(came.size(), 1);
        QVERIFY(see(session) == before);
        // Shots strike the dents that came back with the scene.
        const std::optional<Hit> again = session.simulation().predictedHit(ray, true);
        QVERIFY(aimed && again && again->point == aimed->point && again->triangle == aimed->triangle);
        // The steps before it are still there.
        session.undo();
        QCOMPARE(session.hits().disabled(), std::size_t{0});
        session.redo();
        session.redo();
        session.redo();
        QVERIFY(see(session) == after);
        QVERIFY(!session.steps().canRedo());
        session.goToStep(0);
        QCOMPARE(session.hits().history().size(), std::size_t{0});
        QCOMPARE(session.targets().size(), std::size_t{16});
        session.goToStep(session.steps().size());
        QVERIFY(see(session) == after);
    }

    void settingsAreSteps() {
        Session session;
        loadTeapot(session);
        SessionSettings& settings = session.settings();
        ProjectileSettings projectile = settings.projectile();
        const float speed = projectile.speed;
        for (const float faster : {speed + 1.0f, speed + 2.0f, speed + 3.0f}) {  // a slider
            projectile.speed = faster;
            settings.setProjectile(projectile);
        }
        settings.setFlightMode(FlightMode::Instant);
        settings.setCoverTexture(std::make_shared<const Image>());
        QCOMPARE(session.steps().size(), std::size_t{3});
        QSignalSpy covers(&settings, &SessionSettings::coverTextureChanged);
        session.undo();
        QVERIFY(settings.coverTexture() == nullptr);
        QCOMPARE(covers.size(), 1);
        QVERIFY(settings.flightMode() == FlightMode::Instant);
        session.undo();
        QVERIFY(settings.flightMode() == FlightMode::Quick);
        QCOMPARE(settings.projectile().speed, speed + 3.0f);
        session.undo();
        QCOMPARE(settings.projectile().speed, speed);
        QVERIFY(!session.steps().canUndo());
        session.goToStep(3);
        QVERIFY(settings.coverTexture() != nullptr);
        QCOMPARE(settings.projectile().speed, speed + 3.0f);
        // What is restored at a start is no step.
        settings.restoreProjectile(ProjectileSettings{}, FlightMode::Paper);
        settings.restoreCoverTexture(nullptr);
        QCOMPARE(session.steps().size(), std::size_t{3});
    }

    void theCuttingPlaneIsUndone() {
        Session session;
        loadTeapot(session);
        SessionSettings& settings = session.settings();
        const CuttingPlane before = settings.cut();
        CuttingPlane cut = before;
        cut.on = true;
        settings.setCut(cut);
        for (const float offset : {0.1f, 0.2f, 0.3f}) {  // a handle
            cut.offset = offset;
            settings.setCut(cut,
                            offset == 0.1f ? SessionUndo::Merge::Never : SessionUndo::Merge::WithSameKind);
        }
        QCOMPARE(session.steps().size(), std::size_t{2});
        QSignalSpy changed(&settings, &SessionSettings::cutChanged);
        session.undo();
        QCOMPARE(changed.size(), 1);
        QVERIFY(settings.cut().on && settings.cut().offset == before.offset);
        session.redo();
        QCOMPARE(settings.cut(), cut);
        // A scene that comes back brings its plane, and a new one leaves it to who shows it.
        loadPaperRow(session, 0);
        CuttingPlane other = cut;
        other.offset = -7.0f;
        settings.restoreCut(other);
        session.undo();
        QCOMPARE(settings.cut(), cut);
        settings.restoreCut(other);
        session.redo();
        QCOMPARE(settings.cut(), other);
        session.goToStep(0);
        QCOMPARE(settings.cut(), before);
    }

    /// One announcement, whatever the way: followers look at all rows again.
    void aLongWayIsOneChange() {
        Session session;
        loadTeapot(session);
        Hit hit;
        hit.target = session.targets().front()->id;
        const TargetId ids[] = {hit.target};
        std::vector<Hit> all;
        constexpr int kHits = 20'000;
        for (int i = 0; i < kHits; ++i) {
            hit.point.x = static_cast<float>(i);
            hit.enabled = i % 7 != 0;
            all.push_back(hit);
            QVERIFY(session.hits().add(hit).ok());
        }
        session.hits().remove(std::vector<std::size_t>{1, 3, 17'000});
        QVERIFY(session.hits().add(hit).ok());
        const std::uint64_t now = hitsFingerprint(session.hits().history().hits(), ids);
        const std::size_t disabled = session.hits().disabled();
        session.hits().select(1);  // the third hit made, which stays
        QSignalSpy rearranged(&session.hits(), &SessionHits::rearranged);
        QSignalSpy steps(&session, &Session::undoChanged);
        session.goToStep(3);
        QCOMPARE(session.hits().history().size(), std::size_t{3});
        QCOMPARE(session.hits().disabled(), std::size_t{1});
        QVERIFY(std::equal(all.begin(), all.begin() + 3, session.hits().history().hits().begin()));
        QCOMPARE(*session.hits().selected(), std::size_t{2});
        QCOMPARE(rearranged.size(), 1);
        QCOMPARE(steps.size(), 1);
        session.goToStep(session.steps().size());
        QCOMPARE(hitsFingerprint(session.hits().history().hits(), ids), now);
        QCOMPARE(session.hits().disabled(), disabled);
        QCOMPARE(rearranged.size(), 2);
        // Neighbours are joined, and others are not.
        session.hits().remove(std::vector<std::size_t>{9});
        session.hits().remove(std::vector<std::size_t>{2});
        session.hits().remove(std::vector<std::size_t>{1});
        session.hits().move(std::vector<std::size_t>{4, 6}, 0);
        session.hits().select(5);
        const Hit selected = session.hits().history().hits()[5];
        const std::uint64_t last = hitsFingerprint(session.hits().history().hits(), ids);
        const std::size_t end = session.steps().size();
        session.goToStep(kHits);
        QCOMPARE(session.hits().history().hits()[*session.hits().selected()], selected);
        session.goToStep(end);
        QCOMPARE(hitsFingerprint(session.hits().history().hits(), ids), last);
        QCOMPARE(*session.hits().selected(), std::size_t{5});
        session.goToStep(kHits);
        QVERIFY(std::equal(all.begin(), all.end(), session.hits().history().hits().begin(),
                           session.hits().history().hits().end()));
    }

    void stateTellsWhetherAnythingChanged() {
        Session session;
        loadTeapot(session);
        Hit hit;
        hit.target = session.targets().front()->id;
        const std::uint64_t first = session.steps().state();
        QVERIFY(session.hits().add(hit).ok());
        const std::uint64_t second = session.steps().state();
        QVERIFY(second != first);
        session.undo();
        QCOMPARE(session.steps().state(), first);
        session.redo();
        QCOMPARE(session.steps().state(), second);
        session.undo();
        hit.point.x = 1.0f;
        QVERIFY(session.hits().add(hit).ok());
        QVERIFY(session.steps().state() != second && session.steps().state() != first);
        // A slider that goes on changes the step that is there.
        ProjectileSettings projectile;
        projectile.speed = 31.0f;
        session.settings().setProjectile(projectile);
        const std::uint64_t dragged = session.steps().state();
        projectile.speed = 32.0f;
        session.settings().setProjectile(projectile);
        QVERIFY(session.steps().state() != dragged);
    }

    void memoryIsBounded() {
        constexpr std::size_t kMost = 100 * sizeof(Hit);
        SessionUndo undo(kMost);
        HitHistory history;
        for (int i = 0; i < 200; ++i) {
            undo.record({.edits = {history.append(Hit{})}});
            QVERIFY(undo.bytes() <= kMost);
        }
        QVERIFY(undo.size() > 20);
        QCOMPARE(undo.size() + undo.forgotten(), std::size_t{200});
        const std::uint64_t now = undo.state();
        while (undo.canUndo()) {
            for (const HistoryEdit& edit : undo.undo(history.hits()).edits) {
                history.redo(edit);
            }
        }
        QCOMPARE(history.size(), undo.forgotten());
        QVERIFY(undo.state() != now);
        // One step too large for all of it is kept.
        undo.record({.edits = {history.append(std::vector<Hit>(1000))}});
        QVERIFY(undo.canUndo());
        undo.clear();
        QCOMPARE(undo.bytes(), std::size_t{0});
    }
};

HITSCOPE_TEST(SceneUndoTest, QCoreApplication)

}  // namespace hitscope::scene_undo_test

#include "scene_undo_test.moc"
