// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes whose files change while they are in the window.
#include <QApplication>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>

#include "app/mesh_reloader.h"
#include "app/notice_bar.h"
#include "app/reload_bar.h"
#include "deform/fingerprint.h"
#include "document/journal_records.h"
#include "document/session_journal.h"
#include "session/shots/demo_shots.h"
#include "session/task_list.h"
#include "session/vertex_selection.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::reload_test {

class ReloadTest : public QObject, private WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_mesh = m_folder->filePath(QStringLiteral("rock.obj"));
        save(makeUvSphere(24, 12, 1.0f));
        makeWindow();
        m_window->openFiles({m_mesh});
        QTRY_COMPARE_WITH_TIMEOUT(target().name, QStringLiteral("rock"), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(m_session->tasks().current() == nullptr, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(!knownContentOf(*m_window, m_mesh).empty(), kPatience);
    }
    void cleanup() {
        dropWindow();
        m_folder.reset();
    }

    void alongWithItsVertices();
    void byPosition();
    void ignored();
    void sameContentIsNoChange();
    void goesBackByItself();
    void sharedByTwo();
    void materialsAndPictures();
    void broken();
    void gone();
    void keptByTheJournal();
    void notOfThisSession();
    void changedMeanwhile();
    void changedDuringReadingStaysOffered();

private:
    [[nodiscard]] const Target& target() const { return *m_session->targets().front(); }
    [[nodiscard]] ReloadBar& bar() const { return *m_window->findChild<ReloadBar*>(); }
    [[nodiscard]] QString told() const { return m_window->findChild<NoticeBar*>()->text(); }
    void write(const QString& name, const QByteArray& content) const {
        QFile file(m_folder->filePath(name + QStringLiteral(".new")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
        file.close();
        QVERIFY(std::rename(qPrintable(file.fileName()), qPrintable(m_folder->filePath(name))) == 0);
    }
    void save(const MeshData& mesh) const { writeObj(mesh, m_mesh); }
    void shoot(int count) {
        for (const Ray& ray : demoShots(*m_session, count, 3)) {
            m_session->simulation().hitscan(ray);
        }
        QVERIFY(m_session->hits().history().size() > 3);
    }
    void press(const char* button) const {
        auto* found = bar().findChild<QPushButton*>(QLatin1String(button));
        QVERIFY(found != nullptr && found->isVisible());
        QTest::mouseClick(found, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!bar().isVisible(), kPatience);
    }
    void reload() const {
        QSignalSpy done(m_window->findChild<MeshReloader*>(), &MeshReloader::reloaded);
        QTRY_VERIFY_WITH_TIMEOUT(bar().isVisible(), kPatience);
        press("reloadMeshes");
        QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, kPatience);
    }
    /// As the steps of the Mesh menu do: each is another target then.
    void change(const std::vector<TargetState>& targets) const {
        m_session->targets().replaceMeshes(
            targets, [](const Hit& hit) { return hit; }, SessionUndo::Kind::RefineMesh);
    }
    [[nodiscard]] std::size_t vertices(std::size_t index) const {
        return m_session->targets()[index]->deformed.original().vertexCount();
    }
    [[nodiscard]] std::uint64_t positions() const {
        if (!m_window->viewport().syncNow().ok()) {
            return 0;
        }
        std::vector<const DeformedMesh*> meshes;
        for (const std::unique_ptr<Target>& each : m_session->targets()) {
            meshes.push_back(&each->deformed);
        }
        return positionsFingerprint(meshes);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_mesh;
};

void ReloadTest::alongWithItsVertices() {
    shoot(12);
    m_session->simulation().setPaused(true);  // it is in the air
    const TargetId id = target().id;
    QVERIFY(m_session->targets().rename(id, QStringLiteral("Fels")).ok());
    QVERIFY(m_session->targets().setTransform(id, {{3.0f, 1.0f, 0.0f}, glm::quat(1, 0, 0, 0)}).ok());
    QVERIFY(m_session->targets().setPhysics(id, {true, 5.0f, 0.25f, 0.5f}).ok());
    m_session->selection().select(id, {3, 5}, VertexSelection::Combine::Replace);
    const std::vector<Hit> before(m_session->hits().history().hits().begin(),
                                  m_session->hits().history().hits().end());
    const std::uint64_t asBefore = positions();
    const Camera camera = m_window->viewport().camera();

    MeshData mesh = makeUvSphere(24, 12, 1.0f);
    for (glm::vec3& position : mesh.positions) {
        position += glm::vec3(0.0f, 2.0f, 0.0f);
    }
    save(mesh);
    QTRY_VERIFY_WITH_TIMEOUT(bar().isVisible(), kPatience);
    QVERIFY(bar().findChild<QLabel*>()->text().contains(QStringLiteral("rock.obj")));
    QCOMPARE(target().id, id);  // nothing happens by itself
    const std::size_t steps = m_session->steps().size();
    reload();
    QVERIFY2(told().contains(QStringLiteral("rock.obj")) && told().contains(QStringLiteral("correspond")) &&
                 !told().contains(QStringLiteral("do not")),
             qPrintable(told()));
    QCOMPARE(m_session->targets().size(), std::size_t{1});
    QCOMPARE(target().name, QStringLiteral("Fels"));
    QCOMPARE(target().transform.position, glm::vec3(3.0f, 1.0f, 0.0f));
    QVERIFY(target().physics.isDynamic);
    QVERIFY(std::get<MeshFile>(target().source) == meshFileAt(m_mesh));
    QCOMPARE(m_session->selection().vertices(target().id).size(), std::size_t{2});
    const std::span<const Hit> now = m_session->hits().history().hits();
    QCOMPARE(now.size(), before.size());
    for (std::size_t i = 0; i < now.size(); ++i) {
        QVERIFY(glm::distance(now[i].point, before[i].point + glm::vec3(0.0f, 2.0f, 0.0f)) < 1.0e-4f);
        QVERIFY(now[i].target == target().id);
    }
    const std::uint64_t reloaded = positions();
    QVERIFY(reloaded != asBefore);
    float farthest = 0.0f;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        farthest = std::max(farthest, glm::distance(target().deformed.positions()[i], mesh.positions[i]));
    }
    QVERIFY(farthest > 0.01f);  // the dents are there
    QVERIFY(m_window->viewport().camera().eye() == camera.eye());
    QCOMPARE(m_session->steps().size(), steps + 1);
    m_session->undo();
    QCOMPARE(target().id, id);
    QCOMPARE(positions(), asBefore);
    QVERIFY(!bar().isVisible());
    m_session->redo();
    QCOMPARE(positions(), reloaded);
}

void ReloadTest::byPosition() {
    shoot(12);
    const std::vector<Hit> before(m_session->hits().history().hits().begin(),
                                  m_session->hits().history().hits().end());
    m_session->hits().select(2);
    m_session->hits().show(before.size() - 1);
    save(makeUvSphere(48, 24, 1.0f));
    reload();
    QCOMPARE(m_session->hits().selected(), std::optional<std::size_t>(2));
    QCOMPARE(m_session->hits().shown().size(), before.size() - 1);
    m_session->hits().show(std::nullopt);
    QVERIFY2(told().contains(QStringLiteral("do not correspond")), qPrintable(told()));
    QVERIFY(told().contains(QString::number(before.size())));
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Hit& now = m_session->hits().history().hits()[i];
        QVERIFY(now.point == before[i].point && now.triangle == kNoIndex);
    }
    // It is what the same hits make of the new mesh in a window that never had another.
    const std::uint64_t reloaded = positions();
    std::vector<Hit> hits(m_session->hits().history().hits().begin(),
                          m_session->hits().history().hits().end());
    makeWindow();
    m_window->openFiles({m_mesh});
    QTRY_COMPARE_WITH_TIMEOUT(target().name, QStringLiteral("rock"), kPatience);
    for (Hit& hit : hits) {
        hit.target = target().id;
    }
    QVERIFY(m_session->hits().add(hits).ok());
    QCOMPARE(positions(), reloaded);
}

