// SPDX-License-Identifier: GPL-3.0-or-later
// Refined pictures: what the mean of their samples comes to.
#include <epoxy/gl.h>

#include <QTest>
#include <algorithm>
#include <cmath>
#include <memory>

#include "refined_scene.h"
#include "render/refined/refined_picture.h"
#include "support/baseline.h"
#include "support/test_program.h"

namespace hitscope::refined_test {

using namespace test;

namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

/// Each pixel the mean of side x side.
QImage shrunk(const QImage& large, int side) {
    QImage small(large.width() / side, large.height() / side, QImage::Format_RGB32);
    for (int y = 0; y < small.height(); ++y) {
        for (int x = 0; x < small.width(); ++x) {
            int sums[3] = {};
            for (int i = 0; i < side * side; ++i) {
                const QRgb pixel = large.pixel(side * x + i % side, side * y + i / side);
                sums[0] += qRed(pixel);
                sums[1] += qGreen(pixel);
                sums[2] += qBlue(pixel);
            }
            const int count = side * side;
            const auto mean = [count](int sum) { return (sum + count / 2) / count; };
            small.setPixel(x, y, qRgb(mean(sums[0]), mean(sums[1]), mean(sums[2])));
        }
    }
    return small;
}

int green(const QImage& image, int x, int y) {
    return qGreen(image.pixel(x, y));
}

}  // namespace

class RefinedTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void cleanup() { QCOMPARE(m_refined.gl.errors(), QStringList()); }
    void cleanupTestCase();
    void samplesAreSpread();
    void convergesToTheMean();
    void sameBitsAgain();
    void coloursOfChangeStay();
    void dentsGetDarker();
    void theFloorIsThereInAllModes();
    void theFloorIsSmoothlyOccluded();
    void shadowsGetSoft();
    void environmentIsRefined();
    void orthographicHasOcclusion();
    void marksAreCrisp();
    void transparentStaysSo();
    void nextSizeStartsAnew();

private:
    [[nodiscard]] Frame frame(const DisplayOptions& options = {}) const;
    /// The mean of so many samples.
    [[nodiscard]] QImage refined(const Frame& frame, int samples);
    [[nodiscard]] QImage shown(const Frame& frame) { return m_refined.shown(frame, *m_picture); }
    [[nodiscard]] QImage plain(const Frame& frame, int samples = 1) {
        return picture(*m_refined.renderer, frame, *m_refined.pipeline, samples);
    }

    RefinedScene m_refined;
    std::unique_ptr<RefinedPicture> m_picture;
};

void RefinedTest::initTestCase() {
    m_refined.open();
    m_picture = std::make_unique<RefinedPicture>();
}

void RefinedTest::cleanupTestCase() {
    m_picture.reset();
    m_refined.close();
}

Frame RefinedTest::frame(const DisplayOptions& options) const {
    Frame made = m_refined.frame(kWidth, kHeight, options);
    if (options.change.on) {
        made.change = ShownChange{options.change.quantity, options.change.style().map,
                                  options.change.style().fixed, 0.0f};
    }
    return made;
}

QImage RefinedTest::refined(const Frame& frame, int samples) {
    m_picture->clear();
    while (m_picture->samples() < samples) {
        glViewport(0, 0, 5, 5);  // what the caller has
        if (const Status added = m_refined.renderer->refine(frame, *m_refined.pipeline, *m_picture); !added) {
            QTest::qFail(added.error().message().c_str(), __FILE__, __LINE__);
            return {};
        }
    }
    return shown(frame);
}

void RefinedTest::samplesAreSpread() {
    for (const int count : {4, 16, 64}) {
        glm::vec2 middle(0.0f);
        std::vector<int> columns(4, 0);
        for (int i = 0; i < count; ++i) {
            const RefinedPicture::Sample sample = RefinedPicture::sampleAt(i);
            QVERIFY(std::max(std::abs(sample.jitter.x), std::abs(sample.jitter.y)) < 0.54f);
            QVERIFY(glm::dot(sample.light, sample.light) <= 1.0001f);
            middle += sample.jitter / static_cast<float>(count);
            ++columns[static_cast<std::size_t>(std::clamp(4.0f * (sample.jitter.x + 0.5f), 0.0f, 3.0f))];
        }
        QVERIFY2(std::max(std::abs(middle.x), std::abs(middle.y)) < 0.5f / static_cast<float>(count) + 0.03f,
                 qPrintable(QStringLiteral("%1: %2, %3").arg(count).arg(middle.x).arg(middle.y)));
        QVERIFY(*std::min_element(columns.begin(), columns.end()) >= std::max(1, count / 5));
    }
}

