// SPDX-License-Identifier: GPL-3.0-or-later
// The picture outlives its OpenGL context, and what is under the cursor is so at any scale: run with other
// values of QT_SCALE_FACTOR too.
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QEvent>
#include <QImage>
#include <QMainWindow>
#include <QOpenGLContext>
#include <QScopeGuard>
#include <QScreen>
#include <QSettings>
#include <QSignalSpy>
#include <QStatusBar>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "mesh/primitives.h"
#include "panels/frame_rate/frame_graph.h"
#include "support/baseline.h"
#include "support/test_program.h"
#include "viewport/surface/surface_format.h"
#include "widgets/window_support.h"

namespace hitscope::context_test {

namespace {

std::vector<std::vector<DynamicVertex>> readBack(const Session& session) {
    std::vector<std::vector<DynamicVertex>> all;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        const auto vertices = target->deformed.vertices();
        all.emplace_back(vertices.begin(), vertices.end());
    }
    return all;
}

/// On the sphere of radius 2.5 m, at its side `out` (unit).
Hit hitOn(const Session& session, const glm::vec3& out, const glm::vec3& direction) {
    Hit hit;
    hit.target = session.targets().front()->id;
    hit.point = 2.5f * out;
    hit.direction = direction;
    return hit;
}

bool sameBits(const std::vector<std::vector<DynamicVertex>>& a,
              const std::vector<std::vector<DynamicVertex>>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].size() != b[i].size() ||
            std::memcmp(a[i].data(), b[i].data(), a[i].size() * sizeof(DynamicVertex)) != 0) {
            return false;
        }
    }
    return a.size() == b.size();
}

}  // namespace

namespace {

/// Counts what widgets of the whole program paint, from its making on.
class PaintCounter : public QObject {
public:
    PaintCounter() { qApp->installEventFilter(this); }
    [[nodiscard]] qsizetype count() const { return m_count; }
    [[nodiscard]] const QString& last() const { return m_last; }  ///< who painted last

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint && watched->isWidgetType()) {
            ++m_count;
            m_last =
                QLatin1String(watched->metaObject()->className()) + QLatin1Char(' ') + watched->objectName();
        }
        return QObject::eventFilter(watched, event);
    }

private:
    qsizetype m_count = 0;
    QString m_last;
};

}  // namespace

class ContextTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init();
    void cleanup();
    void anotherContextShowsTheSame_data();
    void anotherContextShowsTheSame();
    void windowTricksLoseNothing();
    void pixelsAndRaysAgree_data();
    void pixelsAndRaysAgree();
    void windowFitsTheScreen();
    void idleDrawsNothing();
    void idleWindowPaintsNothing();

private:
    void hitIt();
    [[nodiscard]] QImage shown() { return m_window->viewport().surface().grab(); }
    /// Empty: the picture shown is this one.
    [[nodiscard]] QString differenceFrom(const QImage& before) {
        const QImage now = shown();
        const int pixels = test::differing(now, before);
        if (pixels == 0) {
            return {};
        }
        now.save(QDir::temp().filePath(QStringLiteral("hitscope-after.png")));
        before.save(QDir::temp().filePath(QStringLiteral("hitscope-before.png")));
        return QStringLiteral("%1 of %2 pixels differ, %3 by more than 2")
            .arg(pixels)
            .arg(now.width() * now.height())
            .arg(test::differing(now, before, 2));
    }
};

/// Only what Qt composes loses its context.
void ContextTest::init() {
    const bool isComposed =
        QLatin1String(QTest::currentTestFunction()) == QLatin1String("anotherContextShowsTheSame");
    if (isComposed) {
        qputenv(kComposes, "4");  // samples, which Qt forgets
    }
    makeWindow();
    qunsetenv(kComposes);
}

void ContextTest::cleanup() {
    dropWindow();
}

void ContextTest::hitIt() {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> between(-1.0f, 1.0f);
    std::vector<Hit> hits;
    const glm::vec3 toEye = -m_window->viewport().camera().forward();
    for (int i = 0; i < 40; ++i) {
        const glm::vec3 out =
            glm::normalize(toEye + 0.6f * glm::vec3{between(random), between(random), between(random)});
        hits.push_back(hitOn(*m_session, out, -out));
    }
    QVERIFY(m_session->hits().add(hits).ok());
    QVERIFY(m_window->viewport().syncNow().ok());
}

void ContextTest::anotherContextShowsTheSame_data() {
    QTest::addColumn<QString>("pipeline");
    for (const PipelineTraits& traits : allPipelines()) {
        const auto name = QString::fromUtf8(traits.key);
        QTest::newRow(qPrintable(name)) << name;
    }
}

