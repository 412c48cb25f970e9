// SPDX-License-Identifier: GPL-3.0-or-later
// What a session does, followed by its journal.
#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <random>

#include "document/document_json.h"
#include "document/journal_records.h"
#include "document/session_journal.h"
#include "document_support.h"
#include "io_support.h"
#include "session/mesh_steps/mesh_edit.h"
#include "session/primitive_target.h"
#include "session/session.h"
#include "session/vertex_selection.h"
#include "support/test_program.h"

namespace hitscope::session_journal_test {

using namespace test;

namespace {

Hit hitOn(const Session& session, std::size_t target, float x) {
    return exampleHit(session.targets()[target]->id.value, x);
}

/// Fingerprints are of what was read back, which a journal does not follow.
QByteArray stateOf(const Session& session, const CapturedView& view) {
    SessionDocument document = captureSession(session, view);
    document.positions.clear();
    return writeDocument(document);
}

}  // namespace

class SessionJournalTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_view = {};
        m_session = std::make_unique<Session>();
        m_session->loadScene({QStringLiteral("Two"),
                              {planPrimitive({PrimitiveKind::Cube, 3, 1.0f}),
                               planPrimitive({PrimitiveKind::Sheet, 3, 2.0f})}});
        m_journal = std::make_unique<SessionJournal>(
            *m_session, [this] { return m_view; }, m_folder->path());
    }
    void cleanup() {
        m_journal.reset();
        m_session.reset();
    }
    void beginsWithTheFirstHit();
    void beginsWithTargets();
    void followsWhatAPersonDoes();
    void anotherScene();
    void otherMeshes();
    void targetsComeBeforeTheirHits();
    void targetsThatComeTogetherAreWrittenOnce();
    void aTargetThatMovesIsWrittenAlone();
    void endsInOrder();
    void longHistories();

private:
    [[nodiscard]] qsizetype files() const { return QDir(m_folder->path()).entryList(QDir::Files).size(); }
    /// The journal comes to what the session is.
    void compare();
    void doSomething(std::mt19937& random);
    void doSomethingElse(std::mt19937& random);

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<SessionJournal> m_journal;
    CapturedView m_view;
};

void SessionJournalTest::compare() {
    QTest::qWait(0);
    m_journal->flush();
    QVERIFY(m_journal->writer().wait(kPatience));
    const Result<RecoveredJournal> read =
        readJournal(QByteArray::fromStdString(readFile(m_journal->writer().path())));
    QVERIFY2(read.ok(), qPrintable(messageOf(read)));
    QVERIFY2(read.value().problem.empty(), read.value().problem.c_str());
    QCOMPARE(read.value().droppedHits, std::size_t(0));
    SessionDocument document = read.value().document;
    document.positions.clear();
    QCOMPARE(writeDocument(document), stateOf(*m_session, m_view));
}

void SessionJournalTest::beginsWithTheFirstHit() {
    m_session->targets().select(m_session->targets()[0]->id);
    m_session->settings().setFlightMode(FlightMode::Paper);
    m_journal->viewChanged();
    QTest::qWait(2 * SessionJournal::kSoon);
    QVERIFY(m_journal->writer().wait(kPatience));
    QCOMPARE(files(), 0);
    QVERIFY(m_session->hits().add(hitOn(*m_session, 0, 0.1f)).ok());
    QVERIFY(QTest::qWaitFor([this] { return files() == 1; }, kPatience));  // by itself
    compare();
}

void SessionJournalTest::doSomething(std::mt19937& random) {
    const auto upTo = [&random](std::size_t most) {
        return std::uniform_int_distribution<std::size_t>(0, most)(random);
    };
    Session& session = *m_session;
    const std::size_t hits = session.hits().history().size();
    const std::size_t index = upTo(std::max<std::size_t>(hits, 1) - 1);
    const std::size_t some[] = {index, std::min(index + 2, std::max<std::size_t>(hits, 1) - 1)};
    const auto& target = session.targets()[upTo(session.targets().size() - 1)];
    const TargetId id = target->id;
    switch (upTo(19)) {
        case 0:
        case 1:
        case 2:
        case 3:
            QVERIFY(session.hits()
                        .add(hitOn(session, upTo(session.targets().size() - 1),
                                   0.01f * static_cast<float>(upTo(99))))
                        .ok());
            break;
        case 4:
            session.hits().remove(some);
            break;
        case 5:
            session.hits().setEnabled(some, upTo(1) == 0);
            break;
        case 6:
            session.hits().move(some, upTo(hits));
            break;
        case 7:
        case 8:
        case 9:
            session.undo();
            break;
        case 10:
            session.redo();
            break;
        case 17:
            session.hits().giveConstants(some);
            break;
        case 18:
            session.hits().show(upTo(hits));
            session.selection().select(id, {static_cast<std::uint32_t>(upTo(5))},
                                       VertexSelection::Combine::Replace);
            break;
        case 11:
        case 12:
        case 13:
        case 14:
        case 15:
        case 16:
            doSomethingElse(random);
            break;
        default:
            m_view.display.flat = !m_view.display.flat;
            m_view.cameras.current = cameraText(Camera());
            m_journal->viewChanged();
    }
}

