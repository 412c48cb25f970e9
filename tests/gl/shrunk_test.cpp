// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/shrunk.h"

#include <QTest>
#include <cstdlib>

#include "gl/render_target.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::shrunk_test {

namespace {

constexpr int kWidth = 330;
constexpr int kHeight = 210;

/// Red above, of which the right half is green.
void paint(const gl::RenderTarget& target) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    glEnable(GL_SCISSOR_TEST);
    const auto fill = [](int x, int y, int width, int height, float red, float green) {
        glScissor(x, y, width, height);
        glClearColor(red, green, 0.25f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
    };
    fill(0, 0, kWidth, kHeight, 0.0f, 0.0f);
    fill(0, kHeight / 2, kWidth, kHeight, 1.0f, 0.0f);
    fill(kWidth / 2, kHeight / 2, kWidth, kHeight, 0.0f, 1.0f);
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

bool isAbout(const Image& image, int x, int y, int red, int green) {
    const std::uint8_t* pixel = image.pixels.data() + 4 * (y * image.width + x);
    return std::abs(pixel[0] - red) < 3 && std::abs(pixel[1] - green) < 3 && std::abs(pixel[2] - 64) < 3;
}

}  // namespace

class ShrunkTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void isThePictureSmall_data() {
        QTest::addColumn<int>("samples");
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::newRow("an eleventh") << 1 << 30 << 19;
        QTest::newRow("of samples") << 4 << 30 << 19;
        QTest::newRow("less than a half") << 1 << 120 << 76;
        QTest::newRow("as large") << 4 << kWidth << kHeight;
        QTest::newRow("one pixel") << 1 << 1 << 1;
    }
    void isThePictureSmall() {
        QFETCH(int, samples);
        QFETCH(int, width);
        QFETCH(int, height);
        const gl::RenderTarget target(kWidth, kHeight, samples);
        QVERIFY(target.isComplete());
        paint(target);
        GLint texture = -1;
        GLint framebuffer = -1;
        const Image small = gl::shrunk(target.framebuffer(), kWidth, kHeight, width, height);
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
        glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &framebuffer);
        QCOMPARE(texture, 0);
        QCOMPARE(framebuffer, 0);
        QCOMPARE(small.width, width);
        QCOMPARE(small.height, height);
        if (width > 1) {
            QVERIFY(isAbout(small, width / 4, height / 4, 255, 0));
            QVERIFY(isAbout(small, 3 * width / 4, height / 4, 0, 255));
            QVERIFY(isAbout(small, width / 4, 3 * height / 4, 0, 0));
            QVERIFY(isAbout(small, 3 * width / 4, 3 * height / 4, 0, 0));
        } else {
            QVERIFY(small.pixels[0] > 40 && small.pixels[0] < 90);  // all of it, not one place
        }
    }

private:
    test::GlFixture m_gl;
};

HITSCOPE_TEST(ShrunkTest, QCoreApplication)

}  // namespace hitscope::shrunk_test

#include "shrunk_test.moc"
