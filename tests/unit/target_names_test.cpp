// SPDX-License-Identifier: GPL-3.0-or-later
// The names that targets get, and who is told of one.
#include <QSignalSpy>
#include <QTest>
#include <array>

#include "mesh/primitives.h"
#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::target_names_test {

namespace {

TargetPlan namedCube(const QString& name) {
    TargetPlan plan = planMesh(makeCube(2, 1.0f));
    plan.name = name;
    return plan;
}

QStringList names(const Session& session) {
    QStringList list;
    for (const auto& target : session.targets()) {
        list << target->name;
    }
    return list;
}

}  // namespace

class TargetNamesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_session = std::make_unique<Session>();
        m_session->loadScene({QStringLiteral("Two"),
                              {namedCube(QStringLiteral("Left")), namedCube(QStringLiteral("Right"))},
                              -1.0f});
    }

    /// In one operation and in the next, whatever was free before.
    void namesAreTheFirstFree() {
        QVERIFY(m_session->targets().rename(id(1), QStringLiteral("Left 3")).ok());
        const std::array both{id(0), id(1)};
        m_session->targets().duplicate(both);
        QCOMPARE(names(*m_session), (QStringList{QStringLiteral("Left"), QStringLiteral("Left 3"),
                                                 QStringLiteral("Left 2"), QStringLiteral("Left 4")}));
        m_session->targets().remove({&both[1], 1});
        m_session->targets().add({namedCube(QStringLiteral("Left 9")), namedCube(QStringLiteral("Left 4")),
                                  namedCube(QStringLiteral("Left"))});
        QCOMPARE(names(*m_session),
                 (QStringList{QStringLiteral("Left"), QStringLiteral("Left 2"), QStringLiteral("Left 4"),
                              QStringLiteral("Left 9"), QStringLiteral("Left 3"), QStringLiteral("Left 5")}));
    }

    /// changed() comes in every frame for those that move.
    void tellsNamesFromPlaces() {
        const QSignalSpy changed(&m_session->targets(), &SessionTargets::changed);
        const QSignalSpy renamed(&m_session->targets(), &SessionTargets::renamed);
        const QSignalSpy textured(&m_session->targets(), &SessionTargets::textured);
        const TargetId left = id(0);
        QVERIFY(m_session->targets().setTransform(left, {{1.0f, 2.0f, 3.0f}}).ok());
        m_session->targets().setVisible({&left, 1}, false);
        QCOMPARE(changed.size(), 2);
        QCOMPARE(renamed.size() + textured.size(), 0);
        QVERIFY(m_session->targets().rename(left, QStringLiteral("Other")).ok());
        m_session->undo();
        QCOMPARE(changed.size(), 4);
        QCOMPARE(renamed.size(), 2);
        m_session->targets().setTexture(
            {&left, 1}, std::make_shared<MeshData>(*m_session->targets().find(left)->shape.mesh), {});
        m_session->undo();
        QCOMPARE(renamed.size(), 2);
        QCOMPARE(textured.size(), 2);
    }

private:
    [[nodiscard]] TargetId id(std::size_t index) const { return m_session->targets()[index]->id; }

    std::unique_ptr<Session> m_session;
};

HITSCOPE_TEST(TargetNamesTest, QCoreApplication)

}  // namespace hitscope::target_names_test

#include "target_names_test.moc"