void ReloadTest::ignored() {
    const TargetId id = target().id;
    save(makeUvSphere(48, 24, 1.0f));
    QTRY_VERIFY_WITH_TIMEOUT(bar().isVisible(), kPatience);
    press("ignoreChange");
    QTest::qWait(3 * FileWatch::kSettles);
    QVERIFY(!bar().isVisible());
    QCOMPARE(target().id, id);
    save(makeUvSphere(12, 6, 1.0f));
    reload();
    QCOMPARE(target().deformed.original().vertexCount(), makeUvSphere(12, 6, 1.0f).vertexCount());
}

void ReloadTest::sameContentIsNoChange() {
    save(makeUvSphere(24, 12, 1.0f));
    QTest::qWait(4 * FileWatch::kSettles);
    QVERIFY(!bar().isVisible());
}

void ReloadTest::goesBackByItself() {
    save(makeUvSphere(48, 24, 1.0f));
    QTRY_VERIFY_WITH_TIMEOUT(bar().isVisible(), kPatience);
    save(makeUvSphere(24, 12, 1.0f));
    QTRY_VERIFY_WITH_TIMEOUT(!bar().isVisible(), kPatience);
}

void ReloadTest::sharedByTwo() {
    const TargetId id = target().id;
    m_session->targets().duplicate({&id, 1});
    shoot(8);
    save(makeUvSphere(48, 24, 1.0f));
    reload();
    QCOMPARE(m_session->targets().size(), std::size_t{2});
    QCOMPARE(m_session->targets()[0]->shape.mesh, m_session->targets()[1]->shape.mesh);
    QCOMPARE(target().deformed.original().vertexCount(), makeUvSphere(48, 24, 1.0f).vertexCount());
    m_session->undo();
    QCOMPARE(m_session->targets()[1]->deformed.original().vertexCount(),
             makeUvSphere(24, 12, 1.0f).vertexCount());
}

