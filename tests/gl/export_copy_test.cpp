// SPDX-License-Identifier: GPL-3.0-or-later
// An export is written while the window goes on, and its copy shares with the target what no hit has changed.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "mesh/primitives.h"
#include "scene/scene_gpu.h"
#include "session/export/export_target.h"
#include "session/session.h"
#include "session/shots/demo_shots.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::export_copy_test {

class ExportCopyTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void laterHitsAreNotInIt_data() {
        QTest::addColumn<NormalMode>("normals");
        QTest::addColumn<int>("shots");
        QTest::newRow("few vertices") << NormalMode::True << 3;
        QTest::newRow("most vertices") << NormalMode::True << 300;
        QTest::newRow("the paper's normals") << NormalMode::Paper << 3;
    }
    void laterHitsAreNotInIt() {
        QFETCH(const NormalMode, normals);
        QFETCH(const int, shots);
        Session session;
        session.loadScene({QStringLiteral("one"), {planMesh(makeHighPolySphere())}});
        Result<std::unique_ptr<SceneGpu>> gpu = SceneGpu::create(session);
        QVERIFY(gpu);
        shootAll(session, demoShots(session, shots, 2));
        QVERIFY(gpu.value()->sync());
        const Target& sphere = *session.targets().front();
        const DeformedMesh& mesh = sphere.deformed;
        QCOMPARE(2 * mesh.onceChanged().size() < mesh.positions().size(), shots == 3);
        const Target* const one = &sphere;
        const ExportOptions options{.normals = normals};
        const SceneExport copy = copyForExport(session, {&one, 1}, options);
        QVERIFY(exportTarget(session, sphere, path("now.obj"), options).ok());
        shootAll(session, demoShots(session, 3, 5));
        QVERIFY(gpu.value()->sync());
        QVERIFY(writeExport(copy, path("copy.obj")).ok());
        QVERIFY(exportTarget(session, sphere, path("later.obj"), options).ok());
        QVERIFY(!contentOf("now.obj").isEmpty());
        QVERIFY(contentOf("copy.obj") == contentOf("now.obj"));
        QVERIFY(contentOf("later.obj") != contentOf("now.obj"));
    }

private:
    [[nodiscard]] QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    [[nodiscard]] QByteArray contentOf(const char* name) const {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    test::GlFixture m_gl;
    QTemporaryDir m_folder;
};

HITSCOPE_TEST(ExportCopyTest, QCoreApplication)

}  // namespace hitscope::export_copy_test

#include "export_copy_test.moc"
