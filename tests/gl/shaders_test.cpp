// SPDX-License-Identifier: GPL-3.0-or-later
#include <epoxy/gl.h>

#include <QDir>
#include <QTest>

#include "gl/program.h"
#include "gl/render_target.h"
#include "gl/shader_source.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::shaders_test {
namespace {

QString compileLog(GLenum stage, const std::string& text) {
    const GLuint shader = glCreateShader(stage);
    const char* source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    QByteArray log(4096, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    glDeleteShader(shader);
    return compiled == GL_TRUE ? QString()
                               : QStringLiteral("refused: ") + QString::fromUtf8(log.left(length));
}

GLenum stageOf(const QString& file) {
    if (file.endsWith(QStringLiteral(".vert"))) {
        return GL_VERTEX_SHADER;
    }
    if (file.endsWith(QStringLiteral(".frag"))) {
        return GL_FRAGMENT_SHADER;
    }
    if (file.endsWith(QStringLiteral(".geom"))) {
        return GL_GEOMETRY_SHADER;
    }
    return GL_COMPUTE_SHADER;
}

}  // namespace

class ShadersTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void versionThenDefinesThenCode() {
        const Result<std::string> text = gl::loadShader("capture.vert", {{"FIRST", "1"}, {"SECOND", "two"}});
        QVERIFY(text.ok());
        const QString shader = QString::fromStdString(text.value());
        QVERIFY(shader.startsWith(QStringLiteral("#version 330 core\n")));
        QCOMPARE(shader.count(QStringLiteral("#version")), 1);
        const qsizetype first = shader.indexOf(QStringLiteral("#define FIRST 1\n"));
        const qsizetype second = shader.indexOf(QStringLiteral("#define SECOND two\n"));
        const qsizetype code = shader.indexOf(QStringLiteral("#line 1 0\n"));
        QVERIFY(first > 0 && first < second && second < code);
    }