void ContextTest::anotherContextShowsTheSame() {
    QFETCH(QString, pipeline);
    for (const PipelineTraits& traits : allPipelines()) {
        if (pipeline == QString::fromUtf8(traits.key)) {
            if (const QString why = m_session->readBack().whyUnavailable(traits.kind); !why.isEmpty()) {
                QSKIP(qPrintable(why));
            }
            choosePipeline(*m_window, traits.kind);
            QCOMPARE(m_session->settings().pipeline(), traits.kind);
        }
    }
    hitIt();
    Viewport& viewport = m_window->viewport();
    viewport.setFixedSize(viewport.size());  // while it is away the docks spread
    const QImage before = shown();
    const auto vertices = readBack(*m_session);
    const QSize size = viewport.size();

    QOpenGLContext* first = viewport.surface().context();
    const QSignalSpy gone(first, &QOpenGLContext::aboutToBeDestroyed);
    const QSignalSpy again(&viewport.scene(), &ViewportScene::made);
    // To a window of its own, as when a panel is undocked, and back.
    viewport.setParent(nullptr);
    const auto goesWithTheWindow = qScopeGuard([this, &viewport] {
        if (viewport.parent() == nullptr) {
            m_window->setCentralWidget(&viewport);
        }
    });
    viewport.show();
    QVERIFY(QTest::qWaitForWindowExposed(&viewport, kPatience));
    QTRY_COMPARE_WITH_TIMEOUT(again.size(), 1, kPatience);
    QCOMPARE(gone.size(), 1);
    QVERIFY(viewport.syncNow().ok());
    QCOMPARE(viewport.size(), size);
    QCOMPARE(differenceFrom(before), QString());
    QVERIFY(sameBits(readBack(*m_session), vertices));

    m_window->setCentralWidget(&viewport);
    QTRY_COMPARE_WITH_TIMEOUT(again.size(), 2, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(viewport.size(), size, kPatience);
    QVERIFY(viewport.syncNow().ok());
    QCOMPARE(differenceFrom(before), QString());
    QVERIFY(sameBits(readBack(*m_session), vertices));
    // And it goes on: one more hit is seen.
    Hit hit = hitOn(*m_session, {}, -viewport.camera().up());
    const glm::vec3 out = -viewport.camera().forward();
    const auto now = m_session->targets().front()->deformed.vertices();
    hit.point =
        std::max_element(now.begin(), now.end(), [&out](const DynamicVertex& a, const DynamicVertex& b) {
            return glm::dot(a.position, out) < glm::dot(b.position, out);
        })->position;
    QVERIFY(m_session->hits().add(hit).ok());
    QVERIFY(viewport.syncNow().ok());
    QVERIFY(!sameBits(readBack(*m_session), vertices));
    QVERIFY(shown() != before);
}

void ContextTest::windowTricksLoseNothing() {
    hitIt();
    Viewport& viewport = m_window->viewport();
    const QImage before = shown();
    const QSize size = viewport.size();
    const auto back = [&] {
        QTRY_COMPARE_WITH_TIMEOUT(viewport.size(), size, kPatience);
        QCOMPARE(differenceFrom(before), QString());
    };
    m_window->resize(m_window->size() + QSize(120, 90));
    QTRY_VERIFY_WITH_TIMEOUT(viewport.size() != size, kPatience);
    m_window->resize(m_window->size() - QSize(120, 90));
    back();
    m_window->showMinimized();
    QTest::qWait(50);
    m_window->showNormal();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), kPatience));
    back();
    m_window->showFullScreen();
    QVERIFY(m_window->windowState().testFlag(Qt::WindowFullScreen));
    QTest::qWait(50);
    m_window->showNormal();
    back();
    m_window->hide();
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), kPatience));
    back();
    auto* dock = m_window->findChild<QDockWidget*>(QStringLiteral("hitHistory"));
    dock->setFloating(true);
    QTRY_VERIFY_WITH_TIMEOUT(dock->isFloating() && dock->isVisible(), kPatience);
    dock->setFloating(false);
    back();
}

/// At first; at twice the scale the tests' screen is a small one.
void ContextTest::windowFitsTheScreen() {
    Session session;
    QSettings().clear();  // the other window may have noted its size
    MainWindow window(session);
    const QSize screen = window.screen()->availableSize();
    QVERIFY2(window.width() <= screen.width() && window.height() <= screen.height(),
             qPrintable(QStringLiteral("%1x%2").arg(window.width()).arg(window.height())));
}

void ContextTest::pixelsAndRaysAgree_data() {
    QTest::addColumn<bool>("orthographic");
    QTest::newRow("perspective") << false;
    QTest::newRow("orthographic") << true;
}

