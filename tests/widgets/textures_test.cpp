// SPDX-License-Identifier: GPL-3.0-or-later
// Textures that a mesh's file names and that are somewhere else.
#include <QAction>
#include <QImage>
#include <QPushButton>
#include <QTemporaryDir>

#include "app/dialogs/texture_locator.h"
#include "app/notice_bar.h"
#include "app/session_files.h"
#include "io/import.h"
#include "mesh/missing_textures.h"
#include "panels/help/help_text.h"
#include "session/task_list.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::textures_test {

class TexturesTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("mesh")));
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("pictures")));
        write("mesh/board.obj",
              "mtllib board.mtl\nv -1 0 0\nv 1 0 0\nv 1 2 0\nv -1 2 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
              "usemtl wood\nf 1/1 2/2 3/3\nusemtl tin\nf 1/1 3/3 4/4\n");
        write(
            "mesh/board.mtl",
            "newmtl wood\nKd 1 1 1\nKs 0 0 0\nmap_Kd maps\\wood.png\nnewmtl tin\nKd 1 1 1\nmap_Kd tin.png\n");
        paint("pictures/planks.png", QColor(250, 10, 10));
        paint("pictures/tin.png", QColor(10, 10, 250));
        makeWindow();
        open();
    }
    void cleanup() {
        dropWindow();
        m_folder.reset();
    }

    void noticeOffersToLocate() {
        const auto* notice = m_window->findChild<NoticeBar*>();
        QVERIFY(notice->isVisible() && notice->text().contains(QStringLiteral("wood.png")));
        const auto* offer = notice->findChild<QPushButton*>();
        QVERIFY(offer->isVisible() && offer->text().startsWith(QStringLiteral("Locate")));
        QVERIFY(action().isEnabled());
    }

    void noticeOffersToLocateThoseOfASession() {
        auto* files = m_window->findChild<SessionFiles*>();
        files->save(in("board.hitscope"));
        QTRY_VERIFY_WITH_TIMEOUT(!files->isBusy(), kPatience);
        makeWindow();
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->findChild<SessionFiles*>()->isBusy(), kPatience);
        m_window->openFiles({in("board.hitscope")});
        const auto* notice = m_window->findChild<NoticeBar*>();
        QTRY_VERIFY_WITH_TIMEOUT(notice->isVisible(), kPatience);
        QVERIFY2(notice->text().contains(QStringLiteral("wood.png")), qPrintable(notice->text()));
        const auto* offer = notice->findChild<QPushButton*>();
        QVERIFY(offer->isVisible() && offer->text().startsWith(QStringLiteral("Locate")));
    }

    void oneFindsItsNeighboursAndCanBeUndone() {
        QCOMPARE(missing(), std::size_t{2});
        QVERIFY(locator().use(in("pictures/planks.png")).ok());
        // The other one lies beside it under its own name.
        QCOMPARE(missing(), std::size_t{0});
        QTRY_VERIFY_WITH_TIMEOUT(!action().isEnabled(), kPatience);
        QVERIFY(!whyDisabled(action()).isEmpty());
        QVERIFY(redness() > 40);
        m_session->undo();
        QCOMPARE(missing(), std::size_t{1});
        m_session->undo();
        QCOMPARE(missing(), std::size_t{2});
        QTRY_VERIFY_WITH_TIMEOUT(action().isEnabled(), kPatience);
        QVERIFY(redness() < 40);
        m_session->redo();
        QCOMPARE(missing(), std::size_t{1});
        QVERIFY(redness() > 40);
    }

    /// Dynamic targets move in every frame.
    void onlyOtherPicturesAreLookedAt() {
        const TargetId board = m_session->targets().front()->id;
        QCoreApplication::processEvents();
        action().setEnabled(false);  // as nobody would: who looks for missing ones notices
        QVERIFY(m_session->targets().setTransform(board, {{1.0f, 2.0f, 3.0f}}).ok());
        m_session->targets().setVisible({&board, 1}, false);
        QVERIFY(m_session->targets().rename(board, QStringLiteral("Other")).ok());
        QCoreApplication::processEvents();
        QVERIFY(!action().isEnabled());
        m_session->targets().duplicate({&board, 1});
        QTRY_VERIFY_WITH_TIMEOUT(action().isEnabled(), kPatience);
    }

    void isKeptByExport() {
        QVERIFY(locator().use(in("pictures/planks.png")).ok());
        for (const char* path : {"mesh/dented.obj", "pictures/dented.obj", "dented.obj"}) {
            QVERIFY(m_window->exportTo(in(path)).ok());
            const Result<ImportedMesh> again = importMesh(in(path));
            QVERIFY(again.ok());
            QVERIFY2(missingTextures(again.value().mesh).empty(), path);
            QCOMPARE(again.value().mesh.images.size(), std::size_t{2});
        }
        // What was there is as it was.
        QFile library(in("mesh/board.mtl"));
        QVERIFY(library.open(QIODevice::ReadOnly) && library.readAll().contains("maps\\wood.png"));
    }

    void isRememberedWhenTheFileIsOpenedAgain() {
        QVERIFY(locator().use(in("pictures/planks.png")).ok());
        open();
        QCOMPARE(missing(), std::size_t{0});
        QVERIFY(!m_window->findChild<NoticeBar*>()->isVisible());
    }

    /// Sessions and journals take it from there.
    void theTargetKnowsWhereTheyAre() {
        QVERIFY(locator().use(in("pictures/planks.png")).ok());
        const std::vector<LocatedTexture> located = {{"maps\\wood.png", in("pictures/planks.png")},
                                                     {"tin.png", in("pictures/tin.png")}};
        QVERIFY(m_session->targets().front()->textures == located);
    }

    void saysWhenItIsNoPicture() {
        const Status used = locator().use(in("mesh/board.mtl"));
        QVERIFY(!used.ok() && !used.error().what.empty());
        QCOMPARE(missing(), std::size_t{2});
    }

