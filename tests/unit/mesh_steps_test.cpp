// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/mesh_steps/mesh_edit.h"

#include <QTest>
#include <algorithm>

#include "deform/reference.h"
#include "document/capture.h"
#include "document/document_json.h"
#include "document/open_document.h"
#include "mesh/primitives.h"
#include "mesh/same_bits.h"
#include "session/primitive_target.h"
#include "session/session.h"
#include "support/test_program.h"

namespace hitscope::mesh_steps_test {

namespace {

/// The paper's low-poly cube with two hits, one disabled.
void fillSession(Session& session) {
    ScenePlan plan;
    plan.name = QStringLiteral("cube");
    plan.targets.push_back(planBuiltIn(BuiltInMesh::LowPolyCube));
    session.loadScene(std::move(plan));
    for (const float x : {0.1f, -1.0f}) {
        Hit hit;
        hit.target = session.targets().front()->id;
        hit.point = {x, 2.5f, 0.3f};
        hit.direction = {0.0f, -1.0f, 0.0f};
        hit.enabled = x > 0.0f;
        QVERIFY(session.hits().add(hit).ok());
    }
}

const MeshData& meshOfSession(const Session& session) {
    return *session.targets().front()->shape.mesh;
}

Status doStep(Session& session, MeshEdit edit) {
    const Target& target = *session.targets().front();
    Result<EditedMesh> made = edited(*target.shape.mesh, edit);
    return made ? takeEdited(session, stateWith(target, std::move(made).value()), edit)
                : Status(made.error());
}

MeshEdit editOf(const Session& session, MeshStep step, MeshEdit::Where where, bool applies = false) {
    MeshEdit edit = meshEdit(session, session.targets().front()->id, std::move(step));
    edit.where = where;
    edit.appliesHits = applies;
    return edit;
}

RefineOptions refineTo(float length) {
    return {.method = RefineMethod::Midpoint, .edgeLength = length, .keepQuads = true, .region = {}};
}

bool isSameMesh(const MeshData& a, const MeshData& b) {
    return a.positions.size() == b.positions.size() &&
           std::equal(a.positions.begin(), a.positions.end(), b.positions.begin(), sameBits) &&
           a.faceStarts == b.faceStarts && a.cornerVertices == b.cornerVertices &&
           a.cornerNormals == b.cornerNormals && a.sourceVertices == b.sourceVertices;
}

}  // namespace

class MeshStepsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void refiningIsAStepToUndo();
    void smoothingAppliesHits();
    void hitsThatChangedMeanwhileAreNotApplied();
    void sessionsKeepSteps();
    void regionsThatAreEmptyAreErrors();
};

void MeshStepsTest::refiningIsAStepToUndo() {
    Session session;
    fillSession(session);
    const MeshData before = meshOfSession(session);
    const TargetId was = session.targets().front()->id;
    session.selection().select(was, {3, 5}, VertexSelection::Combine::Replace);
    QVERIFY(doStep(session, editOf(session, refineTo(0.1f), MeshEdit::Where::Hits)).ok());
    const TargetId is = session.targets().front()->id;
    QVERIFY(is != was);
    const MeshData after = meshOfSession(session);
    QVERIFY(after.vertexCount() > before.vertexCount() + 50);
    QVERIFY(std::equal(before.positions.begin(), before.positions.end(), after.positions.begin(), sameBits));
    QCOMPARE(session.hits().history().size(), std::size_t(2));
    for (const Hit& hit : session.hits().history().hits()) {
        QCOMPARE(hit.target, is);
    }
    QCOMPARE(session.selection().vertices(is).size(), std::size_t(2));
    QCOMPARE(session.steps().toUndo()->kind, SessionUndo::Kind::RefineMesh);
    session.undo();
    QVERIFY(isSameMesh(meshOfSession(session), before));
    QVERIFY(session.targets().front()->steps.empty());
    QCOMPARE(session.hits().history().hits()[0].target, session.targets().front()->id);
    session.redo();
    QVERIFY(isSameMesh(meshOfSession(session), after));
    QCOMPARE(session.targets().front()->steps.size(), std::size_t(1));
}