void ReloadTest::materialsAndPictures() {
    write(QStringLiteral("board.mtl"), "newmtl wood\nKd 0.5 0.5 0.5\nmap_Kd wood.png\n");
    QImage image(4, 4, QImage::Format_RGB32);
    image.fill(Qt::red);
    QVERIFY(image.save(m_folder->filePath(QStringLiteral("wood.png"))));
    write(
        QStringLiteral("board.obj"),
        "mtllib board.mtl\nv -1 0 0\nv 1 0 0\nv 1 2 0\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl wood\nf 1/1 2/2 3/3\n");
    m_window->openFiles({m_folder->filePath(QStringLiteral("board.obj"))});
    QTRY_COMPARE_WITH_TIMEOUT(target().name, QStringLiteral("board"), kPatience);
    QTest::qWait(3 * FileWatch::kSettles);
    QVERIFY(!bar().isVisible());
    write(QStringLiteral("board.mtl"), "newmtl wood\nKd 1 1 0.25\nmap_Kd wood.png\n");
    reload();
    QCOMPARE(target().deformed.original().materials[0].diffuse.z, 0.25f);
    QTest::qWait(3 * FileWatch::kSettles);
    image.fill(Qt::blue);
    QVERIFY(image.save(m_folder->filePath(QStringLiteral("wood.png"))));
    reload();
    QCOMPARE(target().deformed.original().images[0].pixels[2], std::uint8_t{255});
}

void ReloadTest::broken() {
    shoot(5);
    const TargetId id = target().id;
    const std::uint64_t before = positions();
    write(QStringLiteral("rock.obj"), "v 1 2\nf 1 2 3\n");
    QTRY_VERIFY_WITH_TIMEOUT(bar().isVisible(), kPatience);
    QTest::mouseClick(bar().findChild<QPushButton*>(QStringLiteral("reloadMeshes")), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeModalWidget() != nullptr, kPatience);
    QApplication::activeModalWidget()->close();
    QCOMPARE(target().id, id);
    QCOMPARE(positions(), before);
    QVERIFY(bar().isVisible());  // once it is mended
    save(makeUvSphere(24, 12, 1.5f));
    QTest::qWait(3 * FileWatch::kSettles);
    reload();
    QVERIFY(target().id != id);
}

void ReloadTest::gone() {
    QVERIFY(QFile::remove(m_mesh));
    QTest::qWait(3 * FileWatch::kSettles);
    QVERIFY(!bar().isVisible());
    save(makeUvSphere(48, 24, 1.0f));
    reload();
    QCOMPARE(target().deformed.original().vertexCount(), makeUvSphere(48, 24, 1.0f).vertexCount());
}

/// A crash right after it loses none of the hits.
void ReloadTest::keptByTheJournal() {
    shoot(9);
    const std::size_t hits = m_session->hits().history().size();
    save(makeUvSphere(24, 12, 2.0f));
    std::size_t kept = 0;
    JournalWriter& writer = m_window->findChild<SessionJournal*>()->writer();
    connect(m_window->findChild<MeshReloader*>(), &MeshReloader::reloaded, this, [&kept, &writer] {
        QFile journal(writer.path());
        if (writer.wait(kPatience) && journal.open(QIODevice::ReadOnly)) {
            const Result<RecoveredJournal> read = readJournal(journal.readAll());
            kept = read ? read.value().document.hits.size() : 0;
        }
    });
    reload();
    QCOMPARE(kept, hits);
    const std::uint64_t reloaded = positions();
    QVERIFY(m_window->findChild<SessionJournal*>()->writer().wait(kPatience));
    makeWindow();
    m_window->offerRecovery();
    auto* recover = m_window->findChild<QPushButton*>(QStringLiteral("recover"));
    QTRY_VERIFY_WITH_TIMEOUT(recover->isVisible(), kPatience);
    recover->click();
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), hits, kPatience);
    QCOMPARE(positions(), reloaded);
}

