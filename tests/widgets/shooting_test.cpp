// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QSignalSpy>
#include <QStatusBar>
#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/primitives.h"
#include "session/shots/shot_script.h"
#include "support/test_program.h"
#include "viewport/aim_preview.h"
#include "widgets/window_support.h"

namespace hitscope::shooting_test {

namespace {

constexpr double kPixelDiffers = 12;  // of 255

/// The part of the picture that has the projectile's colour in these tests, which nothing else has.
double projectilePart(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor colour = image.pixelColor(x, y);
            count += colour.red() > colour.green() + 40 && colour.blue() > colour.green() + 40 ? 1 : 0;
        }
    }
    return static_cast<double>(count) / (image.width() * image.height());
}

/// How many pixels are not as they were.
int difference(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < std::min(a.height(), b.height()); ++y) {
        for (int x = 0; x < std::min(a.width(), b.width()); ++x) {
            const QColor one = a.pixelColor(x, y);
            const QColor other = b.pixelColor(x, y);
            const int apart = std::abs(one.red() - other.red()) + std::abs(one.green() - other.green()) +
                              std::abs(one.blue() - other.blue());
            count += apart > kPixelDiffers ? 1 : 0;
        }
    }
    return count;
}

}  // namespace

/// From the button up to the dent, at any scale, by real clicks.
class ShootingTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init();
    void cleanup() { dropWindow(); }
    void clickDentsAMeshOfAnySize();
    void instantDentIsThereInTwoFrames();
    void quickShotArrivesInTime();
    void firstFrameAfterIdlenessMovesOn();
    void noFrameIsHiddenByTheProjectile_data();
    void noFrameIsHiddenByTheProjectile();
    void statusBarSaysWhatShotsDid();
    void choiceInTheToolBarIsKept();

private:
    [[nodiscard]] Viewport& viewport() const { return m_window->viewport(); }
    [[nodiscard]] QPoint centre() const { return viewport().rect().center(); }
    [[nodiscard]] QString said() const { return m_window->statusBar()->currentMessage(); }
    void click(const QPoint& at) { QTest::mouseClick(&viewport(), Qt::LeftButton, {}, at); }
    void waitUntilIdle();
};

void ShootingTest::init() {
    makeWindow();
    m_window->findChild<QAction*>(QStringLiteral("aimPreviewOn"))->trigger();
}

void ShootingTest::waitUntilIdle() {
    QSignalSpy frames(&viewport().pictures(), &PictureFlow::framePainted);
    do {
        frames.clear();
        QTest::qWait(150);
    } while (!frames.isEmpty());
}

void ShootingTest::clickDentsAMeshOfAnySize() {
    for (int power = -4; power <= 5; ++power) {
        const float extent = std::pow(10.0f, static_cast<float>(power));
        MeshData mesh = makeHighPolySphere(2.5f);
        for (glm::vec3& position : mesh.positions) {
            position *= extent / kUsualExtent;
        }
        loadMesh(*m_session, std::move(mesh));
        std::size_t hits = 0;
        for (const FlightMode mode : {FlightMode::Quick, FlightMode::Instant}) {
            m_session->settings().setFlightMode(mode);
            click(centre() + QPoint(mode == FlightMode::Quick ? -60 : 60, 0));
            ++hits;
            QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), hits, kPatience);
            QVERIFY(viewport().syncNow().ok());
            const auto depth =
                static_cast<float>(m_session->targets().front()->deformed.statistics().maximum);
            QVERIFY2(depth > 0.05f * extent && depth < 0.07f * extent,
                     qPrintable(QStringLiteral("%1 m: %2").arg(extent).arg(depth)));
        }
    }
}

void ShootingTest::instantDentIsThereInTwoFrames() {
    m_session->settings().setFlightMode(FlightMode::Instant);
    for (const bool large : {false, true}) {
        if (large) {
            loadMesh(*m_session, makeUvSphere(1000, 1001, 2.5f));  // 1,000,000 vertices
        }
        waitUntilIdle();
        const QImage before = viewport().surface().grab();
        waitUntilIdle();
        std::vector<QImage> pictures;
        const auto grab = connect(&viewport().pictures(), &PictureFlow::framePainted, this, [&] {
            pictures.push_back(viewport().surface().grab());  // what is being drawn: nothing is drawn again
        });
        click(centre());
        QCOMPARE(m_session->hits().history().size(), std::size_t{1});
        const auto firstWithTheDent = [&] {
            const auto found = std::find_if(pictures.begin(), pictures.end(), [&](const QImage& picture) {
                return difference(picture, before) > 500;
            });
            return found - pictures.begin();
        };
        QTRY_VERIFY_WITH_TIMEOUT(firstWithTheDent() < std::ssize(pictures), kPatience);
        disconnect(grab);
        QVERIFY(firstWithTheDent() < (large ? 3 : 2));
    }
}

void ShootingTest::quickShotArrivesInTime() {
    loadPaperRow(*m_session, kDefaultPaperRow);
    for (const int notches : {0, -6, 12}) {
        for (int i = 0; i < std::abs(notches); ++i) {
            viewport().navigation().flyStep({0.0f, 0.0f, notches > 0 ? 0.6f : -2.0f});
        }
        m_session->hits().clear();
        const double before = m_session->simulation().physics().clock().time();
        click(centre());
        QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), std::size_t{1}, kPatience);
        QVERIFY(m_session->hits().history().hits().front().time - before <= 0.12);
        waitUntilIdle();
    }
}