private:
    [[nodiscard]] QString in(const char* name) const { return m_folder->filePath(QString::fromLatin1(name)); }
    void write(const char* name, const QByteArray& content) {
        QFile file(in(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
    }
    void paint(const char* name, const QColor& colour) {
        QImage image(8, 8, QImage::Format_RGB32);
        image.fill(colour);
        QVERIFY(image.save(in(name)));
    }
    void open() {
        m_window->openFiles({in("mesh/board.obj")});
        QTRY_VERIFY_WITH_TIMEOUT(m_session->targets().size() == 1 &&
                                     m_session->targets().front()->name == QStringLiteral("board") &&
                                     m_window->windowTitle().contains(QStringLiteral("board")),
                                 kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(m_session->tasks().current() == nullptr, kPatience);
    }
    [[nodiscard]] TextureLocator& locator() { return *m_window->findChild<TextureLocator*>(); }
    [[nodiscard]] QAction& action() {
        for (QAction* found : m_window->findChildren<QAction*>()) {
            if (found->text().contains(QStringLiteral("Missing Texture"))) {
                return *found;
            }
        }
        qFatal("no action");
    }
    [[nodiscard]] std::size_t missing() const {
        return missingTextures(m_session->targets().front()->deformed.original()).size();
    }
    /// How much redder than blue the board's lower right half is.
    [[nodiscard]] int redness() {
        Viewport& viewport = m_window->viewport();
        PictureRequest request = viewport.pictureRequest();
        request.width = 200;
        request.height = 200;
        request.camera.setPivot({0.0f, 1.0f, 0.0f}, 0.0f, 0.0f, 4.0f);
        const Result<Image> image = viewport.drawPicture(request);
        const std::size_t at = 4 * (std::size_t{115} * 200 + 115);
        return image ? image.value().pixels[at] - image.value().pixels[at + 2] : -999;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

HITSCOPE_TEST(TexturesTest, QApplication)

}  // namespace hitscope::textures_test

#include "textures_test.moc"