void ReloadTest::notOfThisSession() {
    save(makeUvSphere(48, 24, 1.0f));
    QTRY_VERIFY_WITH_TIMEOUT(bar().isVisible(), kPatience);
    loadTeapot(*m_session);
    QTRY_VERIFY_WITH_TIMEOUT(!bar().isVisible(), kPatience);
}

/// Nothing is said to be reloaded that was not, and what is left is offered again.
void ReloadTest::changedMeanwhile() {
    const TargetId first = target().id;
    m_session->targets().duplicate({&first, 1});
    auto* reloader = m_window->findChild<MeshReloader*>();
    QSignalSpy reloaded(reloader, &MeshReloader::reloaded);
    QSignalSpy failed(reloader, &MeshReloader::failed);
    save(makeUvSphere(48, 24, 1.0f));
    QTRY_VERIFY_WITH_TIMEOUT(bar().isVisible(), kPatience);
    reloader->reload();
    change({target(), *m_session->targets().back()});
    QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience);
    QCOMPARE(reloaded.size(), 0);
    QCOMPARE(reloader->changedFiles(), QStringList{m_mesh});
    QApplication::activeModalWidget()->close();

    reloader->reload();
    change({target()});
    QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 2, kPatience);
    QCOMPARE(reloaded.size(), 1);
    QCOMPARE(reloader->changedFiles(), QStringList{m_mesh});
    QCOMPARE(vertices(0), makeUvSphere(24, 12, 1.0f).vertexCount());
    QCOMPARE(vertices(1), makeUvSphere(48, 24, 1.0f).vertexCount());
    QApplication::activeModalWidget()->close();

    // Of what is gone there is nothing to say.
    reloader->reload();
    const TargetId both[] = {m_session->targets()[0]->id, m_session->targets()[1]->id};
    m_session->targets().remove(both);
    QTRY_VERIFY_WITH_TIMEOUT(m_session->tasks().current() == nullptr, kPatience);
    QCOMPARE(failed.size(), 2);
    QCOMPARE(reloaded.size(), 1);
    QVERIFY(reloader->changedFiles().isEmpty());
}

/// Once each, whether reading is cancelled or fails.
void ReloadTest::changedDuringReadingStaysOffered() {
    const QString board = m_folder->filePath(QStringLiteral("board.obj"));
    const QString material = m_folder->filePath(QStringLiteral("board.mtl"));
    write(QStringLiteral("board.mtl"), "newmtl wood\nKd 0.5 0.5 0.5\n");
    const QByteArray triangle = "mtllib board.mtl\nv -1 0 0\nv 1 0 0\nv 1 2 0\nusemtl wood\nf 1 2 3\n";
    write(QStringLiteral("board.obj"), triangle);
    m_window->openFiles({board});
    QTRY_COMPARE_WITH_TIMEOUT(target().name, QStringLiteral("board"), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!knownContentOf(*m_window, board).empty(), kPatience);
    write(QStringLiteral("board.obj"), "v 1 2\nf 1 2 3\n");
    QTRY_VERIFY_WITH_TIMEOUT(bar().isVisible(), kPatience);
    auto* reloader = m_window->findChild<MeshReloader*>();
    auto* watch = reloader->findChild<FileWatch*>();
    const QSignalSpy failed(reloader, &MeshReloader::failed);
    const auto readWhileBothChange = [&] {
        reloader->reload();
        Q_EMIT watch->changed(board);
        Q_EMIT watch->changed(material);
    };
    readWhileBothChange();
    m_session->tasks().cancel(m_session->tasks().current()->id);
    QCOMPARE(reloader->changedFiles(), (QStringList{board, material}));
    readWhileBothChange();
    QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience);
    QCOMPARE(reloader->changedFiles(), (QStringList{board, material}));
    QApplication::activeModalWidget()->close();
}

HITSCOPE_TEST(ReloadTest, QApplication)

}  // namespace hitscope::reload_test

#include "reload_test.moc"