void ShootingTest::firstFrameAfterIdlenessMovesOn() {
    waitUntilIdle();
    const double before = m_session->simulation().physics().clock().time();
    std::vector<double> times;
    connect(&viewport().pictures(), &PictureFlow::framePainted, this,
            [&] { times.push_back(m_session->simulation().physics().clock().time() - before); });
    click(centre());
    QTRY_VERIFY_WITH_TIMEOUT(times.size() >= 2, kPatience);
    QVERIFY(times[1] > 0.0);
}

void ShootingTest::noFrameIsHiddenByTheProjectile_data() {
    QTest::addColumn<FlightMode>("mode");
    QTest::addColumn<float>("strides");
    QTest::newRow("quick") << FlightMode::Quick << 0.0f;
    QTest::newRow("quick, near") << FlightMode::Quick << 2.5f;
    QTest::newRow("as in the paper") << FlightMode::Paper << 0.0f;
    QTest::newRow("as in the paper, near") << FlightMode::Paper << 2.5f;
}

void ShootingTest::noFrameIsHiddenByTheProjectile() {
    QFETCH(FlightMode, mode);
    QFETCH(float, strides);
    m_session->settings().setFlightMode(mode);
    ProjectileSettings settings = m_session->settings().projectile();
    settings.colour = {1.0f, 0.0f, 1.0f};
    m_session->settings().setProjectile(settings);
    viewport().navigation().flyStep({0.0f, 0.0f, strides});
    waitUntilIdle();
    m_session->simulation().setPaused(true);
    click(centre());
    double most = projectilePart(viewport().surface().grab());
    for (int step = 0; step < 30; ++step) {
        m_session->simulation().stepOnce();
        most = std::max(most, projectilePart(viewport().surface().grab()));
    }
    QVERIFY2(most < 0.15, qPrintable(QString::number(most)));
    QVERIFY2(most > 0.0, "the projectile was never seen");
}

void ShootingTest::statusBarSaysWhatShotsDid() {
    m_session->settings().setFlightMode(FlightMode::Paper);
    const QString name = m_session->targets().front()->name;
    click(centre());
    QCOMPARE(said(), QStringLiteral("The shot is on its way."));
    QTRY_COMPARE_WITH_TIMEOUT(said(), QStringLiteral("The shot hit %1.").arg(name), kPatience);
    m_session->settings().setFlightMode(FlightMode::Quick);
    click({centre().x() + 200, viewport().height() - 40});
    QTRY_COMPARE_WITH_TIMEOUT(said(), QStringLiteral("The shot struck the floor."), kPatience);
    click({8, 8});
    QCOMPARE(said(), QStringLiteral("The shot is on its way."));
    QTRY_COMPARE_WITH_TIMEOUT(said(), QStringLiteral("The shot went past everything."), kPatience);
    m_session->settings().setFlightMode(FlightMode::Instant);
    click(centre());
    QCOMPARE(said(), QStringLiteral("The shot hit %1.").arg(name));
    click({8, 8});
    QCOMPARE(said(), QStringLiteral("The shot went past everything."));
    ShotScript script;
    script.isInstant = true;
    script.shots = burst(viewport().rayThrough({0.5, 0.5}), 65, 0.02f, 1);
    script.shots.push_back({0.0, viewport().rayThrough({0.01, 0.01})});
    script.shots.push_back({0.0, viewport().rayThrough({0.5, 0.99})});
    schedule(*m_session, script);
    QCOMPARE(said(), QStringLiteral("67 shots are on their way."));
    QTRY_COMPARE_WITH_TIMEOUT(said(), QStringLiteral("67 shots, 65 hits, 1 on the floor, 1 past everything"),
                              kPatience);
}

void ShootingTest::choiceInTheToolBarIsKept() {
    const auto box = [this] { return m_window->findChild<QComboBox*>(QStringLiteral("flight")); };
    const auto action = [this](const char* key) {
        return m_window->findChild<QAction*>(QStringLiteral("flight/") + QLatin1String(key));
    };
    QCOMPARE(m_session->settings().flightMode(), FlightMode::Quick);
    QVERIFY(action("quick")->isChecked());
    QVERIFY(!box()->toolTip().isEmpty());
    box()->setFocus();
    QTest::keyClick(box(), Qt::Key_Down);
    QCOMPARE(m_session->settings().flightMode(), FlightMode::Instant);
    QVERIFY(action("instant")->isChecked());
    QVERIFY(viewport().hasFocus());
    // At once: a window that is killed closes nothing.
    QCOMPARE(QSettings().value(QStringLiteral("shooting/flight")).toString(), QStringLiteral("instant"));
    makeWindow();
    QCOMPARE(m_session->settings().flightMode(), FlightMode::Instant);
    QCOMPARE(box()->currentText(), QStringLiteral("Instant"));
    action("paper")->trigger();
    QCOMPARE(box()->currentText(), QStringLiteral("As in the paper"));
    QCOMPARE(QSettings().value(QStringLiteral("shooting/flight")).toString(), QStringLiteral("paper"));
}

HITSCOPE_TEST(ShootingTest, QApplication)

}  // namespace hitscope::shooting_test

#include "shooting_test.moc"