/// Every pipeline shows what the reference makes of the hits: so the applied shape is what was seen.
void MeshStepsTest::smoothingAppliesHits() {
    Session session;
    fillSession(session);
    const Target& target = *session.targets().front();
    ReferenceDeformation dented(*target.shape.render);
    dented.apply(session.hits().history().hitsOn(target.id));
    PageVector<glm::vec3> shape = meshOfSession(session).positions;
    for (std::size_t v = 0; v < dented.vertices().size(); ++v) {
        shape[target.shape.render->fileVertices[v]] = dented.vertices()[v].position;
    }
    QVERIFY(doStep(session, editOf(session, MergedHits(), MeshEdit::Where::Whole)).ok());
    QVERIFY(std::equal(shape.begin(), shape.end(), meshOfSession(session).positions.begin(), sameBits));
    QCOMPARE(session.hits().history().size(), std::size_t(1));  // the disabled one
    session.undo();
    QCOMPARE(session.hits().history().size(), std::size_t(2));
    QVERIFY(session.hits().history().hits()[0].enabled);

    const auto smoothed = editOf(session, SmoothOptions(), MeshEdit::Where::Hits, true);
    QVERIFY(doStep(session, smoothed).ok());
    QCOMPARE(session.targets().front()->steps.size(), std::size_t(2));
    QCOMPARE(session.steps().toUndo()->kind, SessionUndo::Kind::SmoothMesh);
    const MeshData& now = meshOfSession(session);
    std::size_t moved = 0;
    for (std::size_t v = 0; v < shape.size(); ++v) {
        moved += sameBits(shape[v], now.positions[v]) ? 0 : 1;
    }
    QVERIFY(moved > 0 && moved < 60);  // about the dent alone
}

void MeshStepsTest::hitsThatChangedMeanwhileAreNotApplied() {
    Session session;
    fillSession(session);
    const Target& target = *session.targets().front();
    const MeshEdit edit = editOf(session, MergedHits(), MeshEdit::Where::Whole);
    Result<EditedMesh> made = edited(*target.shape.mesh, edit);
    QVERIFY(made.ok());
    const TargetState state = stateWith(target, std::move(made).value());
    // A hit that came later stays on the new mesh.
    Hit later = session.hits().history().hits()[0];
    later.point.x = 2.0f;
    QVERIFY(session.hits().add(later).ok());
    QVERIFY(takeEdited(session, state, edit).ok());
    QCOMPARE(session.hits().history().size(), std::size_t(2));
    QCOMPARE(session.hits().history().hits()[1].point.x, 2.0f);
    session.undo();
    // One whose dent has another form by now is not applied either.
    for (const auto& change : {+[](Hit& hit) { hit.form.profile = DentProfile::Crater; },
                               +[](Hit& hit) {
                                   hit.normal = {0.0f, 1.0f, 0.0f};
                               }}) {
        Hit other = session.hits().history().hits()[0];
        change(other);
        QVERIFY(session.hits().replace(0, other).ok());
        QVERIFY(!takeEdited(session, state, edit).ok());
        session.undo();
    }
    // One that is not there any more cannot be applied.
    session.hits().remove(std::vector<std::size_t>{0});
    const Status refused = takeEdited(session, state, edit);
    QVERIFY(!refused.ok());
}

void MeshStepsTest::sessionsKeepSteps() {
    Session session;
    fillSession(session);
    QVERIFY(doStep(session, editOf(session, refineTo(0.1f), MeshEdit::Where::Hits)).ok());
    QVERIFY(doStep(session, editOf(session, SmoothOptions(), MeshEdit::Where::Hits, true)).ok());
    QVERIFY(doStep(session, editOf(session, SimplifyOptions(), MeshEdit::Where::Whole)).ok());
    const SessionDocument saved = captureSession(session, {});
    QCOMPARE(saved.targets[0].steps.size(), std::size_t(4));
    const QByteArray bytes = writeDocument(saved);
    Result<SessionDocument> read = readDocument(bytes);
    QVERIFY2(read.ok(), read.ok() ? "" : read.error().message().c_str());
    QCOMPARE(writeDocument(read.value()), bytes);
    Result<PreparedSession> prepared = prepareSession(std::move(read).value(), {});
    QVERIFY(prepared.ok() && prepared.value().isWhole());
    Session other;
    restoreSession(other, prepared.value());
    QVERIFY(isSameMesh(meshOfSession(other), meshOfSession(session)));
    QCOMPARE(other.targets().front()->steps.size(), std::size_t(4));
    // Without steps a file is as it was before there were any.
    Session plain;
    fillSession(plain);
    QVERIFY(!writeDocument(captureSession(plain, {})).contains("mesh_steps"));
}

void MeshStepsTest::regionsThatAreEmptyAreErrors() {
    Session session;
    fillSession(session);
    QVERIFY(!doStep(session, editOf(session, refineTo(0.1f), MeshEdit::Where::Selection)).ok());
    session.hits().clear();
    QVERIFY(!doStep(session, editOf(session, refineTo(0.1f), MeshEdit::Where::Hits)).ok());
    QVERIFY(session.targets().front()->steps.empty());
}

HITSCOPE_TEST(MeshStepsTest, QCoreApplication)

}  // namespace hitscope::mesh_steps_test

#include "mesh_steps_test.moc"
