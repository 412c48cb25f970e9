// SPDX-License-Identifier: GPL-3.0-or-later
// The window's picture refines itself at rest, stops, and begins anew with each change.
#include <QAction>
#include <QApplication>
#include <QDir>
#include <QImageReader>
#include <QMenu>
#include <QSettings>
#include <QSignalSpy>
#include <algorithm>
#include <array>

#include "app/actions/picture_actions.h"
#include "gl/context.h"
#include "mesh/geodesic_sphere.h"
#include "mesh/primitives.h"
#include "panels/frame_rate/frame_graph.h"
#include "panels/help/help_text.h"
#include "scene/picture.h"
#include "support/baseline.h"
#include "support/test_program.h"
#include "viewport/picture_refiner.h"
#include "widgets/window_support.h"

namespace hitscope::refine_test {

class RefineTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init();
    void cleanup() { dropWindow(); }
    void stopsAtSixteen();
    void changesBeginAnew_data();
    void changesBeginAnew();
    void whatIsOverItDoesNot();
    void offForgets();
    void slowPicturesAreCoarseFirst();
    void eventsComeWhileAPictureIsDrawn();
    void frameRateWaitsForIt();
    void measuringIsWithout();
    void savedAreTheSameToTheBit();
    void copiedAreAsShown();
    void turntableIsOneClick();
    void environmentTurnsLightsOff();

private:
    [[nodiscard]] Viewport& viewport() { return m_window->viewport(); }
    [[nodiscard]] PictureRefiner& refiner() { return viewport().pictures().refiner(); }
    void waitUntilRefined() {
        QTRY_COMPARE_WITH_TIMEOUT(refiner().samples(), kShownSamples, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(refiner().wasShown(), kPatience);
    }
    void set(const std::function<void(DisplayOptions&)>& how) {
        DisplayOptions options = viewport().options();
        how(options);
        viewport().setOptions(options);
    }
};

void RefineTest::init() {
    makeWindow();
    // The samples are few pixels each, so that a slow renderer is no trouble.
    m_window->resize(700, 500);
    set([](DisplayOptions& options) { options.refine = true; });
    waitUntilRefined();
}

void RefineTest::stopsAtSixteen() {
    const QSignalSpy samples(&refiner(), &PictureRefiner::refined);
    const QSignalSpy frames(&viewport().pictures(), &PictureFlow::framePainted);
    QTest::qWait(1500);
    QCOMPARE(samples.size(), 0);
    QCOMPARE(frames.size(), 0);
    QCOMPARE(refiner().samples(), kShownSamples);
    // It is what one sees, and smoother than a frame.
    const QImage mean = viewport().surface().grab();
    set([](DisplayOptions& options) { options.refine = false; });
    QVERIFY(test::differing(mean, viewport().surface().grab(), 8) > 200);
}

void RefineTest::changesBeginAnew_data() {
    QTest::addColumn<int>("change");
    const char* names[] = {"camera", "hit", "light", "option", "target", "size"};
    for (int i = 0; i < 6; ++i) {
        QTest::newRow(names[i]) << i;
    }
}

void RefineTest::changesBeginAnew() {
    QFETCH(int, change);
    const QSignalSpy samples(&refiner(), &PictureRefiner::refined);
    const QImage before = viewport().surface().grab();
    const TargetId target = m_session->targets().front()->id;
    switch (change) {
        case 0: {
            Camera camera = viewport().camera();
            camera.orbit(0.3f, 0.1f);
            viewport().navigation().setCamera(camera);
            break;
        }
        case 1: {
            Hit hit;
            hit.target = target;
            hit.point = -2.5f * viewport().camera().forward();
            hit.direction = viewport().camera().forward();
            QVERIFY(m_session->hits().add(hit).ok());
            break;
        }
        case 2: {
            Lights lights = m_session->settings().lights();
            lights.directional.direction.x *= -1.0f;
            m_session->settings().setLights(lights);
            break;
        }
        case 3:
            set([](DisplayOptions& options) { options.look = SurfaceLook::Clay; });
            break;
        case 4:
            m_session->targets().setVisible(std::array{target}, false);
            break;
        default:
            m_window->resize(740, 520);
    }
    QTRY_VERIFY_WITH_TIMEOUT(!samples.isEmpty(), kPatience);
    QCOMPARE(samples.front().front().toInt(), 1);
    waitUntilRefined();
    const QImage after = viewport().surface().grab();
    QVERIFY(after.size() != before.size() || test::differing(before, after, 4) > 30);
}

void RefineTest::whatIsOverItDoesNot() {
    const QImage before = viewport().surface().grab();
    const QSignalSpy samples(&refiner(), &PictureRefiner::refined);
    set([](DisplayOptions& options) { options.crosshair = true; });
    QTRY_VERIFY_WITH_TIMEOUT(test::differing(before, viewport().surface().grab(), 20) > 10, kPatience);
    QTest::qWait(300);
    QCOMPARE(samples.size(), 0);
    QCOMPARE(refiner().samples(), kShownSamples);
    set([](DisplayOptions& options) { options.crosshair = false; });
    QCOMPARE(test::differing(before, viewport().surface().grab()), 0);
}

void RefineTest::offForgets() {
    set([](DisplayOptions& options) { options.refine = false; });
    QCOMPARE(refiner().samples(), 0);
    const QSignalSpy samples(&refiner(), &PictureRefiner::refined);
    viewport().wantPicture();
    QTest::qWait(500);
    QCOMPARE(samples.size(), 0);
    QVERIFY(!refiner().wasShown());
}

/// Where a picture takes long, one with fewer triangles is shown at once, and then, drawn in parts, the
/// picture.
void RefineTest::slowPicturesAreCoarseFirst() {
    viewport().surface().makeCurrent();
    const bool isSoftware = gl::rendererInfo().isSoftware();
    viewport().surface().doneCurrent();
    if (!isSoftware) {
        QSKIP("only software renderers draw in parts");
    }
    MeshData mesh = makeGeodesicSphere(90, 2.0f);
    std::vector<TargetPlan> large(1, planMesh(prepareMesh(std::move(mesh)), TargetSource()));
    m_session->loadScene({{}, std::move(large), 0.0f});
    for (const bool refine : {false, true}) {
        set([refine](DisplayOptions& options) {
            options.refine = refine;
            options.reduceInMotion = true;
        });
        PictureMotion& motion = viewport().pictures().motion();
        motion.setSlow(0.0, 0.0);
        bool wasCoarse = false;
        int frames = 0;
        QObject listener;
        connect(&viewport(), &Viewport::windowPainted, &listener, [&] {
            ++frames;
            wasCoarse = wasCoarse || motion.lastDetail().coarse;
        });
        // The first picture after a change of the way to draw is not judged, and one more is drawn in full.
        for (int change = 0; change < 20 && !(wasCoarse && refiner().wasShown()); ++change) {
            frames = 0;
            Lights lights = m_session->settings().lights();
            lights.directional.direction.x *= -1.0f;
            m_session->settings().setLights(lights);
            QTRY_VERIFY_WITH_TIMEOUT(frames > 0 && motion.lastDetail().isFull(), kPatience);
        }
        QVERIFY(wasCoarse);
        QVERIFY(refiner().wasShown());
        if (!refine) {
            QCOMPARE(refiner().samples(), 0);
            const QImage inParts = viewport().surface().grab();
            set([](DisplayOptions& options) { options.reduceInMotion = false; });
            QCOMPARE(test::differing(inParts, viewport().surface().grab()), 0);
        }
    }
}

/// An event that is sent when the drawing has been handed over arrives before the picture is shown.
void RefineTest::eventsComeWhileAPictureIsDrawn() {
    if (!viewport().surface().keepsPictures()) {
        QSKIP("only pictures kept in memory are drawn ahead");
    }
    QStringList order;
    QObject listener;
    connect(&viewport().pictures(), &PictureFlow::drawn, &listener, [&] {
        order << QStringLiteral("drawn");
        QMetaObject::invokeMethod(
            &listener, [&order] { order << QStringLiteral("event"); }, Qt::QueuedConnection);
    });
    connect(&viewport().pictures(), &PictureFlow::shown, &listener,
            [&order] { order << QStringLiteral("shown"); });
    Camera camera = viewport().camera();
    camera.orbit(0.3f, 0.1f);
    viewport().navigation().setCamera(camera);
    // A picture of the test before may be shown first.
    const auto sinceDrawn = [&order] {
        const qsizetype drawn = order.indexOf(QStringLiteral("drawn"));
        return drawn < 0 ? QStringList() : order.mid(drawn);
    };
    QTRY_VERIFY_WITH_TIMEOUT(sinceDrawn().contains(QStringLiteral("shown")), kPatience);
    QCOMPARE(sinceDrawn().first(3).join(u' '), QStringLiteral("drawn event shown"));
}

void RefineTest::frameRateWaitsForIt() {
    refiner().setWanted(400);  // takes longer than the graph's timer
    int drawn = 0;
    int looks = 0;
    QObject listener;
    connect(m_window->findChild<FrameGraph*>(), &FrameGraph::drawn, &listener,
            [&] { drawn += refiner().isUnderWay() ? 1 : 0; });
    connect(&refiner(), &PictureRefiner::aboutToShow, &listener,
            [&] { looks += refiner().isUnderWay() ? 1 : 0; });
    Camera camera = viewport().camera();
    camera.orbit(0.3f, 0.1f);
    viewport().navigation().setCamera(camera);
    QTRY_COMPARE_WITH_TIMEOUT(refiner().samples(), 400, kPatience);
    QVERIFY2(drawn <= looks, qPrintable(QStringLiteral("%1 of %2").arg(drawn).arg(looks)));
}

void RefineTest::measuringIsWithout() {
    const QSignalSpy samples(&refiner(), &PictureRefiner::refined);
    const QSignalSpy frames(&viewport().pictures(), &PictureFlow::framePainted);
    viewport().setDrawsContinuously(true);
    QTRY_VERIFY_WITH_TIMEOUT(frames.size() > 5, kPatience);
    QCOMPARE(samples.size(), 0);
    viewport().setDrawsContinuously(false);
    waitUntilRefined();
}

void RefineTest::savedAreTheSameToTheBit() {
    PictureRequest request = viewport().pictureRequest();
    request.width = 200;
    request.height = 150;
    request.samples = 24;
    const Result<Image> first = viewport().drawPicture(request);
    const Result<Image> second = viewport().drawPicture(request);
    QVERIFY(first.ok() && second.ok());
    QVERIFY(first.value().pixels == second.value().pixels);
    const auto& notes = first.value().notes;
    QVERIFY(std::find(notes.begin(), notes.end(), std::pair<std::string, std::string>("Samples", "24")) !=
            notes.end());
    request.samples = 1;
    const Result<Image> once = viewport().drawPicture(request);
    QVERIFY(once.ok() && once.value().pixels != first.value().pixels);
}

/// What is copied has the samples that the window shows, and none of what was shown before a hit.
void RefineTest::copiedAreAsShown() {
    waitUntilRefined();
    const auto samplesOf = [](const Image& image) {
        for (const auto& [key, text] : image.notes) {
            if (key == "Samples") {
                return QString::fromStdString(text).toInt();
            }
        }
        return 1;
    };
    const Result<Image> copied = viewport().drawShown();
    const Result<Image> once = viewport().drawPicture(viewport().pictureRequest());
    QVERIFY(copied.ok() && once.ok());
    QCOMPARE(samplesOf(copied.value()), 16);
    QVERIFY(copied.value().pixels != once.value().pixels);
    Hit hit;
    hit.target = m_session->targets().front()->id;
    hit.point = m_session->targets().front()->deformed.positions().front();
    hit.direction = {0.0f, -1.0f, 0.0f};
    QVERIFY(m_session->hits().add(hit).ok());
    const Result<Image> dented = viewport().drawShown();
    QVERIFY(dented.ok());
    QCOMPARE(samplesOf(dented.value()), 1);
    m_session->undo();
}

void RefineTest::turntableIsOneClick() {
    const QTemporaryDir folder;
    auto* pictures = m_window->findChild<PictureActions*>();
    QSettings().setValue(QStringLiteral("picture/folder"), folder.path());
    for (QAction* action : m_window->findChildren<QAction*>()) {
        if (action->text().remove(u'&') == QStringLiteral("Save Turntable")) {
            action->trigger();
        }
    }
    QVERIFY(pictures->sequences().isRunning());
    const QString made = pictures->sequences().plan().folder;
    QVERIFY(made.startsWith(folder.path() + u'/') && QFileInfo(made).isDir());
    pictures->sequences().cancel();
    QTRY_VERIFY_WITH_TIMEOUT(!pictures->sequences().isRunning(), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(!QFileInfo::exists(made), kPatience);  // nothing was written
    SequenceWriter::Plan plan = pictures->turntablePlan();
    QVERIFY(plan.turntable >= 60 && plan.picture.samples == kShownSamples);
    plan.picture.width = 96;
    plan.picture.height = 64;
    plan.turntable = 4;
    plan.folder = folder.path();
    const QSignalSpy ended(&pictures->sequences(), &SequenceWriter::ended);
    const QSignalSpy progress(&pictures->sequences(), &SequenceWriter::sampled);
    pictures->writeSequence(plan);
    QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatience);
    QVERIFY(progress.size() >= 4 * (kShownSamples - 1));
    const QStringList files = QDir(folder.path()).entryList(QDir::Files, QDir::Name);
    QCOMPARE(files.size(), 4);
    QImageReader reader(QDir(folder.path()).filePath(files.front()));
    QCOMPARE(reader.text(QStringLiteral("Samples")), QString::number(kShownSamples));
    // From all sides the whole scene is in the picture: its edge shows none of it.
    for (const QString& file : files) {
        const QImage image(QDir(folder.path()).filePath(file));
        QCOMPARE(image.size(), QSize(96, 64));
    }
}

void RefineTest::environmentTurnsLightsOff() {
    const auto light = [this]() -> QAction* {
        for (QAction* action : m_window->findChildren<QAction*>()) {
            if (action->text() == QStringLiteral("&Directional")) {
                return action;
            }
        }
        return nullptr;
    };
    QVERIFY(light() != nullptr && light()->isEnabled());
    set([](DisplayOptions& options) { options.environment = true; });
    QVERIFY(!light()->isEnabled());
    QVERIFY(whyDisabled(*light()).contains(QStringLiteral("environment")));
    set([](DisplayOptions& options) { options.environment = false; });
    QVERIFY(light()->isEnabled());
}

HITSCOPE_TEST(RefineTest, QApplication)

}  // namespace hitscope::refine_test

#include "refine_test.moc"