/// Lit as ever and with no floor, a sample is the frame itself, off by a part of a pixel: their mean is that
/// of a larger picture's pixels.
void RefinedTest::convergesToTheMean() {
    DisplayOptions options{.floor = false, .transparent = true};
    options.change.on = true;
    Frame large = frame(options);
    large.width *= 8;
    large.height *= 8;
    const QImage reference = shrunk(plain(large), 8);
    const double once = meanDifference(plain(frame(options)), reference);
    const double four = meanDifference(refined(frame(options), 4), reference);
    const double sixteen = meanDifference(refined(frame(options), 16), reference);
    const double most = meanDifference(refined(frame(options), 64), reference);
    const QString all = QStringLiteral("%1 %2 %3 %4").arg(once).arg(four).arg(sixteen).arg(most);
    QVERIFY2(four < 0.75 * once && sixteen < 0.25 * once && most < 1.2 * sixteen, qPrintable(all));
    // Where a colour jumps; how the reference's pixels are rounded decides whether one is 12 levels off
    // or 13.
    QCOMPARE(differing(refined(frame(options), 64), reference, 13), 0);
}

void RefinedTest::sameBitsAgain() {
    const DisplayOptions options{.shadows = true};
    const QImage first = refined(frame(options), 16);
    static_cast<void>(refined(frame(DisplayOptions{.environment = true}), 3));
    QCOMPARE(differing(first, refined(frame(options), 16)), 0);
    QVERIFY(differing(first, refined(frame(options), 15)) > 0);
}

/// Colours that stand for a quantity mean what the bar says: nothing darkens them.
void RefinedTest::coloursOfChangeStay() {
    DisplayOptions options{.floor = false, .shadows = true};
    options.change.on = true;
    const QImage once = plain(frame(options));
    const QImage mean = refined(frame(options), 16);
    int inside = 0;
    int off = 0;
    for (int y = 1; y + 1 < kHeight; ++y) {
        for (int x = 1; x + 1 < kWidth; ++x) {
            // Where the picture is smooth, half a pixel aside is nothing.
            int steep = 0;
            for (int i = 0; i < 9; ++i) {
                steep = std::max(steep, levels(once.pixel(x, y), once.pixel(x + i % 3 - 1, y + i / 3 - 1)));
            }
            inside += steep <= 3 ? 1 : 0;
            off += steep <= 3 && levels(once.pixel(x, y), mean.pixel(x, y)) > 2 ? 1 : 0;
        }
    }
    QVERIFY2(inside > 5000 && off == 0, qPrintable(QStringLiteral("%1 of %2").arg(off).arg(inside)));
}

void RefinedTest::dentsGetDarker() {
    const Frame view = frame(DisplayOptions{.floor = false});
    const QImage once = plain(view);
    const QImage mean = refined(view, 16);
    int darker = 0;
    int brighter = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const int change = green(mean, x, y) - green(once, x, y);
            darker += change < -10 ? 1 : 0;
            brighter += change > 10 ? 1 : 0;
        }
    }
    // The dent, and nothing of the convex rest but its outline.
    QVERIFY2(darker > 150 && darker < 3000 && brighter < darker / 3,
             qPrintable(QStringLiteral("%1, %2").arg(darker).arg(brighter)));
}

