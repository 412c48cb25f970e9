// SPDX-License-Identifier: GPL-3.0-or-later
// Refined pictures that are drawn in parts, and what is there before their first sample.
#include <QTest>

#include "gl/context.h"
#include "refined_scene.h"
#include "render/refined/refined_picture.h"
#include "support/baseline.h"
#include "support/test_program.h"

namespace hitscope::refined_parts_test {

using namespace test;

class RefinedPartsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_refined.open(); }
    void cleanup() { QCOMPARE(m_refined.gl.errors(), QStringList()); }
    void cleanupTestCase() { m_refined.close(); }
    void beforeSamplesItIsThePicture();
    void whatWasDrawnIsNotDrawnAgain();
    void inPartsItIsTheSame();
    void partsSurviveOtherPictures();
    void dentsMayComeBetweenParts();

private:
    [[nodiscard]] Frame frame(const DisplayOptions& options = {}) const {
        return m_refined.frame(160, 120, options);
    }
    [[nodiscard]] bool add(const Frame& frame, RefinedPicture& picture) {
        return m_refined.renderer->refine(frame, *m_refined.pipeline, picture).ok();
    }
    [[nodiscard]] QImage shown(const Frame& frame, RefinedPicture& picture) {
        return m_refined.shown(frame, picture);
    }
    [[nodiscard]] QImage refined(const Frame& frame, int samples);

    RefinedScene m_refined;
};

/// Each sample in one.
QImage RefinedPartsTest::refined(const Frame& frame, int samples) {
    RefinedPicture picture;
    while (picture.samples() < samples && add(frame, picture)) {
    }
    return shown(frame, picture);
}

/// What is drawn before the first sample is what draw() draws, to the bit: a window shows it.
void RefinedPartsTest::beforeSamplesItIsThePicture() {
    DisplayOptions options;
    for (const bool shadows : {true, false}) {
        options.shadows = shadows;
        const Frame wanted = frame(options);
        RefinedPicture made;
        QVERIFY(add(wanted, made));
        QVERIFY(made.hasPicture());
        QCOMPARE(made.samples(), 0);
        QCOMPARE(shown(wanted, made), picture(*m_refined.renderer, wanted, *m_refined.pipeline, 1));
    }
}

/// A window draws what comes before the first sample as its picture; samples go on with that.
void RefinedPartsTest::whatWasDrawnIsNotDrawnAgain() {
    DisplayOptions options;
    options.shadows = true;
    const Frame wanted = frame(options);
    const QImage whole = refined(wanted, 3);
    RefinedPicture made(RefinedPicture::Extent::WhereItVaries, 1000);
    DisplayOptions light = options;
    light.theme = Theme::Light;
    for (const Frame& drawn : {frame(light), wanted}) {
        QVERIFY(m_refined.renderer->drawPlain(drawn, *m_refined.pipeline, made).ok());
        QVERIFY(made.hasPicture() && !made.isBegun());
        QCOMPARE(shown(drawn, made), picture(*m_refined.renderer, drawn, *m_refined.pipeline, 1));
    }
    QVERIFY(add(wanted, made));
    QVERIFY(made.isBegun());
    QCOMPARE(made.samples(), 0);
    for (int calls = 0; made.samples() < 3 && calls < 1000; ++calls) {
        QVERIFY(add(wanted, made));
    }
    QVERIFY(differing(shown(wanted, made), whole) <= 2);
    QVERIFY(m_refined.renderer->drawPlain(wanted, *m_refined.pipeline, made).ok());
    QVERIFY(made.samples() == 0 && !made.isBegun());
}

/// The sphere's 12,000 triangles, in thirteen parts of a sample and of its shadows.
void RefinedPartsTest::inPartsItIsTheSame() {
    if (!gl::rendererInfo().isSoftware()) {
        QSKIP("only software renderers draw in parts");
    }
    DisplayOptions options;
    for (const bool shadows : {true, false}) {
        options.shadows = shadows;
        const Frame wanted = frame(options);
        const QImage whole = refined(wanted, 3);
        RefinedPicture made(RefinedPicture::Extent::WhereItVaries, 1000);
        int calls = 0;
        while (made.samples() < 3 && calls < 1000) {
            QVERIFY(add(wanted, made));
            ++calls;
            // What comes before the first sample is a picture too.
            QCOMPARE(made.hasPicture(), calls >= 13);
        }
        QVERIFY2(calls > 4 * 12, qPrintable(QString::number(calls)));
        // The order of triangles is another, which decides where two have the same depth.
        const int pixels = differing(shown(wanted, made), whole);
        QVERIFY2(pixels <= 8, qPrintable(QString::number(pixels)));
    }
}

/// Another picture that the same renderer draws takes the map of shadows away.
void RefinedPartsTest::partsSurviveOtherPictures() {
    if (!gl::rendererInfo().isSoftware()) {
        QSKIP("only software renderers draw in parts");
    }
    const Frame wanted = frame();
    Frame otherLight = wanted;
    otherLight.lights.directional.direction = {-0.6f, -0.5f, 0.4f};
    const QImage whole = refined(wanted, 2);
    RefinedPicture made(RefinedPicture::Extent::WhereItVaries, 1000);
    RefinedPicture other;
    for (int calls = 0; made.samples() < 2 && calls < 1000; ++calls) {
        QVERIFY(add(wanted, made));
        if (calls % 31 == 30) {
            QVERIFY(add(otherLight, other));
        }
    }
    QCOMPARE(made.samples(), 2);
    QVERIFY(differing(shown(wanted, made), whole) <= 2);
}

/// Of the shadows, only what two dents have moved is drawn again, and the second comes before the first has
/// been drawn.
void RefinedPartsTest::dentsMayComeBetweenParts() {
    if (!gl::rendererInfo().isSoftware()) {
        QSKIP("only software renderers draw in parts");
    }
    DisplayOptions options;
    options.shadows = true;
    Frame wanted = frame(options);
    const auto addParts = [&](RefinedPicture& made, int most) {
        int calls = 0;
        while (!made.hasPicture() && calls < most && add(wanted, made)) {
            ++calls;
        }
        return calls;
    };
    RefinedPicture before(RefinedPicture::Extent::WhereItVaries, 1000);
    addParts(before, 100);
    QVERIFY(before.hasPicture());
    RefinedPicture made(RefinedPicture::Extent::WhereItVaries, 1000);
    Hit hit = dents({1}, 1).front();
    for (const float along : {2.2f, -2.2f}) {
        hit.point = {along, std::sqrt(2.5f * 2.5f - along * along), 0.0f};
        hit.direction = -hit.point / 2.5f;
        hit.constants = {0.4f, 0.2f, 0.4f};
        m_refined.pipeline->append(std::span(&hit, 1));
        ++wanted.meshRevision;
        QVERIFY(addParts(made, along > 0.0f ? 3 : 100) >= 3);
    }
    QVERIFY(made.hasPicture());
    const QImage inParts = shown(wanted, made);
    const auto other = Renderer::create();
    QVERIFY(other);
    QCOMPARE(inParts, picture(*other.value(), wanted, *m_refined.pipeline, 1));
    QVERIFY(differing(inParts, shown(wanted, before)) > 20);
}

HITSCOPE_TEST(RefinedPartsTest, QCoreApplication)

}  // namespace hitscope::refined_parts_test

#include "refined_parts_test.moc"
