// SPDX-License-Identifier: GPL-3.0-or-later
// The dent measurement panel on a session whose vertices are moved by hand.
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <array>
#include <glm/geometric.hpp>

#include "deform/reference.h"
#include "mesh/grid_primitives.h"
#include "mesh/primitives.h"
#include "panels/dent_measurement/dent_measurement_panel.h"
#include "support/read_back.h"
#include "support/test_program.h"

namespace hitscope::dent_measurement_test {

namespace {

/// What a pipeline would have read back.
void applyHits(Session& session) {
    const Target& target = *session.targets().front();
    ReferenceDeformation reference(target.deformed.render());
    reference.apply(session.hits().history().hitsOn(target.id));
    test::readBackOf(session).take(target.id, 0, reference.vertices());
    static_cast<void>(test::readBackOf(session).finish());
}

}  // namespace

class DentMeasurementTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_session = std::make_unique<Session>();
        loadMesh(*m_session, makeSheet(100, 100, 4.0f, 4.0f));
        Hit hit;
        hit.target = m_session->targets().front()->id;
        hit.point = m_session->targets().front()->deformed.positions()[50 * 101 + 50];
        hit.direction = {0.0f, 0.0f, -1.0f};
        QVERIFY(m_session->hits().add(hit).ok());
        applyHits(*m_session);
        m_panel = std::make_unique<DentMeasurementPanel>(*m_session);
        m_panel->resize(320, 420);
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get(), kPatience));
    }
    void cleanup() {
        m_panel.reset();
        m_session.reset();
    }

    void theSelectedHitIsMeasured() {
        QVERIFY(label("subject").contains(QStringLiteral("Select a hit")));
        m_session->hits().select(0);
        QTRY_VERIFY_WITH_TIMEOUT(report().dent.has_value(), kPatience);
        // power / r under the cap of 0.3 m, out to 0.5 m.
        QVERIFY(std::abs(report().dent->depth - 0.3) < 1.0e-4);
        QVERIFY(std::abs(report().dent->rimDiameter - 1.0) < 0.08);
        QVERIFY(std::abs(report().dent->affectedArea / (3.14159265 * 0.25) - 1.0) < 0.05);
        QVERIFY(label("depth").startsWith(QStringLiteral("0.3")));
        QVERIFY(std::abs(m_panel->depthAt(0.0).value_or(0.0) - 0.3) < 1.0e-3);
        QVERIFY(std::abs(m_panel->depthAt(0.4).value_or(0.0) - 0.125) < 5.0e-3);
        QCOMPARE(m_panel->depthAt(0.65).value_or(-1.0), 0.0);
        QVERIFY(!m_panel->depthAt(3.0));
        const auto lines = report().after.front().size();
        m_panel->findChild<QSpinBox*>(QStringLiteral("angle"))->setValue(45);
        QTRY_VERIFY_WITH_TIMEOUT(report().after.front().size() != lines, kPatience);
    }

    /// It is where the shot struck, and no face has it.
    void aLooseVertexIsNotTheDent() {
        MeshData mesh = makeSheet(100, 100, 4.0f, 4.0f);
        const glm::vec3 beside = mesh.positions[50 * 101 + 50] + glm::vec3(0.013f, 0.011f, 0.0f);
        mesh.positions.push_back(beside);
        loadMesh(*m_session, mesh);
        Hit hit;
        hit.target = m_session->targets().front()->id;
        hit.point = beside;
        hit.direction = {0.0f, 0.0f, -1.0f};
        hit.constants.maxMagnitude = 10.0f;  // so that the nearest vertex is moved farthest
        QVERIFY(m_session->hits().add(hit).ok());
        applyHits(*m_session);
        m_session->hits().select(0);
        QTRY_VERIFY_WITH_TIMEOUT(report().dent.has_value(), kPatience);
        QVERIFY(report().dent->deepest < mesh.positions.size() - 1);
    }

    void thePickedVertexIsMeasured() {
        const TargetId target = m_session->targets().front()->id;
        m_session->selection().setPicked(VertexRef{target, 0});
        QTRY_VERIFY_WITH_TIMEOUT(label("subject").contains(QStringLiteral("No hit has moved")), kPatience);
        QCOMPARE(label("distance"), QStringLiteral("pick two vertices"));
        m_session->selection().setPicked(VertexRef{target, 50 * 101 + 50});
        QTRY_VERIFY_WITH_TIMEOUT(report().dent.has_value(), kPatience);
        const std::optional<DentMeasurement::Distance> distance = m_panel->measurement().distance();
        QVERIFY(distance);
        QVERIFY(std::abs(distance->before - std::sqrt(8.0)) < 1.0e-4);
        QVERIFY(std::abs(distance->after - std::sqrt(8.0 + 0.09)) < 1.0e-3);
    }

    /// Between vertices of two targets the distance follows where these stand.
    void theDistanceFollowsMovedTargets() {
        const TargetId first = m_session->targets().front()->id;
        m_session->targets().duplicate(std::array{first});
        const TargetId second = m_session->targets()[1]->id;
        m_session->selection().setPicked(VertexRef{first, 0});
        m_session->selection().setPicked(VertexRef{second, 0});
        const QString before = label("distance");
        RigidTransform away = m_session->targets()[1]->transform;
        away.position += glm::vec3(0.0f, 7.0f, 0.0f);
        QVERIFY(m_session->targets().setTransform(second, away).ok());
        QVERIFY(label("distance") != before);
    }

    void followsTheMesh() {
        m_session->hits().select(0);
        QTRY_VERIFY_WITH_TIMEOUT(report().dent.has_value(), kPatience);
        const double before = report().dent->displacedVolume;
        QVERIFY(before > 0.0);
        QVERIFY(m_session->hits().add(m_session->hits().history().hits()[0]).ok());
        applyHits(*m_session);
        QTRY_VERIFY_WITH_TIMEOUT(report().dent->displacedVolume > 1.2 * before, kPatience);
        loadMesh(*m_session, makeSheet(4, 4, 4.0f, 4.0f));
        QVERIFY(!report().dent);
        QCOMPARE(label("depth"), QStringLiteral("–"));
    }

    /// The selected hit's part, its own depth, and which hits made it.
    void overlappingDentsAreToldApart() {
        Hit first = m_session->hits().history().hits()[0];
        first.constants.maxMagnitude = 0.25f;
        first.point += glm::vec3(0.9f, 0.0f, 0.0f);
        QVERIFY(m_session->hits().add(first).ok());
        applyHits(*m_session);
        m_session->hits().select(1);
        QTRY_VERIFY_WITH_TIMEOUT(report().dent && !report().partHits.empty(), kPatience);
        QCOMPARE(report().partHits, (std::vector<std::size_t>{1}));
        QVERIFY2(std::abs(report().dent->depth - 0.25) < 1.0e-3, qPrintable(label("depth")));
        QVERIFY(label("subject").contains(QStringLiteral("the part that hit 2 moved most")));
        QVERIFY(m_panel->measurement().text().contains(QStringLiteral("\nPart moved most by hits\t2")));
        const std::size_t part = report().dent->vertices;
        m_panel->findChild<QCheckBox*>(QStringLiteral("apart"))->setChecked(false);
        QTRY_VERIFY_WITH_TIMEOUT(report().dent && report().partHits.empty(), kPatience);
        QVERIFY(report().dent->vertices > part);
        QVERIFY(std::abs(report().dent->depth - 0.3) < 1.0e-3);
    }

    void overlappingHitsAreNamed() {
        m_panel->measurement().setTellsApart(false);
        useSphere();
        addHitAt({0.0f, 0.0f, 1.0f});
        addHitAt({0.0f, 0.0f, -1.0f});  // on the far side
        applyHits(*m_session);
        m_session->hits().select(0);
        QTRY_VERIFY_WITH_TIMEOUT(report().dent.has_value(), kPatience);
        QVERIFY2(report().mergedHits.empty(), qPrintable(report().merged));
        QVERIFY(!label("subject").contains(QStringLiteral("erged")));
        QVERIFY(m_panel->measurement().profileCsv().startsWith("state,"));
        const std::size_t alone = report().dent->vertices;

        addHitAt(glm::normalize(glm::vec3(0.4f, 0.0f, 1.0f)));
        applyHits(*m_session);
        QTRY_VERIFY_WITH_TIMEOUT(label("subject").contains(QStringLiteral("Merged with hit 3")), kPatience);
        QVERIFY(report().dent->vertices > alone);
        addHitAt(glm::normalize(glm::vec3(-0.4f, 0.0f, 1.0f)));
        applyHits(*m_session);
        QTRY_VERIFY_WITH_TIMEOUT(label("subject").contains(QStringLiteral("Merged with hits 3 and 4")),
                                 kPatience);
        QVERIFY(m_panel->measurement().text().contains(QStringLiteral("\nMerged dent of hits\t1, 3, 4")));
        QVERIFY(m_panel->measurement().profileCsv().startsWith("# merged dent of hits 1, 3, 4\nstate,"));
        const auto& target = *m_session->targets().front();
        m_session->selection().setPicked(VertexRef{target.id, report().dent->deepest});
        QTRY_VERIFY_WITH_TIMEOUT(label("subject").contains(QStringLiteral("Merged dent of hits")), kPatience);
        m_session->hits().select(1);
        QTRY_VERIFY_WITH_TIMEOUT(report().dent && report().merged.isEmpty(), kPatience);
        for (int i = 0; i < 3; ++i) {
            addHitAt({0.0f, 0.1f * static_cast<float>(i), 1.0f});
        }
        applyHits(*m_session);
        m_session->hits().select(0);
        QTRY_VERIFY_WITH_TIMEOUT(label("subject").contains(QStringLiteral("hits 3, 4, 5, 6 and 7")),
                                 kPatience);
        addHitAt({0.0f, -0.1f, 1.0f});
        applyHits(*m_session);
        QTRY_VERIFY_WITH_TIMEOUT(label("subject").contains(QStringLiteral("hits 3, 4, 5, 6 and 2 more")),
                                 kPatience);
    }

    void aHitThatIsNotAppliedIsRefused() {
        m_session->hits().select(0);
        QTRY_VERIFY_WITH_TIMEOUT(report().dent.has_value(), kPatience);
        const std::array<std::size_t, 1> first = {0};
        m_session->hits().setEnabled(first, false);
        QVERIFY(!report().dent);
        QVERIFY(label("subject").contains(QStringLiteral("Hit 1 is disabled")));
        QCOMPARE(label("depth"), QStringLiteral("–"));
        m_session->hits().setEnabled(first, true);
        QTRY_VERIFY_WITH_TIMEOUT(report().dent.has_value(), kPatience);
        m_session->hits().show(0);
        QVERIFY(label("subject").contains(QStringLiteral("comes after the hits that are shown")));
        QVERIFY(!report().dent);
        m_session->hits().select(std::nullopt);
        QVERIFY(label("subject").contains(QStringLiteral("Select a hit")));
    }

    void theProfileLeavesOutAFarWall_data() {
        QTest::addColumn<bool>("isSphere");
        QTest::newRow("sphere") << true;
        QTest::newRow("cube") << false;
    }
    void theProfileLeavesOutAFarWall() {
        QFETCH(bool, isSphere);
        if (isSphere) {
            useSphere();
        } else {
            loadMesh(*m_session, makeCube(48, 1.0f));
        }
        // A second hit beside the first makes the dent wide.
        addHitAt({0.0f, 0.0f, 1.0f});
        addHitAt({0.5f, 0.0f, isSphere ? 0.85f : 1.0f});
        applyHits(*m_session);
        m_session->hits().select(0);
        QTRY_VERIFY_WITH_TIMEOUT(report().dent.has_value(), kPatience);
        const double lowest = -(report().dent->depth + 0.6 * report().dent->rimDiameter);
        for (const int angle : {0, 45, 90}) {
            m_panel->findChild<QSpinBox*>(QStringLiteral("angle"))->setValue(angle);
            QTRY_VERIFY_WITH_TIMEOUT(!m_panel->measurement().isBusy(), kPatience);
            for (const DentMeasurement::Profile& profile : {report().before, report().after}) {
                QCOMPARE(profile.size(), std::size_t{1});
                for (const ProfilePoint& point : profile.front()) {
                    QVERIFY2(point.height > lowest, qPrintable(QString::number(point.height)));
                }
            }
        }
    }

    void copiesAndSaves() {
        m_session->hits().select(0);
        QTRY_VERIFY_WITH_TIMEOUT(report().dent.has_value(), kPatience);
        m_panel->findChild<QToolButton*>(QStringLiteral("copy"))->click();
        QVERIFY(QGuiApplication::clipboard()->text().contains(QStringLiteral("Displaced volume\t")));
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("profile.csv"));
        QVERIFY(m_panel->saveCsv(path).ok());
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray csv = file.readAll();
        QVERIFY(csv.startsWith("state,line,along_m,height_m\noriginal,0,"));
        QVERIFY(csv.contains("\ndeformed,0,"));
    }

private:
    void useSphere() { loadMesh(*m_session, makeUvSphere(128, 64, 1.0f)); }
    void addHitAt(const glm::vec3& point) {
        Hit hit;
        hit.target = m_session->targets().front()->id;
        hit.point = point;
        hit.direction = -glm::normalize(point);
        QVERIFY(m_session->hits().add(hit).ok());
    }
    [[nodiscard]] const DentMeasurement::Report& report() { return m_panel->measurement().report(); }
    [[nodiscard]] QString label(const char* name) {
        return m_panel->findChild<QLabel*>(QLatin1String(name))->text();
    }
    std::unique_ptr<Session> m_session;
    std::unique_ptr<DentMeasurementPanel> m_panel;
};

HITSCOPE_TEST(DentMeasurementTest, QApplication)

}  // namespace hitscope::dent_measurement_test

#include "dent_measurement_test.moc"