/// Its layers are drawn in a way of their own, with occlusion or, as in two of these modes, without.
void RefinedTest::theFloorIsThereInAllModes() {
    DisplayOptions change;
    change.change.on = true;
    for (const DisplayOptions& with :
         {DisplayOptions(), change, DisplayOptions{.wireframe = WireframeMode::Only}}) {
        m_picture = std::make_unique<RefinedPicture>();  // with nothing left in its layers
        DisplayOptions without = with;
        without.floor = false;
        const QRect beside(kWidth * 4 / 5, kHeight / 2, kWidth / 5, kHeight / 2);
        const QImage floor = plain(frame(with)).copy(beside);
        const double seen = meanDifference(floor, plain(frame(without)).copy(beside));
        QVERIFY(seen > 5.0);
        const double off = meanDifference(refined(frame(with), 4).copy(beside), floor);
        QVERIFY2(off < 0.3 * seen, qPrintable(QStringLiteral("%1 of %2").arg(off).arg(seen)));
    }
}

/// Of many samples from the start: between few of them, pixels would be spotted.
void RefinedTest::theFloorIsSmoothlyOccluded() {
    TestScene scene;
    scene.add(*m_refined.renderer, makeCube(8, 2.0f), glm::vec3(0.0f, 1.0f, 0.0f));
    scene.showTrueNormals({});
    const auto pipeline = scene.pipeline(PipelineKind::TransformFeedback, {});
    const auto drawn = [&](const DisplayOptions& options, int samples) {
        Frame view = frameOf(scene, kWidth, kHeight);
        view.options = options;
        if (samples == 0) {
            return picture(*m_refined.renderer, view, *pipeline, 1);
        }
        RefinedPicture refined;
        while (refined.samples() < samples) {
            if (!m_refined.renderer->refine(view, *pipeline, refined).ok()) {
                return QImage();
            }
        }
        const ::hitscope::gl::RenderTarget target(kWidth, kHeight, 1);
        if (!m_refined.renderer->drawRefined(view, *pipeline, refined, target.framebuffer()).ok()) {
            return QImage();
        }
        const Image image = target.read();
        return QImage(image.pixels.data(), image.width, image.height, QImage::Format_RGBA8888).copy();
    };
    const QImage target = drawn({.floor = false, .transparent = true}, 0);
    const QImage before = drawn({}, 0);
    const QImage few = drawn({}, 4);
    const QImage many = drawn({}, 64);
    const auto isBeside = [&target](int x, int y) {
        for (int i = 0; i < 9; ++i) {
            if (qAlpha(target.pixel(x - 1 + i % 3, y - 1 + i / 3)) != 0) {
                return false;
            }
        }
        return true;
    };
    int darker = 0;
    for (int y = 1; y < kHeight - 1; ++y) {
        for (int x = 1; x < kWidth - 1; ++x) {
            if (isBeside(x, y)) {
                QVERIFY2(std::abs(green(few, x, y) - green(many, x, y)) <= 2,
                         qPrintable(QStringLiteral("%1, %2").arg(x).arg(y)));
                darker += green(many, x, y) + 4 < green(before, x, y) ? 1 : 0;
            }
        }
    }
    QVERIFY2(darker > 20, qPrintable(QString::number(darker)));
}

void RefinedTest::shadowsGetSoft() {
    Frame view = frame(DisplayOptions{.shadows = true});
    view.camera.orbit(0.0f, 0.5f);
    view.camera.zoom(1.6f);
    for (PointLight& light : view.lights.points) {
        light.on = false;
    }
    view.lights.spot.on = false;
    const QImage cover = plain([&view] {
        Frame alone = view;
        alone.options = DisplayOptions{.floor = false, .transparent = true};
        return alone;
    }());
    // Pixels of the shadow's edge on the floor: neither lit nor dark.
    const auto between = [this, &view, &cover](bool refine) {
        Frame bare = view;
        bare.options.shadows = false;
        const QImage with = refine ? refined(view, 32) : plain(view);
        const QImage without = refine ? refined(bare, 32) : plain(bare);
        int deepest = 0;
        for (int pass = 0, count = 0; pass < 2; ++pass) {
            for (int y = 0; y < kHeight; ++y) {
                for (int x = 0; x < kWidth; ++x) {
                    if (qAlpha(cover.pixel(x, y)) != 0) {
                        continue;
                    }
                    const int lost = green(without, x, y) - green(with, x, y);
                    deepest = pass == 0 ? std::max(deepest, lost) : deepest;
                    count += pass == 1 && lost > deepest / 5 && lost < deepest * 4 / 5 ? 1 : 0;
                }
            }
            if (pass == 1) {
                return count;
            }
        }
        return 0;
    };
    const int hard = between(false);
    const int soft = between(true);
    // With a light of no size it would be less than six times as many.
    QVERIFY2(soft > hard * 6, qPrintable(QStringLiteral("%1, %2").arg(hard).arg(soft)));
}