    void includesAreReplacedOnceAndKeepLines() {
        const Result<gl::ShaderSource> source = gl::assembleShader("capture.vert", {});
        QVERIFY(source.ok());
        QCOMPARE(source.value().files,
                 (std::vector<std::string>{"capture.vert", "hits.glsl", "deform.glsl", "dent_forms.glsl"}));
        const QString text = QString::fromStdString(source.value().text);
        QVERIFY(!text.contains(QStringLiteral("#include")));
        QCOMPARE(text.count(QStringLiteral("bool deform(")), 1);
        // After the include the numbering goes on in the including file, at the line the file really has.
        QFile file(QStringLiteral(HITSCOPE_SHADERS "/capture.vert"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QStringList lines = QString::fromUtf8(file.readAll()).split(u'\n');
        const qsizetype include = lines.indexOf(QStringLiteral("#include \"hits.glsl\""));
        QVERIFY(include >= 0);
        QVERIFY(text.contains(QStringLiteral("#line %1 0\n%2").arg(include + 2).arg(lines[include + 1])));
    }

    void missingFileIsNamed() {
        const Result<std::string> text = gl::loadShader("no_such.vert");
        QVERIFY(!text.ok());
        QVERIFY(text.error().message().find("no_such.vert") != std::string::npos);
    }

    void driverMessagesGetFileNames_data() {
        QTest::addColumn<QString>("log");
        QTest::addColumn<QString>("named");
        QTest::newRow("Mesa") << "0:12(5): error: syntax\n1:3(1): warning: x"
                              << "a.vert:12(5): error: syntax\nb.glsl:3(1): warning: x";
        QTest::newRow("NVIDIA") << "1(12) : error C0000"
                                << "b.glsl(12) : error C0000";
        QTest::newRow("AMD") << "ERROR: 1:12: 'x'"
                             << "ERROR: b.glsl:12: 'x'";
        QTest::newRow("unknown file") << "7:12(5): error"
                                      << "7:12(5): error";
        QTest::newRow("no place") << "1 error generated"
                                  << "1 error generated";
        QTest::newRow("empty") << ""
                               << "";
    }
    void driverMessagesGetFileNames() {
        QFETCH(const QString, log);
        QFETCH(const QString, named);
        QCOMPARE(QString::fromStdString(gl::nameFiles(log.toStdString(), {"a.vert", "b.glsl"})), named);
    }

    void refusedShaderNamesIncludedFileAndLine() {
        // The define breaks the name of the function that hits.glsl calls, so the error is in that file.
        const Result<gl::Program> program =
            gl::Program::build({"capture.vert", "", {{"applyHits", "0"}}, {"capturedPosition"}});
        QVERIFY(!program.ok());
        QCOMPARE(QString::fromStdString(program.error().where), QStringLiteral("capture.vert"));
        // "hits.glsl:12(3)" of Mesa's, "hits.glsl(12)" of NVIDIA's.
        const QString what = QString::fromStdString(program.error().what);
        QVERIFY2(what.contains(QStringLiteral("hits.glsl:")) || what.contains(QStringLiteral("hits.glsl(")),
                 qPrintable(what));
    }

    void everyShaderCompiles_data() {
        QTest::addColumn<QString>("file");
        const QDir folder(QStringLiteral(HITSCOPE_SHADERS));
        for (const QString& file : folder.entryList({QStringLiteral("*.vert"), QStringLiteral("*.frag"),
                                                     QStringLiteral("*.geom"), QStringLiteral("*.comp")},
                                                    QDir::Files, QDir::Name)) {
            for (const char* defines : {"", " with hits"}) {
                QTest::newRow(qPrintable(file + QString::fromLatin1(defines))) << file;
            }
        }
    }
    void everyShaderCompiles() {
        QFETCH(const QString, file);
        gl::Defines defines;
        if (QByteArray(QTest::currentDataTag()).endsWith("with hits")) {
            defines = {{"HITSCOPE_UNIFORM_HITS", "64"}};
        }
        const Result<std::string> text = gl::loadShader(file.toStdString(), defines);
        QVERIFY2(text.ok(), text.ok() ? "" : text.error().message().c_str());
        QCOMPARE(compileLog(stageOf(file), text.value()), QString());
    }

    void uniformsArriveAndUnknownOnesAreNoError() {
        const Result<gl::Program> built =
            gl::Program::build({"capture.vert", "", {{"HITSCOPE_UNIFORM_HITS", "8"}}, {"capturedPosition"}});
        QVERIFY2(built.ok(), built.ok() ? "" : built.error().message().c_str());
        const gl::Program& program = built.value();
        program.use();
        program.set("u_hitCount", 5);
        program.set("u_notThere", 1.0f);
        GLint count = 0;
        glGetUniformiv(program.id(), program.location("u_hitCount"), &count);
        QCOMPARE(count, 5);
        QCOMPARE(program.location("u_notThere"), -1);
        glUseProgram(0);
    }

    void renderTargetReadsTopRowFirst_data() {
        QTest::addColumn<int>("samples");
        QTest::newRow("one sample") << 1;
        QTest::newRow("four samples") << 4;
        QTest::newRow("more than any driver has") << 4096;
    }
    void renderTargetReadsTopRowFirst() {
        QFETCH(const int, samples);
        const gl::RenderTarget target(4, 3, samples);
        QVERIFY(target.isComplete());
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
        glClearColor(0, 0, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 2, 4, 1);  // OpenGL counts rows from below
        glClearColor(1, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        glDisable(GL_SCISSOR_TEST);
        const Image image = target.read();
        GLint bound = 0;
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
        QCOMPARE(static_cast<GLuint>(bound), target.framebuffer());
        QCOMPARE(image.pixels.size(), std::size_t{48});
        QCOMPARE(std::vector<std::uint8_t>(image.pixels.begin(), image.pixels.begin() + 4),
                 (std::vector<std::uint8_t>{255, 0, 0, 255}));
        QCOMPARE(std::vector<std::uint8_t>(image.pixels.begin() + 16, image.pixels.begin() + 20),
                 (std::vector<std::uint8_t>{0, 0, 255, 255}));
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }

    void errorsAreTakenOnce() {
        glEnable(GL_TEXTURE_2D + 12345);
        QCOMPARE(gl::takeErrors().size(), std::size_t{1});
        QVERIFY(gl::takeErrors().empty());
    }

    void rendererSaysWhatItIs() {
        const gl::RendererInfo info = gl::rendererInfo();
        QVERIFY(info.major > 3 || (info.major == 3 && info.minor >= 3));
        QVERIFY(!info.renderer.empty() && !info.version.empty());
        QVERIFY(info.maxVertexUniformComponents >= 1024);
        qInfo("%s, OpenGL %s, %d vertex uniform components", info.renderer.c_str(), info.version.c_str(),
              info.maxVertexUniformComponents);
    }

private:
    test::GlFixture m_gl;
};

HITSCOPE_TEST(ShadersTest, QCoreApplication)

}  // namespace hitscope::shaders_test

#include "shaders_test.moc"