/// To targets and settings.
void SessionJournalTest::doSomethingElse(std::mt19937& random) {
    const auto upTo = [&random](std::size_t most) {
        return std::uniform_int_distribution<std::size_t>(0, most)(random);
    };
    Session& session = *m_session;
    const TargetId id = session.targets()[upTo(session.targets().size() - 1)]->id;
    switch (upTo(5)) {
        case 0:
            QVERIFY(session.targets().rename(id, QStringLiteral("Name %1").arg(upTo(999))).ok());
            break;
        case 1:
            QVERIFY(session.targets()
                        .setTransform(id, {{0.1f * static_cast<float>(upTo(50)), 0.0f, -0.0f},
                                           {1.0f, 0.0f, 0.0f, 0.0f}})
                        .ok());
            break;
        case 2:
            if (session.targets().size() < 6) {
                session.targets().duplicate({&id, 1});
            } else {
                session.targets().remove({&id, 1});
            }
            break;
        case 3:
            session.targets().setVisible({&id, 1}, upTo(1) == 0);
            break;
        case 4: {
            Lights lights = session.settings().lights();
            lights.spot.innerAngle = 0.01f * static_cast<float>(upTo(20));
            session.settings().setLights(lights);
            break;
        }
        default:
            QVERIFY(
                session.settings()
                    .setConstants(ConstantsSetting{{0.5f, 0.01f * static_cast<float>(upTo(9)), 0.3f}, true})
                    .ok());
            break;
    }
}

void SessionJournalTest::beginsWithTargets() {
    const TargetId first = m_session->targets().front()->id;
    m_session->targets().setVisible({&first, 1}, false);
    QTest::qWait(20);
    QCOMPARE(files(), qsizetype{0});
    m_session->targets().duplicate({&first, 1});
    compare();
    QVERIFY(m_session->targets().setTransform(first, RigidTransform{{1.0f, 2.0f, 3.0f}}).ok());
    compare();
}

void SessionJournalTest::followsWhatAPersonDoes() {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        std::mt19937 random(seed);
        QVERIFY(m_session->hits().add(hitOn(*m_session, 0, 0.1f)).ok());
        for (int i = 0; i < 150; ++i) {
            doSomething(random);
            if (i % 10 == 0) {
                QTest::qWait(0);
            }
            if (i % 50 == 0) {
                compare();
            }
        }
        compare();
    }
}

void SessionJournalTest::anotherScene() {
    QVERIFY(m_session->hits().add(hitOn(*m_session, 1, 0.1f)).ok());
    compare();
    loadTeapot(*m_session);
    compare();
    QVERIFY(m_session->hits().add(hitOn(*m_session, 0, 0.1f)).ok());
    compare();
    while (m_session->steps().canUndo()) {
        m_session->undo();
    }
    compare();
    while (m_session->steps().canRedo()) {
        m_session->redo();
    }
    compare();
}

/// A target whose mesh was refined, simplified or given its dents is another target, with the same hits.
void SessionJournalTest::otherMeshes() {
    const auto edit = [this](const MeshStep& step, bool appliesHits) {
        const Target& target = *m_session->targets()[0];
        MeshEdit what = meshEdit(*m_session, target.id, step);
        what.appliesHits = appliesHits;
        Result<EditedMesh> made = edited(*target.shape.mesh, what);
        QVERIFY2(made.ok(), qPrintable(messageOf(made)));
        QVERIFY(takeEdited(*m_session, stateWith(target, std::move(made).value()), what).ok());
    };
    QVERIFY(m_session->hits().add(hitOn(*m_session, 0, 0.1f)).ok());
    edit(RefineOptions{.method = RefineMethod::Midpoint, .edgeLength = 0.2f, .keepQuads = true, .region = {}},
         false);
    compare();
    QVERIFY(m_session->hits().add(hitOn(*m_session, 0, 0.2f)).ok());
    edit(SimplifyOptions{.share = 0.5f, .region = {}}, true);
    compare();
    QCOMPARE(m_session->targets()[0]->steps.size(), std::size_t(3));
    QVERIFY(m_session->hits().add(hitOn(*m_session, 0, 0.3f)).ok());
    compare();
    while (m_session->steps().canUndo()) {
        m_session->undo();
        compare();
    }
    while (m_session->steps().canRedo()) {
        m_session->redo();
        compare();
    }
}