void RefinedTest::environmentIsRefined() {
    for (const SurfaceLook look : {SurfaceLook::Matcap, SurfaceLook::Clay, SurfaceLook::Metal}) {
        const Frame view = frame(DisplayOptions{.shadows = true, .look = look, .environment = true});
        const QImage mean = refined(view, 8);
        QVERIFY(differing(mean, plain(view), 4) > 300);
        QVERIFY(differing(mean, plain(view), 90) < kWidth * kHeight / 20);
    }
}

void RefinedTest::orthographicHasOcclusion() {
    Frame view = frame(DisplayOptions{.floor = false});
    const auto darkest = [this](const Frame& seen) {
        const QImage mean = refined(seen, 16);
        const QImage once = plain(seen);
        int sum = 0;
        for (int y = kHeight / 4; y < kHeight * 3 / 4; ++y) {
            for (int x = kWidth / 3; x < kWidth * 2 / 3; ++x) {
                sum += std::max(0, green(once, x, y) - green(mean, x, y));
            }
        }
        return sum;
    };
    const int perspective = darkest(view);
    view.camera.setProjection(Projection::Orthographic);
    const int orthographic = darkest(view);
    QVERIFY2(perspective > 1000 && orthographic > perspective / 2 && orthographic < 2 * perspective,
             qPrintable(QStringLiteral("%1, %2").arg(perspective).arg(orthographic)));
}

/// What is drawn over the scene is not part of the mean, and the scene hides it as ever.
void RefinedTest::marksAreCrisp() {
    Frame view = frame(DisplayOptions{.floor = false, .crosshair = true});
    const QImage bare = [&] {
        Frame without = view;
        without.options.crosshair = false;
        return refined(without, 16);
    }();
    // The picture is that of before: only what is over it is drawn.
    const QImage crossed = shown(view);
    const int changed = differing(bare, crossed, 20);
    Frame once = view;
    once.options.crosshair = false;
    const int changedOnce = differing(plain(once), plain(view), 20);
    QVERIFY2(changed > 20 && std::abs(changed - changedOnce) < changedOnce / 4 + 4,
             qPrintable(QStringLiteral("%1, %2").arg(changed).arg(changedOnce)));
}

void RefinedTest::transparentStaysSo() {
    const Frame view = frame(DisplayOptions{.floor = false, .transparent = true});
    const QImage mean = refined(view, 16);
    QCOMPARE(qAlpha(mean.pixel(2, 2)), 0);
    QCOMPARE(qAlpha(mean.pixel(kWidth / 2, kHeight / 2)), 255);
    int partly = 0;
    for (int x = 0; x < kWidth; ++x) {
        const int alpha = qAlpha(mean.pixel(x, kHeight / 2));
        partly += alpha > 0 && alpha < 255 ? 1 : 0;
    }
    QVERIFY(partly >= 1 && partly <= 4);
}

void RefinedTest::nextSizeStartsAnew() {
    Frame view = frame();
    static_cast<void>(refined(view, 2));
    view.width = 100;
    for (int step = 0; step < 3; ++step) {  // the plain picture, what samples have in common, a sample
        QVERIFY(m_refined.renderer->refine(view, *m_refined.pipeline, *m_picture).ok());
        QVERIFY(m_picture->hasPicture());
        QCOMPARE(m_picture->isBegun(), step > 0);
        QCOMPARE(m_picture->samples(), step < 2 ? 0 : 1);
    }
    QCOMPARE(shown(view).width(), 100);
}

HITSCOPE_TEST(RefinedTest, QCoreApplication)

}  // namespace hitscope::refined_test

#include "refined_test.moc"