void ContextTest::pixelsAndRaysAgree() {
    QFETCH(bool, orthographic);
    Viewport& viewport = m_window->viewport();
    viewport.navigation().setProjection(orthographic ? Projection::Orthographic : Projection::Perspective);
    DisplayOptions options = viewport.options();
    options.floor = false;
    viewport.setOptions(options);
    const QImage with = shown();
    const TargetId target[] = {m_session->targets().front()->id};
    const double scale = viewport.devicePixelRatioF();
    QCOMPARE(with.width(), static_cast<int>(std::lround(viewport.width() * scale)));
    if (qEnvironmentVariableIsSet("QT_SCALE_FACTOR")) {
        QCOMPARE(scale, qEnvironmentVariable("QT_SCALE_FACTOR").toDouble());
    }
    struct Probe {
        QPoint pixel;
        bool hit;
    };
    std::vector<Probe> probes;
    std::mt19937 random(7);
    std::uniform_int_distribution<int> x(3, with.width() - 4);
    std::uniform_int_distribution<int> y(3, with.height() - 4);
    const auto meets = [&](const QPointF& pixel) {
        const Ray ray = viewport.navigation().rayAt(pixel / scale);
        const auto met = m_session->simulation().physics().castRay(ray.origin, ray.direction, 1.0e4f);
        return met && met->target;  // not the floor
    };
    for (int i = 0; i < 600; ++i) {
        const QPoint pixel(x(random), y(random));
        const QPointF middle = QPointF(pixel) + QPointF(0.5, 0.5);
        const bool hit = meets(middle);
        bool edge = false;
        for (const QPointF& off : {QPointF(2, 0), QPointF(-2, 0), QPointF(0, 2), QPointF(0, -2)}) {
            edge = edge || meets(middle + off) != hit;
        }
        if (!edge) {
            probes.push_back({pixel, hit});
        }
    }
    m_session->targets().setVisible(target, false);
    const QImage without = shown();
    std::size_t hits = 0;
    std::size_t unseen = 0;
    for (const Probe& probe : probes) {
        const bool seen = with.pixel(probe.pixel) != without.pixel(probe.pixel);
        QVERIFY(probe.hit || !seen);
        hits += probe.hit ? 1 : 0;
        unseen += probe.hit && !seen ? 1 : 0;  // somewhere the surface is as bright as what is behind it
    }
    QVERIFY2(hits > 50 && hits < probes.size() && unseen <= hits / 50,
             qPrintable(QStringLiteral("%1 of %2 unseen").arg(unseen).arg(hits)));
}

void ContextTest::idleDrawsNothing() {
    hitIt();
    Viewport& viewport = m_window->viewport();
    viewport.frameAll();  // a glide ends, and then nothing more is drawn
    QTRY_VERIFY_WITH_TIMEOUT(!viewport.navigation().isMoving(), kPatience);
    // On a busy machine the last frames may come late; but some time none come.
    const QSignalSpy frames(&viewport.pictures(), &PictureFlow::framePainted);
    QElapsedTimer patience;
    patience.start();
    qsizetype last = -1;
    while (last != frames.size() && patience.elapsed() < kPatience) {
        last = frames.size();
        QTest::qWait(3000);
    }
    QCOMPARE(frames.size(), last);
}

/// Nor is anything else in the window: panels, graphs, read-outs.
void ContextTest::idleWindowPaintsNothing() {
    // So much time in sight that a graph that went on as long as something moves in it would do so for
    // minutes.
    auto* plot = m_window->findChild<QWidget*>(QStringLiteral("framesPage"))
                     ->findChild<QWidget*>(QStringLiteral("plot"));
    for (int i = 0; i < 12; ++i) {
        QTest::keyClick(plot, Qt::Key_Minus);
    }
    Viewport& viewport = m_window->viewport();
    viewport.setFocus();
    const QSignalSpy changed(&m_session->readBack(), &ReadBack::verticesMoved);
    viewport.shootAtCrosshair();
    QTRY_VERIFY_WITH_TIMEOUT(!changed.isEmpty(), kPatience);
    m_window->statusBar()->clearMessage();  // which would go by itself one day
    const PaintCounter paints;
    QElapsedTimer patience;
    patience.start();
    // What is worked out meanwhile may come late on a busy machine, and is painted then; but some time all is
    // quiet.
    qsizetype last = -1;
    while (last != paints.count() && patience.elapsed() < qint64{2} * kPatience) {
        last = paints.count();
        QTest::qWait(5000);
    }
    QVERIFY2(paints.count() == last, qPrintable(paints.last()));
    // The next frame wakes it again.
    const QSignalSpy drawn(m_window->findChild<FrameGraph*>(), &FrameGraph::drawn);
    viewport.wantPicture();
    QTRY_VERIFY_WITH_TIMEOUT(!drawn.isEmpty(), kPatience);
}

HITSCOPE_TEST(ContextTest, QApplication)

}  // namespace hitscope::context_test

#include "context_test.moc"
