// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures that a person located: in the session, in its file, and in its journal.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "document/journal_records.h"
#include "document/session_file.h"
#include "document/session_journal.h"
#include "io/import.h"
#include "io/read_picture.h"
#include "mesh/missing_textures.h"
#include "open_document_support.h"
#include "support/test_program.h"

namespace hitscope::located_textures_test {

using namespace test;

class LocatedTexturesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init();
    void cleanup() { m_session.reset(); }
    void comesBack();
    void movesWithTheSession();
    void goneIsTold();
    void foundByTheMeshItself();
    void undone();
    void isInTheJournal();

private:
    [[nodiscard]] QString in(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    [[nodiscard]] const Target& board() const { return *m_session->targets().front(); }
    /// As TextureLocator does.
    void locate(const QString& path) {
        const TargetId id = board().id;
        const Result<Image> picture = readPicture(path);
        QVERIFY(picture.ok());
        m_session->targets().setTexture(
            {&id, 1},
            std::make_shared<MeshData>(withTexture(*board().shape.mesh, "maps\\wood.png", picture.value())),
            {"maps\\wood.png", path});
    }
    Result<PreparedSession> opened(const QString& path) const {
        Result<SessionDocument> document = readSessionFile(path);
        MeshPlaces places;
        places.folder = QFileInfo(path).absolutePath();
        return document ? prepareSession(document.value(), places) : document.error();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Session> m_session;
};

void LocatedTexturesTest::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    for (const char* folder : {"a/mesh", "a/pictures"}) {
        QVERIFY(QDir(m_folder->path()).mkpath(QLatin1String(folder)));
    }
    const QString mesh = writeFile(in("a/mesh"), QStringLiteral("board.obj"),
                                   "mtllib board.mtl\nv -1 0 0\nv 1 0 0\nv 1 2 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
                                   "usemtl wood\nf 1/1 2/2 3/3\n");
    writeFile(in("a/mesh"), QStringLiteral("board.mtl"), "newmtl wood\nKd 1 1 1\nmap_Kd maps\\wood.png\n");
    const QByteArray png = smallPng();
    writeFile(in("a/pictures"), QStringLiteral("planks.png"),
              {png.constData(), static_cast<std::size_t>(png.size())});
    const Result<ImportedMesh> imported = importMesh(mesh);
    QVERIFY2(imported.ok(), qPrintable(messageOf(imported)));
    m_session = std::make_unique<Session>();
    loadMesh(*m_session, imported.value().mesh, mesh);
    QCOMPARE(missingTextures(*board().shape.mesh).size(), std::size_t{1});
    locate(in("a/pictures/planks.png"));
    QVERIFY(missingTextures(*board().shape.mesh).empty());
}

void LocatedTexturesTest::comesBack() {
    const SessionDocument document = captureSession(*m_session, {});
    QVERIFY(document.targets[0].textures ==
            (std::vector<LocatedTexture>{{"maps\\wood.png", in("a/pictures/planks.png")}}));
    QVERIFY(captureSettings(*m_session, {}).targets[0].textures == document.targets[0].textures);
    QVERIFY(writeSessionFile(document, in("a/one.hitscope")).ok());
    Result<PreparedSession> ready = opened(in("a/one.hitscope"));
    QVERIFY2(ready.ok(), qPrintable(messageOf(ready)));
    Session again;
    restoreSession(again, ready.value());
    const MeshData& mesh = *again.targets().front()->shape.mesh;
    QVERIFY(missingTextures(mesh).empty());
    QCOMPARE(mesh.images.size(), std::size_t{1});
    QVERIFY(mesh.images[0].pixels == board().shape.mesh->images[0].pixels);
    // And the next time.
    QVERIFY(captureSession(again, {}).targets[0].textures == document.targets[0].textures);
}

void LocatedTexturesTest::movesWithTheSession() {
    QVERIFY(writeSessionFile(captureSession(*m_session, {}), in("a/one.hitscope")).ok());
    QVERIFY(QDir(m_folder->path()).rename(QStringLiteral("a"), QStringLiteral("b")));
    const Result<PreparedSession> ready = opened(in("b/one.hitscope"));
    QVERIFY2(ready.ok(), qPrintable(messageOf(ready)));
    QVERIFY(ready.value().isWhole());
    const TargetState& target = ready.value().scene.targets[0];
    QVERIFY(missingTextures(*target.shape.mesh).empty());
    QVERIFY(target.textures ==
            (std::vector<LocatedTexture>{{"maps\\wood.png", in("b/pictures/planks.png")}}));
}

/// Where it should be is kept: its disk may be back the next time.
void LocatedTexturesTest::goneIsTold() {
    QVERIFY(writeSessionFile(captureSession(*m_session, {}), in("a/one.hitscope")).ok());
    QVERIFY(QFile::remove(in("a/pictures/planks.png")));
    const Result<PreparedSession> ready = opened(in("a/one.hitscope"));
    QVERIFY(ready.ok());
    QVERIFY(ready.value().notes.join(u'\n').contains(QStringLiteral("planks.png")));
    QCOMPARE(ready.value().scene.targets[0].textures.size(), std::size_t{1});
    QCOMPARE(missingTextures(*ready.value().scene.targets[0].shape.mesh).size(), std::size_t{1});
}

void LocatedTexturesTest::foundByTheMeshItself() {
    QVERIFY(writeSessionFile(captureSession(*m_session, {}), in("a/one.hitscope")).ok());
    QVERIFY(QFile::copy(in("a/pictures/planks.png"), in("a/mesh/wood.png")));
    const Result<PreparedSession> ready = opened(in("a/one.hitscope"));
    QVERIFY(ready.ok());
    QCOMPARE(ready.value().scene.targets[0].shape.mesh->images.size(), std::size_t{1});
}

void LocatedTexturesTest::undone() {
    locate(in("a/pictures/planks.png"));
    QCOMPARE(board().textures.size(), std::size_t{1});  // the same name once
    m_session->undo();
    m_session->undo();
    QVERIFY(board().textures.empty());
    QVERIFY(captureSession(*m_session, {}).targets[0].textures.empty());
    m_session->redo();
    const TargetId id = board().id;
    m_session->targets().duplicate({&id, 1});
    QVERIFY(m_session->targets()[1]->textures == board().textures && !board().textures.empty());
}

void LocatedTexturesTest::isInTheJournal() {
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("journals")));
    SessionJournal journal(
        *m_session, [] { return CapturedView{}; }, in("journals"));
    m_session->undo();
    shoot(*m_session, 1, 1);
    QCoreApplication::processEvents();
    journal.flush();
    const auto recovered = [&journal] {
        return readJournal(QByteArray::fromStdString(readFile(journal.writer().path())));
    };
    QVERIFY(journal.writer().wait(10'000));
    QVERIFY(recovered().ok());
    QVERIFY(recovered().value().document.targets[0].textures.empty());
    locate(in("a/pictures/planks.png"));
    journal.flush();
    QVERIFY(journal.writer().wait(10'000));
    QVERIFY(recovered().value().document.targets[0].textures == board().textures);
}

HITSCOPE_TEST(LocatedTexturesTest, QCoreApplication)

}  // namespace hitscope::located_textures_test

#include "located_textures_test.moc"
