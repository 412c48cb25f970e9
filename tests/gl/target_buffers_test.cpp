// SPDX-License-Identifier: GPL-3.0-or-later
// What a target has on the GPU, brought there at once or part by part, before the session has it or after.
#include "pipeline/target_buffers.h"

#include <epoxy/gl.h>

#include <QTest>
#include <cstring>
#include <limits>

#include "mesh/coarse_triangles.h"
#include "mesh/primitives.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::target_buffers_test {

namespace {

template <class T>
std::vector<T> contentOf(GLuint buffer) {
    GLint bytes = 0;
    glBindBuffer(GL_COPY_READ_BUFFER, buffer);
    glGetBufferParameteriv(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &bytes);
    std::vector<T> content(static_cast<std::size_t>(bytes) / sizeof(T));
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, bytes, content.data());
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    return content;
}

template <class A, class B>
bool same(const A& a, const B& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), std::span(a).size_bytes()) == 0;
}

/// The buffer that an attribute of a vertex array comes from.
GLuint bufferAt(GLuint array, Attribute attribute) {
    GLint buffer = 0;
    glBindVertexArray(array);
    glGetVertexAttribiv(static_cast<GLuint>(attribute), GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &buffer);
    glBindVertexArray(0);
    return static_cast<GLuint>(buffer);
}

GLuint indicesOf(GLuint array) {
    GLint buffer = 0;
    glBindVertexArray(array);
    glGetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &buffer);
    glBindVertexArray(0);
    return static_cast<GLuint>(buffer);
}

RenderMesh meshWithCoarse() {
    RenderMesh mesh = buildRenderMesh(makeUvSphere(90, 60, 1.0f));
    mesh.coarseTriangles.assign(mesh.triangles.begin(), mesh.triangles.begin() + 300);
    mesh.coarseDraws = {{0, 300, kNoIndex}};
    return mesh;
}

}  // namespace

class TargetBuffersTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { static_cast<void>(m_gl.open()); }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void comeInParts_data() {
        QTest::addColumn<std::size_t>("bytes");
        QTest::newRow("all") << std::numeric_limits<std::size_t>::max();
        QTest::newRow("one") << std::size_t{1};
        QTest::newRow("some") << std::size_t{1000};
        QTest::newRow("whole normals") << std::size_t{1200};
        QTest::newRow("many") << std::size_t{100'000};
    }
    void comeInParts() {
        QFETCH(std::size_t, bytes);
        const RenderMesh mesh = meshWithCoarse();
        TargetBuffers buffers(mesh, {}, TargetBuffers::Later{});
        std::size_t calls = 1;
        while (!buffers.fillMore(bytes)) {
            ++calls;
        }
        const std::size_t all = 2 * mesh.vertices.size() * sizeof(DynamicVertex) +
                                mesh.vertices.size() * (sizeof(glm::vec2) + sizeof(glm::vec3)) +
                                (mesh.triangles.size() + 300) * sizeof(std::uint32_t);
        QVERIFY(calls >= all / std::max(bytes, sizeof(glm::vec3)));  // no more than so many at once
        QVERIFY(same(contentOf<DynamicVertex>(buffers.dynamicBuffer()), mesh.vertices));
        QVERIFY(same(contentOf<DynamicVertex>(buffers.originalBuffer()), mesh.vertices));
        QVERIFY(same(contentOf<glm::vec2>(bufferAt(buffers.surfaceArray(), Attribute::Texcoord)),
                     mesh.texcoords));
        std::vector<glm::vec3> normals;
        for (const DynamicVertex& vertex : mesh.vertices) {
            normals.push_back(vertex.normal);
        }
        QVERIFY(same(contentOf<glm::vec3>(buffers.shadingNormalBuffer()), normals));
        RawVector<std::uint32_t> triangles = mesh.triangles;
        triangles.insert(triangles.end(), mesh.coarseTriangles.begin(), mesh.coarseTriangles.end());
        QVERIFY(same(contentOf<std::uint32_t>(indicesOf(buffers.surfaceArray())), triangles));
    }

    void edgesComeWhenTheyAreDrawn() {
        const RenderMesh mesh = buildRenderMesh(makeUvSphere(20, 10, 1.0f));
        const TargetBuffers buffers(mesh);
        glBindVertexArray(buffers.surfaceArray());
        const GLuint array = buffers.edgeArray();
        GLint bound = 0;
        glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
        QCOMPARE(static_cast<GLuint>(bound), buffers.surfaceArray());  // in the middle of a frame
        QVERIFY(same(contentOf<std::uint32_t>(indicesOf(array)), mesh.edges));
        QCOMPARE(indicesOf(buffers.originalEdgeArray()), indicesOf(array));
        QCOMPARE(buffers.edgeRuns().runs()[0].first, 0u);
    }

private:
    test::GlFixture m_gl;
};

HITSCOPE_TEST(TargetBuffersTest, QCoreApplication)

}  // namespace hitscope::target_buffers_test

#include "target_buffers_test.moc"