/// At no moment are there hits on a target that the journal does not know yet.
void SessionJournalTest::targetsComeBeforeTheirHits() {
    QVERIFY(m_session->hits().add(hitOn(*m_session, 1, 0.1f)).ok());
    compare();
    const auto tryNow = [this] {
        QVERIFY(m_journal->writer().wait(kPatience));
        const Result<RecoveredJournal> read =
            readJournal(QByteArray::fromStdString(readFile(m_journal->writer().path())));
        QVERIFY2(read.ok(), qPrintable(messageOf(read)));
        QCOMPARE(read.value().droppedHits, std::size_t(0));
        QCOMPARE(read.value().document.hits.size(), m_session->hits().history().size());
    };
    m_session->targets().duplicate(std::array{m_session->targets()[1]->id});
    QCOMPARE(m_session->hits().history().size(), std::size_t(2));
    tryNow();
    m_session->undo();
    tryNow();
    m_session->redo();
    tryNow();
}

/// And in the next turn of the event loop, without waiting as sliders do.
void SessionJournalTest::targetsThatComeTogetherAreWrittenOnce() {
    QVERIFY(m_session->hits().add(hitOn(*m_session, 1, 0.1f)).ok());
    compare();
    const auto settings = [this] {
        const bool isWritten = m_journal->writer().wait(kPatience);
        const Result<RecoveredJournal> read =
            readJournal(QByteArray::fromStdString(readFile(m_journal->writer().path())));
        return isWritten && read ? read.value().settings : std::size_t(0);
    };
    const std::size_t before = settings();
    m_session->targets().add(std::vector<TargetPlan>(8, planPrimitive({PrimitiveKind::Cube, 3, 1.0f})));
    QCOMPARE(settings(), before);
    QTest::qWait(0);
    QCOMPARE(settings(), before + 1);
    compare();
    QCOMPARE(settings(), before + 1);
}

/// One that rolls is written five times a second.
void SessionJournalTest::aTargetThatMovesIsWrittenAlone() {
    QVERIFY(m_session->hits().add(hitOn(*m_session, 1, 0.1f)).ok());
    compare();
    m_session->targets().add(std::vector<TargetPlan>(100, planPrimitive({PrimitiveKind::Cube, 3, 1.0f})));
    compare();
    const auto bytes = [this] { return readFile(m_journal->writer().path()).size(); };
    const std::size_t before = bytes();
    const TargetId moving = m_session->targets()[1]->id;
    QVERIFY(m_session->targets().setTransform(moving, RigidTransform{{1.0f, 2.0f, 3.0f}}).ok());
    compare();
    QVERIFY2(bytes() - before < 1000, qPrintable(QString::number(bytes() - before)));
}

void SessionJournalTest::endsInOrder() {
    QVERIFY(m_session->hits().add(hitOn(*m_session, 1, 0.1f)).ok());
    compare();
    m_journal->finish();
    QVERIFY(m_journal->writer().wait(kPatience));
    QCOMPARE(files(), 0);
    m_session->hits().select(0);
    m_journal->viewChanged();
    QTest::qWait(2 * SessionJournal::kSoon);
    QVERIFY(m_journal->writer().wait(kPatience));
    QCOMPARE(files(), 0);  // looking is no work that could be lost
    m_session->hits().clear();
    QVERIFY(QTest::qWaitFor([this] { return files() == 1; }, kPatience));
    compare();
    m_session->undo();
    m_journal->finish();
    loadTeapot(*m_session);  // in which nothing was done yet
    QTest::qWait(2 * SessionJournal::kSoon);
    QVERIFY(m_journal->writer().wait(kPatience));
    QCOMPARE(files(), 0);
}

/// More edits between two looks than a history keeps.
void SessionJournalTest::longHistories() {
    QVERIFY(m_session->hits().add(hitOn(*m_session, 1, 0.1f)).ok());
    compare();
    const std::vector<Hit> many(50'000, hitOn(*m_session, 0, 0.3f));
    QVERIFY(m_session->hits().add(many).ok());
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < 1000; ++i) {
        rows.push_back(i * 7);
    }
    m_session->hits().remove(rows);
    m_session->undo();
    compare();
    const std::size_t before = m_session->steps().done();
    for (int i = 0; i < 3000; ++i) {
        QVERIFY(m_session->hits().add(hitOn(*m_session, 1, 0.01f * static_cast<float>(i))).ok());
    }
    compare();
    m_session->goToStep(before);
    compare();
    m_session->goToStep(m_session->steps().size());
    compare();
}

HITSCOPE_TEST(SessionJournalTest, QCoreApplication)

}  // namespace hitscope::session_journal_test

#include "session_journal_test.moc"
